# cz.py FAM KIND FATE SIGDELAY SEED: group of 4, drive 1 with a fate, drive 4 slow to stop, Ctrl-C SIGDELAY s behind first write; prints how long each drive was unseen at the end
import sys,signal
from vb import *
import h4s
fam,kind,ft,sd,seed=sys.argv[1],sys.argv[2],sys.argv[3],float(sys.argv[4]),int(sys.argv[5]); L=fam=='lx'
RR=random.Random(seed); n=int(__import__('os').environ.get('N','4')); ns=int(__import__('os').environ.get('NSIG','1'))
ds=[]
for a in range(1,n+1):
    d=(LXM if L else ACU)(a); (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
if L: ds[-1].n=1500; ds[-1].p[6938]=1500
else: ds[-1].n=30; ds[-1].ram[484,0]=3000
S={}
def fate(i,t,q,r,d):
    if d is ds[0] and all(x.n==0 for x in ds):
        if ft=='los' and RR.random()<.4: return []
        if ft=='lat' and RR.random()<.4: return [(RR.uniform(.1,.6),r)]
        if ft=='slow': return [(.25,r)]
        if ft=='crc' and RR.random()<.4: return [(0,r[:-1]+bytes([r[-1]^1]))]
        if ft=='dead': return []
        if ft=='alt':
            S['g']=S.get('g',0)+1
            if S['g']%2: return []
    return [(0,r)]
ln=Line(ds,fate)
c=lambda d,t: bool(ds[0].wr) and (S.setdefault('w',t) and t-S['w']>=sd)
c2=lambda d,t: t-S['w']>=sd+.3
args=['-a','1-%d'%n]+{'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
try: r=run(ln,args,ds[0],timeout=150,extra=(),verbose=True,sig=[(c,signal.SIGINT)]+([(c2,signal.SIGINT)] if ns>1 else []))
finally: ln.close()
t1=r['t1']; g={}
for t,k,b in ln.log:
    if k=='<' and b and t<=t1: g[b[0]]=t1-t
nn=[round([m for t,m in d.hist if t<=t1][-1],1) for d in ds]
cap='STILL TURN' in r['out']+r['err']
z=max([t for d in ds for t,m in d.hist if abs(m)>1e-6 and t<=t1],default=0)
l='%s %s %s sig %.2f seed %d rc %s took %.2f cap %d allstand->end %.2f unseen %s n %s %s'%(fam,kind,ft,sd,seed,r['rc'],r['took'],cap,t1-z,{a:round(x,2) for a,x in g.items()},nn,'GAP' if max(g.values())>.4 and not cap else '')
print(l,flush=True); open('out/cz-%s-%s-%s-%s-%d.txt'%(fam,kind,ft,sd,seed),'w').write(l+'\n'+r['out']+r['err']+'\nLOG end %.3f\n'%(t1-r['t0'])+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
