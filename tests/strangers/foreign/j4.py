from vb import *
lx=lambda **o:(lambda: LXM(3,**o)); ac=lambda **o:(lambda: ACU(1,**o))
jobs=[]
def K(name,mk,a,dur,n,**k): jobs.append(J(name,mk,a,dur,n,**k))
turn=lambda d,t: abs(d.n)>(5 if isinstance(d,LXM) else .5)
def setp(p,v):
    def f(d,t): d.p[p]=v&0xffffffff; d.mark(t,'%d=%d'%(p,v))
    return f
def sets(v):
    def f(d,t): d.ram[484,0]=v; d.mark(t,'484=%d'%v)
    return f
def ren(v=15):
    def f(d,t):
        if isinstance(d,LXM): d.control(6,t); d.control(15,t); d.mark(t,'reen')
        else: d.ctl(6,t); d.ctl(v,t); d.mark(t,'reen')
    return f
def mode(v):
    def f(d,t): d.mode=v; d.p[6918]=v&0xffffffff; d.p[8456]=400;d.p[6946]=2; d.mark(t,'mode=%d'%v)
    return f
V=['sollwert','300rpm']; A=['sollwert','20Hz','--take-control']
slow={1558:750}
def slowl(d): d.p[1558]=200 if False else 750
dec=lambda d: d.ram.update({(421,i):200 for i in range(1,5)})
for w in (1.02,1.1,1.25,1.5):   # stop takes .4 s on lxm at 300 rpm
    K('j4-lx-sp-%s'%w,lx(),V+['--jog','1s'],None,None,ev=lambda d,w=w:[(ev_after(turn,w),setp(6938,500))])
    K('j4-lx-mode-%s'%w,lx(),V+['--jog','1s'],None,None,ev=lambda d,w=w:[(ev_after(turn,w),mode(-4))])
    K('j4-lx-reen-%s'%w,lx(),V+['--jog','1s'],None,None,ev=lambda d,w=w:[(ev_after(turn,w),lambda d,t:(ren()(d,t),setp(6938,500)(d,t)))])
for w in (1.05,1.3,2,3.0):
    K('j4-ac-sp-%s'%w,ac(set={418:0}),A+['--jog','1s'],None,None,adr=1,ev=lambda d,w=w:[(ev_after(turn,w),sets(4000))])
    K('j4-ac-reen-%s'%w,ac(set={418:0}),A+['--jog','1s'],None,None,adr=1,ev=lambda d,w=w:[(ev_after(turn,w),ren())])
for oe in('quick-stop','coast'):
    for w in (1.05,1.3):
        K('j4-lx-%s-sp-%s'%(oe,w),lx(),V+['--jog','1s','--on-exit',oe],None,None,ev=lambda d,w=w:[(ev_after(turn,w),lambda d,t:(ren()(d,t),setp(6938,500)(d,t)))])
        K('j4-ac-%s-%s'%(oe,w),ac(set={418:0}),A+['--jog','1s','--on-exit',oe],None,None,adr=1,ev=lambda d,w=w:[(ev_after(turn,w),ren())])
sg=lambda sec: [(ev_after(turn,sec),signal.SIGINT)]
for w in (1.1,1.3): 
    K('j4-lx-int-sp-%s'%w,lx(),V+['--enable','--hold'],None,None,sig=sg(1),ev=lambda d,w=w:[(ev_after(turn,w),setp(6938,500))])
    K('j4-ac-int-reen-%s'%w,ac(set={418:0}),A+['--enable','--hold'],None,None,adr=1,sig=sg(1),ev=lambda d,w=w:[(ev_after(turn,w),ren())])
# verbs against running drives
def runsl(d): d.st='OE'; d.mode=3; d.p[6918]=3; d.p[6938]=900; d.p[6914]=15; d.n=900
def runsa(d):
    for i in range(1,5): d.ram[412,i]=d.ee[412,i]=1; d.ram[418,i]=0
    d.cw=15; d.st='OE'; d.ram[484,0]=2000; d.n=20
for v,a in (('disable',['statemachine','disable']),('qs',['statemachine','quick-stop']),('dv',['statemachine','disable-voltage']),('zero',['sollwert','0'])):
    for w in (.3,.7,1.2):
        K('j4-v-lx-%s-sp-%s'%(v,w),lx(),a,None,None,prep=runsl,ev=lambda d,w=w:[(ev_after(lambda d,t:len(d.wr)>0,w),setp(6938,1500))])
        K('j4-v-lx-%s-re-%s'%(v,w),lx(),a,None,None,prep=runsl,ev=lambda d,w=w:[(ev_after(lambda d,t:len(d.wr)>0,w),lambda d,t:(ren()(d,t),setp(6938,1500)(d,t)))])
        K('j4-v-ac-%s-re-%s'%(v,w),ac(),a,None,None,prep=runsa,adr=1,ev=lambda d,w=w:[(ev_after(lambda d,t:len(d.wr)>0,w),lambda d,t:(ren()(d,t),sets(4500)(d,t)))])
# measure: time from the last foreign mark to the fight (first falling n after)
import mx
def go2(jobs,n=5):
    def do(a,k):
        r,d=scen(*a,**k)
        m=[x[0] for x in d.marks or []]
        if m:
            m0=m[-1]; h=[(t,n) for t,n in d.hist if t>=m0]
            w=[x for x in d.wr if x[0]>m0+.001]
            up=[t for t,n in h]; pk=max(h,key=lambda x:abs(x[1]))
            z=[t for t,n in h if abs(n)>1e-6]
            print('   %-30s foreign at %.2f first own write +%.2f (%s) peak %.0f at +%.2f last turn +%.2f'%(a[0],m0-r['t0'],w[0][0]-m0 if w else -1,w[0][1:] if w else '',pk[1],pk[0]-m0,(z[-1]-m0) if z else 0),flush=True)
    with ThreadPoolExecutor(n) as ex:
        for f in [ex.submit(do,a,k) for a,k in jobs]:
            try: f.result()
            except Exception as e: print('ERR',repr(e))
go2(jobs)
