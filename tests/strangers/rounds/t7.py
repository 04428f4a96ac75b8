from line import *
import sys
I,T,H=signal.SIGINT,signal.SIGTERM,signal.SIGHUP
def L(): return [Act(1,qs=4),Act(2,qs=4,model='acu'),Lxm(6,qs=80)]
for w in sys.argv[1:]:
    print('######',w)
    A=['-a','1,2,6','statemachine','quick-stop']
    if w=='hupsig': R=run(L(),A,[(1.5,H)])
    if w=='hup': R=run(L(),A,[(1.5,'HUP')],term=True)
    if w=='int3': R=run(L(),A,[(1.5,I),(4,I)])
    if w=='int4': R=run(L(),A,[(1.5,I),(2.0,I),(4,I)])
    if w=='term2': R=run(L(),A,[(1.5,T),(2.0,T)])
