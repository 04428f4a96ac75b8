from mat import *
random.seed(int(sys.argv[1])); TEND=time.monotonic()+float(sys.argv[2])
KNOWN=[372,373,375,376,480,481,482,483,485,486,487,488,600,601,602,603,604,518,519,392,412,434,549,30,400,637,638,632,418]
A=BIN
# which have unknown sets
r=run(['params','--drive','acu','--format','json'],None); 
P0=table(); cat={}
try:
    def walk(o):
        if isinstance(o,dict):
            if 'param' in o or 'number' in o: cat[o.get('param',o.get('number'))]=o
            for v in o.values(): walk(v)
        elif isinstance(o,list):
            for v in o: walk(v)
    walk(r.j)
except Exception: pass
if cat: 
    k=next(iter(cat)); print(json.dumps(cat.get(480,cat[k]))[:500]); 
n=bad=0; ST={}
while time.monotonic()<TEND:
    rows={}; 
    for p in random.sample(KNOWN,random.randint(1,6)):
        q=P0[p]; ds=0
        for ds in ([0] if not q['ds'] or random.random()<.4 else random.sample([1,2,3,4],random.randint(1,3))):
            lo,hi=q['lo'],q['hi']
            lo=lo if lo is not None else 0; hi=hi if hi is not None else 200
            if p in(412,): v=random.choice([1,2,44])
            elif p==30: v=random.choice([110,210,410])
            else: v=random.choice([lo,hi,random.randint(lo,hi),q['ee'][0]])
            rows[(p,ds)]=v
    T=[(p,ds,v) for (p,ds),v in sorted(rows.items(),key=lambda x:x[0][1])]
    open(W+'/m.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'+''.join('"%d%s" = "raw %d"\n'%(p,'@%d'%ds if ds else '',v) for p,ds,v in T))
    ramm=random.random()<.3; kind=random.choice(['none','lost','refuse','kill','int','int2','power','dead','late','garble','hupsig','powlong']); k=random.randint(3,60)
    difr=random.random()<.4; seed=random.random()
    def prep(d):
        g=random.Random(seed)
        if difr:
            for _ in range(3):
                p=g.choice([x for x,_,_ in T]); q=d.P[p]; i=g.randrange(4) if q['ds'] else 0
                d.set(p,i+1 if q['ds'] else 0,g.randint(q['lo'] or 0,q['hi'] or 200),ee=g.random()<.5)
    def sg(s): 
        def h(d,n,b):
            if n==k or (kind=='int2' and n==k+4):
                try: os.kill(CUR[0].pid,s)
                except OSError: pass
                time.sleep(.03)
        return h
    wc=[0]; kw=random.randint(1,8)
    def refuse(d,n,b):
        if b[1] in(6,101):
            wc[0]+=1
            if wc[0]==kw: return ('exc',4,random.choice([1,6,8]))
    act={'lost':'lost','power':('powerafter',0.4),'dead':'dead','late':('late',0.5),'garble':'garble','powlong':('power',3)}
    hook=None if kind=='none' else refuse if kind=='refuse' else sg(signal.SIGKILL) if kind=='kill' else sg(signal.SIGINT) if kind in('int','int2') else sg(signal.SIGHUP) if kind=='hupsig' else (lambda d,n,b: act[kind] if n==k else None)
    ar=['--timeout','150ms']+(['--ram'] if ramm else [])
    clean(); d=Drive(); prep(d); b=d.snap(); d.hook=hook; d.clr()
    r=run(['dataset','load','m.toml','--yes',*ar],d)
    # target
    mem=('ram',) if ramm else ('ee','ram')
    p=judge('%s k%d kw%d ram%d dif%d'%(kind,k,kw,ramm,difr),r,d,b,T,quiet=True,mem=mem)
    if p: print('     T',T,'before',{q:b[q] for q,_,_ in T},'w',d.wlog); bad+=1
    uf=W+'/m.undo.toml'
    if r.rc!=0 and not (kind.startswith('pow')): 
        d.hook=None; d.dead=False; d.silent=0; d.clr()
        if os.path.exists(uf):
            u=run(['dataset','undo',uf,'--yes','--timeout','150ms'],d); a=d.snap()
            e={q:(b[q],a[q]) for q in a if (a[q][0]!=b[q][0] or ((not difr) and a[q][1]!=b[q][1]))}
            if e or u.rc: print('UNDO after',kind,k,'rc',u.rc,e,((u.j or {}).get('error') or {}).get('message'),'T',T,'before',{q:b[q] for q,_,_ in T}); bad+=1
    d.stop(); n+=1
print('random',n,'bad',bad,STAT)
