from vb import *
lx=lambda **o:(lambda: LXM(3,**o)); ac=lambda **o:(lambda: ACU(1,**o)); va=lambda **o:(lambda: VACU(1,**o))
def asc(**o): return lambda:(lambda d:(setattr(d,'ascii',True),d)[1])(ACU(1,**o))
jobs=[]
for oe in ('ramp','quick-stop','coast','keep'):
    jobs.append(J('ck-lx-'+oe,lx(),['sollwert','300rpm','--jog','1s','--on-exit',oe,'--json'],1,300))
    jobs.append(J('ck-ac-'+oe,ac(set={418:0}),['sollwert','20Hz','--take-control','--jog','1s','--on-exit',oe],1,20,adr=1))
    jobs.append(J('ck-as-'+oe,asc(set={418:0}),['--protocol','ascii','sollwert','20Hz','--take-control','--jog','1s','--on-exit',oe],1,20,adr=1))
    jobs.append(J('ck-va-'+oe,va(set={418:0}),['--protocol','vabus','sollwert','20Hz','--take-control','--jog','1s','--on-exit',oe],1,20,adr=1))
if __name__=='__main__': go(jobs,5)
