from h import *
import socket
def gone(name,mk,which,args=RUN,limit=15):
    with act() as d:
        r,w,rc=mk()
        kw={}
        if 'o' in which: kw['out']=w
        if 'e' in which: kw['err']=w
        x=run(d,args,[(0.8,lambda p: rc())],limit=limit,after=1,**kw)
        # note: our own copy of w is still open; fine
        show(name+' '+which,x); print('   ',(x.get('err') or '')[-300:].replace('\n',' / ') if isinstance(x.get('err'),str) else '')
def pipe():
    r,w=os.pipe(); return r,os.fdopen(w,'wb',0),lambda: os.close(r)
def sock():
    a,b=socket.socketpair(); return a,b,lambda: a.close()
def sockshut():
    a,b=socket.socketpair(); return a,b,lambda: a.shutdown(socket.SHUT_RDWR)
class F:
    pass
for n,mk in (('pipe',pipe),('socket',sock)):
    for w in ('o','e','oe'):
        gone(n,mk,w,RUN[:-2]+['15s','--yes'] if False else [a.replace('6s','12s') for a in RUN],limit=18)
# background with tostop in a terminal
import tty
def bg(name,stty,args,limit=16):
    m,s=pty.openpty()
    a=termios.tcgetattr(s); 
    if 'tostop' in stty: a[3]|=termios.TOSTOP
    termios.tcsetattr(s,termios.TCSANOW,a)
    with act() as d:
        t0=time.monotonic()
        # a session leader (sleep) in foreground, the tool in its own background process group
        code='''
import os,fcntl,termios,sys,signal
os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
pid=os.fork()
if pid==0:
    os.setpgid(0,0); signal.signal(signal.SIGTTOU,signal.SIG_DFL); os.execv(sys.argv[1],sys.argv[1:])
import time
st=None; b=time.time()
while time.time()-b<%f:
    p,s=os.waitpid(pid,os.WNOHANG|os.WUNTRACED)
    if p and os.WIFSTOPPED(s): os.write(3,('stopped by %%d at %%.2f\\n'%%(os.WSTOPSIG(s),time.time()-b)).encode())
    elif p: os.write(3,('ended %%d at %%.2f\\n'%%(s,time.time()-b)).encode()); sys.exit()
    time.sleep(.05)
os.kill(pid,9)
'''%limit
        r,w=os.pipe()
        def pre(): os.dup2(w,3)
        p=subprocess.Popen([sys.executable,'-c',code]+cmd(d,args),stdin=s,stdout=s,stderr=s,pass_fds=(3,) if False else (),close_fds=False,preexec_fn=pre,env=env())
        os.close(w); p.wait(); print(name,os.read(r,9999).decode(),d.look(),flush=True)
        os.set_blocking(m,False)
        try: print(os.read(m,9999).decode()[-300:])
        except OSError: pass
bg('background, tostop','tostop',RUN)
bg('background','',RUN)
