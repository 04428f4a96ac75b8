from b4 import *
def ch(n,f,args,opt=O,at=None):
    c=run([Cube(opt)],args+['--yes'],triggers=[(EN(at),setx(f))],maxt=40,quiet=True,label=n)
    show(c); print('speeds',[h[1][0][1] for h in c.hist][::10])
A2=['-a','1','sollwert','10Hz','--enable','--hold','--duration','3s']
for i in (1,2):
    go('int',[(ASK(.3,Y),setx(lambda d:setattr(d.opt,'internal',40.))),(ASK(.6,Y),key(b'y\n'))],args=A2+['--json'])
    go('set',[(ASK(.3,Y),setx(lambda d:(setattr(d,'contact_set',2),setattr(d.opt,'internal',-30.)))),(ASK(.6,Y),key(b'y\n'))],opt=O+'--set 434@1=2 --set 434@2=3 ',args=A2+['--until','reached'])
ch('run: data set 2 (P.434=3, internal -30)',lambda d:(setattr(d,'contact_set',2)),A2,O+'--set 434@1=2 --set 434@2=3 --internal -30 ',.5)
ch('run: internal 0->-30',lambda d:setattr(d.opt,'internal',-30.),A2,O,.5)
