from s1 import *
def vstop(log,t0):
    dst={}
    for t,k,b in log:
        if k!='>': continue
        if b[:1]==b'\x04' and b'\x02' in b[:4] and b[4:7] in(b'410',b'484',b'524'): dst.setdefault(b[1]-64,round(t-t0,2))
        elif isstop(b): dst.setdefault(b[0],round(t-t0,2))
    return dst
def runs(d):
    if isinstance(d,LXM):
        d.st='OE'; d.mode=3; d.p[6918]=3; d.p[6938]=900; d.p[6914]=15; d.n=900
    else:
        for i in range(1,5): d.ram[412,i]=d.ee[412,i]=1
        d.cw=15; d.st='OE'; d.ram[484,0]=2000; d.n=20
def grp(name,args,spec,ext=[],to=None,prep=runs):
    # spec: list of (family, adr, late or None=dead)
    ds=[];late={}
    for f,a,l in spec:
        if l=='dead': d=Dead(a)
        else: d=(LXM if f=='l' else ACU)(a); prep(d); late[a]=l
        ds.append(d)
    def fate(i,t,q,r,d): 
        l=late[d.adr]
        if isinstance(l,str) and l.startswith('lost'): return [] if random.random()<float(l[4:]) else [(0,r)]
        return [(l,r)]
    L=Line(ds,fate)
    try:
        r=run(L,['-a',','.join(str(a) for f,a,l in spec)]+args+(['--timeout',to] if to else []),None,timeout=90,extra=('--yes',)+tuple(ext))
        dst=vstop(L.log,r['t0'])
        # when did it begin to slow
        slow={}
        for d in ds:
            if isinstance(d,Dead): continue
            h=[(t,n) for t,n in d.hist if t>=r['t0']]; n0=h[0][1]
            x=[t for t,n in h if abs(n)<abs(n0)*.98]; z=[t for t,n in h if abs(n)>1e-6]
            slow[d.adr]=(round(x[0]-r['t0'],2) if x else None, round(z[-1]-r['t0'],2) if z else 0, round(d.n,1), d.st)
        cap='STILL TURN' in r['err'] or 'STILL TURN' in r['out']
        bad=any(abs(v[2])>1e-6 for v in slow.values()) and not cap
        print('%-34s rc %s took %5.2f first stop %s slow/last/end %s cap %s %s'%(name,r['rc'],r['took'],dst,slow,cap,'BAD' if bad else ''),flush=True)
        open('out/s2-'+name.replace(' ','_').replace('/','-')+'.txt','w').write(r['out']+r['err']+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in L.log))
    finally: L.close()
if __name__=='__main__':
    G={'a3-mid-dead':[('a',1,0),('a',2,'dead'),('a',3,0)],'a-first-dead':[('a',1,'dead'),('a',2,0)],'a5-2dead':[('a',1,'dead'),('a',2,0),('a',3,'dead'),('a',4,.3),('a',5,0)],
       'l3-first-dead':[('l',1,'dead'),('l',2,0),('l',3,0)],'mix-l-a-dead':[('l',1,0),('a',2,0),('l',3,'dead'),('a',4,0)],'a3-slow':[('a',1,.45),('a',2,.45),('a',3,.45)],'l2-slow6':[('l',1,.6),('l',2,0)],'a2-slow6':[('a',1,.6),('a',2,0)],'a1-slow6':[('a',1,.6)],'l1-slow1':[('l',1,1.0)],'a-lost':[('a',1,'lost0.4'),('a',2,'lost0.4')],'a4dead-live':[('a',1,'dead'),('a',2,'dead'),('a',3,'dead'),('a',4,'dead'),('a',5,0)]}
    V={'disable':['statemachine','disable'],'zero':['sollwert','0'],'qs':['statemachine','quick-stop']}
    with ThreadPoolExecutor(5) as ex:
        fs=[]
        for g,sp in G.items():
            for v,a in V.items(): 
                fs.append(ex.submit(grp,'%s-%s'%(g,v),a,sp))
                if g in('a5-2dead','mix-l-a-dead') : fs.append(ex.submit(grp,'%s-%s-t5'%(g,v),a,sp,[], '5s'))
        for f in fs:
            try: f.result()
            except Exception as e: print('ERR',repr(e))
