from judge import *
import random
random.seed(11)
for i in range(9):
    t=random.uniform(0.1,3.5); k=random.choice(['kill','dead','hangup','dead+INT','deadback'])
    f={'kill':[(t,lambda r,d:d.p.kill())],'dead':[(t,lambda r,d:d.cmd('dead'))],'hangup':[(t,lambda r,d:d.cmd('hangup'))],'dead+INT':[(t,lambda r,d:d.cmd('dead')),(t+.3,lambda r,d:INT(r))],'deadback':[(t,lambda r,d:d.cmd('dead')),(t+2.5,lambda r,d:d.cmd('alive'))]}[k]
    case('rnd%d %s %.2f'%(i,k,t),['--yes','sollwert','10Hz','--enable','--hold','--duration','2s','--take-control']+(['--watchdog','1s'] if i%2 else []),dict(),at=f,after=3,limit=80)
