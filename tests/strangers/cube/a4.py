from judge import *
Y=['--yes']
run=['p 484 2000','set cw 15',2.2]
sm=lambda *a:Y+['statemachine',*a]
case('ramref disable',sm('disable'),dict(p412=1,ram_read='refused'),pre=run,after=1)
case('ramref quick-stop',sm('quick-stop'),dict(p412=1,ram_read='refused'),pre=run,after=1)
case('ramref zero',['sollwert','0'],dict(p412=1,ram_read='refused',fmin=0),pre=run,after=1)
case('ramref enable hold',sm('enable','--hold','--duration','1s'),dict(p412=1,ram_read='refused'))
case('zero fmin0',['sollwert','0'],dict(p412=1,fmin=0),pre=run,after=1)
case('disable unread 411 drops',sm('disable'),dict(p412=1),pre=run+['drop 20'],after=1)
case('disable into babble',sm('disable'),dict(p412=1),pre=run+['babble 8'],after=3,limit=120)
case('quick into babble gap5',sm('quick-stop'),dict(p412=1,babble_gap=0.005),pre=run+['babble 30'],after=3,limit=120)
case('disable slow 700',sm('disable'),dict(p412=1,slow_after=0,slow=0.7),pre=run,after=1,limit=120)
case('disable slow 3s',sm('disable'),dict(p412=1,slow_after=0,slow=3.0),pre=run,after=1,limit=120)
case('dv no yes',['statemachine','disable-voltage'],dict(p412=1),pre=run,after=8)
case('ascii zero',['--protocol','ascii','sollwert','0'],dict(p412=1,ascii=1,fmin=0),pre=run,after=1)
case('ascii identify',['--protocol','ascii','identify'],dict(p412=1,ascii=1,fmin=0))
