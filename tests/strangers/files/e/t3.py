from mat import *
import pty,fcntl,termios,struct
def ask(d,args,ans,at,timeout=40,needle=rb'\[[yj]/N\]|\[[yj]/n\]',sig=None,cwd=HERE,port=True):
    """runs on an 80x24 terminal, calls at() when the question stands, sends ans"""
    pid,fd=pty.fork()
    if pid==0:
        os.chdir(cwd); e=dict(ENV,TERM='xterm'); os.execve(BIN,[BIN]+(['--port',d.tty,'-a',str(d.addr)] if port else [])+args,e)
    fcntl.ioctl(fd,termios.TIOCSWINSZ,struct.pack('HHHH',24,80,0,0))
    out=b''; asked=False; end=time.monotonic()+timeout
    while time.monotonic()<end:
        r,_,_=select.select([fd],[],[],.1)
        if r:
            try: x=os.read(fd,4096)
            except OSError: break
            if not x: break
            out+=x
        if not asked and re.search(needle,out):
            asked=True; time.sleep(.05); at()
            if callable(ans): ans(pid,fd)
            else: os.write(fd,ans)
    else: os.kill(pid,9); out+=b'HANG'
    _,st=os.waitpid(pid,0); os.close(fd)
    class R: pass
    R=R(); R.rc=os.waitstatus_to_exitcode(st); R.o=out.decode(errors='replace').replace('\r',''); R.asked=asked; return R
def case(tag,at,ans=b'y\n',pre=None,args=None,show=700,**k):
    d=Drv(**k)
    if pre: pre(d)
    clean(); d.reset(); b=d.snap()
    r=ask(d,args or ['dataset','load',W+'/m.toml'],ans,lambda:at(d))
    a=d.snap(); d.stop=True
    print('=== %s rc=%s asked=%s wr=%s eqw=%s run=%s'%(tag,r.rc,r.asked,d.wr,d.eqw,d.runw)); print('  diffs',diffs(b,a)); print('  ...'+r.o[-show:]); sys.stdout.flush(); return d,r
if __name__=='__main__':
    case('plain 80x24 de',lambda d:None,args=['--lang','de','dataset','load',W+'/m.toml'],show=6000)
    case('480@2 changed to 7.77',lambda d:d.set(480,2,777))
    case('480@2 set to target',lambda d:d.set(480,2,-1250))
    case('480@2 RAM only changed',lambda d:d.set(480,2,777,ee=False))
    case('419@3 changed',lambda d:d.set(419,3,4321))
    case('601@1 (not in scope) changed',lambda d:d.set(601,1,33))
    case('run starts',lambda d:setattr(d,'run',True))
    case('power cycled (ram diff before)',lambda d:d.power(),pre=lambda d:d.set(480,2,777,ee=False))
    case('Ctrl-C at question',lambda d:None,ans=b'\x03',show=300)
    case('n',lambda d:None,ans=b'n\n',show=300)
    case('ja (de)',lambda d:None,ans=b'ja\n',args=['--lang','de','dataset','load',W+'/m.toml'],show=300)
    case('y (de)',lambda d:None,ans=b'y\n',args=['--lang','de','dataset','load',W+'/m.toml'],show=300)
    def gone(d): d.off=True
    case('drive gone',gone,show=400)
