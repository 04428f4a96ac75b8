from n1_ import *
B=dict(getcfg='basic')
cb=lambda s:s.basic[0]&3 and s.bus_run
cp=lambda s:s.stw==0x47F and s.bus_run
for nm,a,o,c,f,d in (('B start mute',BRUN+('--watchdog','1s'),B,cb,mutewd(2.5),'l200'),('B start leave',BRUN,B,cb,lambda s:s.leave('wd'),'l200'),('B start power',BRUN,B,cb,cyc(1),'l200'),('PD start leave',RUN,{},cp,lambda s:s.leave('wd'),None),('PD start mute',RUN,{},cp,mutewd(2.5),None),
  ('PD until leave',RUN+('--until','reached'),{},lambda s:s.out>8,lambda s:s.leave('wd'),None),('B until leave',BRUN+('--until','reached'),B,lambda s:s.out>8,lambda s:s.leave('wd'),'l200'),('B 0050 phase leave',BRUN,B,lambda s:s.basic[0]==0x50 and s.dx_count>4,lambda s:s.leave('wd'),'l200'),('PD stop leave',RUN,{},lambda s:s.stw==0x47e and s.out>3 and len(s.stws)>3,lambda s:s.leave('wd'),None),('PD stop mute',RUN,{},lambda s:s.stw==0x47e and s.out>3 and len(s.stws)>3,mutewd(2.5),None),('PD giveback leave',RUN,{},lambda s:len(s.writes)>=2,lambda s:s.leave('wd'),None),('PD zero mute',RUN,{},lambda s:s.stw==0 and len(s.stws)>3,mutewd(2.5),None),
  ('reset leave',('statemachine','reset'),{},lambda s:s.stw==0x406,lambda s:s.leave('wd'),None),('reset leave486',('statemachine','reset'),{},lambda s:s.stw==0x486,lambda s:s.leave('wd'),None)):
    def su(s,a=a,c=c,f=f):
        if 'reset' in a: s.do_trip()
        s.when(c,f,'ev')
    s,r=S('n2-'+nm.replace(' ',''),*a,opts=o,setup=su,after=1,drive=d,msg=True)
    print('     turns',[(round(t,2),x) for t,x in s.turn_log])
