from judge import *
Y=['--yes']
L=dict(m44_keypad=0,fmin=1000)
case('t44 run INT b',Y+['sollwert','10Hz','--enable','--hold','--take-control'],L,at=[(2.5,lambda r,d:INT(r))],json_=False,show=True)
case('t44 zero b',Y+['sollwert','0','--take-control'],L,pre=[1.5],json_=False,show=True)
case('t44 zero notake',['sollwert','0'],L,pre=[1.5],json_=False,show=True)
case('t44 zero 434=1',['sollwert','0'],dict(m44_keypad=0,fmin=1000,p434=1),pre=[1.5],json_=False,show=True)
case('t0 zero notake',['sollwert','0'],dict(p412=0),pre=[1.5],json_=False,show=True)
case('t1 zero int',['sollwert','0'],dict(p412=1,intset=1000),pre=['set cw 15',2],json_=False,show=True)
case('t44 sm quick b',Y+['statemachine','quick-stop','--take-control'],L,pre=[1.5],json_=False,show=True)
case('t44 sm quick edge',Y+['statemachine','quick-stop','--take-control'],dict(m44_keypad=0,fmin=1000,cw='edge'),pre=[1.5],json_=False,show=True)
