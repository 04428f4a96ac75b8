from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
import resource
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
def f(n,t): open(W+'/'+n,'w').write(H+t)
d=Drive()
D=lambda *a,**k: run(['dataset',*a],d,**k)
C=lambda *a: D('check',*a,'--timeout','150ms')
for x in glob.glob(W+'/*.toml'): 
    if not x.endswith('m.toml'): os.remove(x)
D('save','c.toml'); r=C('c.toml'); print('check same',r.rc)
def two(nm,fn,**k):
    d.P=table(); fn(); d.clr(); r=C('c.toml'); da=(r.j or {}).get('data') or {}; print(nm,'rc',r.rc,'n',d.n,json.dumps(da)[:400] if k.get('show') else '',((r.j or {}).get('error') or {}).get('message'),[w['message'][:150] for w in (r.j or {}).get('warnings',[])])
two('one diff',lambda:d.set(480,2,1),show=1)
two('ram only diff',lambda:d.set(480,2,1,ee=False)); 
two('unknown param gone',lambda:d.P.pop(601)); 
d.P=table(); d.hook=lambda d,n,b:'drop' if b[1]in(3,100) and b[2:4]==bytes.fromhex('0259') else None; r=C('c.toml'); print('601@0 silent',r.rc,((r.j or {}).get('error') or {}).get('message')); d.hook=None
d.hook=lambda d,n,b:'drop' if b[1]in(3,100) and int.from_bytes(b[2:4],'big')&0xfff==601 else None; d.set(480,2,1); r=C('c.toml'); print('601 silent + a diff',r.rc,((r.j or {}).get('error') or {}).get('message'),s(r)[:100]); d.hook=None
d.P=table(); d.clr(); d.hook=lambda d,n,b:'dead' if n==30 else None; r=C('c.toml'); print('dead at 30',r.rc,((r.j or {}).get('error') or {}).get('message')); d.hook=None; d.dead=False
d.dead=True; r=C('c.toml'); print('dead all',r.rc,((r.j or {}).get('error') or {}).get('message')); d.dead=False
d.hook=lambda d,n,b:(os.kill(CUR[0].pid,2),time.sleep(.03))[0] if n==60 else None; d.clr(); r=C('c.toml'); print('INT in check',r.rc,s(r)[:200]); d.hook=None
f('act.toml','"372"="1450"\n'); t=open(W+'/act.toml').read().replace('acu','act'); open(W+'/act.toml','w').write(t); r=C('act.toml'); print('other family',r.rc,s(r)[:200])
r=C('nofile.toml'); print('no file',r.rc); f('e.toml',''); r=C('e.toml'); print('empty values',r.rc,s(r)[:200])
t=open(W+'/c.toml').read().replace('"480" = "5.00 Hz"','"480" = "6.00 Hz"'); open(W+'/ced.toml','w').write(t); r=C('ced.toml'); print('edited',r.rc,s(r)[-300:]); d.set(480,0,600); r=C('ced.toml'); print('edited & equal',r.rc,s(r)[-300:]); d.P=table()
t=open(W+'/c.toml').read().replace('[values]','[values]\n"480@2" = "6.00 Hz"'); open(W+'/cov.toml','w').write(t); r=C('cov.toml'); print('override set',r.rc)
f('wo.toml','"484"="3 Hz"\n"480"="5 Hz"\n'); r=C('wo.toml'); print('write-only in file',r.rc,s(r)[:250])
f('n.toml','"1599"="3"\n"480"="5 Hz"\n'); r=C('n.toml'); print('unknown num in file',r.rc,s(r)[:250])
print('--- diff')
G=lambda *a,**k: D('diff',*a,'--timeout','150ms',**k)
d.P=table(); d.set(480,2,1); d.set(372,3,1,ee=False)
for a in (('c.toml','drive'),('drive','c.toml'),('c.toml','factory'),('factory','drive'),('factory','2'),('1','2'),('1','1'),('2','2ram'),('3','3ram'),('3ram','drive'),('drive','drive'),('c.toml','2'),('c.toml','3ram'),('c.toml','c.toml'),('c.toml','ced.toml'),('c.toml','act.toml'),('factory','factory'),('5','1'),('drive:1','drive:2'),('drive:1','c.toml'),('c.toml','drive','480'),('c.toml','drive','nonsense'),('c.toml','nofile'),('0','1')):
    d.clr(); r=G(*a,js=False); print(a,'rc',r.rc,'n',d.n,'w',d.nw,'|',r.out.replace('\n',' / ')[:330],'|',r.err.strip()[:200].replace('\n',' / '))
r=G('c.toml','drive','--unified',js=False); print(r.out); r=G('c.toml','drive','--format','csv',js=False); print(r.out[:600])
r=run(['dataset','diff','c.toml','ced.toml']); print('no port',r.rc,r.err[:200]); r=run(['dataset','diff','c.toml','factory']); print('factory no port',r.rc,r.err[:200], json.dumps(r.j.get('data'))[:300] if r.j else '')
d.stop()
