import pty,select
from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
clean()
def wx(d,b): 
    a=cells(d.snap()); B=cells(b); return {k:(B[k],a[k]) for k in a if a[k]!=B[k]}
def tty(keys,d,args=['dataset','load','m.toml'],limit=40):
    m,sl=pty.openpty(); p=subprocess.Popen([BIN,'-p',d.tty,'-a','1','-b','115200',*args],cwd=W,env=ENV,stdin=sl,stdout=sl,stderr=sl,start_new_session=True,preexec_fn=lambda:__import__('fcntl').ioctl(0,0x540E,0)); os.close(sl); CUR[0]=p
    out=b''; t0=time.monotonic(); sent=False
    while time.monotonic()-t0<limit:
        r,_,_=select.select([m],[],[],0.3)
        if r:
            try: x=os.read(m,4096)
            except OSError: break
            if not x: break
            out+=x
        elif not sent and len(out)>200: sent=True; os.write(m,keys)
        if p.poll() is not None and not r: break
    if p.poll() is None: p.kill(); print('HUNG')
    rc=p.wait(); os.close(m); return rc,out.decode(errors='replace')
for nm,k in (('y',b'y\n'),('n',b'n\n'),('enter',b'\n'),('ctrl-c',b'\x03'),('ctrl-d',b'\x04'),('yes',b'yes\n'),('junk',b'maybe\n\n'),('ctrl-\\',b'\x1c')):
    clean(); d=Drive(); b=d.snap(); rc,o=tty(k,d); print(nm,'rc',rc,'nw',d.nw,'changed',len(wx(d,b)),'undo files',[os.path.basename(x) for x in glob.glob(W+'/m.und*')],'|',o[-160:].replace('\r\n',' / ')); d.stop()
# drive changes between plan and yes
clean(); d=Drive(); b=d.snap()
def chg(d,n,bb):
    if n==15: d.set(480,2,777)
d.hook=chg; r=run(['dataset','load','m.toml','--yes'],d); print('480 changed by another just before the writes (after plan)',r.rc,s(r)[:200], open(W+'/m.undo.toml').read().count('7.77'))
d.stop()
# another master changes value after verified
one('480@2 changed by other after verify',lambda d,n,b: d.set(480,2,777) if n==24 else None)
one('601@3 changed by other during rollback',lambda d,n,b: (d.set(480,2,777),None)[1] if n==25 else (('exc',4,6) if b[1]==6 and b[2:4]==bytes.fromhex('419c') and b[5]==2 else None))
# untouched: leftover undo file?
def h(d,n,b): return ('exc',4,6) if b[1]==101 else None
r,p,d=one('refuse first',h,doundo=False); print('undo_file field',(r.j['data'] or {}).get('undo_file'),glob.glob(W+'/m.undo*'),r.err[-200:])
r,p,d=one('runs before 1st write',lambda d,n,b:(setattr(d,'run',True) if n==14 else None),doundo=False); print('undo_file field',(r.j['data'] or {}).get('undo_file'),glob.glob(W+'/m.undo*'),r.err[-200:])
# dead at small k with rc 7
for k in (1,2,3,4): r,p,d=one('dead %d'%k,lambda d,n,b:'dead' if n==k else None,args=['--timeout','150ms'])
# resume other drive part
d=Drive(); d.clr(); d.hook=lambda d,n,b:'dead' if n==200 else None; 
for f_ in glob.glob(W+'/q*'): os.remove(f_)
run(['dataset','save','q.toml','--timeout','150ms'],d); d.hook=None; d.dead=False; d.addr=2; r=run(['dataset','save','q.toml','--resume','--timeout','150ms'],d); print(s(r)[:300]); r=run(['dataset','save','q.toml','--timeout','150ms'],d); print('without --resume:',s(r)[:300]); d.stop()
# two addresses save with directory
