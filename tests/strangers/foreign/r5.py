# r5.py FAM KIND X Y N: a master enables ALL drives at once whenever all stand for X s, 4 times; behind the 4th, drive 1 alone Y s behind its standstill while drive N (fast, slow to stop) still slows
import sys,os
from vb import *
import h4s
fam,kind,X,Y,n=sys.argv[1],sys.argv[2],float(sys.argv[3]),float(sys.argv[4]),int(sys.argv[5]); L=fam=='lx'; K=int(os.environ.get('K','4'))
ds=[]
for a in range(1,n+1):
    d=(LXM if L else ACU)(a); (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
S={'k':0}; T=[]
def go(d,t,x):
    if L: d.mode=3; d.p[6918]=3; d.p[6938]=x; d.control(6,t); d.control(15,t); d.n=x
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ram[484,0]=x*2; d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.n=x/50
def ev(d,t):
    if S['k']>=K:
        if 'f' in S: return False
        if ds[0].n==0 and t-T[-1]>.1:
            S.setdefault('y',t); return t-S['y']>=Y
        return False
    if all(x.n==0 and x.wr for x in ds): S.setdefault('z',t); return t-S['z']>=X
    S.pop('z',None); return False
def g(d,t):
    if S['k']>=K:
        S['f']=t; S['nB']=ds[-1].n; go(ds[0],t,300); return
    S['k']+=1; T.append(t); S.pop('z',None)
    for x in ds: go(x,t,(1500 if L else 1500) if x is ds[-1] and S['k']==K else 60)
    d.events.append((ev,g))
ds[0].events=[(ev,g)]
args=['-a','1-%d'%n]+{'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
ln=Line(ds)
try: r=run(ln,args,ds[0],timeout=150,extra=(),verbose=True)
finally: ln.close()
t1=r['t1']; txt=r['out']+r['err']; cap='STILL TURN' in txt
nn=[round([m for t,m in d.hist if t<=t1][-1],1) for d in ds]
l='%s %s X%s Y%s n%d rc %s took %.2f cap %d k %d all-enabled before end %s A-enabled %s nB then %s n %s %s'%(fam,kind,X,Y,n,r['rc'],r['took'],cap,S['k'],['%.2f'%(t1-t) for t in T],'f' in S and '%.2f'%(t1-S['f']),S.get('nB'),nn,[d.st for d in ds])
if any(abs(x)>1e-6 for x in nn) and r['rc']==0: l+=' **FALSE0**'
elif any(abs(x)>1e-6 for x in nn) and not cap: l+=' NOCAPS'
print(l,flush=True); open('out/r5-%s-%s-%s-%d.txt'%(fam,kind,X,n),'w').write(l+'\n'+txt+'\nLOG end %.3f\n'%(t1-r['t0'])+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
