# n2.py COUNT WORKERS SEED : (cd /tmp/judge9/foreign && ANTRIEB=.. python3 ../new/n1.py 10 1 5) groups; pass 1 without event measures who is unseen how long before exit and the length, pass 2 (and 3) enables drive v in the closing second. (n1 with overrides by env: V U EVK U3 SP FATE SLOW N KIND FS STAG W WHO) env FAMS KINDS NS FATES EVS LAGS ONLY
import sys,os
sys.path.insert(0,os.getcwd())
from vb import *
from multiprocessing import Pool
import h4s
E=os.environ.get
for cls in(LXM,ACU):
    def mkp(old):
        def tick(s,t):
            old(s,t)
            if not hasattr(s,'sh'): s.sh=[]
            en=s.power and (s.st=='OE' if isinstance(s,LXM) else s.shown()==0x27)
            k=(s.st if s.power else 'OFF',en,abs(s.n)>1e-6)
            if not s.sh or s.sh[-1][1]!=k: s.sh.append((t,k,s.n))
        return tick
    cls.tick=mkp(cls.tick)
def go_(d,t,x,L):
    if L: d.mode=3; d.p[6918]=3; d.p[6938]=x; d.control(6,t); d.control(15,t)
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ram[484,0]=x; d.ctl(0,t); d.ctl(6,t); d.ctl(15,t)
def one(seed,ev=None,T=0):
    R=random.Random(seed); C=lambda k,d: R.choice(E(k,d).split(','))
    fam=C('FAMS','lx,lx,rtu,mixed,mixed,ascii,vabus'); kind=C('KINDS','disable,qs,dv,zero,zero'); n=int(C('NS','2,3,4,6'))
    fate_=C('FATES','clean,clean,slow,slow1,lateR,lostR,dupR,mixR'); lags=[float(x) for x in E('LAGS','0.05,.15,.25,.45').split(',')]
    slow=R.choice(lags); v=R.randrange(n); stag=R.random()<.6; evk=C('EVS','en,en,brief,rep,two'); brf=R.choice([.1,.25,.5]); late=R.choice([.15,.3,.45,.7]); js=R.random()<.2
    fs=[('lx' if R.random()<.5 else 'rtu') if fam=='mixed' else fam for _ in range(n)]
    who=R.randrange(n); u=R.uniform(0.05,1.3); u3=R.uniform(.0,.5); sp=R.choice([500,60]); p=R.choice([.1,.25]); w=R.randrange(n)
    v=int(E('V',v)); u=float(E('U',u)); evk=E('EVK',evk); u3=float(E('U3',u3)); sp=int(E('SP',sp)); fate_=E('FATE',fate_); slow=float(E('SLOW',slow)); kind=E('KIND',kind); stag=int(E('STAG',stag)); w=int(E('W',w)); who=int(E('WHO',who)); js=False
    v%=n; w%=n; who%=n
    if E('FS'): fs=E('FS').split(','); n=len(fs); fam='ascii' if fs[0]=='ascii' else 'vabus' if fs[0]=='vabus' else 'mixed' if len(set(fs))>1 else fs[0]; v%=n; w%=n; who%=n
    ds=[]
    for i,f in enumerate(fs):
        d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[f](i+1)
        if f=='ascii': d.ascii=True
        (h4s.runsl if f=='lx' else h4s.runsa)(d); ds.append(d)
    if stag:
        d=ds[w]
        if fs[w]=='lx': d.n=1500; d.p[6938]=1500
        else: d.n=30; d.ram[484,0]=3000
    args=(['--protocol',fam] if fam in('ascii','vabus') else [])+['-a',('1-%d'%n if R.random()<.5 else ','.join(str(d.adr) for d in ds))]+{'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
    if js: args+=['--json']
    S={}; RR=random.Random(seed+7)
    def rest(): return all(x.wr and x.n==0 for x in ds)
    def fate(i,t,q,r,d):
        o=[(0,r)]
        if fate_=='jit' : return [(RR.uniform(0,slow),r)]
        if fate_=='slow': return [(slow,r)]
        if fate_=='noid1':
            if d is ds[who] and q[1:2]==b'\x2b': return []
            return o
        if fate_=='no641':
            if d is ds[who] and q[1:2]==b'\x64': return []
            return o
        if fate_=='bad641':
            if d is ds[who] and q[1:2]==b'\x64': return [(0,bytes([r[0]])+r[1:-1]+bytes([r[-1]^1]))]
            return o
        if fate_=='bad6':
            if d is ds[who] and 'z' in S and q[1:2] in(b'\x64',b'\x2b') and S.get('g',0)<int(E('GN','12')): S['g']=S.get('g',0)+1; return [(0,bytes([r[0]])+r[1:-1]+bytes([r[-1]^1]))]
            return o
        if fate_=='jit1': return [(RR.uniform(0,slow) if d is ds[who] else 0,r)]
        if fate_=='now1' : return [(slow if d is ds[who] and RR.random()<p else 0,r)]
        if fate_=='grow1':
            if d is ds[who]: S['g']=S.get('g',0)+1; return [(min(.45,S['g']*slow*.1),r)]
            return o
        if fate_=='alt1':
            if d is ds[who]:
                S['g']=S.get('g',0)+1
                if S['g']%2: return []
            return o
        if fate_=='altz1' and 'z' in S:
            if d is ds[who]:
                S['g']=S.get('g',0)+1
                if S['g']%2: return []
            return o
        if fate_=='los1':
            if d is ds[who] and 'z' in S and RR.random()<p*2: return []
            return o
        if fate_=='lat1':
            if d is ds[who] and 'z' in S and RR.random()<p*2: return [(late*RR.uniform(.3,1),r)]
            return o
        if fate_=='die1':
            if d is ds[who] and 'z' in S and t-S['z']>u3*6: return []
            return o
        if fate_=='gone1':
            if d is ds[who] and 'z' in S and u3*6<t-S['z']<u3*6+late*3: return []
            return o
        if fate_=='crc1':
            if d is ds[who] and 'z' in S and RR.random()<p*2: return [(0,bytes([r[0]^(0 if RR.random()<.5 else 1)])+r[1:-1]+bytes([r[-1]^1]))]
            return o
        if fate_=='exc1' and 'z' in S and d is ds[who] and RR.random()<p and fs[who] in('lx','rtu'):
            import struct
            x=bytes([q[0],q[1]|0x80,6]); c=0xffff
            for y in x:
                c^=y
                for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
            return [(0,x+struct.pack('<H',c))]
        if fate_=='slow2': return [(slow if d in(ds[who],ds[(who+1)%n]) else 0,r)]
        if fate_=='slow1': return [(slow if d is ds[who] else 0,r)]
        if 'z' not in S: return o
        y=RR.random()
        if fate_=='lateR' and y<p: return [(late*RR.uniform(.5,1),r)]
        if fate_=='lostR' and y<p: return []
        if fate_=='dupR' and y<2*p: return [(0,r),(RR.choice([.003,.02,.1,late]),r)]
        if fate_=='mixR':
            if y<p/2: return []
            if y<p: return [(late*RR.uniform(.3,1),r)]
            if y<1.5*p: return [(late*RR.uniform(.3,1),r),(late*RR.uniform(1,1.5),r)]
            if y<2*p: return [(0,r),(RR.choice([.003,.02,.1,late]),r)]
        return o
    vd=ds[v]
    def e0(d,t):
        if E('EVT') and ev is not None:
            if d.n or not d.wr: return False
            S.setdefault('y',t); return t-S['y']>=float(E('EVT'))
        if 'z' not in S and rest(): S['z']=t
        return ev is not None and 'z' in S and t-S['z']>=ev
    def g0(d,t):
        S['a']=t; L=isinstance(d,LXM); x=sp if L else sp*6
        go_(d,t,x,L)
        if evk in('brief',): d.events.append((lambda dd,tt:tt-t>=brf,lambda dd,tt:(d.control(0,tt) if L else d.ctl(0,tt))))
        if evk=='rep':
            S['n']=S.get('n',0)+1
            if S['n']<=3: d.events.append((lambda dd,tt:tt-t>.15 and not(dd.st=='OE' and (kind!='zero' or abs(dd.n)>0 )) ,g0))
        if evk=='two' and n>1 and 'b' not in S:
            o=ds[int(E('O'))%n] if E('O') else ds[(v+1+seed%(n-1))%n]; S['b']=o.adr
            o.events.append((lambda dd,tt:tt-t>=u3,lambda dd,tt:go_(dd,tt,sp if isinstance(dd,LXM) else sp*6,isinstance(dd,LXM))))
    vd.events=[(e0,g0)]
    BD=int(E('BAUD','19200'))
    if BD!=19200: args=['--baud',str(BD)]+args
    ln=Line(ds,fate,baud=BD)
    try: 
        import signal
        sg=None
        if E('SIG') and ev is not None:
            tt=lambda x:(lambda d,t:'z' in S and t-S['z']>=ev+x)
            o=u3
            if E('EVT'): sg=[(lambda d,t:'a' in S and t-S['a']>=o,signal.SIGINT)]
            elif E('SIG')=='int': sg=[(tt(o),signal.SIGINT)]
            if E('SIG')=='int2': sg=[(tt(o),signal.SIGINT),(tt(o+.1),signal.SIGINT)]
            if E('SIG')=='term': sg=[(tt(o),signal.SIGTERM)]
            if E('SIG')=='stop': sg=[(tt(o-.25),signal.SIGSTOP),(tt(o+late*2),signal.SIGCONT)]
        r=run(ln,args,vd,timeout=150,extra=(),verbose=True,**({'sig':sg} if sg else {}))
    finally: ln.close()
    t1=r['t1']; txt=r['out']+r['err']; cap='STILL TURN' in txt; fl=[]
    if r['rc']=='HANG': fl.append('**HANG**')
    # last answered question of each drive
    gap={}
    qs={}; lastq=None
    for t,k,b in ln.log:
        if k=='>': lastq=(t,b)
        if k=='<' and b and t<=t1:
            # which drive
            a=None
            if fam=='ascii':
                try: a=int(b[1:3],16)
                except Exception: pass
            elif fam=='vabus': a=b[0]-64
            else: a=b[0]
            if a: gap[a]=t1-t
    info=[]; worst=0
    for i,d in enumerate(ds):
        sh=[x for x in d.sh if x[0]<=t1]; st,en,tu=sh[-1][1]; ts=te=t1
        for x in reversed(sh):
            if x[1][2]: ts=x[0]
            else: break
        for x in reversed(sh):
            if x[1][1]: te=x[0]
            else: break
        nn=[m for t,m in d.hist if t<=t1][-1]
        if kind=='dv' and not en: tu=False
        b=max(t1-ts if tu else 0,(t1-te if en else 0) if kind!='zero' else 0)
        if b>.2: info.append('%d:%s %s n%.1f tu%.2f en%.2f unseen%.2f'%(d.adr,fs[i],st,nn,t1-ts if tu else 0,t1-te if en else 0,gap.get(d.adr,9)))
        # seen since: answered telegram later than event start +60ms
        saw=b>0 and gap.get(d.adr,9)<b-.06
        if b>.3 and r['rc']==0: fl.append('**FALSE0%s**'%('-SEEN' if saw else ''))
        if b>.3 and r['rc']!=0 and not cap: fl.append('NOCAPS')
    if cap and not any(abs(d.n)>0 or d.st=='OE' for d in ds): fl.append('capsnone')
    if ev is None and r['rc']!=0: fl.append('rc%s'%r['rc'])
    L1='%s %d %-5s %-7s n%d %s %s slow%.2f v%d stag%d ev %s rc %s took %.2f z->end %s ev->end %s cap %d unseen max %.2f %s %s'%('P1' if ev is None else 'P2',seed,fam,kind,n,''.join(f[0] for f in fs),fate_,slow,v+1,stag,evk if ev is not None else '-',r['rc'],r['took'],'%.2f'%(t1-S['z']) if 'z' in S else '-','%.2f'%(t1-S['a']) if 'a' in S else '-',cap,max([gap.get(d.adr,9) for d in ds]),info,' '.join(fl))
    if r['rc'] not in(0,) or fl or E('KEEP'): open('out/n3-%d-%s-%s.txt'%(seed,E('TAG','x'),'p1' if ev is None else 'p2'),'w').write(L1+'\n'+' '.join(args)+'\n'+r['out']+'\n'+r['err']+'\nSH\n'+'\n'.join('%d %.3f %s %.1f'%(d.adr,x[0]-r['t0'],x[1],x[2]) for d in ds for x in d.sh)+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG end %.3f\n'%(t1-r['t0'])+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    G={d.adr:round(gap.get(d.adr,9),2) for i,d in enumerate(ds)}
    L1+=' p%s who%d G %s'%(p,who+1,max(G.values()))
    S['G']=G
    return L1,(t1-S['z'] if 'z' in S else None),(u,G,r['rc'],cap)
def job(seed):
    try:
        if E('EV'): return '\n'.join(one(seed,ev=float(x))[0] for x in E('EV').split(','))
        l,T,(u,G,rc,cap)=one(seed); o=[l]
        b=max(G,key=lambda a:G[a])
        if T and rc==0 and G[b]>float(E('LIM','.4')) and not E('NOP2'):
            os.environ['V']=str(b-1); os.environ['EVK']='en'
            l,_,_=one(seed,ev=max(0,T-G[b]+.04)); o.append('GAP '+l)
            del os.environ['V'],os.environ['EVK']
        if T and not E('P1'):
            l,_,_=one(seed,ev=max(0,T-u)); o.append(l)
        return '\n'.join(o)
    except Exception as ex:
        import traceback; return 'ERR %d '%seed+traceback.format_exc()[-500:]
if __name__=='__main__':
    s=int(sys.argv[3]); J=[int(x) for x in E('ONLY').split(',')] if E('ONLY') else [s*1000+i for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2])) as p:
        for x in p.imap_unordered(job,J): print(x,flush=True)
