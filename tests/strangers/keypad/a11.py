from k import *
from a4 import stopt
import random,a2
want=sys.argv[1:]
def on(n): return not want or any(w in n for w in want)
# resize storms and tiny terminals
def storm(t,d):
    random.seed(1); end=time.monotonic()+3
    while time.monotonic()<end: t.size(random.choice([0,1,2,3,24,200]),random.choice([0,1,5,10,80,500])); time.sleep(.01)
    t.size(3,10); time.sleep(.5); t.key(' '); time.sleep(1.5); t.key('q')
a2.want=want
a2.case('resize storm',storm,dur='9s')
for sz in ((3,10),(1,1),(0,0),(2,200),(1000,3),(3,2000)): a2.case(f'size {sz}',[1,'\x1b[A',.5,' ',1,'d',.5,'q'],dur='9s',size=sz)
# terminal not read (blocked), keys still work
def block(t,d):
    t.reading=False; fcntl.fcntl(t.m,fcntl.F_SETFL,0); time.sleep(5); m=time.monotonic(); t.key(' '); time.sleep(2); print('   words',stopt(d,m),d.look()); t.key('q'); time.sleep(2); t.reading=True
a2.case('terminal unread 5 s, then space',block,dur='20s')
def block2(t,d):
    t.key('\x13'); time.sleep(.1); t.reading=False; time.sleep(8); print('   at duration end',d.look()); t.reading=True
a2.case('XOFF and unread over duration',block2,dur='5s')
# diagnosis during the run
a2.case('d while running, space in it, q',['d',2,'\x1b[A',.5,'d',.5,'\x1b[A',.5,' ',1,'q'],dur='20s')
a2.case('d x30 quickly, up',['d'*30,1,'\x1b[A',.5,'q'],dur='20s')
# TERM variants
for e in ('dumb','','vt100','nonsense'):
    if on('TERM'):
        with act() as d:
            t=T(d,VIEW+['--duration','4s'],extra_env={'TERM':e}); t.wait(12); t.key('q'); t.wait(5); report('TERM='+e,t,d,.5); t.kill()
