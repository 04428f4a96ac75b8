from nov import *
Y=b'y/N]'
def key(t):
    def key(c):
        if c.tm is not None: os.write(c.tm,t)
    return key
hold=['-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','1s']
O='--set 418=0 '
def go(n,tr,args=hold,opt=O,term='in',**k):
    c=run([Cube(opt)],args,triggers=tr,term=term,label=n,maxt=40,quiet=True,**k)
    show(c)
    return c
def setx(f):
    def setx(c): f(c.drives[0].d)
    return setx
cases={
'cc':lambda: go('Ctrl-C at the question, later y',[(ASK(.3,Y),key(b'\x03')),(ASK(.5,Y),key(b'y\n'))]),
'int':lambda: go('SIGINT at the question, later y',[(ASK(.3,Y),INT),(ASK(.31,Y),key(b'y\n'))]),
'term':lambda: go('SIGTERM',[(ASK(.3,Y),TERM),(ASK(.3,Y),key(b'y\n'))]),
'hup':lambda: go('hang-up',[(ASK(.3,Y),lambda c:c.hup())]),
'eof':lambda: go('Ctrl-D',[(ASK(.3,Y),key(b'\x04'))]),
'ahead':lambda: go('typed ahead',[(T(.02),key(b'y\ny\n')),(ASK(2,Y),key(b'n\n'))]),
'aheadlate':lambda: go('y without newline typed ahead, newline later',[(T(.05),key(b'y')),(ASK(.5,Y),key(b'\n'))]),
'same':lambda: go('y in the same moment as the question',[(ASK(0,b'MOTION'),key(b'y\n')),(ASK(3,Y),key(b'n\n'))]),
'toctou484':lambda: go('somebody sets P.484 = 40 Hz while it asks (sum, no --source)',[(ASK(.3,Y),setx(lambda d:setattr(d,'line_setpoint',4000))),(ASK(.6,Y),key(b'y\n'))],args=['-a','1','statemachine','enable','--hold','--duration','1s'],opt=O+'--set 434=2 '),
'toctouint':lambda: go('internal setpoint 0 -> 40 Hz while it asks',[(ASK(.3,Y),setx(lambda d:setattr(d.opt,'internal',40.))),(ASK(.6,Y),key(b'y\n'))],args=['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s']),
'toctou412':lambda: go('P.412 -> 0 while it asks',[(ASK(.3,Y),setx(lambda d:d.eeprom.__setitem__((412,1),0))),(ASK(.6,Y),key(b'y\n'))]),
'toctouset':lambda: go('data set 2 while it asks, P.434@2 = 3 with internal -30 Hz',[(ASK(.3,Y),setx(lambda d:(setattr(d,'contact_set',2),setattr(d.opt,'internal',-30.)))),(ASK(.6,Y),key(b'y\n'))],opt=O+'--set 434@1=2 --set 434@2=3 ',args=['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s']),
'toctouqs':lambda: go('shaft started by another master while it asks (statemachine switch-on)',[(ASK(.3,Y),setx(lambda d:(setattr(d,'line_setpoint',2000),d._command(15,time.monotonic())))),(ASK(1.5,Y),key(b'y\n'))],args=['-a','1','statemachine','switch-on']),
'write':lambda: go('write, question, value changes meanwhile',[(ASK(.3,Y),setx(lambda d:d.eeprom.__setitem__((480,1),777))),(ASK(.6,Y),key(b'y\n'))],args=['-a','1','write','480@1=6Hz']),
'writecc':lambda: go('write, Ctrl-C at the question then y',[(ASK(.3,Y),key(b'\x03')),(ASK(.4,Y),key(b'y\n'))],args=['-a','1','write','480@1=6Hz']),
'stop':lambda: go('Ctrl-Z at question then fg and y',[(ASK(.3,Y),key(b'\x1a')),(ASK(1.3,Y),SIG(signal.SIGCONT)),(ASK(1.6,Y),key(b'y\n'))]),
'long':lambda: go('10 s at the question, then y; drive was power-cycled',[(ASK(.3,Y),setx(lambda d:d.trip(0x0500,time.monotonic()))),(ASK(4,Y),key(b'y\n'))]),
}
if __name__=='__main__':
  for n in (sys.argv[1:] or cases): print('#####',n); cases[n]()
