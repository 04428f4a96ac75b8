from h import *
import tty
which=sys.argv[1:]
def terminal(d,args,keys,limit=25,drain=True,after=2,close_at=None):
    """tool as session leader on a controlling pty; keys [(t after enabled, bytes)]"""
    m,s=pty.openpty(); fcntl.ioctl(s,termios.TIOCSWINSZ,struct.pack('HHHH',24,80,0,0))
    def pre():
        os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
    t0=time.monotonic()
    p=subprocess.Popen(cmd(d,args),stdin=s,stdout=s,stderr=s,env=env(),preexec_fn=pre)
    os.close(s); os.set_blocking(m,False); buf=b''; todo=list(keys); hang=False; closed=False
    while p.poll() is None:
        n=time.monotonic(); b=firsten(d)
        while todo and b is not None and n>=b+todo[0][0]:
            k=todo.pop(0)[1]
            if callable(k): k(p)
            else: os.write(m,k)
        if close_at is not None and b is not None and n>=b+close_at and not closed: os.close(m); closed=True
        if drain and not closed:
            try: buf+=os.read(m,65536)
            except OSError: pass
        if n-t0>limit: hang=True; end=d.look(); p.send_signal(signal.SIGCONT); p.kill(); p.wait(); break
        time.sleep(0.005)
    r={'code':p.returncode,'s':round(time.monotonic()-t0,2),'hang':hang,'end':d.look()}
    time.sleep(after); r['later']=d.look()
    if not closed:
        try: buf+=os.read(m,65536)
        except OSError: pass
        os.close(m)
    r['out']=buf.decode('utf8','replace'); r['err']=''
    return r
CASES={
 'quit':lambda:( [(0.8,b'\x1c')],{}),
 'tstp':lambda:( [(0.8,b'\x1a')],{'limit':15}),
 'xoff':lambda:( [(0.8,b'\x13')],{'limit':25}),          # Ctrl-S then duration ends
 'xoff-term':lambda:( [(0.8,b'\x13'),(1.5,sig(signal.SIGTERM))],{'limit':25}),
 'xoff-int':lambda:( [(0.8,b'\x13'),(1.5,b'\x03')],{'limit':25}),
 'close':lambda:( [],{'close_at':0.8}),
}
for c in which or CASES:
    k,kw=CASES[c]()
    for extra in ([],['-vv']):
        with act() as d:
            r=terminal(d,extra+RUN,k,**kw); show(c+' '+' '.join(extra),r); print(r['out'][-700:])
