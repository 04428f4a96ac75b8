"""My line: several strict drives (ACTIVE Cube / ACT after the CM-485 manual, LXM05), a hostile wire in Python hooks, signals, terminal."""
import os,sys,pty,tty,time,select,signal,subprocess,struct,fcntl,termios,heapq,json,random
H=os.path.dirname(os.path.abspath(__file__))
sys.path[:0]=[H+'/../active',H+'/../lexium']
import active_drive as A
from lexium05 import Device,Readings
BIN=os.environ.get('ANTRIEB','target/debug/antrieb')
CH=11/19200.
crc=lambda b:A.with_crc(b)
class Cube:
    kind='act'
    def __init__(s,opt='',addr=1,proto='rtu'):
        s.opt=A.options('--family acu --address %d --protocol %s '%(addr,proto)+opt); s.addr=addr; s.proto=proto; s.sins=[]
        s.t0=time.monotonic()
        s.d=A.Drive(s.opt,lambda n,x='':s.sins.append((round(time.monotonic()-s.t0,3),n,x)),s.t0)
        s.p=A.PROTOCOLS[proto](s.d,s.opt,s.d.sin)
        s.mb=getattr(s.p,'modbus',None)
        s.before=s.d.settings(); s.dead=False
    def advance(s,now): s.d.advance(now)
    def speed(s): return s.d.shaft
    def state(s): return s.d.state
    @property
    def enabled(s): return s.d.first_enabled
    def rtu(s,f,now):
        if s.d.booting_until is not None: return None
        r,e=s.mb.answer(f[:-2],now)
        if e=='reboot': s.d.reboot(now)
        return crc(r) if r else None
    def diff(s):
        n=s.d.settings(); b=s.before
        r={k:(b.get(k),n.get(k)) for k in set(b)|set(n) if b.get(k)!=n.get(k)}
        if s.d.line_setpoint!=round(s.opt.left*100): r['484']=(round(s.opt.left*100),s.d.line_setpoint)
        return r
    def wear(s): return [(round(t-s.t0,2),n,k,v) for t,n,k,v in s.d.wear]
class Lx:
    kind='lxm'; proto='rtu'
    def __init__(s,addr=1,**k):
        s.addr=addr; s.t0=time.monotonic(); s.d=Device(Readings(**k),s.t0); s.d.value['MBadr']=addr if 'MBadr' in s.d.value else None
        s.en=None; s.dead=False; s.before=dict(s.d.value)
    def advance(s,now):
        s.d.advance(now)
        if s.en is None and s.d.state=='enabled': s.en=now
    def speed(s): return s.d.axis.speed
    def state(s): return s.d.state
    @property
    def enabled(s): return s.en
    def rtu(s,f,now):
        r=s.d.serve(f[1:-2],f[0]==0)
        return crc(bytes([s.addr])+r) if r else None
    def diff(s): return {k:(v,s.d.value.get(k)) for k,v in s.before.items() if s.d.value.get(k)!=v}
    def wear(s): return []
    @property
    def sins(s): return s.d.sins
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
def tell(f):
    """a telegram in short, or None for a read"""
    fc=f[1]
    if fc==6: r,v=struct.unpack('>HH',f[2:6]); return '%d:P%d@%d=%s'%(f[0],r&0xFFF,r>>12,hex(v) if r&0xFFF==410 else v)
    if fc==0x65: r,v=struct.unpack('>Hi',f[2:8]); return '%d:P%d@%d=%d'%(f[0],r&0xFFF,r>>12,v)
    if fc==0x10:
        r,=struct.unpack('>H',f[2:4]); v,=struct.unpack('>i',f[7:11]); return '%d:R%d=%s'%(f[0],r,hex(v) if r==6914 else v)
    if fc==0x17: return '%d:fc23 %s'%(f[0],f.hex())
    return None
class R: pass
def run(drives,args,hook=None,inject=(),triggers=(),term=False,maxt=60,turn=.010,echo=None,quiet=False,after=.5,cwd=None,env=None,out='pipe',show_all=False,typed=(),verbose_line=False,dropterm=None,label=''):
    """hook(c,f,reply,now,d)->[(delay,bytes)]; triggers: [(pred(c,now)->bool, act(c))]; inject: [(from,period,bytes or fn(c))]; typed [(pred,text)]"""
    c=R(); c.D={d.addr:d for d in drives}; c.drives=drives; c.log=[]; c.n=0; c.mute=False; c.nohear=False; c.m=None; c.words=[]; c.frames=[]; c.rnd=random.Random(1)
    m,sl=pty.openpty(); tty.setraw(m); tty.setraw(sl); c.m=m; c.sl=sl; name=os.ttyname(sl); c.name=name
    argv=[BIN,'-p',name]+([] if cwd else ['--no-config'])+args; c.args=args
    e=dict(os.environ); e.update({'LC_ALL':'C.UTF-8','LANG':'C.UTF-8'}); e.update(env or {})
    c.out=b'';c.err=b''; c.tty=b''; c.hang=False
    c.t0=time.monotonic()
    kw=dict(env=e,cwd=cwd)
    tm=None
    if term:
        tm,ts=pty.openpty(); fcntl.ioctl(ts,termios.TIOCSWINSZ,struct.pack('HHHH',24,100,0,0)); e['TERM']='xterm'
        def pre(): os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
        if term=='in':  # terminal for stdin and stderr, stdout a pipe
            p=subprocess.Popen(argv,stdin=ts,stdout=subprocess.PIPE,stderr=ts,preexec_fn=pre,**kw); fds={tm:'t',p.stdout.fileno():'o'}
        else:
            p=subprocess.Popen(argv,stdin=ts,stdout=ts,stderr=ts,preexec_fn=pre,**kw); fds={tm:'t'}
        os.close(ts)
    else:
        so=subprocess.PIPE if out=='pipe' else open(out,'w')
        p=subprocess.Popen(argv,stdin=subprocess.DEVNULL,stdout=so,stderr=subprocess.PIPE,**kw)
        fds={p.stderr.fileno():'e'}
        if out=='pipe': fds[p.stdout.fileno()]='o'
    c.p=p; c.tm=tm
    def hup():
        if c.tm is not None: fds.pop(c.tm,None); os.close(c.tm); c.tm=None
    c.hup=hup
    def unplug():
        if c.m is not None: os.close(c.m); os.close(c.sl); c.m=None; c.log.append((time.monotonic()-c.t0,'UNPLUG',''))
    c.unplug=unplug
    pend=[]; seq=[0]; free=[0.]
    def send(at,b):
        seq[0]+=1; heapq.heappush(pend,(at,seq[0],b))
    c.send=send
    inj=[[c.t0+x[0],x[1],x[2]] for x in inject]; trig=list(triggers); trig+=[(pr,(lambda t:(lambda cc: os.write(cc.tm,t.encode()) if cc.tm is not None else None))(t)) for pr,t in typed]
    buf=b''; bt=0; end=None; lastlook=0; c.hist=[]; c.polled=0
    def act_on(f,now):
        c.n+=1; c.log.append((now-c.t0,'>',f.hex(' '))); c.frames.append((now-c.t0,f))
        w=tell(f)
        if w: c.words.append((now-c.t0,w))
        if c.nohear: return
        for d in drives:
            if d.proto!='rtu' or d.dead: continue
            if f[0]==0: d.advance(now); d.rtu(f,now); continue
            if f[0]!=d.addr: continue
            d.advance(now); r=d.rtu(f,now)
            if r is None and not hook: continue
            base=now+len(f)*CH
            outs=[(turn,r)] if not hook else hook(c,f,r,now,d)
            if c.mute: continue
            for dl,b in outs or ():
                if b: send(base+dl+len(b)*CH,b)
    while True:
        now=time.monotonic()
        if now-lastlook>.02:
            lastlook=now
            for d in drives: d.advance(now)
            c.hist.append((now-c.t0,[(d.state(),round(d.speed(),2)) for d in drives]))
        for t in list(trig):
            if t[0](c,now):
                trig.remove(t); c.log.append((now-c.t0,'TRIG','')); c.words.append((now-c.t0,'!%s'%getattr(t[1],'__name__','act'))); t[1](c)
        for x in inj:
            while x[0]<=now and c.m is not None:
                b=x[2](c) if callable(x[2]) else x[2]
                if b:
                    try: os.write(c.m,b)
                    except OSError: pass
                x[0]=max(x[0]+x[1],now-.2)
        while pend and pend[0][0]<=now:
            _,_,b=heapq.heappop(pend)
            if c.m is None: continue
            c.log.append((now-c.t0,'<',b.hex(' ')))
            try: os.write(c.m,b)
            except OSError: pass
        rc=p.poll()
        if rc is not None and end is None:
            end=now; c.rc=rc; c.dur=now-c.t0
            for d in drives: d.advance(now)
            c.end=[(d.state(),round(d.speed(),2)) for d in drives]
        if end is not None and now>end+after: break
        if now>c.t0+maxt and end is None:
            c.hang=True; p.kill(); c.log.append((now-c.t0,'KILL',''))
            maxt+=10
        to=.02
        if pend: to=min(to,max(0,pend[0][0]-now))
        for x in inj: to=min(to,max(0,x[0]-now))
        rd=([c.m] if c.m is not None else [])+list(fds)
        try: r,_,_=select.select(rd,[],[],to)
        except (OSError,ValueError): r=[]
        now=time.monotonic()
        for fd in r:
            if fd==c.m:
                try: x=os.read(fd,4096)
                except OSError: continue
                if echo=='whole': send(now+.001,x)
                if callable(echo): echo(c,x,now)
                v=[d for d in drives if d.proto=='vabus']
                if v:
                    c.log.append((now-c.t0,'>',x.hex(' '))); c.frames.append((now-c.t0,x))
                    for d in v:
                        if d.dead: continue
                        d.advance(now)
                        for rep,eff in d.p.feed(x,now):
                            outs=[(turn,rep)] if not hook else hook(c,x,rep,now,d)
                            if c.mute: continue
                            for dl,b in outs or (): send(now+len(x)*CH+dl+len(b)*CH,b)
                    continue
                if buf and now-bt>.05: c.log.append((now-c.t0,'?',buf.hex(' '))); buf=b''
                buf+=x; bt=now
                while buf:
                    n=flen(buf)
                    if n is None or (n and len(buf)<n): break
                    if n==0: c.log.append((now-c.t0,'?',buf.hex(' '))); buf=b''; break
                    f,rest=buf[:n],buf[n:]
                    if crc(f[:-2])!=f: c.log.append((now-c.t0,'?crc',buf.hex(' '))); buf=b''; break
                    buf=rest
                    act_on(f,now)
            elif fd in fds:
                try: x=os.read(fd,65536)
                except OSError: x=b''
                k=fds[fd]
                if not x: fds.pop(fd,None); continue
                if k=='o': c.out+=x
                elif k=='e': c.err+=x
                else: c.tty+=x
    for d in drives: d.advance(time.monotonic())
    c.later=[(d.state(),round(d.speed(),2)) for d in drives]
    if c.m is not None: os.close(c.m); os.close(c.sl)
    if c.tm is not None: os.close(c.tm)
    c.out=c.out.decode('utf8','replace'); c.err=c.err.decode('utf8','replace'); c.ttys=c.tty.decode('utf8','replace')
    if not quiet: show(c,verbose_line,label)
    return c
def show(c,line=False,label=''):
    print('\n##',label,'$ antrieb24 -p PTY',' '.join(c.args)); print('rc',c.rc,'dur %.2f'%c.dur,'HANG' if c.hang else '','end',c.end,'later',c.later)
    ws=c.words; s=[]
    for t,w in ws:
        if s and s[-1][1]==w: s[-1][2]+=1; s[-1][3]=t
        else: s.append([t,w,1,t])
    print('words:',' '.join('%.2f%s %s'%(t,'-%.2fx%d'%(t2,n) if n>1 else '',w) for t,w,n,t2 in s), '(%d telegrams)'%c.n)
    for d in c.drives:
        x=d.diff()
        if x: print('  not as before',d.addr,x)
        if d.wear(): print('  EEPROM',d.addr,d.wear())
        if d.sins: print('  sins',d.addr,d.sins[:6])
    if line:
        for l in c.log: print('   %.3f %s %s'%l)
    for n,x in (('out',c.out),('err',c.err),('tty',c.ttys)):
        if x.strip(): print('--'+n); print(x.rstrip())
T=lambda t:(lambda c,n: n>=c.t0+t)
def EN(t,i=0): return lambda c,n: c.drives[i].enabled is not None and n>=c.drives[i].enabled+t
def W(w,t=0,k=1):
    """after the k-th telegram whose text contains w, t seconds later"""
    def f(c,n):
        l=[x for x,y in c.words if w in y]
        return len(l)>=k and n-c.t0>=l[k-1]+t
    return f
def END(text,t=0):
    st={}
    def f(c,n):
        if 't' not in st and text.encode() in c.err_b() : st['t']=n
        return 't' in st and n>=st['t']+t
    return f
def ASK(t=0,text=b'?'):
    st={}
    def f(c,n):
        if 't' not in st and (text in c.tty or (isinstance(c.err,bytes) and text in c.err)): st['t']=n
        return 't' in st and n>=st['t']+t
    return f
def SIG(s):
    def sig(c): c.p.send_signal(s)
    sig.__name__=str(s).split('.')[-1]; return sig
INT,TERM,HUP=SIG(signal.SIGINT),SIG(signal.SIGTERM),SIG(signal.SIGHUP)
def CC(c): os.write(c.tm,b'\x03')
