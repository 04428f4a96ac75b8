import sys,os,pty,time,signal,subprocess,json,threading,select,fcntl,termios,struct,re
sys.path.insert(0,os.path.join(os.path.dirname(os.path.abspath(__file__)),'..','adversary'))
import h
from h import act,LX,env,ad
K=os.environ.get('ANTRIEB','target/debug/antrieb')
h.A=K
RUN=['-a','1','sollwert','20Hz','--source','line','--enable','--hold','--yes']
VIEW=RUN+['--view','--step','1Hz','--min','0Hz','--max','30Hz']
class T:
    "the tool in a terminal of its own"
    def __init__(s,d,args,size=(24,80),cmdline=None,extra_env=None,ixon=True):
        s.d=d; s.buf=b''; s.ev=[]; s.code=None
        m,sl=pty.openpty(); s.m=m
        fcntl.ioctl(sl,termios.TIOCSWINSZ,struct.pack('HHHH',*size,0,0))
        s.before=termios.tcgetattr(sl); s.sl=sl
        e=env(); e['TERM']='xterm-256color'; e.update(extra_env or {})
        def pre():
            os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
        c=cmdline or h.cmd(d,args)
        s.t0=time.monotonic()
        s.p=subprocess.Popen(c,stdin=sl,stdout=sl,stderr=sl,env=e,preexec_fn=pre,close_fds=True)
        s.stop=False; s.reading=True
        s.th=threading.Thread(target=s._rd,daemon=True); s.th.start()
    def _rd(s):
        while not s.stop:
            if not s.reading: time.sleep(.02); continue
            try:
                r,_,_=select.select([s.m],[],[],.05)
                if r:
                    b=os.read(s.m,65536); s.buf+=b; s.ev.append((time.monotonic(),b))
            except (OSError,ValueError): return
    def key(s,b):
        if isinstance(b,str): b=b.encode()
        try: os.write(s.m,b)
        except OSError as e: print('   write',e)
    def sig(s,n): s.p.send_signal(n)
    def size(s,r,c):
        fcntl.ioctl(s.sl,termios.TIOCSWINSZ,struct.pack('HHHH',r,c,0,0))
    def hang(s):
        s.stop=True; s.th.join(1)
        os.close(s.sl); os.close(s.m)
    def wait(s,t=30):
        end=time.monotonic()+t
        while time.monotonic()<end:
            if s.p.poll() is not None:
                s.code=s.p.returncode; time.sleep(.15); return True
            time.sleep(.01)
        return False
    def enabled(s,t=20):
        end=time.monotonic()+t
        while time.monotonic()<end:
            if h.firsten(s.d) is not None: return True
            if s.p.poll() is not None: return False
            time.sleep(.01)
        return False
    def term(s):
        "the terminal's state now: termios same, alt screen, cursor"
        try: same=termios.tcgetattr(s.sl)==s.before
        except Exception: same='?'
        b=s.buf
        def last(on,off): return b.rfind(on)>b.rfind(off)
        return dict(termios=same,alt=last(b'\x1b[?1049h',b'\x1b[?1049l'),hidden=last(b'\x1b[?25l',b'\x1b[?25h'),paste=last(b'\x1b[?2004h',b'\x1b[?2004l'),mouse=last(b'\x1b[?1000h',b'\x1b[?1000l'),kitty=last(b'\x1b[>',b'\x1b[<'))
    def kill(s):
        if s.p.poll() is None: s.p.kill(); s.p.wait()
        s.stop=True
    def tail(s,n=1500):
        t=s.buf.decode('utf8','replace')
        i=t.rfind('\x1b[?1049l')
        t=t[i+8:] if i>=0 else t
        return re.sub(r'\x1b\[[0-9;?]*[a-zA-Z]|\x1b[()][A-Z0]|\x1b[=>78]','',t).replace('\r','')[-n:]
def samples(d,since):
    return [(round(t-since,2),st,round(o,2)) for t,st,o,f in getattr(d,'samples',[]) if t>=since]
def maxout(d): return max((abs(o) for t,s,o,f in d.samples),default=0), min((o for t,s,o,f in d.samples),default=0), max((o for t,s,o,f in d.samples),default=0)
def report(name,t,d,later=2.0,text=True):
    e=d.look(); tm=None
    try: tm=t.term()
    except Exception as x: tm=x
    time.sleep(later)
    print(f"## {name}: exit {t.p.poll()} {time.monotonic()-t.t0-later:.1f}s end={e} later={d.look()} range={maxout(d)[1:] if hasattr(d,'samples') else ''}\n   {tm}",flush=True)
    if text: print('   | '+t.tail().strip().replace('\n','\n   | '),flush=True)
def writes484(d): return [(round(t-d.born,2),n,s,v) for t,n,s,v in d.drive.writes if n in(484,524,410)]
