from n1_ import *
for i in range(2):
    S('n1-600l%d'%i,*RUN,setup=lv(c600),after=1,msg=True)
    S('n1-600m%d'%i,*RUN,setup=lv(c600,mutewd(2.5),'mute'),after=1,msg=True)
    S('n1-611l%d'%i,*RUN,setup=lv(c611),after=1,msg=True)
    S('n1-611m%d'%i,*RUN,setup=lv(c611,mutewd(2.5),'mute'),after=1,msg=True)
    S('n1-600p%d'%i,*RUN,opts=dict(p928=1),setup=lv(c600,cyc(1),'power'),after=1,msg=True)
    S('n1-600ps%d'%i,*RUN,opts=dict(p928=1,start='edge'),setup=lv(c600,mutewd(2.5),'mute'),after=1,msg=True)
    S('n1-pct%d'%i,'sollwert','40%','--enable','--hold','--duration','2s','--take-control',setup=lv(lambda s:s.hsw==0x1999 and s.pkw_due,mutewd(3.5),'mute'),after=1,msg=True)
    S('n1-928%d'%i,*RUN,setup=lv(c928,mutewd(2.5),'mute'),after=1,msg=True)
for i in range(2):
    cl=lambda s:s.when(lambda s:s.out>15,lambda s:s.o.update(contact=True),'contact closed')
    S('n1-ct4%d'%i,*RUN,opts=dict(p703=4,lost_by=('wd','unlock')),setup=cl,after=1,msg=True)
    S('n1-ct0%d'%i,*RUN,opts=dict(p703=2,lost_by=('wd','unlock'),p928_lost='0'),setup=cl,after=1,msg=True)
