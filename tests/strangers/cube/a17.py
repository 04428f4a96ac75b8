from judge import *
Y=['--yes']
for both in ('stop','right'):
    L=dict(p412=2,both=both,fmin=1000)
    for v in ('disable','quick-stop','disable-voltage'):
        case('p2 %s run %s'%(v,both),['statemachine',v],L,pre=['set cw 3',1.5],after=3)
        case('p2 %s stand %s'%(v,both),['statemachine',v],L,pre=[0.3],after=3)
    case('p2 zero run '+both,['sollwert','0'],L,pre=['set cw 3',1.5],after=2)
    for x in ('ramp','quick-stop','coast','keep'):
        case('p2 contacts %s %s'%(x,both),Y+['statemachine','contacts','S1IND','S2IND','--hold','--duration','1s','--on-exit',x],L,after=3)
    case('p2 contacts INT '+both,Y+['statemachine','contacts','S1IND','S2IND','--hold'],L,at=[(2,lambda r,d:INT(r))],after=3)
    case('p2 contacts s3 dead '+both,Y+['statemachine','contacts','S1IND','S3IND','--hold','--duration','2s'],L,at=[(1.5,lambda r,d:d.cmd('dead'))],after=3)
    case('p2 run take ends '+both,Y+['sollwert','10Hz','--enable','--hold','--duration','1s','--take-control'],L,pre=['set cw 3',1],after=3)
