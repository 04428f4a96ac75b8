# jj.py (ka.py with: families mixed per port, doubled/late replies at several drives, victim enabled up to 3 times) MODE SEED0 COUNT : dice of stops over 2-3 ports. MODE ev|sig|pull|dead. Each seed: pass 1 without event, pass 2 with one (ev).
import sys
from vb import *
import h4s,re,tempfile
mode=sys.argv[1]
def one(seed,tend=None):
    R=random.Random(seed); fam=os.environ.get('FAM') or R.choice(['lx','rtu','lx','rtu','ascii']); L=fam=='lx'
    kind=R.choice(['disable','qs','zero','dv','zero','disable']); nports=R.choice([2,2,3])
    two=fam!='ascii' and R.random()<.35
    LP=[R.random()<.5 for _ in range(nports)] if fam!='ascii' else [False]*nports; P=[[(LXM if LP[k] else ACU)(i+1) for i in range(R.choice([1,1,2,3]))] for k in range(nports)]
    if two and len(P[0])<2: P[0].append((LXM if LP[0] else ACU)(2))
    allv=[d for p in P for d in p]
    for d in allv:
        if fam=='ascii': d.ascii=True
        (h4s.runsl if isinstance(d,LXM) else h4s.runsa)(d); d.zz=None; d.ev=None
        if R.random()<.15: d.st='SOD'; d.n=0; 
    ft=R.choice(['none','dbl','dbl','dball','dball','latall','one','lat','dead' if mode=='dead' else 'none']); 
    if mode=='dead': ft='dead'
    dam=R.choice(allv); slo=R.choice(allv) if R.random()<.4 else None
    if slo:
        if isinstance(slo,LXM): slo.n=1500; slo.p[6938]=1500; slo.p[1558]=750; slo.st='OE'
        else: slo.n=30; slo.ram[484,0]=3000; slo.st='OE'; slo.cw=15
    dly=R.choice([.1,.15,.25,.4]); p=R.choice([.1,.3,.5]); S={'g':0}
    vic=R.choice([d for d in allv if d is not dam] or allv); vic2=R.choice(allv); emode=R.choice(['own','all','end','end','end','end2','two']); e=R.uniform(0,1.2); ee=R.uniform(.45,1.6); e2=R.uniform(.05,.8); RF=random.Random(seed+7)
    tsig=R.uniform(.03,4); sg=R.choice([signal.SIGINT,signal.SIGTERM]); pp=R.randrange(nports)
    def go(d,t):
        d.ev=t; S.setdefault('a',t)
        if isinstance(d,LXM): d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
    def zof(d,t):
        for x in allv:
            if x.zz is None and x.n==0 and x.wr: x.zz=t
    def ev(d,t):
        zof(d,t)
        if mode=='dead' and emode.startswith('end'): return vic.zz and t-vic.zz>=e
        if emode in('own','two'): return vic.zz and t-vic.zz>=e
        if emode=='all': return all(x.zz for x in allv if x is not dam or ft!='dead') and t-max(x.zz for x in allv if x.zz)>=e
        return tend is not None and 'T0' in S and t-S['T0']>=max(.2,tend-ee)
    def ev2(d,t): return 'a' in S and t-S['a']>=e2 and d.n==0
    if tend is not None or mode!='ev':
        vic.events=[(ev,go)]+[((lambda d,t,k=k: d.ev is not None and S.get('nn',1)==k and t-d.ev>=e2*k and d.n==0),(lambda d,t,k=k:(S.__setitem__('nn',k+1),go(d,t)))) for k in range(1,R.choice([1,1,2,3]))]
        if emode in('two','end2') and vic2 is not vic: vic2.events=[(ev2,go)]
    def fate(i,t,q,r,d):
        if ft=='dball' and RF.random()<p: return [(0,r),(RF.choice([0,.003,.02,RF.uniform(0,.5)]),r)]
        if ft=='latall' and RF.random()<p*.4: return [(RF.uniform(.02,.2),r)]
        if d is dam and ft!='none':
            if ft=='dead': return [] if 'T0' in S and t-S['T0']>tsig*.5 else [(0,r)]
            if ft=='slow': return [(dly,r)]
            if d.zz or R.random()<0:
                if ft=='alt':
                    S['g']+=1
                    if S['g']%2: return []
                if ft=='los' and RF.random()<p: return []
                if ft=='lat' and RF.random()<p: return [(RF.uniform(.05,.8),r)]
                if ft=='dbl' and RF.random()<p: return [(0,r),(RF.uniform(.0,.5),r)]
                if ft=='one' and S['g']<2: S['g']+=1; return []
        return [(0,r)]
    Ls=[Line(p,fate) for p in P]; pr='ascii' if fam=='ascii' else 'rtu'; s=''; nm={}
    for i,l in enumerate(Ls):
        s+='[ports.p%d]\npath="%s"\nprotocol="%s"\nbaud=19200\nparity="even"\n'%(i,l.path,pr)
        if two and i==0: s+='[ports.q0]\npath="%s"\nprotocol="%s"\nbaud=38400\nparity="even"\n'%(l.path,pr)
    for i,p_ in enumerate(P):
        for j,d in enumerate(p_):
            n='d%d%d'%(i,d.adr); nm[n]=d
            s+='[drives.%s]\nport="%s"\naddress=%d\ndrive="%s"\n'%(n,'q0' if two and i==0 and j>=len(p_)//2 else 'p%d'%i,d.adr,'lxm05' if isinstance(d,LXM) else 'acu')
    f=tempfile.mktemp(suffix='.toml'); open(f,'w').write(s)
    a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
    t0=S['T0']=time.time(); pc=subprocess.Popen([BIN,'--config',f,'-a','all']+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
    x=''
    def side():
        time.sleep(tsig)
        if pc.poll() is not None: return
        if mode=='sig': pc.send_signal(sg); S['s']=time.time()
        if mode=='pull':
            l=Ls[pp]; l.stop=True; l.th.join(); os.close(l.m); S['s']=time.time(); S['pull']=1
    if mode in('sig','pull'): threading.Thread(target=side,daemon=True).start()
    try: out,err=pc.communicate(timeout=75); rc=pc.returncode
    except subprocess.TimeoutExpired: pc.kill(); out,err=pc.communicate(); rc='HANG'
    t1=time.time(); time.sleep(.01)
    fl=[]; bl={}
    cur=None
    for ln in (out+'\n'+err).splitlines():
        m=re.match(r'(?:error: )?(d\d\d): ',ln)
        if m: cur=m.group(1)
        elif ln.startswith('error:') or ln.startswith('hint'): cur='*'
        if cur: bl[cur]=bl.get(cur,'')+ln+'\n'
    anycap='STILL TURN' in out+err; stt=[]
    for n,d in nm.items():
        en=(d.st=='OE' if isinstance(d,LXM) else d.shown()==0x27)
        turn=abs(d.n)>1e-6; bad=(turn and not(kind=='dv' and not en)) or (kind!='zero' and en)
        gap=round(t1-d.ev,2) if d.ev else None
        stt.append('%s%s%s%s:%s%s'%(n,'*' if d is dam else '','S' if d is slo else '','V%s'%gap if gap else '',d.st,' n%.0f'%d.n if turn else ''))
        if bad and (gap is None or gap>.35):
            if rc==0: fl.append('**FALSE0 %s'%n)
            elif not anycap: fl.append('**NOCAPS %s'%n)
            elif 'STILL TURN' not in bl.get(n,'')+bl.get('*',''): fl.append('OWNCAPS %s'%n)
            else: fl.append('told %s'%n)
        elif bad: fl.append('late %s'%n)
    if rc==0 and mode in('sig',) and 's' in S: fl.append('SIG-RC0(%.2f)'%(t1-S['s']))
    if rc==0 and 'pull' in S and t1-S['s']>.1: fl.append('**PULL-RC0(%.2f)'%(t1-S['s']))
    if anycap and not any(abs(d.n)>1e-6 for d in allv): fl.append('CBS')
    las=[round(t1-max([t for t,k,b in l.log if k=='>' and t<t1] or [0]),2) for l in Ls]
    line='jj %s %d %s %s ports%s%s %s/%s %s sl%s rc %s took %.2f sig %s last %s | %s | %s'%(mode,seed,fam,kind,[len(p) for p in P],' two' if two else '',ft,dly if ft=='slow' else p,emode,bool(slo),rc,t1-t0,'s' in S and round(t1-S['s'],2),las,' '.join(stt),' '.join(fl))
    open('out/jj-%s-%d-%d.txt'%(mode,seed,tend is not None),'w').write(line+'\n'+s+out+'\nERR\n'+err+'\n'+'\n'.join('PORT %d\n'%i+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l.log) for i,l in enumerate(Ls)))
    for l in Ls:
        l.stop=True
    time.sleep(.02)
    for i,l in enumerate(Ls):
        l.th.join()
        if not('pull' in S and i==pp): os.close(l.m)
        os.close(l.sl)
    return line,t1-t0,fl,rc,emode
for sd in range(int(sys.argv[2]),int(sys.argv[2])+int(sys.argv[3])):
    if time.time()>float(os.environ.get('UNTIL','9e9')): break
    try:
        if mode=='ev':
            ln,tk,fl,rc,em=one(sd)
            if fl or em not in('end','end2','own','all','two') : print('P1',ln,flush=True)
            print(one(sd,tk)[0],flush=True)
        else: print(one(sd)[0],flush=True)
    except Exception as ex: print('EXC',sd,repr(ex),flush=True)
