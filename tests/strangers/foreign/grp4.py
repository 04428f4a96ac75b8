# grp4.py COUNT WORKERS : two drives; the LAST is enabled again behind being proven, and while it is stopped again the first one is enabled too
import sys
from vb import *
from multiprocessing import Pool
import h4s
from grp2 import look
def one(j):
  try:
    seed,fam,kind,dt,dt2=j
    adrs=[1,2]; ds=[]
    L=fam=='lx'
    for a in adrs:
        d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](a)
        if fam=='ascii': d.ascii=True
        (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    a=[] if fam not in('ascii','vabus') else ['--protocol',fam]
    a+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop']}[kind]
    S={}
    def go(d,t,k):
        S[k]=t; S['n'+k]=len(d.wr)
        if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
    def ev2(d,t):
        if any(x.n or not x.wr for x in ds): return False
        S.setdefault('z',t); return t-S['z']>=dt
    def ev1(d,t):
        if 'b' not in S: return False
        if 'r' not in S:
            if len(ds[1].wr)>S['nb']: S['r']=t
            return False
        return t-S['r']>=dt2
    ds[1].events=[(ev2,lambda d,t:go(d,t,'b'))]; ds[0].events=[(ev1,lambda d,t:go(d,t,'a'))]
    ln=Line(ds)
    try: r=h4s.run2(ln,['-a','1,2']+a,ds[0])
    finally: ln.close()
    t1=r['t1']; ga=t1-S['a'] if 'a' in S else None; gb=t1-S['b'] if 'b' in S else None
    cap='STILL TURN' in r['out']+r['err']
    l='%d %-5s %-7s dt %.2f dt2 %.2f rc %s took %.2f gapB %s restop %s gapA %s n %s %s cap %d'%(seed,fam,kind,dt,dt2,r['rc'],r['took'],gb and '%.2f'%gb,'r' in S,ga and '%.2f'%ga,[round(x.n,1) for x in ds],[x.st for x in ds],cap)
    if any(abs(x.n)>1e-6 for x in ds) and r['rc']==0 : l+=' **FALSE0**'
    open('out/grp4-%d.txt'%seed,'w').write(l+'\n'+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex:
    import traceback; return 'ERR '+traceback.format_exc()[-300:]
if __name__=='__main__':
    R=random.Random(int(sys.argv[3]) if len(sys.argv)>3 else 5); jobs=[(i,R.choice(['lx','rtu','ascii','vabus']),R.choice(['disable','qs']),R.choice([.01,.05,.1,.3,.5,.6]),R.uniform(.02,.8)) for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,jobs): print(x,flush=True)
