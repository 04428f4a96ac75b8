from c4 import *
from c3 import left,bleft
import sys
seed=int(sys.argv[1]); end=time.monotonic()+float(sys.argv[2]); n=0; nb=0; rcs={}
while time.monotonic()<end:
    R_=random.Random(seed); random.seed(seed); rnd.seed(seed); n+=1
    basic=R_.random()<.45
    o=dict(getcfg='basic') if basic else {}
    ch=dict(b10=['ramp','local','freeze'],zsw_b10=['0','bits'],pkw_wait=['old','zero','slow0'],dx_keep=[True,False],f003=[1.,2.,4.],lost_by=[('wd',),('wd','unlock'),('wd','unlock','clear')],contact=[False,False,False,True],p927=[1,1,1,0],wdfeed=['dx','any'],first_edge=[True,False],hiw_signed=[True,False],p928_lost=['keep','0'])
    for k,v in ch.items(): o[k]=R_.choice(v)
    a=R_.choice([('statemachine','disable'),('sollwert','0Hz'),('statemachine','quick-stop'),('statemachine','disable-voltage')])
    fault=R_.choice([None,None,drop(.1),drop(.3),garble(.2),late(.1,.05),globals()['bad'](.2),other(.2),dbl(.1)])
    dirn=R_.choice([1,-1])
    p703=R_.choice([0,0,2,4,1])
    def su(s):
        (bleft if basic else left(stw=0x47F if dirn>0 else 0xC7F))(s)
        if dirn<0: 
            with s.lock: s.out=-s.out; s.shaft=s.out; s.basic[0]=0x4052 
        s.gw[703]=p703
        if fault: s.hook=fault
    sig=[(R_.uniform(1.2,3),signal.SIGINT)] if R_.random()<.25 else None
    s=Slave('fd%d'%seed,**o); su(s); s.start()
    r=run(s,*a,'--json',quiet=True,sig=sig,drive='l200',timeout=60); tn=s.turning; 
    t1=s.t0+0; time.sleep(1.5)
    bd=[]
    if r.hang: bd.append('HANG')
    if r.rc==0 and s.turning: bd.append('RC0 TURNS')
    if r.rc==0 and tn and 'voltage' not in a[1]: bd.append('RC0 turned at exit')
    if s.turning and not o['contact'] and r.rc not in (130,) : bd.append('TURNS rc%s'%r.rc)
    if r.rc==130 and s.turning: bd.append('130 TURNS dx%d'%s.dx_count)
    sins=[x[1] for x in s.sins if not x[1].startswith(('same FCB','collision','T_SYN','two'))]
    if sins: bd.append('sins %s'%sins[:2])
    rcs[r.rc]=rcs.get(r.rc,0)+1
    if bd: nb+=1; print(seed,a,'basic' if basic else 'pd',bd,'rc',r.rc,summ(r),((r.j or {}).get('error') or {}).get('message'),{k:o[k] for k in('b10','contact','p927','dx_keep','lost_by')},'p703',p703,'sig',sig is not None,flush=True)
    s.close(); seed+=1
print('runs',n,'flagged',nb,rcs)
