from judge import *
Y=['--yes']
L=dict(m44_keypad=0,fmin=1000,faultlock=2)
case('t44 reset take',Y+['statemachine','reset','--take-control'],L,pre=['fault 0500',2.5],json_=False,show=True,limit=40)
case('t0 reset take',Y+['statemachine','reset','--take-control'],dict(L,p412=0),pre=['fault 0500',2.5],json_=False,show=True,limit=40)
case('t44 switch-on take',Y+['statemachine','switch-on','--take-control'],L,pre=[1],json_=False,show=True,limit=40)
case('t44 shutdown take',Y+['statemachine','shutdown','--take-control'],L,pre=[1],json_=False,show=True,limit=40)
case('write 412 44',Y+['write','412=44'],dict(L,p412=1),pre=[1],json_=False,show=True,limit=40)
case('write 412@1ram 0',Y+['write','412@1ram=0'],dict(L,p412=1),pre=[1],json_=False,show=True,limit=40)
