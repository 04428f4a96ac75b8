from judge import *
res=[]
def second(*a):
    def f(r,d):
        x=subprocess.run([BIN,'-p',d.tty,'-a','1',*a],stdin=subprocess.DEVNULL,capture_output=True,env=ENV,timeout=40); res.append((a,x.returncode,x.stderr.decode()[-250:]))
    return f
case('two instances qs',['--yes','sollwert','10Hz','--enable','--hold','--duration','4s'],dict(p412=1),at=[(2,second('statemachine','quick-stop'))])
case('two instances read',['--yes','sollwert','10Hz','--enable','--hold','--duration','4s'],dict(p412=1),at=[(2,second('read','@actual'))])
print(res)
c=lambda s:(lambda r,d:d.cmd(s))
case('power cycle live 44',['--yes','sollwert','10Hz','--enable','--hold','--duration','6s','--take-control'],dict(m44_keypad=0,s2=True),at=[(2,c('silent 2')),(2.01,c('p 412 44')),(2.02,c('set cw 0'))],after=3)
case('dataset switched by input',['--yes','sollwert','10Hz','--enable','--hold','--duration','4s'],dict(p412=1,params={'412':[1,0,0,0]}),at=[(2,c('p 414 2'))],after=3)
case('warn2 trip',['--yes','sollwert','10Hz','--enable','--hold','--duration','4s'],dict(p412=1),at=[(1.5,c('set warn 137')),(2.5,c('fault 0400'))],after=1)
case('434 changed in run',['--yes','sollwert','10Hz','--enable','--hold','--duration','4s'],dict(p412=1,intset=2500),at=[(2,c('p 434 1'))],after=1)
case('484 overwritten by other',['--yes','sollwert','10Hz','--enable','--hold','--duration','4s'],dict(p412=1),at=[(2,c('p 484 -3000'))],after=1)
