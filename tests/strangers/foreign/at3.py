# at3.py : (cd /tmp/judge/foreign && ANTRIEB=/tmp/b/antrieb PYTHONPATH=../new python3 ../new/at3.py) `sollwert 0 --source line` to a turning ACU: what is said and how fast the shaft is at the end, -v
import sys,os; sys.path.insert(0,os.getcwd())
from at2 import *
for c in(1,44):
    d=mk1(1,c); d.ram.update({(421,i):100 for i in range(1,5)}); ln=Line([d]); time.sleep(.1); r=run(ln,['-a','1','sollwert','0','--source','line'],d,verbose=False); n0=r['nend']; time.sleep(.5); print(c,r['rc'],'%.2f'%r['took'],'n at end %.1f'%n0,'0.5 s later %.1f'%d.n,d.st); print(r['out'],'|',r['err']); ln.close()
