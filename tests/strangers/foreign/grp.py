# grp.py SEED0 COUNT WORKERS : groups of 2..4, one enabled again at a random time
import sys
from vb import *
from multiprocessing import Pool
from blind import shaft
import h4s
def one(seed):
  try:
    R=random.Random(seed)
    n=R.choice([2,2,3,4]); kind=R.choice(['disable','qs','qs','zero','dv'])
    fam=R.choice(['lx','lx','rtu','rtu','ascii','vabus','mix'])
    adrs=R.sample(range(1,9),n); ds=[]
    fams=[]
    for a in adrs:
        f=R.choice(['lx','rtu']) if fam=='mix' else fam
        d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[f](a); fams.append(f)
        if f=='ascii': d.ascii=True
        (h4s.runsl if f=='lx' else h4s.runsa)(d)
        x=R.choice([1,1,2,4])
        if f=='lx': d.n=d.p[6938]=300*x
        else: d.n=6*x; d.ram[484,0]=600*x
        ds.append(d)
    a=[] if fam not in('ascii','vabus') else ['--protocol',fam]
    a+={'disable':['statemachine','disable'],'dv':['statemachine','disable-voltage'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
    if R.random()<.2: a+=['--json']
    v=R.randrange(n); dv=ds[v]; L=fams[v]=='lx'
    trig=R.choice(['zero','zero','any','end']); dt=R.uniform(0,.6) if trig=='zero' else R.uniform(0,3)
    S={}
    moved=lambda d: len(d.wr)>0
    def ev(d,t):
        if not moved(d): return False
        S.setdefault('w',t)
        if d.n==0: S.setdefault('z',t)
        b=S.get('z') if trig!='any' else S['w']
        if trig=='end':
            if any(x.n!=0 for x in ds): return False
            S.setdefault('all',t); return t-S['all']>=dt*.15
        return b is not None and t-b>=dt
    def en(d,t):
        S['en']=t
        if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000; d.ram[434,0]=3
        d.mark(t,'EN')
    dv.events=[(ev,en)]
    loss=R.choice([0,0,0,.03,.1]); 
    late=R.choice([0,0,0,.03])
    ln=Line(ds,(lambda i,t,q,r,dd:[] if R.random()<loss else [(R.uniform(.1,1.2) if R.random()<late else 0,r)]) if loss or late else None)
    try: r=h4s.run2(ln,['-a',','.join(map(str,adrs))]+a,dv)
    finally: ln.close()
    t1=r['t1']; e=S.get('en'); gap=t1-e if e and e<t1 else None
    turning=abs(dv.n)>1e-6
    drv=[t for t in getattr(dv,'dr',[]) if t>t1]
    others=[(x.adr,round(x.n,1),x.st) for x in ds if x is not dv and abs(x.n)>1e-6]
    cap='STILL TURN' in r['out']+r['err']
    fl=''
    if r['rc']=='HANG': fl+='HANG '
    if gap is not None and gap>.05 and (turning or drv):
        if r['rc']==0: fl+='FALSE0 '
        elif not cap: fl+='NOCAPS '
    if others and not cap: fl+='OTHERS '
    if gap is None and r['rc']!=0: fl+='RC-NOEN '
    last=[x[0] for x in ln.log if x[1]=='>' and x[0]<t1]
    l='%d %-5s n%d %-7s v%d %-4s dt %.2f loss %s late %s rc %s took %.2f en %s gap %s n %.1f st %s drv %s cap %d quiet %.2f oth %s %s'%(seed,fam,n,kind,v,trig,dt,loss,late,r['rc'],r['took'],'%.2f'%(e-r['t0']) if e else '-','%.2f'%gap if gap is not None else '-',dv.n,dv.st,bool(drv),cap,t1-last[-1],others,fl)
    open('out/grp-%d.txt'%seed,'w').write(l+'\n-a %s '%adrs+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex: return 'ERR %d %r'%(seed,ex)
if __name__=='__main__':
    A=sys.argv[:]
    with Pool(int(A[3]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,range(int(A[1]),int(A[1])+int(A[2]))): print(x,flush=True)
