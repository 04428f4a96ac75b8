import os,pty,tty,time,select,signal,subprocess,sys,struct,fcntl,termios,heapq,json,random
BIN=os.environ.get('ANTRIEB','target/debug/antrieb')
CH=11/19200.
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return struct.pack('<H',c)
class Act:
    kind='act'
    def __init__(s,addr,speed=40.,model='act',p412=1,delay=.010,dead=False,refuse=False,twice=0,stale=0,lie=None,
                 qs=20.,ramp=10.,coast=None,p392=2,coast_shows='nothing',encoder='none',deadfor=0,ignore=False,late_words=0,jit=0,running=True,start=True,deadafter=None,stateafterqs=0x40,slowfirst=0,holdt=1.0):
        s.__dict__.update(locals()); del s.__dict__['s']
        s.a=addr; s.v=speed; s.set=speed if running else 0.; s.state=0x27 if running else 0x23
        s.mode='run'; s.coastrate=(speed/coast) if coast else 15.
        s.t=None; s.cw=0xF if running else 7; s.p11=0; s.hist=[]; s.words=[]; s.cmds=[]; s.hold=None; s.p484=int(speed*100) if running else 0; s.n=0
        s.pos=0.
    def step(s,now):
        if s.t is None: s.t=now
        while s.t<now:
            dt=min(.02,now-s.t); s.t+=dt
            tgt,rate=s.set,s.ramp
            if s.mode=='coast': tgt,rate=0,s.coastrate
            elif s.mode=='qs': tgt,rate=0,s.qs
            elif s.mode=='t5': tgt=0
            elif s.mode=='off': tgt,rate=0,s.coastrate
            d=tgt-s.v
            s.v = tgt if abs(d)<=rate*dt else s.v+(rate*dt if d>0 else -rate*dt)
            s.pos+=s.v*dt
            if s.v==0:
                if s.mode=='qs':
                    if s.hold is None: s.hold=s.t+s.holdt
                    if s.t>=s.hold: s.state=s.stateafterqs; s.mode='off'; s.hold=None
                elif s.mode=='t5':
                    if s.hold is None: s.hold=s.t+s.holdt
                    if s.t>=s.hold: s.state=0x23; s.mode='off'; s.hold=None
            s.hist.append((s.t,s.sw(),s.f210()))
        if len(s.hist)>2000: s.hist=s.hist[-1000:]
    def f210(s):
        if s.mode in('coast','off') and s.coast_shows=='nothing': return 0
        return int(s.v*100)
    def sw(s):
        w=s.state
        if s.model=='acu': w|=0x10
        if s.p412==1 and s.start: w|=0x200
        if s.mode=='run' and abs(s.v-s.set)<.01 : w|=0x400
        return w
    def word(s,cw,now):
        old=s.cw; s.cw=cw; s.words.append((now,cw))
        if s.ignore or s.p412!=1: return
        if cw&2==0:
            if s.state in(0x27,7): s.mode='coast' 
            if s.state in(0x27,7,0x23,0x21): s.state=0x40
        elif cw&4==0:
            if s.state==0x27: s.state=7; s.mode='qs'
            elif s.model=='acu' and s.state in(0x21,0x23): s.state=0x40
        elif cw&1==0:
            if s.state==0x27: s.mode='coast'; s.state=0x21
            elif s.state in(0x40,0x23): s.state=0x21
        elif cw&8==0:
            if s.state==0x27:
                if s.p392==2: s.mode='t5'
                else: s.mode='coast'; s.state=0x23
            elif s.state==0x21: s.state=0x23
        else:
            if s.state in (0x40,0x21,0x23,0x27): s.state=0x27; s.mode='run'
    def p16(s,p,ds):
        d={411:s.sw(),410:s.cw,249:1,412:s.p412,413:0,392:s.p392,11:s.p11,260:0,270:0,30:110,434:2,250:7,10:4,395:2 if 0 else 1,414:0,211:12,475:1,638:3,637:10,1375:0,1376:s.a}
        return d.get(p)
    def p32(s,p,ds):
        d={210:s.f210(),241:s.f210(),484:s.p484,282:s.p484,283:s.p484,228:0,418:0,419:5000,420:int(s.ramp*100),421:int(s.ramp*100),422:int(s.ramp*100),423:int(s.ramp*100),424:int(s.qs*100),425:int(s.qs*100),480:0,481:0,482:0,483:0}
        if s.encoder=='shaft': d[217]=int(s.v*100); d[218]=0
        if s.encoder=='zero': d[217]=0; d[218]=0
        return d.get(p)
    def handle(s,f,now,rep):
        s.step(now); s.n+=1
        if s.dead or (s.deadfor and now<rep.t0+s.deadfor) or (s.deadafter is not None and s.n>s.deadafter):
            return None
        b=None; fc=f[1]
        def ex(c): return bytes([s.a,fc|0x80,c])
        if fc==3:
            r,n=struct.unpack('>HH',f[2:6]); p=r&0xFFF
            if n!=1: b=ex(2)
            else:
                v=s.p16(p,r>>12)
                if s.lie and p==411: v=s.lie(s,v,now,rep)
                if s.stale and p==411:
                    o=[h for h in s.hist if h[0]<=now-s.stale]; v=o[-1][1] if o else (s.hist[0][1] if s.hist else v)
                if v is None: s.p11=11; b=ex(4)
                else:
                    b=bytes([s.a,3,2])+struct.pack('>H',v&0xFFFF)
                    if p==11: s.p11=0
        elif fc==0x64:
            r,=struct.unpack('>H',f[2:4]); v=s.p32(r&0xFFF,r>>12)
            if s.stale and r&0xFFF==210:
                o=[h for h in s.hist if h[0]<=now-s.stale]; v=o[-1][2] if o else (s.hist[0][2] if s.hist else v)
            if v is None: s.p11=14 if s.p16(r&0xFFF,0) is not None else 11; b=ex(4)
            else: b=bytes([s.a,0x64])+struct.pack('>i',v)
        elif fc==6:
            r,v=struct.unpack('>HH',f[2:6]); p=r&0xFFF
            if p==410:
                s.cmds.append((now,v))
                if s.refuse: s.p11=s.refuse; b=ex(4)
                else: s.word(v,now); b=f[:6]
            else: 
                if s.p16(p,0) is None: s.p11=11; b=ex(4)
                else:
                    s.cmds.append((now,'P%d=%d'%(p,v)))
                    if p==412: s.p412=v
                    b=f[:6]
        elif fc==0x65:
            r,v=struct.unpack('>Hi',f[2:8])
            s.cmds.append((now,'P%d=%d'%(r&0xFFF,v)))
            if s.refuse: s.p11=s.refuse; b=ex(4)
            else:
                if r&0xFFF==484:
                    s.p484=v
                    if s.p412==1: s.set=v/100.
                b=f[:8]
        elif fc==8: b=f[:6]
        else: b=ex(1)
        return b
    def running(s): return abs(s.v)>.05
class Lxm:
    kind='lxm'
    def __init__(s,addr,speed=1000.,delay=.010,dead=False,refuse=False,twice=0,qs=800.,dec=400.,jit=0,stays=True,control7='coasts'):
        s.__dict__.update(locals()); del s.__dict__['s']
        s.a=addr; s.v=speed; s.set=speed; s.state=0x27; s.mode='run'; s.t=None; s.cw=0xF; s.cmds=[]; s.words=[]; s.pos=0.; s.n=0; s.opmode=3; s.regs={6938:int(speed),1556:2000,1558:int(dec),1554:6000,5646:0,5644:0,5640:addr,6920:3,6918:3}
    def step(s,now):
        if s.t is None: s.t=now
        while s.t<now:
            dt=min(.02,now-s.t); s.t+=dt
            tgt,rate=s.set,s.dec
            if s.mode=='coast': tgt,rate=0,150.
            elif s.mode=='qs': tgt,rate=0,s.qs
            elif s.mode=='off': tgt,rate=0,150.
            d=tgt-s.v
            s.v=tgt if abs(d)<=rate*dt else s.v+(rate*dt if d>0 else -rate*dt)
            s.pos+=s.v*dt*16384/60
            if s.v==0 and s.mode=='qs' and not s.stays: s.state=0x40; s.mode='off'
    def sw(s):
        w=s.state|0x10|0x200
        if s.mode=='run' and s.v==s.set: w|=0x400
        return w
    def word(s,cw,now):
        s.words.append((now,cw)); s.cw=cw
        if cw&2==0:
            if s.state in(0x27,7): s.mode='coast'
            s.state=0x40
        elif cw&4==0:
            if s.state==0x27: s.state=7; s.mode='qs'
            elif s.state in(0x21,0x23): s.state=0x40
        elif cw&1==0:
            if s.state==0x27: s.mode='coast'
            if s.state!=7: s.state=0x21
        elif cw&8==0:
            if s.state==0x27: s.mode='coast'; s.state=0x23
            elif s.state==0x21: s.state=0x23
        else:
            if s.state in(0x23,0x27): s.state=0x27; s.mode='run'
    def get(s,r):
        if r==6916: return s.sw()
        if r==6914: return s.cw
        if r==7700: return int(s.pos)&0xFFFFFFFF
        return s.regs.get(r)
    def handle(s,f,now,rep):
        s.step(now); s.n+=1
        if s.dead: return None
        fc=f[1]
        def ex(c): return bytes([s.a,fc|0x80,c])
        if fc==3:
            r,n=struct.unpack('>HH',f[2:6])
            if n%2: return ex(3) if r%2==0 else ex(2)
            out=b''
            for i in range(n//2):
                v=s.get(r+2*i)
                if v is None: return ex(2)
                out+=struct.pack('>I',v)
            return bytes([s.a,3,len(out)])+out
        if fc==16:
            r,n,k=struct.unpack('>HHB',f[2:7])
            if n!=2: return ex(3)
            v,=struct.unpack('>I',f[7:11])
            s.cmds.append((now,v if r==6914 else '%d=%d'%(r,v)))
            if s.refuse: return ex(4)
            if r==6914:
                if v>0xFFFF: return ex(3)
                s.word(v,now)
            elif r in s.regs or r in(6918,):
                s.regs[r]=v
                if r==6938: s.set=v if v<2**31 else v-2**32
            else: return ex(2)
            return f[:6]
        if fc==0x2B:
            o=[(0,b'Schneider Electric'),(1,b'LXM05AD10M2'),(2,b'V1.201')]
            b=bytes([s.a,0x2B,0x0E,1,1,0,0,3])
            for i,t in o: b+=bytes([i,len(t)])+t
            return b
        if fc==8: return f[:6]
        return ex(1)
    def running(s): return abs(s.v)>1
def flen(b):
    if len(b)<2: return None
    fc=b[1]
    if fc in(3,6,8,4,1,2,5): return 8
    if fc==0x64: return 6
    if fc==0x65: return 10
    if fc==0x10: return 9+b[6] if len(b)>6 else None
    if fc==0x2B: return 7
    if fc==0x17: return 13+b[10] if len(b)>10 else None
    return 0
class Run: pass
def run(drives,args,signals=(),term=None,maxt=60,cwd=None,env=None,hangup=None,echo=False,quiet=False,after=0,keys=()):
    R=Run(); R.log=[]
    m,sl=pty.openpty(); tty.setraw(m); tty.setraw(sl); name=os.ttyname(sl)
    D={d.a:d for d in drives}
    out=b'';err=b''
    argv=[BIN,'-p',name,'--no-config' if not cwd else '-q']+args
    if cwd: argv.remove('-q')
    e=dict(os.environ); e.update(env or {}); 
    R.t0=time.monotonic()
    for d in drives: d.step(R.t0)
    tm=None
    if term:
        tm,ts=pty.openpty(); fcntl.ioctl(ts,termios.TIOCSWINSZ,struct.pack('HHHH',24,80,0,0)); 
        e['TERM']='xterm'; e['COLUMNS']=''; e.pop('COLUMNS')
        def pre():
            os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
        p=subprocess.Popen(argv,stdin=ts,stdout=ts,stderr=ts,env=e,preexec_fn=pre,cwd=cwd); os.close(ts)
        fds={tm:'o'}
    else:
        p=subprocess.Popen(argv,stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE,env=e,cwd=cwd)
        fds={p.stdout.fileno():'o',p.stderr.fileno():'e'}
    buf=b''; pend=[]; seq=0; sigs=list(signals); R.first=None; R.errlog=[]
    R.end=None; busy=0
    while True:
        now=time.monotonic()
        while sigs and now>=R.t0+sigs[0][0]:
            t,sg=sigs.pop(0)
            R.log.append((now-R.t0,'SIG',str(sg)))
            if sg=='HUP':
                if tm is not None: os.close(tm); fds.pop(tm,None); tm=None
            elif sg=='^C': os.write(tm,b'\x03')
            elif sg=='UNPLUG': pass
            elif callable(sg): sg(D)
            else:
                try: p.send_signal(sg)
                except Exception: pass
        while pend and pend[0][0]<=now:
            _,_,b=heapq.heappop(pend)
            R.log.append((now-R.t0,'<',b.hex(' ')))
            os.write(m,b)
        if p.poll() is not None and R.end is None:
            R.end=now; R.v_end={a:(d.step(now),round(d.v,2))[1] for a,d in D.items()}
        if R.end is not None and not fds: break
        if R.end is not None and now>R.end+.3: break
        if now>R.t0+maxt:
            R.log.append((now-R.t0,'KILL','')); p.kill(); R.hang=True; maxt+=5
        to=.05
        if pend: to=min(to,max(0,pend[0][0]-now))
        try: r,_,_=select.select([m]+list(fds),[],[],to)
        except OSError: break
        now=time.monotonic()
        for fd in r:
            if fd==m:
                try: x=os.read(m,4096)
                except OSError: continue
                buf+=x
                while buf:
                    n=flen(buf)
                    if n is None or (n and len(buf)<n): break
                    if n==0: R.log.append((now-R.t0,'?',buf.hex(' '))); buf=b''; break
                    f,buf=buf[:n],buf[n:]
                    if crc(f[:-2])!=f[-2:]: R.log.append((now-R.t0,'?crc',f.hex(' '))); continue
                    R.log.append((now-R.t0,'>',f.hex(' ')))
                    if R.first is None: R.first=now
                    if f[0]==0:
                        for d in D.values(): d.handle(bytes([d.a])+f[1:],now,R)
                        continue
                    d=D.get(f[0])
                    if not d: continue
                    b=d.handle(f,now,R)
                    if b is None: continue
                    b=b+crc(b)
                    dl=d.delay
                    if d.jit: dl+=random.random()*d.jit
                    t=max(now+len(f)*CH+dl+len(b)*CH, busy); seq+=1
                    heapq.heappush(pend,(t,seq,b))
                    if d.twice: seq+=1; heapq.heappush(pend,(t+d.twice,seq,b))
            else:
                try: x=os.read(fd,65536)
                except OSError: x=b''
                if not x: fds.pop(fd,None); continue
                if fds[fd]=='o': out+=x
                else: err+=x
                R.errlog.append((now-R.t0,x))
    R.rc=p.wait(); R.dur=R.end-R.t0; R.out=out.decode('utf8','replace'); R.err=err.decode('utf8','replace'); R.D=D
    for fd in (m,sl)+((tm,) if tm is not None else ()):
        os.close(fd)
    if not quiet: show(R,args)
    return R
def show(R,args):
    print('$ antrieb10 -p PTY',' '.join(args)); print('rc',R.rc,'dur %.2f'%R.dur,'HANG' if getattr(R,'hang',0) else '')
    for a,d in R.D.items():
        print('  %3d %-4s v_end=%7.2f state=%02x mode=%s words: %s'%(a,d.kind,R.v_end[a],d.state,d.mode,' '.join('%.2f:%s'%(t-R.t0,('%02X'%w) if isinstance(w,int) else w) for t,w in d.cmds) if not d.dead else 'DEAD '+' '.join('%.2f'%t for t,k,b in R.log if k=='>' and int(b[:2],16)==a)))
    for l in R.log:
        if l[1] in('SIG','KILL'): print('  %.2f %s %s'%l)
    print('--out'); print(R.out.rstrip()); print('--err'); print(R.err.rstrip()); print('=======')
