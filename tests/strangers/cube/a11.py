from judge import *
L=dict(m44_keypad=0,fmin=1000)
case('t44 zero yes',['--yes','sollwert','0'],L,pre=[1.5])
case('t44 zero take noyes',['sollwert','0','--take-control'],L,pre=[1.5])
case('t1 zero take',['--yes','sollwert','0','--take-control'],dict(p412=1,intset=1000),pre=['set cw 15',2])
case('t1 sm disable take',['--yes','statemachine','disable','--take-control'],dict(p412=1,intset=1000),pre=['set cw 15',2])
case('t44 qs take noyes',['statemachine','quick-stop','--take-control'],L,pre=[1.5])
