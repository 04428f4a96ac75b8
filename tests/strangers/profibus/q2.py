from q1 import *
def un(T): 
    def f(s):
        s.mute=True; t=time.monotonic(); s.when(lambda s:time.monotonic()-t>T,lambda s:setattr(s,'mute',False),'u')
    return f
def full(nm,args,opts={},ev=None,drive=None,n=30):
    s=Slave(nm,**opts); s.when(lambda s:s.dx_count>n,ev,'ev'); s.start(); r=run(s,'monitor',*args,'--format','ndjson',quiet=True,drive=drive)
    ts=[round(json.loads(x)['t'],2) for x in r.out.splitlines() if '"sample"' in x]
    g=[(a,b) for a,b in zip(ts,ts[1:]) if b-a>.4]
    e=json.loads(r.out.splitlines()[-1]); print('##',nm,r.rc,'holes in t',g,'gaps',e['summary']['gaps'],'late',e['summary']['late'],'warn',[w['message'][:200] for w in e['warnings']]); print('   ',[x for x in r.err.splitlines() if 'warning' in x or 'note' in x or 'gap' in x or 'again' in x]); print('   wdx',getattr(s,'wd_exp',0)); s.close()
full('q2-mute4',('--interval','100ms','--duration','8s'),ev=un(4))
full('q2-mute4p',('614','--interval','100ms','--duration','8s'),ev=un(4))
full('q2-power',('--interval','100ms','--duration','5s'),ev=lambda s:(s.poweroff(),s.when(lambda s,t=time.monotonic():time.monotonic()-t>1,lambda s:s.poweron(),'u')))
full('q2-mute4i0',('--interval','0','--duration','8s'),ev=un(4))
full('q2-B',('--mode','basic','--interval','100ms','--duration','8s'),dict(getcfg='basic'),un(4),'l200')
full('q2-mute6',('--interval','100ms','--duration','9s'),ev=un(5.8))
