from k import *
from a10h import *
def cap(n=24): return '\n'.join(tm('capture-pane','-t','b','-p').rstrip().split('\n')[-n:])
with act() as d:
    start(d,['--view','--step','1Hz','--max','30Hz','--duration','3s'])
    time.sleep(2.5); print('first run\n'+cap()); rep('Up',4); 
    tm('send-keys','-t','b','Enter'); time.sleep(2); print('second\n'+cap()); print(d.look(),[v for _,n,s,v in d.drive.writes if n==410]); tm('kill-server'); time.sleep(3); print(d.look())
