from vb import *
from s2 import runs
lx=lambda **o:(lambda: LXM(3,**o)); ac=lambda **o:(lambda: ACU(1,**o)); va=lambda **o:(lambda: VACU(1,**o))
turn=lambda d,t: abs(d.n)>(5 if isinstance(d,LXM) else .5)
jobs=[]
def cyc(start,per,n=400):
    # another master writes 000Fh (after 6) every per s, from start cond on
    def ev(d):
        st={}
        def cond(d,t):
            if not start(d,t) and 't' not in st: return False
            st.setdefault('t',t-per)
            if t-st['t']>=per:
                st['t']+=per
                if isinstance(d,LXM):
                    if d.st!='OE': d.control(6,t); d.control(15,t); d.p[6938]=500
                else: d.ctl(6,t) if d.st!='OE' else None; d.ctl(15,t); d.ram[484,0]=3000
            return False
        return [(cond,lambda d,t:None)]
    return ev
def runsa(d): runs(d); d.ram.update({(418,i):0 for i in range(1,5)})
for per in (.1,.5,1.0):
    for v,a in (('disable',['statemachine','disable']),('qs',['statemachine','quick-stop']),('dv',['statemachine','disable-voltage']),('zero',['sollwert','0'])):
        jobs.append(J('cy-lx-%s-%s'%(v,per),lx(),a,None,None,prep=runs,ev=cyc(lambda d,t:len(d.wr)>0,per)))
        jobs.append(J('cy-ac-%s-%s'%(v,per),ac(),a,None,None,adr=1,prep=runsa,ev=cyc(lambda d,t:len(d.wr)>0,per)))
    for oe in ('ramp','quick-stop','coast'):
        jobs.append(J('cy-lx-run-%s-%s'%(oe,per),lx(),['sollwert','300rpm','--jog','1s','--on-exit',oe],None,None,ev=cyc(ev_after(turn,1.02),per)))
        jobs.append(J('cy-ac-run-%s-%s'%(oe,per),ac(set={418:0}),['sollwert','20Hz','--take-control','--jog','1s','--on-exit',oe],None,None,adr=1,ev=cyc(ev_after(turn,1.02),per)))
if __name__=="__main__": go(jobs,10)
