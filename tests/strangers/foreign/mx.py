from cp import *
from concurrent.futures import ThreadPoolExecutor
import json
os.makedirs('out',exist_ok=True)
# driven: patch tick to log driving demand
def patch(cls,f):
    old=cls.tick
    def tick(s,t):
        old(s,t)
        if not hasattr(s,'dr'): s.dr=[]
        if s.power and f(s): s.dr.append(t)
    cls.tick=tick
patch(LXM,lambda s: s.st=='OE' and abs(s.demand())>1e-9)
patch(ACU,lambda s: s.shown()==0x27 and not s.br and abs(s.dem())>1e-9)
class F: # fates with seeds
    def __init__(s,seed): s.r=random.Random(seed)
    def none(s): return None
    def lost(s,p): return lambda i,t,q,r,d: [] if s.r.random()<p else [(0,r)]
    def late(s,a,b=None): return lambda i,t,q,r,d: [(s.r.uniform(a,b or a),r)]
    def dbl(s,p,a,b): return lambda i,t,q,r,d: [(0,r)]+([(s.r.uniform(a,b),r)] if s.r.random()<p else [])
    def mix(s): 
        def f(i,t,q,r,d):
            x=s.r.random()
            if x<.1: return []
            if x<.2: return [(s.r.uniform(0.05,1.2),r)]
            if x<.3: return [(0,r),(s.r.uniform(0,.4),r)]
            if x<.35: b=bytearray(r); b[s.r.randrange(len(b))]^=1<<s.r.randrange(8); return [(0,bytes(b))]
            return [(0,r)]
        return f
    def dead_from(s,cond,sec):
        st={}
        def f(i,t,q,r,d):
            if 't' not in st and cond(d,t): st['t']=t
            if 't' in st and t-st['t']<sec: return []
            return [(0,r)]
        return f
def scen(name,mk,args,agreed_t,agreed_n,fate=None,ev=None,sig=None,lose=None,prep=None,exp0=True,adr=3,settle=1.0):
    d=mk(); 
    if prep: prep(d)
    if ev: d.events=ev(d)
    L=Line([d],fate); 
    if lose: L.lose_req=lose(d)
    if isinstance(d,LXM): before={k:v for k,v in d.p.items() if k not in(6914,6918)}
    else: before=dict(d.ram)
    try:
        r=run(L,['-a',str(adr)]+args,d,settle=settle,sig=sig)
    finally: L.close()
    if isinstance(d,LXM): after={k:v for k,v in d.p.items() if k not in(6914,6918)}
    else: after=dict(d.ram)
    diff={k:(before[k],after[k]) for k in before if before[k]!=after.get(k) and k not in((410,0),(484,0),11,15362,15364,6940)}
    dr=[t for t in getattr(d,'dr',[]) if t>=r['t0']]
    driven=(dr[-1]-dr[0]) if dr else 0
    fl=[]
    if agreed_t and driven>agreed_t+.3: fl.append('LONGER')
    if agreed_n and r['max']>agreed_n*1.03+2: fl.append('FASTER')
    cap='SHAFT MAY STILL TURN' in r['err'] or 'STILL TURN' in r['out']
    still=abs(r['nend'])>1e-6
    if still and not cap: fl.append('TURNS-UNTOLD(%.0f)'%r['nend'])
    if any(t>r['t1'] for t in dr): fl.append('DRIVEN-AFTER'+('' if cap else '-UNTOLD'))
    if d.st=='OE' and not cap: fl.append('ENABLED-AT-END')
    if r['rc']==0 and diff: fl.append('NOTBACK%s'%diff)
    if r['rc']==0 and (d.marks): fl.append('EVENT-RC0')
    if r['rc']=='HANG': fl.append('HANG')
    if cap and not still: fl.append('CBS')
    line='%-44s rc %-4s driven %6.2f max %7.1f took %5.1f end %s n %.0f %s diff=%s marks=%s'%(name,r['rc'],driven,r['max'],r['took'],d.st,r['nend'],' '.join(fl),diff,[m[1]+'@%.2f'%(m[0]-r['t0']) for m in (d.marks or [])])
    with open('out/'+name.replace(' ','_').replace('/','-')+'.txt','w') as f:
        f.write(line+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%.3f %s'%(w[0]-r['t0'],w[1:]) for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in L.log))
    print(line,flush=True)
    return r,d
def go(jobs,n=3):
    with ThreadPoolExecutor(n) as ex:
        fs=[ex.submit(scen,*a,**k) for a,k in jobs]
        for f in fs:
            try: f.result()
            except Exception as e: print('ERR',repr(e))
def J(*a,**k): return (a,k)
