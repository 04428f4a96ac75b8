from vb import *
import mx
ac=lambda **o:(lambda: ACU(1,**o)); va=lambda **o:(lambda: VACU(1,**o))
def asc(**o): return lambda:(lambda d:(setattr(d,'ascii',True),d)[1])(ACU(1,**o))
jobs=[]
H=['sollwert','20Hz','--take-control']
def K(name,mk,p,a,dur,**k): jobs.append(J(name,mk,p+a,dur,20,adr=1,**k))
for p4,o in ((1,dict(set={434:1},internal=5)),(2,dict(set={434:2})),(3,{})):
    for pn,mk,p in (('rtu',ac,[]),('vab',va,['--protocol','vabus'])):
        base=['statemachine','enable','--take-control','--hold','--duration','1s'] if p4==1 else H+['--jog','1s']
        b10=base+['--timeout','10s']
        K('j1-%d-%s-late300'%(p4,pn),mk(**o),p,base,1,fate=F(0).late(.3))
        K('j1-%d-%s-late450'%(p4,pn),mk(**o),p,base,1,fate=F(1).late(.35,.48))
        K('j1-%d-%s-dead0F'%(p4,pn),mk(**o),p,base,1,fate=F(0).dead_from(lambda d,t:d.cw==15,2.5))
        K('j1-%d-%s-dead0F-t10'%(p4,pn),mk(**o),p,b10,1,fate=F(0).dead_from(lambda d,t:d.cw==15,12))
        K('j1-%d-%s-lost30'%(p4,pn),mk(**o),p,base,1,fate=F(3).lost(.25))
K('j1-3-asc-late400',asc(),['--protocol','ascii'],H+['--jog','1s'],1,fate=F(1).late(.3,.45))
K('j1-3-asc-dead',asc(),['--protocol','ascii'],H+['--jog','1s'],1,fate=F(1).dead_from(lambda d,t:d.cw==15,2.5))
K('j1-3-2Hz',ac(),[],['sollwert','2Hz','--take-control','--jog','1s'],1)
K('j1-3-enhold',ac(),[],['sollwert','20Hz','--take-control','--enable','--hold','--duration','1s','--watchdog','2s'],1,fate=F(5).late(.4))
K('j1-3-profile',ac(),[],['sollwert','--ramp','0Hz:20Hz:1s','--take-control','--jog','500ms'],1.5,fate=F(5).late(.4))
# least frequency of another data set
def setds(d):
    for i in (1,3,4): d.ram[418,i]=d.ee[418,i]=0
    d.ee[418,2]=d.ram[418,2]=500; d.o['dsin']=2
K('j1-3-ds2',ac(),[],H+['--jog','1s'],1,prep=setds,fate=F(5).late(.4))
go(jobs,5)
