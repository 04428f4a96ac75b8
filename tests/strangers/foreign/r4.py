# r4.py COUNT WORKERS SEED: two (NS) drives, ALL of them set going again and again behind each standstill (KMAX times each), A and B with own delays
import sys,os
from vb import *
from multiprocessing import Pool
import h4s
E=os.environ.get
def one(seed):
  try:
    R=random.Random(seed); fam=R.choice(E('FAMS','lx,rtu').split(',')); kind=R.choice(E('KINDS','disable,zero').split(',')); n=int(R.choice(E('NS','2').split(','))); L=fam=='lx'
    ds=[]
    for a in range(1,n+1):
        d=(LXM if L else ACU)(a); (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    S={'cnt':{},'go':{}}
    dl={d.adr:R.uniform(*[float(x) for x in E('D','.05,.6').split(',')]) for d in ds}; km=int(E('KMAX','6')); sp={d.adr:R.choice([100,300,600]) for d in ds}
    for d in ds:
        z={}
        def ev(dd,t,z=z):
            if dd.n or not dd.wr or (dd.st=='OE' and kind!='zero') or S['cnt'].get(dd.adr,0)>=km: z.pop('t',None); return False
            z.setdefault('t',t); return t-z['t']>=dl[dd.adr]
        def g(dd,t,z=z,ev=ev):
            z.pop('t',None); S['cnt'][dd.adr]=S['cnt'].get(dd.adr,0)+1; S['go'][dd.adr]=t
            x=sp[dd.adr]
            if L: dd.mode=3; dd.p[6918]=3; dd.p[6938]=x; dd.control(6,t); dd.control(15,t); dd.n=x
            else:
                for i in range(1,5): dd.ram[412,i]=1; dd.ram[434,i]=3
                dd.ram[484,0]=x*2; dd.ctl(0,t); dd.ctl(6,t); dd.ctl(15,t); dd.n=x/50
            dd.events.append((ev,g))
        d.events=[(ev,g)]
    args=['-a','1-%d'%n]+{'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
    ln=Line(ds)
    try: r=run(ln,args,ds[0],timeout=150,extra=(),verbose=True)
    finally: ln.close()
    t1=r['t1']; txt=r['out']+r['err']; cap='STILL TURN' in txt
    tu=[]
    for d in ds:
        h=[m for t,m in d.hist if t<=t1][-1]; tu.append((d.adr,round(h,1),d.st,'go %.2f'%(t1-S['go'].get(d.adr,0)) if d.adr in S['go'] else '-',S['cnt'].get(d.adr,0)))
    bad=any(abs(x[1])>1e-6 for x in tu)
    old=max([t1-S['go'][x[0]] for x in tu if abs(x[1])>1e-6 and x[0] in S['go']],default=0)
    last=next((t1-t for t,k,b in reversed(ln.log) if k=='>' and t<=t1),9)
    fl=''
    if bad and r['rc']==0: fl='**FALSE0** old %.2f'%old
    elif bad and not cap: fl='NOCAPS old %.2f'%old
    l='%d %s %s n%d dl %s rc %s took %.2f cap %d %s %s'%(seed,fam,kind,n,['%.2f'%x for x in dl.values()],r['rc'],r['took'],cap,tu,fl)
    open('out/r4-%d.txt'%seed,'w').write(l+'\n'+txt+'\nLOG end %.3f\n'%(t1-r['t0'])+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception:
    import traceback; return 'ERR '+traceback.format_exc()[-400:]
if __name__=='__main__':
    s=int(sys.argv[3]); J=[int(x) for x in E('ONLY').split(',')] if E('ONLY') else [s*1000+i for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2])) as p:
        for x in p.imap_unordered(one,J): print(x,flush=True)
