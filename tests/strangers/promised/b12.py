from b4 import *
A=lambda *a:['-a','1',*a]
# sisters of F1: question -> state changed -> y
cases={
'enable':lambda: go('enable without hold; internal 0 -> 30 while it asks',[(ASK(.3,Y),setx(lambda d:setattr(d.opt,'internal',30.))),(ASK(.6,Y),key(b'y\n'))],args=A('statemachine','enable'),after=2),
'enablehold':lambda: go('enable hold; internal',[(ASK(.3,Y),setx(lambda d:setattr(d.opt,'internal',30.))),(ASK(.6,Y),key(b'y\n'))],args=A('statemachine','enable','--hold','--duration','2s')),
'sp':lambda: go('setpoint on an enabled drive; set 2 while it asks',[(ASK(.3,Y),setx(lambda d:(setattr(d,'contact_set',2),setattr(d.opt,'internal',-30.)))),(ASK(.6,Y),key(b'y\n'))],opt=O+'--running --set 434@1=2 --set 434@2=3 ',args=A('sollwert','10Hz'),after=2),
'line':lambda: go('--source line; set 2 in the run',[(EN(.6),setx(lambda d:(setattr(d,'contact_set',2))))],opt=O+'--internal -30 ',args=A('sollwert','10Hz','--source','line','--enable','--hold','--duration','3s','--yes'),term=False),
'take':lambda: go('take-control; set 2 while it asks',[(ASK(.3,Y),setx(lambda d:(setattr(d,'contact_set',2)))),(ASK(.6,Y),key(b'y\n'))],opt=O+'--set 412=44 --no-start ',args=A('sollwert','10Hz','--take-control','--enable','--hold','--duration','2s')),
'reset':lambda: go('fault reset, start standing',[(ASK(.6,Y),key(b'y\n'))],opt=O+'--fault 0x0500 --fault-age 20 --word 15 --left 20 ',args=A('statemachine','reset'),after=2),
'write':lambda: go('EEPROM write while somebody starts the drive',[(ASK(.3,Y),setx(lambda d:(setattr(d,'line_setpoint',2000),d._command(15,time.monotonic())))),(ASK(1.3,Y),key(b'y\n'))],args=A('write','480=6Hz','392=0','637=50'),after=1),
}
if __name__=='__main__':
  for n in (sys.argv[1:] or cases): print('#####',n); c=cases[n](); print('speeds',[(h[1][0][0][:2],h[1][0][1]) for h in c.hist][::20])
