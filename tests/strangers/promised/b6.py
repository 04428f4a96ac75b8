from b4 import *
def goL(n,tr,args,term='in',yes=False,**k):
    d=Lx(1,**k); d.before=dict(d.d.value)
    c=run([d],args+(['--yes'] if yes else []),triggers=tr,term=term,label=n,maxt=60,quiet=True)
    show(c); print('speeds',[h[1][0][1] for h in c.hist][::15]); 
    return c
def setv(**kw):
    def setv(c): c.drives[0].d.value.update(kw)
    return setv
H=['-a','1','sollwert','300rpm','--enable','--hold','--duration','1500ms']
cases={
'pv':lambda: goL('PVn_target=2000 while it asks',[(ASK(.3,Y),setv(PVn_target=2000)),(ASK(.6,Y),key(b'y\n'))],['-a','1','statemachine','enable','--hold','--duration','1500ms'],left='DCOMopmode=3'),
'gear':lambda: goL('gear reference set while it asks',[(ASK(.3,Y),setv(GEARreference=1)),(ASK(.6,Y),key(b'y\n'))],['-a','1','statemachine','enable','--hold','--duration','1500ms'],left='DCOMopmode=4'),
'gearleft':lambda: goL('gear left on',[],['-a','1','statemachine','enable','--hold','--duration','1500ms'],term=False,yes=True,left='DCOMopmode=4,GEARreference=1'),
'anal':lambda: goL('speed mode, analog',[],['-a','1','statemachine','enable','--hold','--duration','1500ms'],term=False,yes=True,left='DCOMopmode=-4,SPEEDreference=1',analog=500.),
'pv2':lambda: goL('target 900 left, sollwert 300',[],H,term=False,yes=True,left='DCOMopmode=3,PVn_target=900'),
'turnmode':lambda: goL('gear run under way, sollwert 300 (mode change refused)',[],H,term=False,yes=True,turning=400.,mode_change_turning='refused'),
'ramptoctou':lambda: goL('RAMPn_max',[],['-a','1','sollwert','20000rpm','--enable','--hold','--duration','1s'],term=False,yes=True),
'jog':lambda: goL('jog',[(W('R6930=',.7),INT)],['-a','1','sollwert','1','--mode','jog','--enable','--hold','--duration','3s'],term=False,yes=True),
'pos':lambda: goL('pos + INT',[(W('=0x1f',.5),INT)],['-a','1','sollwert','163840usr','--enable','--hold','--duration','8s','--start','relative'],term=False,yes=True),
'homing':lambda: goL('homing',[],['-a','1','sollwert','1','--mode','homing','--enable','--hold','--duration','4s'],term=False,yes=True),
'cur':lambda: goL('current',[],['-a','1','sollwert','2A','--enable','--hold','--duration','1s'],term=False,yes=True,friction=5.),
'gearrun':lambda: goL('gear 2/3',[],['-a','1','sollwert','2/3','--enable','--hold','--duration','1s'],term=False,yes=True,setpoints='kept'),
'guard':lambda: goL('node guarding, silence 3 s',[(EN(.8),lambda c:(setattr(c,'mute',True),setattr(c,'nohear',True))),(EN(3.8),lambda c:(setattr(c,'mute',False),setattr(c,'nohear',False)))],H[:-1]+['8s','--watchdog','1s'],term=False,yes=True,guard_state='quick-stop',quick_stop_ends='stays'),
'guardf':lambda: goL('node guarding fault, silence 3 s',[(EN(.8),lambda c:(setattr(c,'mute',True),setattr(c,'nohear',True))),(EN(3.8),lambda c:(setattr(c,'mute',False),setattr(c,'nohear',False)))],H[:-1]+['8s','--watchdog','1s'],term=False,yes=True,guard_state='fault'),
}
if __name__=='__main__':
  for n in (sys.argv[1:] or cases): print('#####',n); cases[n]()
