from vb import *
lx=lambda **o:(lambda: LXM(3,**o)); ac=lambda **o:(lambda: ACU(1,**o)); va=lambda **o:(lambda: VACU(1,**o))
jobs=[]
turn=lambda d,t: abs(d.n)>(5 if isinstance(d,LXM) else .5)
import itertools
# duration 3 s; power goes at 3-x, off y
for x,y in ((.3,.15),(.3,.5),(.3,1),(1,.9),(1,1.3),(2,1.9),(2,2.4),(2.7,2.6),(2.7,3.2),(2.5,.5),(.3,4),(.05,.3)):
    for m,a,n in (('vel',['sollwert','300rpm'],300),('gear',['sollwert','2/5','--mode','gear'],400)):
        oes=('ramp','quick-stop','coast') if m=='vel' else ('ramp',)
        for oe in oes:
            for wd in ((),('--watchdog','2s')) if oe=='ramp' and m=='vel' else ((),):
                jobs.append(J('p2-lx-%s-%s-%s-%s%s'%(m,oe,x,y,'-wd' if wd else ''),lx(),a+['--jog','3s','--on-exit',oe]+list(wd),3,n,ev=lambda d,x=x,y=y:[(ev_after(turn,3-x),lambda d,t:d.reboot(t,y))]))
    for oe,pn,mk,p,wd in (('ramp','rtu',ac,[],[]),('coast','rtu',ac,[],[]),('quick-stop','vab',va,['--protocol','vabus'],[]),('ramp','rtuwd',ac,[],['--watchdog','2s'])):
        jobs.append(J('p2-ac-%s-%s-%s-%s'%(pn,oe,x,y),mk(set={418:0}),p+['sollwert','20Hz','--take-control','--jog','3s','--on-exit',oe]+wd,3,20,adr=1,ev=lambda d,x=x,y=y:[(ev_after(turn,3-x),lambda d,t:d.reboot(t,y))]))
go(jobs,6)
