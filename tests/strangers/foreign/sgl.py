# sgl.py COUNT WORKERS SEED : one drive; its k-th reply at rest is lost; 0.02..0.5 s later it is enabled by somebody and its replies are lost from then on (dead) or the next m
import sys
from vb import *
from multiprocessing import Pool
import h4s
from grp2 import look
def one(j):
  try:
    seed,fam,kind,k,m,dt=j
    L=fam=='lx'
    d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](1)
    if fam=='ascii': d.ascii=True
    (h4s.runsl if L else h4s.runsa)(d)
    a=[] if fam not in('ascii','vabus') else ['--protocol',fam]
    a+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
    S={'k':0,'m':0}
    def fate(i,t,q,r,dd):
        if 'a' in S:
            S['m']+=1
            return [] if S['m']<=m else [(0,r)]
        if d.wr and d.n==0:
            S['k']+=1
            if S['k']==k+1: S['l']=t; return []
        return [(0,r)]
    def ev(dd,t): return 'l' in S and t-S['l']>=dt
    def go(dd,t):
        S['a']=t
        if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
    d.events=[(ev,go)]
    ln=Line([d],fate)
    try: r=h4s.run2(ln,['-a','1']+a,d)
    finally: ln.close()
    t1=r['t1']; ga=t1-S['a'] if 'a' in S else None
    lk=[t for t,kk,b in ln.log if kk=='>' and t<t1 and look(fam,b,1)]
    asked=sum(1 for t in lk if 'a' in S and t>S['a'])
    cap='STILL TURN' in r['out']+r['err']
    l='%d %-5s %-7s k%d m%d dt %.2f rc %s took %.2f gapA %s asked behind %d n %s %s cap %d'%(seed,fam,kind,k,m,dt,r['rc'],r['took'],ga and '%.2f'%ga,asked,round(d.n,1),d.st,cap)
    if abs(d.n)>1e-6 and r['rc']==0 and (ga or 0)>.15: l+=' **FALSE0**'
    open('out/sgl-%d.txt'%(seed),'w').write(l+'\n'+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex:
    import traceback; return 'ERR '+traceback.format_exc()[-300:]
if __name__=='__main__':
    s=int(sys.argv[3]); R=random.Random(s); jobs=[(s*100+i,R.choice(['lx','rtu','ascii','vabus']),R.choice(['disable','qs','zero']),R.randrange(0,9),R.choice([1,3,4,5,999]),R.choice([.02,.2,.4])) for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,jobs): print(x,flush=True)
