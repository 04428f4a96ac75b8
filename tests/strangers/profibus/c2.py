from sc import *
k=int(sys.argv[1]); n=int(sys.argv[2])
sgn=lambda x:getattr(signal,x)
turn=lambda s:s.turning
def at(x): return lambda s:abs(s.out)>=x
def tot(x): # x s after the shaft turns
    def f(s,st={}):
        if s.turning: st.setdefault(id(s),time.monotonic())
        return id(s) in st and time.monotonic()-st[id(s)]>=x
    return f
I=signal.SIGINT;T=signal.SIGTERM;H=signal.SIGHUP;K=signal.SIGKILL
rnd=random.Random(7)
C=[]
for t in [0.3,1.3,1.36,1.5,1.8,2.2,2.6,2.9]: C.append(('int@%.2f'%t,RUN,[(t,I)],{},0))
for t in [0.02,0.12,0.2,0.6,1.2]: C.append(('int turn+%.2f'%t,RUN,[(tot(t),I)],{},0))
C+=[('term',RUN,[(tot(.5),T)],{},0),('hup',RUN,[(tot(.5),H)],{},0),('int2',RUN,[(tot(.5),I),(.2,I)],{},4),('int3',RUN,[(tot(.5),I),(.2,I),(.2,I),(.1,I)],{},4),('term2',RUN,[(tot(.5),T),(.1,T)],{},4),
 ('kill p703=0 wd',RUN,[(tot(.5),K)],dict(p703=0),4),('kill p703=4 wd',RUN,[(tot(.5),K)],dict(p703=4),4),('kill p703=2 nowd',[x for x in RUN if x not in('--watchdog','1s')],[(tot(.5),K)],{},5),
 ('kill p703=0 nowd',[x for x in RUN if x not in('--watchdog','1s')],[(tot(.5),K)],dict(p703=0),5),
 ('int in stop',RUN,[(lambda s:s.bus_run is False and s.turning and s.stw==0x47e,I)],{},2),
 ('int in giveback',RUN,[(lambda s:(928,0) in [w[1:] for w in s.writes],I)],{},2),
 ('int in zeros',RUN,[(lambda s:len(s.stws)>4 and s.stw==0,I)],{},2),
 ('int at 928=1',RUN,[(lambda s:s.gw[928]==1,I)],{},2),
 ('B int',BRUN,[(tot(.5),I)],dict(getcfg='basic'),0),('B int2',BRUN,[(tot(.5),I),(.2,I)],dict(getcfg='basic'),0),('B term',BRUN,[(tot(.05),T)],dict(getcfg='basic'),0),
 ('B kill',BRUN+('--watchdog','1s'),[(tot(.5),K)],dict(getcfg='basic'),4),('B kill p620',BRUN+('--watchdog','1s'),[(tot(.5),K)],dict(getcfg='basic',basic_lost='either',p620=1),4),
 ('coast exit',RUN+('--on-exit','coast'),None,{},4),('coast exit int',RUN+('--on-exit','coast'),[(tot(.5),I)],{},4),('qs exit',RUN+('--on-exit','quick-stop'),None,{},2),('keep exit',RUN+('--on-exit','keep'),None,{},2),
 ('B coast',BRUN+('--on-exit','coast'),None,dict(getcfg='basic'),0),('int contact',RUN,[(tot(.5),I)],dict(contact=True),0),
]
for i,(nm,a,sg,o,af) in enumerate(C):
    if i%n!=k: continue
    print('#',nm,o); S('c2-%d'%i,*a,opts=o,sig=sg,after=af,drive='l200' if 'basic' in a else None,msg=True)
