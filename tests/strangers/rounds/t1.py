from line import *
def L(): return [Act(1),Act(2,delay=.6,model='acu'),Act(3,dead=True),Act(4,refuse=3),Act(5,p412=44),Lxm(6),Act(7,coast=20,encoder='shaft'),Act(8,twice=.02,model='acu'),Act(9,stale=2.)]
run(L(),['-a','1-9','statemachine','quick-stop'],maxt=200)
