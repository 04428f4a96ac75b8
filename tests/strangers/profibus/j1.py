from c3 import left,bleft
from sc import *
import sys
def l927(s): left()(s); s.gw[927]=0
# ramp proof statistics
def st(f,n,basic,hz='20Hz'):
    for i in range(n):
        s=Slave('j1-r',getcfg='basic' if basic else 'ppo1',f003=f,f002=.5,p928=1); seen=[]
        def hk(s,q,b):
            if s.turning or (seen and s.out==0): seen.append((round(s.out,2),b[14]) if basic and len(b)==17 else round(s.out,2))
            return [(0,b)]
        s.hook=hk; s.start()
        a=('sollwert',hz,'--enable','--hold','--duration','300ms')+(('--set','F002=0.5s','--set','F003=%ss'%f,'--mode','basic') if basic else ())
        r=run(s,*a,'--json',quiet=True,drive='l200')
        k=max([i for i,x in enumerate(seen) if (x[0] if isinstance(x,tuple) else x)>0] or [0]); 
        print('basic' if basic else 'pd',f,'rc',r.rc,seen[max(0,k-5):k+6],'late',s.nlate); s.close()
if len(sys.argv)>1: st(0.6,6,True); st(0.3,4,True); st(1.0,4,True); st(0.5,4,False)
else:
    for a in (('statemachine','disable'),('sollwert','0Hz'),('statemachine','disable-voltage'),('read','F002'),('monitor','--duration','1s')):
        S('j1-l927-'+a[-1].replace(' ','')[:8],*a,setup=l927,after=1.5,msg=True,json_='monitor' not in a)
