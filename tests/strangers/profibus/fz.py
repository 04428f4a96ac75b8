from c4 import *
import sys
seed=int(sys.argv[1]); end=time.monotonic()+float(sys.argv[2]); n=0; nbad=0
while time.monotonic()<end:
    R_=random.Random(seed); random.seed(seed); rnd.seed(seed); n+=1
    basic=R_.random()<.4
    o=dict(getcfg='basic') if basic else {}
    ch=dict(start=['direct','edge'],b10=['ramp','local','freeze'],zsw_b10=['0','bits'],off2=['ramp','coast'],off3=['coast','quick'],b9=['both','any'],rest8=[True,False],pkw_wait=['old','zero','slow0'],pkw_repeat=['once','every'],p703=[2,2,1,3],p928=[0,1,2],zsw_local=['commanded','0'],b928=['edge','level'],restart=['edge','standing'],wdfeed=['dx','any'],lost_by=[('wd',),('wd','unlock'),('wd','unlock','clear')],p928_lost=['keep','0'],trip_diag=['block','none'],basic_lost=['conn','either'],errword=['low','high'],lock120=['wait','refuse'],dx_keep=[True,False],f003=[1.,2.,3.],pkw_inv_ms=[5,60,250])
    for k,v in ch.items(): o[k]=R_.choice(v)
    a=BRUN if basic else RUN
    if R_.random()<.2: a=a+('--until','reached')
    fault=R_.choice([None,None,None,drop(.1),garble(.1),late(.1,.03),bad(.1),noise(.1)])
    evs=R_.choice([None,None,'trip','mute.3','mute3','power1','leave','frs','928','contact'])
    th=R_.uniform(1,19)
    def su(s):
        if fault: s.hook=fault
        c=lambda s:s.out>th
        if evs=='trip': s.when(c,lambda s:s.do_trip(),evs)
        if evs in('mute.3','mute3'): 
            d=float(evs[4:])
            def on(s): s.mute=True; t1=time.monotonic(); s.when(lambda s:time.monotonic()-t1>d,lambda s:setattr(s,'mute',False),'unmute')
            s.when(c,on,evs)
        if evs=='power1':
            def off(s): s.poweroff(); t1=time.monotonic(); s.when(lambda s:time.monotonic()-t1>1,lambda s:s.poweron(),'on')
            s.when(c,off,evs)
        if evs=='leave': s.when(c,lambda s:s.leave('wd'),evs)
        if evs=='frs': s.when(c,lambda s:setattr(s,'frs',True),evs)
        if evs=='928': s.when(c,lambda s:s.gw.__setitem__(928,0),evs)
        if evs=='contact': s.when(c,lambda s:s.o.update(contact=True),evs)
    sig=None
    if R_.random()<.6:
        sg=[signal.SIGINT,signal.SIGTERM,signal.SIGHUP][R_.randrange(3)]
        sig=[(R_.uniform(1.2,7),sg)]
        while R_.random()<.3: sig.append((R_.uniform(0.01,.6),sg))
    nm='fz%d'%seed
    import io,contextlib
    b=io.StringIO()
    with contextlib.redirect_stdout(b):
        res=S(nm,*a,opts=o,setup=su,sig=sig,after=3.5,drive='l200' if basic else None,msg=True,timeout=100)
    t=b.getvalue(); keep=True
    s,r=res
    sins=[x for x in s.sins if not x[1].startswith('same FCB')]
    bd=[]
    if r.hang: bd.append('HANG')
    if s.turning and not(o.get('x')): bd.append('TURNS')
    if r.rc==0 and (sig is None) and evs in('trip','mute3','power1','leave','928','frs'): bd.append('RC0 with '+evs)
    if r.rc not in(0,130,8,6,4): bd.append('rc%s'%r.rc)
    if sins: bd.append('sins')
    if r.j is None: bd.append('nojson')
    if bd: print('seed',seed,bd,'ev',evs,'sig',sig,'basic',basic,'fault',fault is not None,{k:o[k] for k in('b10','p703','p928','lost_by','dx_keep')}); print(t,flush=True); nbad+=1
    else:
        for x in ('logs/%s.log'%nm,'pty-'+nm):
            try: os.unlink(WD+'/'+x)
            except OSError: pass
    seed+=1
print('runs',n,'flagged',nbad)
