# grp2.py SEED0 COUNT WORKERS : two passes over groups; 2nd: enabling behind the last look at the drive with the longest blind time
import sys
from vb import *
from multiprocessing import Pool
import h4s
def look(fam,b,adr):
    try:
        if fam=='lx': return b[0]==adr and b[1]==3 and int.from_bytes(b[2:4],'big') in(6916,7700,7696,7698,7690)
        if fam=='ascii': b=bytes.fromhex(b[1:-2].decode())
        if fam in('ascii','rtu'):
            return b[0]==adr and b[1] in(3,100) and (int.from_bytes(b[2:4],'big')&0xfff) in(411,210,217,241)
        return b[-1:]==b'\x05' and b[-4:-1] in(b'411',b'210',b'217',b'241')
    except Exception: return False
def one(seed,vic=None,at=None):
    R=random.Random(seed)
    n=R.choice([2,2,3,4]); kind=R.choice(['disable','disable','qs','qs','zero'])
    fam=R.choice(['lx','lx','rtu','ascii','vabus','mix'])
    adrs=R.sample(range(1,9),n); ds=[]; fams=[]
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
    a+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
    S={}
    mode=R.choice(['clean','lose1','late1','lose2','late2']); ks=[R.randrange(0,25) for _ in range(2)]; late=R.uniform(.2,2)
    C={'c':0}
    def fate(i,t,q,r,dd):
        if 'b' not in S and any(x.n==0 and x.wr for x in ds): S['b']=t
        if 'b' in S and mode!='clean':
            k=C['c']; C['c']+=1
            if k==ks[0] or mode[-1]=='2' and k==ks[1]: return [] if 'lose' in mode else [(late,r)]
        return [(0,r)]
    v=vic
    if v is not None:
        dv=ds[v]; L=fams[v]=='lx'
        def ev(d,t): 
            if 'w' not in S and any(x.wr for x in ds): S['w']=min(x.wr[0][0] for x in ds if x.wr)
            return 'w' in S and t-S['w']>=at
        def en(d,t):
            S['en']=t
            if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
            else:
                for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
                d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000; d.ram[434,0]=3
        dv.events=[(ev,en)]
    ln=Line(ds,fate)
    try: r=h4s.run2(ln,['-a',','.join(map(str,adrs))]+a,ds[v or 0])
    finally: ln.close()
    t1=r['t1']
    bl=[]
    cur=None
    for i,(f,x) in enumerate(zip(fams,ds)):
        lk=[]
        for t,k,b in ln.log:
            if k!='>' or t>=t1: continue
            if f=='vabus':
                j=b.rfind(b'\x04'); 
                if j>=0 and j+1<len(b): cur=b[j+1]-64
                if cur==x.adr and look(f,b,x.adr): lk.append(t)
            elif look(f,b,x.adr): lk.append(t)
        bl.append((t1-lk[-1],i,lk[-1]) if lk else (99,i,0))
    wmin=min(x.wr[0][0] for x in ds if x.wr)
    m=max(bl)
    cap='STILL TURN' in r['out']+r['err']
    l='%d %-5s n%d %-7s %s ks %s late %.1f rc %s took %.2f blind %s cap %d'%(seed,fam,n,kind,mode,ks,late,r['rc'],r['took'],['%.2f'%x[0] for x in bl],cap)
    if v is not None:
        e=S.get('en'); gap=t1-e if e and e<t1 else None
        turning=abs(ds[v].n)>1e-6 or any(t>t1 for t in getattr(ds[v],'dr',[]))
        if gap and gap>.05 and turning: l+=' gap %.2f n %.1f %s'%(gap,ds[v].n,'**FALSE0**' if r['rc']==0 else '' if cap else 'NOCAPS')
        else: l+=' gap %s n %.1f'%(gap and '%.2f'%gap,ds[v].n)
    open('out/grp2-%d-%s.txt'%(seed,v),'w').write(l+'\n-a %s '%adrs+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l,m,wmin,r
def two(seed):
  try:
    l,m,w,r=one(seed)
    o='P1 '+l
    if r['rc']==0 and m[0]>.18:
        l2,*_=one(seed,m[1],m[2]-w+.06)
        o+='\n  P2 v%d '%m[1]+l2
    return o
  except Exception as ex:
    import traceback; return 'ERR %d %s'%(seed,traceback.format_exc()[-300:])
if __name__=='__main__':
    A=sys.argv[:]
    with Pool(int(A[3]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(two,range(int(A[1]),int(A[1])+int(A[2]))): print(x,flush=True)
