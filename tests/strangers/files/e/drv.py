# own ACTIVE (ACT) with CM-485 on a pty; stdlib only
import os,sys,json,time,select,tty,threading,subprocess,signal,random,shutil,re
HERE=os.environ.get('WD','/tmp/files-e'); BIN=os.environ.get('ANTRIEB','antrieb'); os.makedirs(HERE,exist_ok=True)
ENV={k:v for k,v in os.environ.items() if not k.startswith('ANTRIEB')}
ENV.update(LANG='C.UTF-8',HOME=HERE+'/home',XDG_CONFIG_HOME=HERE+'/home/.config'); os.makedirs(HERE+'/home',exist_ok=True)
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
# n: (bits, sets, access, lo, hi, value, writable while running)
T={10:(16,1,'rw',1,8,4,0),11:(16,1,'r',0,99,0,0),30:(16,1,'rw',100,699,110,0),34:(16,1,'rw',0,999,0,0),62:(16,1,'rw',0,999,0,0),
68:(16,4,'rw',0,999,71,0),69:(16,4,'rw',0,999,72,0),70:(16,1,'rw',0,999,0,0),103:(16,1,'rw',0,999,0,0),
210:(32,1,'r',0,0,0,0),211:(16,1,'r',0,0,0,0),241:(32,1,'r',0,0,0,0),249:(16,1,'r',0,0,1,0),250:(16,1,'r',0,0,0,0),259:(16,1,'r',0,0,0,0),
269:(16,1,'r',0,0,0,0),270:(16,1,'r',0,0,0,0),411:(16,1,'r',0,0,0,0),
372:(16,4,'rw',0,60000,1390,0),373:(16,4,'rw',1,24,2,0),375:(32,4,'rw',1000,100000,5000,0),376:(16,4,'rw',1,10000,8,0),
392:(16,1,'rw',0,2,2,1),394:(16,1,'rw',1,30,1,1),395:(16,1,'rw',0,3,2,1),400:(16,1,'rw',1,8,2,0),410:(16,1,'rw',0,65535,0,1),
412:(16,4,'rw',0,44,44,1),413:(16,1,'rw',0,10000,0,1),414:(16,1,'rw',0,4,0,1),418:(32,4,'rw',0,99999,350,1),419:(32,4,'rw',0,99999,5000,1),
424:(32,4,'rw',1,999999,1000,1),425:(32,4,'rw',1,999999,1000,1),434:(16,4,'rw',1,3,3,1),
480:(32,4,'rw',-99900,99900,500,1),481:(32,4,'rw',-99900,99900,1000,1),482:(32,4,'rw',-99900,99900,2500,1),483:(32,4,'rw',-99900,99900,5000,1),
484:(32,1,'rw',-99999,99999,0,1),524:(32,1,'rw',-30000,30000,0,1),518:(32,4,'rw',0,30000,0,1),519:(32,4,'rw',0,30000,10000,1),
549:(16,1,'rw',1,2000,500,1),600:(16,4,'rw',0,1000,50,1),601:(16,4,'rw',-100,200,10,1),602:(16,4,'rw',0,100,20,1),603:(16,4,'rw',600,5600,4000,1),
604:(32,4,'rw',0,59900,5000,1),1375:(16,1,'rw',0,2,0,1),1376:(16,1,'rw',1,247,1,1)}
class E(Exception): pass
class Drv:
    def __init__(s,addr=1,ramread='cells',fault=None,unknown=4,extra=None,delay=0.0,others=()):
        s.addr=addr; s.T=dict(T); s.ramread=ramread; s.fault=fault; s.unknown=unknown; s.delay=delay; s.others=others
        s.ee={n:[t[5]]*t[1] for n,t in s.T.items()}; s.ram={n:[t[5]]*t[1] for n,t in s.T.items()}
        s.ee[1376]=[addr]; s.ram[1376]=[addr]
        s.reset(); s.p11=0; s.run=False; s.off=False; s.stop=False; s.hook=None; s.msgs=0
        s.eefail=lambda n,ds:False; s.eekeep=lambda n,ds:False; s.ramkeep=lambda n,ds:False
        if addr>=0 and not hasattr(s,'child'):
            s.m,s.sl=os.openpty(); tty.setraw(s.sl); s.tty=os.ttyname(s.sl)
            threading.Thread(target=s.loop,daemon=True).start()
    def reset(s): s.n=0; s.nw=0; s.log=[]; s.wr={}; s.eqw=[]; s.runw=[]
    def set(s,n,ds,v,ee=True,ram=True):
        for i in (range(s.T[n][1]) if ds==0 else [ds-1]):
            if ee: s.ee[n][i]=v
            if ram: s.ram[n][i]=v
    def snap(s): return {(n,i,m):v for m,c in(('ee',s.ee),('ram',s.ram)) for n in c if n not in(11,410,411) for i,v in enumerate(c[n])}
    def power(s):
        s.ram={n:list(v) for n,v in s.ee.items()}; s.run=False
    def acc(s,a,bits):
        ds,n=a>>12,a&0xfff
        if n not in s.T: s.p11=11; raise E(s.unknown)
        t=s.T[n]
        if t[0]!=bits: s.p11=14; raise E(2)
        if ds>9 or (ds%5 and t[1]==1): s.p11=2; raise E(4)
        return ds,n,t
    def read(s,a,bits):
        ds,n,t=s.acc(a,bits)
        if n==11: return s.p11
        if n==411: return 0x27 if s.run else 0x23
        if n in(210,241): return 2500 if s.run else 0
        if n==250: return 1 if s.run else 0
        if ds>=5 and s.ramread=='refused': s.p11=2; raise E(4)
        c=s.ram if ds>=5 or s.ramread=='inforce' else s.ee
        v=c[n]
        if t[1]==4 and ds%5==0:
            if len(set(v))>1: s.p11=9; raise E(4)
            return v[0]
        return v[ds%5-1] if t[1]==4 else v[0]
    def write(s,a,v,bits):
        ds,n,t=s.acc(a,bits); s.nw+=1
        if t[2]=='r': s.p11=4; raise E(4)
        if bits==32 and v>>31: v-=1<<32
        if bits==16 and v>>15 and t[3]<0: v-=1<<16
        if not t[3]<=v<=t[4]: s.p11=1; raise E(4)
        if s.run:
            s.runw.append((s.n,n,ds,v))
            if not t[6]: s.p11=8; raise E(4)
        idx=range(t[1]) if ds%5==0 else [ds%5-1]
        for i in idx:
            if not s.ramkeep(n,ds): s.ram[n][i]=v
        if ds<5 and n not in(410,484,524):
            if s.eefail(n,ds): s.p11=6; raise E(4)
            for i in idx:
                if not s.eekeep(n,ds):
                    s.wr[n,i]=s.wr.get((n,i),0)+1
                    if s.ee[n][i]==v: s.eqw.append((s.n,n,i,v))
                    s.ee[n][i]=v
    def pdu(s,b):
        h=lambda i:b[i]<<8|b[i+1]; f=b[0]
        try:
            if f==3:
                if h(3)!=1: raise E(2)
                return bytes([3,2])+(s.read(h(1),16)&0xffff).to_bytes(2,'big')
            if f==6: s.write(h(1),h(3),16); return b
            if f==100: return b[:1]+(s.read(h(1),32)&0xffffffff).to_bytes(4,'big')
            if f==101: s.write(h(1),int.from_bytes(b[3:7],'big'),32); return b
            if f==8:
                sub=h(1)
                if sub==0: return b
                if sub==10: s.msgs=0; return b
                if sub==1: return b
                if sub in(11,14): return b[:3]+(s.msgs&0xffff).to_bytes(2,'big')
                if 11<=sub<=18: return b[:3]+b'\0\0'
            raise E(1)
        except E as e: return bytes([f|0x80,e.args[0]])
    LEN={3:8,6:8,100:6,101:10,8:8,43:7}
    def loop(s):
        buf=b''; last=0
        while not s.stop:
            r,_,_=select.select([s.m],[],[],0.2 if not buf else 0.02)
            if not r: buf=b''; continue
            try: buf+=os.read(s.m,300)
            except OSError: time.sleep(.05); continue
            while len(buf)>=4:
                L=s.LEN.get(buf[1],0)
                if not L: buf=b''; break
                if len(buf)<L: break
                fr,buf=buf[:L],buf[L:]
                if crc(fr[:-2])!=fr[-2:]: buf=b''; break
                d=s if fr[0] in(0,s.addr) else next((o for o in s.others if o.addr==fr[0]),None)
                if d is None: continue
                d.serve(fr,s.m)
    def serve(s,fr,fd):
        s.n+=1; s.msgs+=1; k=s.n; s.log.append((time.monotonic(),fr.hex()))
        act=s.hook(k,fr) if s.hook else None
        if s.off or act in('drop',): return
        out=s.pdu(fr[1:-2]); 
        if fr[0]==0: return
        if act=='lost': return
        rep=bytes([fr[0]])+out; rep+=crc(rep)
        if act=='garble': rep=rep[:2]+bytes([rep[2]^0x41])+rep[3:]
        if isinstance(act,float): time.sleep(act)
        if s.delay: time.sleep(s.delay)
        os.write(fd,rep)
        if act=='dup': time.sleep(.004); os.write(fd,rep)
        if callable(act): act()
def run(d,*a,inp=None,timeout=90,cwd=None,sig=None,env=None,json_=True,pre=None,port=True):
    cmd=(pre or [])+[BIN]+(['--port',d.tty,'-a',str(d.addr)] if port else [])+(['--json'] if json_ else [])+list(a)
    t=time.monotonic()
    p=subprocess.Popen(cmd,stdin=subprocess.PIPE if inp else subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE,cwd=cwd or HERE,env=env or ENV)
    d.proc=p
    try: o,e=p.communicate(inp,timeout)
    except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); e+=b'HANG'
    class R: pass
    r=R(); r.rc=p.returncode; r.o=o.decode(errors='replace'); r.e=e.decode(errors='replace'); r.t=time.monotonic()-t
    try: r.j=json.loads(r.o)
    except Exception: r.j=None
    return r
def diffs(a,b): return {k:(a[k],b[k]) for k in a if a[k]!=b[k]}
