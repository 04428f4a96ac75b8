# sl.py: sollwert 0 --source line --yes of one ACU; set going again EN s behind standstill (setpoint), or by losses
import sys
from vb import *
import h4s
def one(ft,dt,pr):
    d=(VACU if pr=='vabus' else ACU)(1,set={418:0}); h4s.runsa(d); d.ascii=pr=='ascii'
    S={}; RR=random.Random(5)
    def fate(i,t,q,r,dd):
        if ft=='los' and 'z' in S and RR.random()<.3: return []
        if ft=='lat' and 'z' in S and RR.random()<.3: return [(RR.uniform(.1,.5),r)]
        return [(0,r)]
    def ev(dd,t):
        if dd.n==0 and dd.wr: S.setdefault('z',t)
        return 'z' in S and t-S['z']>=dt
    def go(dd,t):
        S['a']=t
        for i in range(1,5): dd.ram[412,i]=1; dd.ram[434,i]=3
        dd.ram[484,0]=3000; dd.ctl(0,t); dd.ctl(6,t); dd.ctl(15,t)
    d.events=[(ev,go)]
    ln=Line([d],fate)
    try: r=run(ln,(['--protocol',pr] if pr!='rtu' else [])+['-a','1','sollwert','0'],d,timeout=90)
    finally: ln.close()
    n=[m for t,m in d.hist if t<=r['t1']][-1]; cap='STILL TURN' in r['out']+r['err']
    print('sl',ft,dt,pr,'rc',r['rc'],'took %.2f'%r['took'],'EN','a' in S and round(r['t1']-S['a'],2),'n',round(n,1),d.st,'cap',cap,'UNTOLD' if abs(n)>1e-6 and not cap else '',(r['err'].splitlines() or ['-'])[-1][:120],flush=True)
for a in (('los',.5,'rtu'),('los',.45,'rtu')): one(*a)
