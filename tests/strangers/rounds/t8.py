from line import *
import sys
for w in sys.argv[1:]:
    print('######',w)
    if w=='dis': R=run([Act(1,p392=0,coast=20,encoder='shaft'),Act(2,p392=2),Act(4,refuse=3),Act(5,p412=44)],['-a','1,2,4,5','statemachine','disable','--json'],maxt=100)
    if w=='disv': R=run([Act(1,coast=20,encoder='shaft'),Act(2),Act(3,coast=20)],['-a','1,2,3','statemachine','disable-voltage'],maxt=100)
    if w=='disvr': R=run([Act(1,coast=20,encoder='shaft'),Act(2),Act(3,coast=20)],['-a','3,2,1','statemachine','disable-voltage','--json'],maxt=100)
    if w=='lie': R=run([Act(1,lie=lambda s,v,n,r:0x240,ignore=True),Act(2,lie=lambda s,v,n,r:0x240,ignore=True,coast_shows='shaft'),Act(3)],['-a','1-3','statemachine','quick-stop'],maxt=100)
    if w=='ign': R=run([Act(1,ignore=True),Act(3),Act(4,p412=44)],['-a','1-4','statemachine','quick-stop','--lang','de'],maxt=100,term=True)
    if w=='lie2': # status 0x40 at once and P.210 0 at once (as coasting) though P.210 shows ramp only in word 07
        R=run([Act(1,lie=lambda s,v,n,r:0x240 if s.words else v),Act(3)],['-a','1,3','statemachine','quick-stop'],maxt=100)
    if 'R' in dir() and '--json' in R.err: pass
