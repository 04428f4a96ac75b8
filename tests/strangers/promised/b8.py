from nov import *
import threading
O='--set 418=0 --set 638=10 '
H=['-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','3s','--yes']
def setx(f):
    def setx(c): c.drives[0].d.advance(time.monotonic()); f(c.drives[0].d)
    return setx
def mute(on):
    def mute(c): c.mute=on; c.nohear=on
    return mute
def deaf(on):
    def deafm(c): c.mute=on
    return deafm
def g(n,tr=(),a=H,o=O,**k):
    k.setdefault('maxt',60)
    c=run([Cube(o)],a,triggers=tr,label=n,**k); print('speeds',[(h[1][0][0][:2],h[1][0][1]) for h in c.hist][::25]); return c
L=lambda x:(lambda c,f,r,now,d:[(x,r)])
en=lambda v:setx(lambda d:setattr(d,'enable',v))
cases={
'wdsilence':lambda: g('3 s silence, watchdog 1s',[(EN(.8),mute(True)),(EN(3.8),mute(False))],H[:-2]+['8s','--yes','--watchdog','1s']),
'silence':lambda: g('3 s of lost replies, no watchdog',[(EN(.8),deaf(True)),(EN(3.8),deaf(False))],H[:-2]+['8s','--yes']),
'silence6':lambda: g('6 s of lost line, no watchdog',[(EN(.8),mute(True)),(EN(6.8),mute(False))],H[:-2]+['8s','--yes']),
'silence30':lambda: g('line lost for good',[(EN(.8),mute(True))],H),
'unplug':lambda: g('adapter pulled',[(EN(.8),lambda c:c.unplug())],H),
'unplugkeep':lambda: g('adapter pulled, keep',[(EN(.8),lambda c:c.unplug())],H+['--on-exit','keep']),
'keep':lambda: g('keep',[],H+['--on-exit','keep']),
'silkeep':lambda: g('line lost, keep',[(EN(.8),mute(True))],H+['--on-exit','keep']),
'enback100':lambda: g('enable lost 20 ms after proof for 1 s, replies 100 ms',[(EN(.12),en(False)),(EN(1.2),en(True))],hook=L(.1)),
'enback10':lambda: g('enable lost 40 ms after',[(EN(.04),en(False)),(EN(1.2),en(True))],hook=L(.01)),
'blink':lambda: g('enable blinks 30 ms between two looks, level',[(EN(1.0),en(False)),(EN(1.03),en(True))],o=O+'--command-by level '),
'blinkedge':lambda: g('enable blinks 30 ms, edge',[(EN(1.0),en(False)),(EN(1.03),en(True))],o=O+'--command-by edge '),
'restart':lambda: g('mains off and on in the run',[(EN(1.0),setx(lambda d:d.reboot(time.monotonic())))]),
'restarttc':lambda: g('mains off and on in the run, --take-control --watchdog',[(EN(1.0),setx(lambda d:d.reboot(time.monotonic())))],['-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','3s','--yes','--take-control','--watchdog','2s'],o=O+'--set 412=0 --no-start '),
'otherword':lambda: g('another master writes quick stop in the run',[(EN(1.0),setx(lambda d:d._command(2,time.monotonic())))]),
'otherset':lambda: g('another master writes P.484 = 40 Hz once',[(EN(1.0),setx(lambda d:setattr(d,'line_setpoint',4000)))]),
'p412':lambda: g('P.412 -> 0 in the run, contacts closed',[(EN(1.0),setx(lambda d:d.ram.__setitem__((412,1),0)))]),
}
if __name__=='__main__':
  for n in (sys.argv[1:] or cases): print('#####',n); cases[n]()
