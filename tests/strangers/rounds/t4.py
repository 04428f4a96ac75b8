from line import *
import sys
from t3f import tele
w=sys.argv[1]
def short(R):
    return
if w=='a':
    for h in (1.0,0.0):
        print('### hold',h)
        run([Act(1,holdt=h),Act(3,dead=True),Act(2,holdt=h)],['-a','1-3','statemachine','quick-stop'])
if w=='b':
    run([Act(1,holdt=.0),Act(2,holdt=0.,qs=10)],['-a','1-2','statemachine','quick-stop'])
    R=run([Act(1),Act(2,delay=.6),Lxm(6)],['-a','1,2,6','statemachine','quick-stop']); tele(R)
