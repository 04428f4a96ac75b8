from judge import *
Y=['--yes']
case('show take44 live contact',Y+['sollwert','10Hz','--enable','--hold','--duration','2s','--take-control'],dict(m44_keypad=0),after=4,json_=False,show=True)
case('show dv take0',Y+['statemachine','disable-voltage','--take-control'],dict(p412=0),pre=[1.0],json_=False,show=True)
case('show percent',Y+['sollwert','30%','--enable','--hold','--duration','2s'],dict(p412=1),json_=False,show=True)
case('show internal',Y+['sollwert','10Hz','--enable','--hold','--duration','2s'],dict(p412=1,intset=2000),json_=False,show=True)
case('show profile',Y+['sollwert','--profile','/tmp/nov22.prof','--enable','--hold'],dict(p412=1),json_=False,show=True,at=[(12,lambda r,d:INT(r))])
