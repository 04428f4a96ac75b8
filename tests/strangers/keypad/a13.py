# dead-man: arrow released 0.6 s in a slow stop, then held again
from k import *
from a4 import hold,stopt
for key,n in (('\x1b[A','up'),('\r','enter')):
  for second in (True,False):
    with act('--set 421=200 --set 423=200 --set 425=400') as d:
        t=T(d,RUN+['--dead-man','--step','1Hz','--max','30Hz','--duration','20s']); time.sleep(1.5); hold(t,key,2); m=time.monotonic(); time.sleep(.8)
        if second: hold(t,key,2.5)
        time.sleep(1); print('##',n,second,d.look(),'words',stopt(d,m)); t.wait(20); print(t.tail(700)); t.kill()
