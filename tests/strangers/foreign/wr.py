import sys
from vb import *
import mx
lx=lambda **o:(lambda: LXM(3,**o)); ac=lambda **o:(lambda: ACU(1,**o)); va=lambda **o:(lambda: VACU(1,**o))
def asc(**o): return lambda:(lambda d:(setattr(d,'ascii',True),d)[1])(ACU(1,**o))
turn=lambda d,t: abs(d.n)>(5 if isinstance(d,LXM) else .5)
jobs=[]
F4=[('lx',lx(),[],['sollwert','300rpm'],3,300),('ac',ac(set={418:0}),[],['sollwert','5Hz','--take-control'],1,5),('as',asc(set={418:0}),['--protocol','ascii'],['sollwert','5Hz','--take-control'],1,5),('va',va(set={418:0}),['--protocol','vabus'],['sollwert','5Hz','--take-control'],1,5)]
for nm,mk,p,b,adr,n in F4:
    for oe in('ramp','quick-stop','coast','keep'):
        jobs.append(J('wr-%s-%s-clean'%(nm,oe),mk,p+b+['--jog','1s','--on-exit',oe],1,n,adr=adr))
        jobs.append(J('wr-%s-%s-int1'%(nm,oe),mk,p+b+['--enable','--hold','--on-exit',oe],1.0,n,adr=adr,sig=[(ev_after(turn,.8),signal.SIGINT)]))
        jobs.append(J('wr-%s-%s-int2'%(nm,oe),mk,p+b+['--enable','--hold','--on-exit',oe],1.0,n,adr=adr,sig=[(ev_after(turn,.8),signal.SIGINT),(ev_after(turn,.95),signal.SIGINT)]))
        jobs.append(J('wr-%s-%s-dead'%(nm,oe),mk,p+b+['--jog','1s','--on-exit',oe],None,n,adr=adr,fate=F(1).dead_from(ev_after(turn,.6),1e9)))
        jobs.append(J('wr-%s-%s-gap1s'%(nm,oe),mk,p+b+['--jog','1s','--on-exit',oe],None,n,adr=adr,fate=F(1).dead_from(ev_after(turn,.6),1.2)))
    jobs.append(J('wr-%s-term'%nm,mk,p+b+['--enable','--hold'],1.0,n,adr=adr,sig=[(ev_after(turn,.8),signal.SIGTERM)]))
    jobs.append(J('wr-%s-hup'%nm,mk,p+b+['--enable','--hold'],1.0,n,adr=adr,sig=[(ev_after(turn,.8),signal.SIGHUP)]))
def lost(d):  # the adapter goes
    return None
if __name__=='__main__': go(jobs,int(sys.argv[1]))
