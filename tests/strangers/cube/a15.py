from a5 import *
import re
y=(1.5,b'y\r')
sn=[]
def snap(s): x=s.d.dump(); sn.append((round(time.monotonic()-s.t0,1),x['state'],x['shaft'],x['p412'][0]))
for n,keys in (('t44 view space',[y,(4,b' '),(6,snap),(7,snap),(8,snap),(9,snap),(10,b'q')]),('t44 view q',[y,(4,b'q'),(6,snap)]),('t44 view ctrlc',[y,(4,b'\x03'),(6,snap)])):
    sn.clear()
    p=view(n,['sollwert','10Hz','--enable','--hold','--view','--take-control'],keys,cfg=dict(p412=44,m44_keypad=0,fmin=1000)); print('   snaps',sn)
    print('   tail', p.text[-1500:-700].replace('\n',' ')[:800] if 'space' in n else '')
