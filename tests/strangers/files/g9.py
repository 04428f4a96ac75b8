from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
import resource
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
src=open('g8.py').read()
def wx(d,b): 
    a=cells(d.snap()); B=cells(b); return {k:(B[k],a[k]) for k in a if a[k]!=B[k]}
exec(src[src.index('class Lie'):src.index("lcase('ack without")])
class Lie2(Lie):
    def wr(s,addr,v,size):
        n=addr&0xfff
        if n in (s.eeerr or {}) and addr>>12<5:
            p=s.P[n]; o=list(p['ee']); Drive.wr(s,addr,v,size); p['ee']=o; raise Exc(4,6)
        return super().wr(addr,v,size)
Lie2.eeerr=None
Lie=Lie2
def ee(nm,ns,**k):
    Lie2.eeerr=ns; lcase(nm,**k); Lie2.eeerr=None
ee('ee error, ram taken, 1st (419)',{419}); ee('ee error, ram taken, 3rd (480)',{480}); ee('same, value drive',{480},ram='ramval'); ee('same, ram unreadable',{480},ram='refused')
# eeprom only, repeated load
clean(); d=Lie2(); d.lie={480:'eeonly'}; 
for i in range(4):
    d.clr(); r=run(['dataset','load','m.toml','--yes'],d); print('load',i,'rc',r.rc,'ee writes',d.cnt(),[(v['param'],v['result'],v['note']) for v in rowsof(r.j) if v['param']==480],'ram',d.P[480]['ram'],[w['message'] for w in r.j['warnings']])
r=run(['dataset','check','m.toml'],d); print('check',r.rc); d.stop()
# trace, long load
L=H+''.join('"%d"="%d.00 Hz"\n'%(n,i+20) for i,n in enumerate((480,481,482,483,485,486,487,488)))
open(W+'/long.toml','w').write(L)
for n in (3000,3500,4500,6000):
    for x in glob.glob(W+'/long.undo*')+glob.glob(W+'/tr'): os.remove(x)
    d=Drive(); b=d.snap(); r=run(['dataset','load','long.toml','--yes','--trace','tr'],d,pre=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,(n,n))); print('trace ulimit',n,'rc',r.rc,'nw',d.nw,'cells changed',len(wx(d,b)),'trace',os.path.getsize(W+'/tr'),'undo',os.path.exists(W+'/long.undo.toml'),r.err[-100:] if r.rc!=0 else '')
    u=run(['dataset','undo','long.undo.toml','--yes'],d); print('   undo',u.rc,d.snap()==b); d.stop()
os.makedirs('/tmp/n22fs',exist_ok=True); m=subprocess.run(['mount','-t','tmpfs','-o','size=8k','tmpfs','/tmp/n22fs'])
open('/tmp/n22fs/fill','wb').write(b'x'*4096)
for x in glob.glob(W+'/long.undo*'): os.remove(x)
d=Drive(); b=d.snap(); r=run(['dataset','load','long.toml','--yes','--trace','/tmp/n22fs/tr'],d); print('trace full disk rc',r.rc,'nw',d.nw,len(wx(d,b)),'trace',os.path.getsize('/tmp/n22fs/tr'),s(r)[-250:],r.err[-200:]); d.stop()
subprocess.run(['umount','/tmp/n22fs'])
# refusal then line dead in rollback, alive again
for k in range(27,34,2):
    st={}
    def h(d,n,b):
        if b[1]==6 and b[2:4]==bytes.fromhex('419c') and int.from_bytes(b[4:6],'big')==2: return ('exc',4,6)
        if n==k: threading.Timer(6,lambda: setattr(d,'dead',False)).start(); return 'dead'
    one('refuse 412, dead at %d for 6 s'%k,h,args=['--timeout','150ms'])
