# h1.py COUNT WORKERS: an ACU is enabled by another master in the giving back (behind P.484=0/P.410=0 of ours, before/behind P.412)
import sys,h4b
from h4b import *
def one(seed):
    R=random.Random(seed)
    fam=R.choice(['rtu','ascii','vabus']); mk={'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam]
    fmin=R.choice([0,0,100]); d=mk(1,set={418:fmin}); d.ascii=fam=='ascii'
    oe=R.choice(['ramp','quick-stop','coast','enable'])
    a=[] if fam=='rtu' else ['--protocol',fam]
    a+=(['sollwert','5Hz','--take-control','--jog','600ms','--on-exit',oe] if oe!='enable' else ['statemachine','enable','--hold','--duration','600ms','--take-control'])
    if oe=='enable': d.ram[434,0]=1
    act=R.choice(['after484','before410','after410','after412','pre']); dt=R.uniform(0,.12) if act!='pre' else R.uniform(0,.3)
    kind=R.choice(['bus','bus','contact']); hz=R.choice([100,300,500,3000]); acc=R.choice([500,2000])
    for i in range(1,5): d.ram[420,i]=acc
    S={}
    def stop(x,t): # stands after the run
        return True
    def ev(dd,t):
        turned='tn' in S
        if abs(d.n)>.5: S['tn']=1
        if not turned: return False
        if d.n==0 and 'z' not in S: S['z']=t
        if 'z' not in S: return False
        w=[x for x in d.wr if x[0]>=S['z']-.3]
        def first(f): 
            y=[x for x in w if f(x)]
            return y[0][0] if y else None
        x={'after484':lambda x:x[1] in(484,524) and x[3]==0,'before410':lambda x:x[1] in(484,524) and x[3]==0,'after410':lambda x:x[1]==410 and x[3]==0,'after412':lambda x:x[1]==412 and x[3]==44,'pre':lambda x:True}[act]
        t0=S['z'] if act=='pre' else first(x)
        return t0 is not None and t-t0>=dt
    def en(dd,t):
        S['en']=t
        if kind=='bus':
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=hz
        else:
            for i in range(1,5): d.ram[412,i]=44; d.ram[434,i]=3
            d.o['contact_start']=True; d.ram[484,0]=hz
        d.mark(t,'EN')
    d.events=[(ev,en)]
    lose=R.choice([0,0,0,.05])
    ln=Line([d],(lambda i,t,q,r,dd:[] if 'z' in S and R.random()<lose else [(0,r)]) if lose else None)
    try: r=run2(ln,['-a','1']+a,d)
    finally: ln.close()
    t1=r['t1']; e=S.get('en'); gap=t1-e if e else None; txt=r['out']+r['err']; cap='STILL TURN' in txt
    turning=abs(r['nend'])>1e-6; pk=max((abs(n) for t,n in d.hist if e and t>=e and t<=t1),default=0)
    fl=''
    if r['rc']=='HANG': fl+='HANG '
    if gap and gap>.1 and turning: 
        if r['rc']==0: fl+='FALSE0 '
        elif not cap: fl+='NOCAPS '
    import re
    words=' | '.join(x.strip() for x in r['out'].splitlines() if re.match(r'\s*(stop|running|state)\s',x))
    l='%d %-5s %-10s %-9s dt %.2f %-7s hz %d lose %s rc %s took %.2f gap %s n %.2f pk %.2f %s cap %d %s :: %s'%(seed,fam,oe,act,dt,kind,hz,lose,r['rc'],r['took'],'%.2f'%gap if gap else '-',r['nend'],pk,d.st,cap,fl,words)
    open('out/h1-%d.txt'%seed,'w').write(l+'\n'+r['out']+'\n'+r['err']+'\nMARKS %s\nWRITES\n'%[(m[1],round(m[0]-r['t0'],3)) for m in d.marks or []]+'\n'.join('%.3f %s'%(w[0]-r['t0'],w[1:]) for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log)+'\nHIST\n'+'\n'.join('%.3f %.1f'%(t-r['t0'],n) for t,n in d.hist[::10]))
    return l
if __name__=='__main__':
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,range(7000,7000+int(sys.argv[1]))): print(x,flush=True)
