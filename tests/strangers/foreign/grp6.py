# grp6.py COUNT WORKERS : two drives, first stands early and is enabled again at once when it has been proven, its later replies: dead / lost k / late / doubled
import sys
from vb import *
from multiprocessing import Pool
import h4s
from grp2 import look
def one(j):
  try:
    seed,fam,kind,mode,late,dt=j
    adrs=[1,2]; ds=[]
    L=fam=='lx'
    for a in adrs:
        d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](a)
        if fam=='ascii': d.ascii=True
        (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    if L: ds[1].n=1500; ds[1].p[6938]=1500
    else: ds[1].n=30; ds[1].ram[484,0]=3000
    a=[] if fam not in('ascii','vabus') else ['--protocol',fam]
    a+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop']}[kind]
    S={'k':0}
    def go(d,t):
        S['a']=t
        if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
    def ev(d,t):  # the second stands: the first was proven long ago
        if any(x.n or not x.wr for x in ds): return False
        S.setdefault('z',t); return t-S['z']>=dt
    ds[0].events=[(ev,go)]
    def fate(i,t,q,r,dd):
        if 'a' not in S or dd is not ds[0]: return [(0,r)]
        k=S['k']; S['k']+=1
        if mode=='dead': return []
        if mode=='lost1' and k==0: return []
        if mode=='lost2' and k<2: return []
        if mode=='lost3' and k<3: return []
        if mode=='late': return [(late,r)]
        if mode=='late1' and k==0: return [(late,r)]
        if mode=='dup': return [(0,r),(late,r)]
        if mode=='dup1' and k==0: return [(0,r),(.03,r)]
        return [(0,r)]
    ln=Line(ds,fate)
    try: r=h4s.run2(ln,['-a','1,2']+a,ds[0])
    finally: ln.close()
    t1=r['t1']; ga=t1-S['a'] if 'a' in S else None
    lk=[[t for t,k,b in ln.log if k=='>' and t<t1 and look(fam,b,x.adr)] for x in ds]
    asked=sum(1 for t in lk[0] if 'a' in S and t>S['a'])
    cap='STILL TURN' in r['out']+r['err']
    l='%d %-5s %-7s %-6s late %.2f dt %.2f rc %s took %.2f gapA %s asked behind %d n %s %s cap %d'%(seed,fam,kind,mode,late,dt,r['rc'],r['took'],ga and '%.2f'%ga,asked,[round(x.n,1) for x in ds],[x.st for x in ds],cap)
    if any(abs(x.n)>1e-6 for x in ds) and r['rc']==0 and (ga or 0)>.1: l+=' **FALSE0**'
    open('out/grp6-%d.txt'%(seed),'w').write(l+'\n'+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex:
    import traceback; return 'ERR '+traceback.format_exc()[-300:]
if __name__=='__main__':
    R=random.Random(7); jobs=[(i,f,R.choice(['disable','qs']),m,R.uniform(.15,1),R.choice([.02,.2])) for i,(f,m) in enumerate([(f,m) for m in('dead','lost1','lost2','lost3','late','late1','dup','dup1') for f in('lx','rtu','ascii','vabus')])]
    R.shuffle(jobs)
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,jobs[:int(sys.argv[1])]): print(x,flush=True)
