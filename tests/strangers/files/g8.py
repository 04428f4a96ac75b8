from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
import resource
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
def f(n,t): open(W+'/'+n,'w').write(H+t)
# ulimit with trace
def lim(n): return lambda: resource.setrlimit(resource.RLIMIT_FSIZE,(n,n))
def wx(d,b): 
    a=cells(d.snap()); B=cells(b); return {k:(B[k],a[k]) for k in a if a[k]!=B[k]}
for n in(1500,2000,2500,3000,4000):
    clean(); d=Drive(); b=d.snap(); 
    if os.path.exists(W+'/tr'): os.remove(W+'/tr')
    r=run(['dataset','load','m.toml','--yes','--trace','tr'],d,pre=lim(n)); print('trace ulimit',n,'rc',r.rc,'nw',d.nw,'diff',wx(d,b),s(r)[-200:]); d.stop()
os.makedirs('/tmp/n22fs',exist_ok=True); m=subprocess.run(['mount','-t','tmpfs','-o','size=4k','tmpfs','/tmp/n22fs'],capture_output=True,text=True)
if m.returncode==0:
    clean(); d=Drive(); b=d.snap(); r=run(['dataset','load','m.toml','--yes','--trace','/tmp/n22fs/tr'],d); print('trace full','rc',r.rc,'nw',d.nw,'diff',wx(d,b),s(r)[-300:],r.err[-300:]); d.stop(); subprocess.run(['umount','/tmp/n22fs'])
# stdout/stderr closed or broken pipe mid-load
for nm,kw in (('stdout /dev/full',dict(stdout=open('/dev/full','w'),stderr=subprocess.PIPE)),('stderr /dev/full',dict(stdout=subprocess.PIPE,stderr=open('/dev/full','w')))):
    clean(); d=Drive(); b=d.snap(); p=subprocess.run([BIN,'-p',d.tty,'-a','1','-b','115200','dataset','load','m.toml','--yes'],cwd=W,env=ENV,stdin=subprocess.DEVNULL,timeout=60,**kw); print(nm,p.returncode,'nw',d.nw,'n diff',len(wx(d,b)),(p.stderr or b'')[-200:],(p.stdout or b'')[-100:]); d.stop()
clean(); d=Drive(); b=d.snap(); p=subprocess.Popen([BIN,'-p',d.tty,'-a','1','-b','115200','dataset','load','m.toml','--yes','-v'],cwd=W,env=ENV,stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE); p.stderr.close(); p.stdout.close(); rc=p.wait(60); print('both pipes closed rc',rc,'nw',d.nw,'diff',wx(d,b)); d.stop()
# lying drive
def acklie(param): 
    def h(d,n,b):
        return None
    return h
class Lie(Drive):
    lie=None; side=None
    def wr(s,addr,v,size):
        n=addr&0xfff
        if s.lie and n in s.lie:
            k=s.lie[n]
            if k=='no': s.nw+=1; return
            if k=='clamp': v=v-1 if v>0 else v+1
            if k=='eeonly' or k=='ramonly':
                p=s.P[n]; o=(list(p['ram']),list(p['ee'])); super().wr(addr,v,size); 
                if k=='eeonly': p['ram']=o[0]
                else: p['ee']=o[1]
                return
        super().wr(addr,v,size)
        if s.side: s.side(s,n,v)
def lcase(nm,lie=None,side=None,hook=None,file='m.toml',ram='cells',T=TGT,args=()):
    for x in glob.glob(W+'/'+file.replace('.toml','.undo*')): os.remove(x)
    d=Lie(ram=ram); d.lie=lie; d.side=side; d.hook=hook; b=d.snap(); r=run(['dataset','load',file,'--yes','--timeout','150ms',*args],d); judge(nm,r,d,b,T); print('    ',[w[1:4] for w in d.wlog], {k:v for k,v in wx(d,b).items()} if r.rc else ''); 
    for x in rowsof(r.j):
        if x['error']: print('      row',x['param'],x['data_set'],x['result'],x['error']['message'][:150])
    d.stop(); return r
lcase('ack without writing 480',{480:'no'}); lcase('clamps 480',{480:'clamp'}); lcase('eeprom only 480',{480:'eeonly'}); lcase('ram only 480',{480:'ramonly'})
def side(s,n,v):
    if n==419: s.set(549,0,123)
lcase('419 changes 549 (later written)',side=side)
def side2(s,n,v):
    if n==601: s.set(480,2,77)
lcase('601 changes 480@2 (already written)',side=side2)
def side3(s,n,v):
    if n==549: s.set(375,2,4444)
lcase('549 changes 375 beside the file',side=side3)
f('p30.toml','"30"="410"\n"392"="1"\n"480"="3 Hz"\n'); TP=[(30,0,410),(392,0,1),(480,0,300)]
def p30(s,n,v):
    if n==30: s.set(392,0,0); s.set(372,0,1000)
lcase('P.30 resets 392 and 372',side=p30,file='p30.toml',T=TP)
lcase('P.30 + refuse 480@4',side=p30,file='p30.toml',T=TP,hook=lambda d,n,b:('exc',4,6) if b[1]==101 and b[2:4]==bytes.fromhex('41e0') else None)
print('--- other ends')
d=Drive(); 
for a in ('0','1,2','1-3'):
    d.clr(); r=run(['dataset','load','m.toml','--yes'],d,addr=a); print('addr',a,d.nw,s(r))
clean(); r=run(['dataset','load','m.toml'],d,stdin=subprocess.PIPE); print('no yes',s(r)[:150])
r=run(['dataset','load','m.toml','m.toml','nofile','--yes'],d); print(s(r)[:150])
r=run(['dataset','load','.','--yes'],d); print(s(r)[:200]); os.path.exists(W+'/ff') or os.mkfifo(W+'/ff'); r=run(['dataset','load','ff','--yes'],d,limit=10); print('fifo',r.hung,s(r)[:200]); r=run(['dataset','load','/dev/zero','--yes'],d,limit=20); print('zero',r.hung,s(r)[:200]);
os.chmod(W,0o555); clean; r=run(['dataset','load','m.toml','--yes'],d); os.chmod(W,0o755); print('ro dir (root)',s(r)[:100]);
d.stop()
