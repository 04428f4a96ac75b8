from mm import *
import threading
O='--family acu --set 418=0 --set 434=2 --set 638=5 '
H=['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s']
def g(n,tr=(),a=H,o=O,rep=2,d=None,**k):
    for i in range(rep):
        dr=[d() if d else Cube(o)]; c=run(dr,a,triggers=tr,quiet=True,maxt=40,after=1,**k)
        print('##',n,'|',' '.join(a),'\n  rc',c.rc,'%.1fs'%c.dur,'HANG' if c.hang else '','end',c.end,'later',c.later,'speeds',[h[1][0][1] for h in c.hist][::14]); print('   words',' '.join('%.2f %s'%w for w in c.words)[:500]); print('   out',c.out.strip().replace('\n',' | ')[:500]); print('   err',(c.err+' TTY '+c.ttys).strip().replace('\n',' | ')[-700:],'diff',dr[0].diff(),flush=True)
def STOP(c): c.p.send_signal(signal.SIGSTOP)
def CONT(c): c.p.send_signal(signal.SIGCONT)
if __name__=="__main__":
  pass
# freeze
if __name__=="__main__": g('frozen 3 s in the run',[(EN(.8),STOP),(EN(3.8),CONT)],H+['--yes'])
if __name__=="__main__": g('frozen 3 s with watchdog 1s',[(EN(.8),STOP),(EN(3.8),CONT)],H[:-1]+['6s','--yes','--watchdog','1s'])
if __name__=="__main__": g('frozen during the stop wait 1.5 s, load drives on',[(W('P410@0=0x7',.05),STOP),(W('P410@0=0x7',1.5),CONT)],H+['--yes'])
# question changes, LXM05
LH=['-a','1','sollwert','300rpm','--enable','--hold','--duration','1s']
def setv(**kw):
    def setv(c): c.drives[0].d.value.update(kw)
    return setv
def mode(m):
    def mode(c): c.drives[0].d.mode=m; c.drives[0].d.value['DCOMopmode']=m
    return mode
L1=lambda **k:(lambda: Lx(1,**k))
if __name__=='__main__':
    g('LXM: RAMPn_max 100 while it asks',[(ASK(.3,Y),setv(RAMPn_max=100)),(ASK(.6,Y),key(b'y\n'))],LH,d=L1(left='DCOMopmode=3'),term='in',rep=1)
    g('LXM: enabled by another at 2000 while it asks',[(ASK(.3,Y),lambda c:(setattr(c.drives[0].d,'state','enabled'),setattr(c.drives[0].d,'mode',3),c.drives[0].d.value.update(PVn_target=2000,DCOMopmode=3,DCOMcontrol=15),c.drives[0].d.acting.update(PVn_target=2000))),(ASK(2,Y),key(b'y\n'))],LH,d=L1(),term='in')
    g('LXM enable: mode -2 gear with reference set while it asks',[(ASK(.3,Y),lambda c:(mode(-2)(c),setv(GEARreference=1)(c))),(ASK(.6,Y),key(b'y\n'))],['-a','1','statemachine','enable','--hold','--duration','1s'],d=L1(left='DCOMopmode=3'),term='in')
    g('LXM run: mode changed by another master in the run',[(EN(.4),lambda c:(mode(-2)(c),setv(GEARreference=1)(c),c.drives[0].d.acting.update(GEARreference=1)))],LH+['--yes'],d=L1())
    g('LXM run: PVn_target -2000 by another once',[(EN(.4),lambda c:(c.drives[0].d.value.update(PVn_target=-2000),c.drives[0].d.acting.update(PVn_target=-2000)))],LH+['--yes'],d=L1())
    g('ACU: ramps changed and P.419 up while it asks',[(ASK(.3,Y),setx(lambda d:d.ram.__setitem__((419,1),500))),(ASK(.6,Y),key(b'y\n'))],H,term='in')
    g('ACU: P.418 30 Hz while it asks',[(ASK(.3,Y),setx(lambda d:d.ram.__setitem__((418,1),3000))),(ASK(.6,Y),key(b'y\n'))],H,term='in',rep=1)
    g('ACU contacts: internal 40 while it asks',[(ASK(.3,Y),setx(lambda d:setattr(d.opt,'internal',40.))),(ASK(.6,Y),key(b'y\n'))],['-a','1','statemachine','contacts','S1IND','S2IND','--hold','--duration','1s'],O+'--set 412=2 --set 434=1 ',term='in')
    g('ACU reset: word 0F and level while it asks',[(ASK(.6,Y),key(b'y\n'))],['-a','1','statemachine','goto','operation-enabled'],O+'--internal 20 --set 434=1 ',term='in',rep=1)
    g('drive replaced by an LXM05 while asked: no',[],['-a','1','statemachine'],rep=1)
