import os,sys,json,time,select,tty,threading,subprocess,signal,fcntl,struct,copy,random
BIN=os.environ.get('ANTRIEB', 'antrieb')
ENV={k:v for k,v in os.environ.items() if not k.startswith('ANTRIEB')}; ENV.update(LANG='C.UTF-8',HOME='/tmp/files-home'); os.makedirs(ENV['HOME'],exist_ok=True)
W=os.environ.get('WD','/tmp/files-w'); os.makedirs(W,exist_ok=True)
U,S,L,I='u16','i16','i32','u32'
def table(extra=()):
    P={}
    def par(n,t,ds=False,acc='rw',lo=None,hi=None,v=0,run=True):
        P[n]=dict(t=t,ds=ds,acc=acc,lo=lo,hi=hi,ee=[v]*4 if ds else [v],ram=[v]*4 if ds else [v],run=run,w=[0]*4 if ds else [0],rw=[0]*4 if ds else [0])
    par(10,U,lo=1,hi=6,v=4); par(11,U,acc='r'); par(30,U,v=110,run=False)
    par(103,U,v=7)
    for n in(210,241,217,228,229,282,283): par(n,L,acc='r')
    for n in(211,213,218): par(n,S,acc='r')
    for n in(249,250,254,260,269,270,411): par(n,U,acc='r')
    P[249]['ee']=P[249]['ram']=[1]
    par(372,U,True,lo=0,hi=60000,v=1390,run=False); par(373,U,True,lo=1,hi=24,v=2,run=False); par(375,L,True,lo=1000,hi=100000,v=5000,run=False); par(376,U,True,lo=1,hi=10000,v=40,run=False)
    par(392,U,True,lo=0,hi=2,v=2); par(394,U,lo=1,hi=30,v=1); par(395,U,lo=0,hi=3,v=2)
    par(400,U,lo=1,hi=8,v=2)
    par(410,U); par(412,U,True,lo=0,hi=44,v=44); par(413,U,lo=0,hi=10000,v=0); par(414,U,lo=0,hi=4,v=0)
    par(418,L,True,lo=0,hi=99999,v=350); par(419,L,True,lo=0,hi=99999,v=5000)
    for n in range(420,424): par(n,L,True,lo=1,hi=999999,v=500)
    for n in(424,425): par(n,L,True,lo=1,hi=999999,v=1000)
    par(434,U,True,lo=1,hi=3,v=3)
    for i,n in enumerate((480,481,482,483,485,486,487,488)): par(n,L,True,lo=-99900,hi=99900,v=500*(i+1))
    par(484,L,acc='w',lo=-99999,hi=99999); par(524,L,acc='w',lo=-30000,hi=30000); par(518,L,True,lo=0,hi=30000); par(519,L,True,lo=0,hi=30000,v=10000)
    par(549,U,lo=1,hi=2000,v=500); par(632,U,True,lo=0,hi=2000,v=20); par(637,U,True,lo=0,hi=1000,v=10); par(638,U,True,lo=0,hi=2000,v=5)
    par(600,U,True,lo=0,hi=1000,v=50); par(601,S,True,lo=-100,hi=200,v=10); par(602,U,True,lo=0,hi=100,v=20); par(603,U,True,lo=600,hi=5600,v=4000); par(604,L,True,lo=0,hi=59900,v=5000)
    par(1375,U,lo=0,hi=2,v=0); par(1376,U,lo=1,hi=247,v=1)
    for e in extra: par(*e[:1],**e[1])
    return P
class Exc(Exception):
    def __init__(s,c,sst=0): s.c=c; s.sst=sst
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
LEN={3:8,6:8,100:6,101:10,8:8,17:4,43:7}
class Drive:
    def __init__(s,addr=1,ram='cells',unknown=2,P=None,hook=None,delay=0.0,run=None,p30=None,life=500):
        s.addr=addr; s.ramread=ram; s.unknown=unknown; s.P=P or table(); s.hook=hook; s.delay=delay
        s.run=False; s.p30=p30; s.n=0; s.nw=0; s.log=[]; s.sst=0; s.dead=False; s.silent=0; s.viol=[]; s.wlog=[]
        s.open()
        s.end=time.monotonic()+life; s.stopf=False; s.hup=False
        s.th=threading.Thread(target=s.loop,daemon=True); s.th.start()
    def open(s):
        s.m,s.s=os.openpty(); tty.setraw(s.s); s.tty=os.ttyname(s.s)
    def snap(s): return {n:(list(p['ee']),list(p['ram'])) for n,p in s.P.items() if p['acc']=='rw' and n not in(410,)}
    def cnt(s): return {(n,i):w for n,p in s.P.items() for i,w in enumerate(p['w']) if w}
    def clr(s):
        for p in s.P.values(): p['w']=[0]*len(p['w']); p['rw']=[0]*len(p['rw'])
        s.n=0; s.nw=0; s.log=[]; s.wlog=[]
    def set(s,n,i,v,ram=True,ee=True):
        p=s.P[n]; idx=range(len(p['ee'])) if (not p['ds'] or i==0) else [i-1]
        for k in idx:
            if ee: p['ee'][k]=v
            if ram: p['ram'][k]=v
    def power(s):
        for p in s.P.values(): p['ram']=list(p['ee'])
        s.run=False
    def a(s,addr,size):
        n=addr&0xFFF; ds=addr>>12
        if ds>9 or n not in s.P: raise Exc(s.unknown if n<1600 else 4,11)
        p=s.P[n]
        if (p['t'] in(L,I))!=(size==32): raise Exc(2,14)
        if ds%5 and not p['ds']: raise Exc(4,2)
        if n in(410,484,524) and ds: raise Exc(4,2)
        if ds>=5 and s.ramread=='refused_all': raise Exc(4,2)
        return n,p,ds
    def rd(s,addr,size):
        n,p,ds=s.a(addr,size)
        if p['acc']=='w': raise Exc(4,3)
        if ds>=5 and s.ramread=='refused': raise Exc(4,2)
        if n==11: v=s.sst; s.sst=0
        elif n==411: v=0x37 if s.run else 0x50
        elif n==241 or n==210: v=3000 if s.run else 0
        elif n==250: v=3 if s.run else 0
        elif n==249: v=p['ee'][0]
        else:
            src=p['ee'] if (ds<5 and s.ramread in('cells',)) else p['ram']
            k=ds%5
            if p['ds'] and k==0:
                if len(set(src))>1: raise Exc(4,9)
                v=src[0]
            else: v=src[k-1] if p['ds'] else src[0]
        return v&(0xFFFFFFFF if size==32 else 0xFFFF)
    def wr(s,addr,v,size):
        n,p,ds=s.a(addr,size); s.nw+=1
        if p['acc']=='r': raise Exc(4,4)
        if size==32 and v>=1<<31: v-=1<<32
        if p['t']==S and v>=1<<15: v-=1<<16
        if p['lo'] is not None and v<p['lo'] or p['hi'] is not None and v>p['hi']: raise Exc(4,1)
        if s.run and not p['run']: raise Exc(4,8)
        if n==11: return
        k=ds%5; idx=range(len(p['ram'])) if (not p['ds'] or k==0) else [k-1]
        eq=[]
        for i in idx:
            if ds<5 and n not in(410,484,524):
                if p['ee'][i]==v and p['ram'][i]==v: eq.append(i)
                p['ee'][i]=v; p['w'][i]+=1
            elif p['ram'][i]==v: eq.append(i)
            p['ram'][i]=v; p['rw'][i]+=1
        s.wlog.append((s.n,n,ds,v,eq))
        if n==30 and s.p30: s.p30(s)
    def pdu(s,b):
        fc=b[0]; h=lambda i:b[i]<<8|b[i+1]
        try:
            if fc==3:
                if h(3)!=1: raise Exc(2)
                v=s.rd(h(1),16); return bytes([3,2,v>>8,v&255])
            if fc==6: s.wr(h(1),h(3),16); return b
            if fc==100: return bytes([100])+s.rd(h(1),32).to_bytes(4,'big')
            if fc==101: s.wr(h(1),int.from_bytes(b[3:7],'big'),32); return b
            if fc==8:
                if 10<=h(1)<=18:
                    v=s.n&0xffff if h(1) in(11,14) else 0
                    return b[:3]+bytes([v>>8,v&255])
                if h(1)==0: return b
            raise Exc(1)
        except Exc as e:
            if e.sst: s.sst=e.sst
            return bytes([fc|0x80,e.c])
    def loop(s):
        buf=b''
        while not s.stopf and time.monotonic()<s.end:
            try: r,_,_=select.select([s.m],[],[],0.2)
            except (OSError,ValueError): 
                if s.hup: time.sleep(0.1); continue
                break
            if not r: buf=b''; continue
            try: x=os.read(s.m,4096)
            except OSError: time.sleep(0.05); continue
            buf+=x
            while len(buf)>=2:
                l=LEN.get(buf[1])
                if l is None:
                    time.sleep(0.01); s.log.append(('?',buf.hex())); buf=b''; break
                if len(buf)<l: break
                fr,buf=buf[:l],buf[l:]
                if crc(fr[:-2])!=fr[-2:]: s.log.append(('CRC',fr.hex())); buf=b''; break
                s.frame(fr)
    def frame(s,fr):
        body=fr[:-2]
        if body[0] not in(0,s.addr) : return
        s.n+=1
        act=s.hook(s,s.n,body) if s.hook else None
        if s.dead or time.monotonic()<s.silent: s.log.append((s.n,'DEAD',body.hex())); return
        if act=='drop': s.log.append((s.n,'DROP',body.hex())); return
        if act=='dead': s.dead=True; s.log.append((s.n,'DEAD',body.hex())); return
        if isinstance(act,tuple) and act[0]=='exc': r=bytes([body[1]|0x80,act[1]]); s.sst=act[2]
        elif isinstance(act,tuple) and act[0]=='power': s.power(); s.silent=time.monotonic()+act[1]; return
        else: r=s.pdu(body[1:])
        if isinstance(act,tuple) and act[0]=='powerafter': s.power(); s.silent=time.monotonic()+act[1]; return
        s.log.append((s.n,body.hex(),r.hex()))
        if act=='lost': return
        if act=='deadafter': s.dead=True; return
        if act=='hup':
            s.hup=True; s.dead=True
            try: os.close(s.s); os.close(s.m)
            except OSError: pass
            return
        if body[0]==0: return
        d=s.delay
        if isinstance(act,tuple) and act[0]=='late': d=act[1]
        if d: time.sleep(d)
        w=bytes([body[0]])+r; w+=crc(w)
        if act=='garble': w=w[:2]+bytes([w[2]^0x10])+w[3:]
        try: os.write(s.m,w)
        except OSError: pass
    def stop(s):
        s.stopf=True; s.th.join(1)
        for f in(s.m,s.s):
            try: os.close(f)
            except OSError: pass
class Run: pass
CUR=[None]
def run(args,d=None,limit=120,js=True,addr=None,baud=115200,cwd=W,kill_after=None,pre=None,stdin=subprocess.DEVNULL,bg=False,on=None):
    a=[BIN]
    if d is not None: a+=['-p',d if isinstance(d,str) else d.tty,'-a',str(addr if addr is not None else (d.addr if not isinstance(d,str) else 1))]
    if d is not None and not isinstance(d,str) and baud: a+=['-b',str(baud)]
    a+=[str(x) for x in args]
    if js and '--format' not in a: a+=['--json']
    r=Run(); r.args=a; t0=time.monotonic()
    r.p=subprocess.Popen(a,stdin=stdin,stdout=subprocess.PIPE,stderr=subprocess.PIPE,env=ENV,cwd=cwd,start_new_session=True,preexec_fn=pre); CUR[0]=r.p
    if on: threading.Thread(target=on,args=(r.p,),daemon=True).start()
    r.hung=False
    try: o,e=r.p.communicate(timeout=limit)
    except subprocess.TimeoutExpired: r.hung=True; r.p.kill(); o,e=r.p.communicate()
    r.t=time.monotonic()-t0; r.out=o.decode(errors='replace'); r.err=e.decode(errors='replace'); r.rc=r.p.returncode
    try: r.j=json.loads(r.out)
    except Exception: r.j=None
    return r
def show(r,n=1500): print('rc',r.rc,'t %.1f'%r.t,'HUNG' if r.hung else ''); print(r.out[:n]); print(r.err[-n:])
