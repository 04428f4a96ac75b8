from judge import *
Y=['--yes']
case('f 2Hz 434=2',Y+['sollwert','2Hz','--enable','--hold','--duration','2s'],dict(p412=1,p434=2),json_=False,show=True)
case('f 0 434=2',Y+['sollwert','0','--enable','--hold','--duration','2s'],dict(p412=1,p434=2),json_=False,show=True)
case('f 30% 434=2',Y+['sollwert','30%','--enable','--hold','--duration','2s'],dict(p412=1,p434=2),json_=False,show=True)
case('f 30% 434=3',Y+['sollwert','30%','--enable','--hold','--duration','2s'],dict(p412=1,p434=3),json_=False,show=True)
case('f 0 434=3',Y+['sollwert','0','--enable','--hold','--duration','2s'],dict(p412=1,p434=3),json_=False,show=True)
case('f -3.5 434=3',Y+['sollwert','-3.5Hz','--enable','--hold','--duration','2s'],dict(p412=1,p434=3),json_=False,show=True)
case('f profile 434=3',Y+['sollwert','--profile','/tmp/nov22.prof','--enable','--hold','--duration','4s'],dict(p412=1),json_=False,show=True)
case('f profile 434=2',Y+['sollwert','--profile','/tmp/nov22.prof','--enable','--hold','--duration','4s'],dict(p412=1,p434=2),json_=False,show=True)
