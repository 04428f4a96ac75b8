from line import *
from t3f import tele
import sys
def L(): return [Act(1),Act(2,delay=.4,model='acu'),Act(4,refuse=3),Act(5,p412=44),Act(7,coast=20,encoder='shaft'),Act(8,twice=.02,model='acu'),Act(9,stale=2.)]
if sys.argv[1]=='o':
    run(L(),['-a','1,2,4,5,7,8,9','statemachine','quick-stop'],maxt=100)
    run(L(),['-a','9,8,7,5,4,2,1','statemachine','quick-stop'],maxt=100)
if sys.argv[1]=='dead':
    D=[Act(a,dead=True) for a in range(10,16)]
    run(D+[Act(1)],['-a','10-15,1','statemachine','quick-stop'],maxt=60)
    run(D+[Act(1)],['-a','10-15,1','statemachine','disable-voltage'],maxt=60)
if sys.argv[1]=='dup':
    run([Act(1),Act(1+1)],['-a','1,2,1','statemachine','quick-stop'])
    run([Act(1),Act(2)],['-a','1-2,2','statemachine','quick-stop'])
