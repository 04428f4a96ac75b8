from judge import *
import random
random.seed(int(sys.argv[1]) if len(sys.argv)>1 else 5)
n=int(sys.argv[2]) if len(sys.argv)>2 else 30
for i in range(n):
    t=random.uniform(0.02,1.6); k=random.choice(['INT','TERM','INT2','HUP','INT4']); cfg=random.choice([dict(),dict(cw='edge'),dict(delay=0.1),dict(p412=1),dict(ram_read='eeprom')])
    ex=random.choice(['ramp','quick-stop','coast'])
    f={'INT':INT,'TERM':TERM,'HUP':HUP,'INT2':INT,'INT4':INT}[k]
    at=[(t,lambda r,d,f=f:f(r))]
    if k=='INT2': at.append((t+0.005,lambda r,d:INT(r)))
    if k=='INT4': at+=[(t+0.01*j,lambda r,d:INT(r)) for j in range(1,4)]
    case('fuzz%02d %s %.3f %s %s'%(i,k,t,ex,json.dumps(cfg)),['--yes','sollwert','10Hz','--enable','--hold','--take-control','--watchdog','2s','--on-exit',ex],cfg,at=at,after=4)
