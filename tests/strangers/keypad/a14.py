from k import *
from a4 import hold,stopt
for key,n,gap in (('\x1b[A','up',.033),('\x1b[A','up',.12),('\r','enter',.12),('\x1b[A','up',.3),('\x1b[A','up',.4)):
    with act() as d:
        t=T(d,RUN+['--dead-man','--step','1Hz','--max','30Hz','--duration','3s']); time.sleep(1.5); hold(t,key,5,rate=gap); m=time.monotonic()
        print('##',n,gap,d.look(),'words',stopt(d,m)); t.wait(20); print(t.p.poll(),t.tail(700)); t.kill()
