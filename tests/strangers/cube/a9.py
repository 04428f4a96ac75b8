from judge import *
Y=['--yes']
L=dict(m44_keypad=0,fmin=1000)
case('t44 run',Y+['sollwert','10Hz','--enable','--hold','--duration','1s','--take-control'],L)
case('t44 run INT',Y+['sollwert','10Hz','--enable','--hold','--take-control'],L,at=[(2.5,lambda r,d:INT(r))])
case('t44 run quick',Y+['sollwert','10Hz','--enable','--hold','--duration','1s','--take-control','--on-exit','quick-stop'],L)
case('t44 sm disable',Y+['statemachine','disable','--take-control'],L,pre=[1.5])
case('t44 sm quick',Y+['statemachine','quick-stop','--take-control'],L,pre=[1.5])
case('t44 sm dv',Y+['statemachine','disable-voltage','--take-control'],L,pre=[1.5])
case('t44 zero',Y+['sollwert','0','--take-control'],L,pre=[1.5])
case('t44 sm enable',Y+['statemachine','enable','--hold','--duration','1s','--take-control'],L)
case('t44 keypad-silent contact',Y+['sollwert','10Hz','--enable','--hold','--duration','1s','--take-control'],dict(m44_keypad=0,s2=False),at=[(2.0,lambda r,d:d.cmd('set s2 true'))])
case('t44 contact closes in run',Y+['sollwert','10Hz','--enable','--hold','--duration','1s','--take-control'],dict(m44_keypad=0,contacts_edge=True))
case('t0 sm disable',Y+['statemachine','disable','--take-control'],dict(p412=0),pre=[1.5],json_=False,show=True)
