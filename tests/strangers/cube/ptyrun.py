import os,pty,fcntl,termios,struct,time,select,signal,subprocess
from bench import BIN,ENV
class Pty:
    """runs the tool on a terminal of its own; keys: list of (time, bytes|callable)"""
    def __init__(s,args,rows=24,cols=80,env=None,cwd='/tmp',stdin_only=False):
        s.m,sl=os.openpty(); fcntl.ioctl(sl,termios.TIOCSWINSZ,struct.pack('HHHH',rows,cols,0,0))
        e=dict(ENV); e.update(env or {})
        def pre():
            os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
        s.p=subprocess.Popen([BIN]+list(args),stdin=sl,stdout=sl,stderr=sl,env=e,cwd=cwd,preexec_fn=pre,close_fds=True)
        s.before=termios.tcgetattr(sl); s.sl=sl; s.buf=b''; s.t0=time.monotonic(); s.closed=False
    def go(s,keys=(),limit=40):
        keys=sorted(keys,key=lambda x:x[0]); i=0; s.hung=False
        while True:
            t=time.monotonic()-s.t0
            while i<len(keys) and keys[i][0]<=t:
                k=keys[i][1]; i+=1
                if callable(k): k(s)
                elif not s.closed: os.write(s.m,k)
            if not s.closed:
                r,_,_=select.select([s.m],[],[],0.05)
                if r:
                    try: s.buf+=os.read(s.m,65536)
                    except OSError: pass
            else: time.sleep(0.05)
            if s.p.poll() is not None: break
            if t>limit: s.hung=True; s.p.kill(); s.p.wait(); break
        s.t=time.monotonic()-s.t0; s.rc=s.p.returncode
        if not s.closed:
            while select.select([s.m],[],[],0.1)[0]:
                try: x=os.read(s.m,65536)
                except OSError: break
                if not x: break
                s.buf+=x
            try: s.after=termios.tcgetattr(s.sl)
            except Exception: s.after=None
        return s
    def hangup(s):
        "the terminal goes away"
        s.closed=True; os.close(s.sl); os.close(s.m)
    def end(s):
        if not s.closed: os.close(s.sl); os.close(s.m); s.closed=True
    @property
    def text(s):
        import re
        t=s.buf.decode(errors='replace'); return re.sub(r'\x1b\[[0-9;?]*[A-Za-z]|\x1b[()][A-Z0-9]|\x1b[=>78]','',t)
