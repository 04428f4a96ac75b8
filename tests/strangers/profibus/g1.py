from sc import *
import pty as P_
def inter(s,args,script,drive=None,timeout=120,setup=None,raw=None):
    "script: list of (cond(text,s,t) , bytes or callable)"
    m,sl=P_.openpty()
    c=raw or cmd(s,*args,yes=False,drive=drive)
    def pre(): os.setsid(); import fcntl; fcntl.ioctl(0,termios.TIOCSCTTY,0)
    p=subprocess.Popen(c,stdin=sl,stdout=sl,stderr=sl,env=ENV,cwd=WD+'/cwd',preexec_fn=pre)
    os.close(sl); buf=''; t0=time.monotonic(); i=0; r=R(); tc=t0
    while True:
        rr,_,_=select.select([m],[],[],0.02)
        if rr:
            try: b=os.read(m,4096)
            except OSError: b=b''
            if not b: break
            buf+=b.decode(errors='replace')
        if i<len(script) and script[i][0](buf,s,time.monotonic()-tc):
            a=script[i][1]; i+=1; tc=time.monotonic()
            s.log('--> user %r'%(a if not callable(a) else 'action'))
            if callable(a): a(s,p)
            else: os.write(m,a)
        if p.poll() is not None and not rr: break
        if time.monotonic()-t0>timeout: p.kill(); buf+='\n*** HANG'; break
    p.wait(); r.rc=p.returncode; r.t=time.monotonic()-t0; r.out=buf; s.log('--> ended rc=%s'%r.rc); os.close(m)
    return r
def has(x,n=1): return lambda b,s,t: b.count(x)>=n
def after(x,d): return lambda b,s,t:(x in b and t>d)
