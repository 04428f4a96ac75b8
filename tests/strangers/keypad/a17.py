# built-in simulator killed in the run with a view
from k import *
class D: pass
for how in (signal.SIGKILL,signal.SIGSTOP):
    lnk='/tmp/adv3sim'
    s=subprocess.Popen([K,'simulate','--link',lnk,'--no-config'],stdout=subprocess.DEVNULL,stderr=subprocess.DEVNULL); time.sleep(.8)
    d=D(); d.path=lnk
    t=T(d,['-a','1','sollwert','20Hz','--source','line','--take-control','--enable','--hold','--yes','--view','--step','1Hz','--max','30Hz','--duration','30s']); time.sleep(3)
    s.send_signal(how); time.sleep(1); t.key('\x1b[A'); time.sleep(.3); t.key(' '); time.sleep(.3); t.key('q')
    print('done',t.wait(40),t.p.poll(),f'{time.monotonic()-t.t0:.1f}s',t.term()); print(t.tail(900)); t.kill(); s.kill(); s.wait()
