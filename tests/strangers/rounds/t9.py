from line import *
import sys
for w in sys.argv[1:]:
    print('######',w)
    if w=='d12': run([Act(1,p392=0,coast=12,encoder='shaft'),Act(2,p392=2)],['-a','1,2','statemachine','disable'],maxt=60)
    if w=='d21': run([Act(1,p392=0,coast=12,encoder='shaft'),Act(2,p392=2)],['-a','2,1','statemachine','disable'],maxt=60)
    if w=='i12': run([Act(1,ignore=True),Act(2)],['-a','1,2','statemachine','quick-stop'],maxt=60)
    if w=='i21': run([Act(1,ignore=True),Act(2)],['-a','2,1','statemachine','quick-stop'],maxt=60)
    if w=='lie': run([Act(1,lie=lambda s,v,n,r:0x240,ignore=True),Act(3)],['-a','1,3','statemachine','quick-stop'],maxt=60)
    if w=='r02': # refuses only 02/07 accepts 00
        class R02(Act):
            def handle(s,f,now,rep):
                s.refuse=3 if f[1]==6 and f[2:4]==b'\x01\x9a' and f[5]!=0 else False
                return Act.handle(s,f,now,rep)
        run([R02(1),Act(2),Act(3,dead=True)],['-a','1-3','statemachine','quick-stop'],maxt=60)

    def gaps(R,a):
        L=[x[0] for x in R.log if x[1]=='>' and x[2][:2]=='%02x'%a]; g=[(round(b-c,2),round(c,2)) for c,b in zip(L,L[1:])]; print('largest gaps (s, at) to',a,sorted(g)[-3:])
    if w=='g12':
        R=run([Act(1,p392=0,coast=12,encoder='shaft'),Act(2,p392=2)],['-a','1,2','statemachine','disable'],maxt=60); gaps(R,2)
    if w=='g21':
        R=run([Act(1,p392=0,coast=12,encoder='shaft'),Act(2,p392=2)],['-a','2,1','statemachine','disable'],maxt=60); gaps(R,2)
    if w=='gi':
        R=run([Act(1,ignore=True),Act(2)],['-a','2,1','statemachine','quick-stop'],maxt=60); gaps(R,2)
    if w=='slow9':
        R=run([Act(1,delay=.9),Act(2)],['-a','1,2','statemachine','quick-stop'],maxt=60); gaps(R,2)
    if w=='slow9r':
        R=run([Act(1,delay=.9),Act(2)],['-a','2,1','statemachine','quick-stop'],maxt=60); gaps(R,2)
    if w=='lx':
        R=run([Act(2,delay=.6),Lxm(6)],['-a','2,6','statemachine','quick-stop'],maxt=60); gaps(R,6)
        n=sum(1 for x in R.log if x[1]=='>' and x[2][:2]=='06'); m=sum(1 for x in R.log if x[1]=='<' and x[2][:2]=='06'); print('to 6:',n,'answers',m,'last',[x for x in R.log if x[2][:2]=='06'][-1])
    if w=='tw':
        R=run([Act(1,twice=.3),Act(2),Act(3)],['-a','1,2,3','statemachine','quick-stop'],maxt=60); gaps(R,2)
