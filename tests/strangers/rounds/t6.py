from line import *
from t3f import tele
import sys
I,T,H=signal.SIGINT,signal.SIGTERM,signal.SIGHUP
def L(): return [Act(1,qs=4),Act(2,qs=4,model='acu'),Act(3,dead=True),Lxm(6,qs=80)]
for w in sys.argv[1:]:
    print('######',w)
    A=['-a','1,2,3,6','statemachine','quick-stop']
    if w=='int': R=run(L(),A,[(1.5,I)])
    if w=='int2': R=run(L(),A,[(1.5,I),(2.6,I)])
    if w=='term': R=run(L(),A,[(1.5,T)])
    if w=='hup': R=run(L(),A,[(1.5,'HUP')],term=True)
    if w=='early': R=run(L(),A,[(.12,I)])
    if w=='early2': R=run(L(),A,[(.12,I),(.5,I)])
    if w=='cc': R=run(L(),A+['--lang','de'],[(1.5,'^C')],term=True)
    if w=='cc2': R=run(L(),A+['--lang','de'],[(1.5,'^C'),(2.7,'^C')],term=True)
