from vb import *
lx=lambda **o:(lambda: LXM(3,**o)); ac=lambda **o:(lambda: ACU(1,**o)); va=lambda **o:(lambda: VACU(1,**o))
jobs=[]
turn=lambda d,t: abs(d.n)>(5 if isinstance(d,LXM) else .5)
for x in (.1,.2,.3,.5):
    for y in (.7,.9,1.1,1.3,1.6):
        jobs.append(J('p3-lx-%s-%s'%(x,y),lx(),['sollwert','300rpm','--jog','3s'],3,300,ev=lambda d,x=x,y=y:[(ev_after(turn,3-x),lambda d,t:d.reboot(t,y))]))
for x,y in ((.3,.8),(.2,1.0),(.3,1.2),(.1,1.1)):
    jobs.append(J('p3-lx-speed-%s-%s'%(x,y),lx(),['sollwert','300rpm','--mode','speed','--jog','3s'],3,300,ev=lambda d,x=x,y=y:[(ev_after(turn,3-x),lambda d,t:d.reboot(t,y))]))
    jobs.append(J('p3-lx-jog-%s-%s'%(x,y),lx(),['sollwert','1','--mode','jog','--jog','3s'],3,60,ev=lambda d,x=x,y=y:[(ev_after(turn,3-x),lambda d,t:d.reboot(t,y))]))
for late in (.1,.3,.6):
    jobs.append(J('j6-lx-%s'%late,lx(),['sollwert','300rpm','--enable','--hold','--until','reached','--duration','500ms'],None,300,fate=F(1).late(late)))
    jobs.append(J('j6-lxspeed-%s'%late,lx(),['sollwert','300rpm','--mode','speed','--enable','--hold','--until','reached','--duration','500ms'],None,300,fate=F(1).late(late)))
    jobs.append(J('j6-ac-%s'%late,ac(set={418:0}),['sollwert','5Hz','--take-control','--enable','--hold','--until','reached','--duration','500ms'],None,300,adr=1,fate=F(1).late(late)))
    jobs.append(J('j6-vab-%s'%late,va(set={418:0}),['--protocol','vabus','sollwert','5Hz','--take-control','--enable','--hold','--until','reached','--duration','500ms'],None,300,adr=1,fate=F(1).late(late)))
    jobs.append(J('j6-pos-%s'%late,lx(),['sollwert','16384usr','--enable','--hold','--until','reached','--duration','500ms'],None,60,fate=F(1).late(late)))
    jobs.append(J('j6-ac-jit-%s'%late,ac(set={418:0}),['sollwert','5Hz','--take-control','--enable','--hold','--until','reached','--duration','500ms'],None,300,adr=1,fate=F(1).late(late*.5,late)))
go(jobs,6)
