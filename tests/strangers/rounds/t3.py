from line import *
def tele(R,a=0,b=999,addr=None):
    for l in R.log:
        if a<=l[0]<=b and (addr is None or (l[2][:2] and l[2][:2]=='%02x'%addr)): print('    %.3f %s %s'%l)
R=run([Act(1),Lxm(6)],['-a','1,6','statemachine','quick-stop'],maxt=60); tele(R)
R=run([Act(1),Act(3,dead=True),Act(2)],['-a','1-3','statemachine','quick-stop'],maxt=60); tele(R)
