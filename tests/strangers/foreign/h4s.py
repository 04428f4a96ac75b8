# h4b.py SEED0 COUNT WORKERS : two passes; 1st without an enabling, 2nd with one behind the last look of the 1st
import sys
from vb import *
from multiprocessing import Pool
turn=lambda d,t: abs(d.n)>(5 if isinstance(d,LXM) else .5)
FORCE=None
def runsl(d): d.st='OE'; d.mode=3; d.p[6918]=3; d.p[6938]=300; d.p[6914]=15; d.n=300
def runsa(d):
    for i in range(1,5): d.ram[412,i]=d.ee[412,i]=1; d.ram[418,i]=d.ee[418,i]=0
    d.cw=15; d.st='OE'; d.ram[484,0]=600; d.n=6
def one(seed,en_at=None,tag='p1'):
    R=random.Random(seed)
    fam=FORCE['fam'] if FORCE else R.choice(['lx','lx','rtu','ascii','vabus'])
    if len(sys.argv)>4 and sys.argv[4]!='-': fam=sys.argv[4]
    kind=FORCE['kind'] if FORCE else R.choice(['ramp','quick-stop','coast','enable','disable','dv','qs','zero'])
    if len(sys.argv)>5: kind=sys.argv[5]
    L=fam=='lx'
    mk={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam]
    d=mk(3) if L else mk(1,set={418:0})
    if fam=='ascii': d.ascii=True
    a=[] if L or fam=='rtu' else ['--protocol',fam]
    if kind in('ramp','quick-stop','coast'):
        a+=['sollwert','300rpm' if L else '5Hz']+([] if L else ['--take-control'])+['--enable','--hold','--duration','600ms','--on-exit',kind]; cond=ev_after(turn,.55)
    elif kind=='enable':
        a+=['statemachine','enable','--hold','--duration','600ms']+([] if L else ['--take-control'])
        if not L: d.ram[434,0]=1; 
        cond=ev_after(lambda d,t:d.st=='OE',.55)
    else:
        (runsl if L else runsa)(d)
        a+={'disable':['statemachine','disable'],'dv':['statemachine','disable-voltage'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]; cond=lambda d,t:len(d.wr)>0
    js=R.random()<.3
    if js: a+=['--json']

    S={}
    def tick(t):
        if 'c' not in S and cond(d,t): S['c']=t
        if 'c' in S and 'z' not in S and d.n==0 and t-S['c']>.05: S['z']=t
    mode=R.choice(['lose1','late1','lose3','late3','window','latewin','zlose','zlate','zlose','zlate','zwin','zlatewin'])
    ks=[R.randrange(0,22) for _ in range(3)]; zks=[R.randrange(0,14) for _ in range(R.choice([1,1,2,3]))]
    late=R.uniform(.2,3) if R.random()<.7 else R.uniform(.05,.6); w0=R.uniform(0,1.5); wl=R.uniform(.2,1.6)
    if FORCE: mode,zks,late=FORCE['mode'],FORCE['zks'],FORCE['late']
    C={'c':0,'z':0}
    def fate(i,t,q,r,dd):
        tick(t)
        o=[(0,r)]
        if 'c' in S:
            k=C['c']; C['c']+=1
            if mode in('lose1','late1') and k==ks[0] or mode in('lose3','late3') and k in ks: o=[] if 'lose' in mode else [(late,r)]
            if mode in('window','latewin') and w0<=t-S['c']<w0+wl: o=[] if mode=='window' else [(late,r)]
        if 'z' in S:
            k=C['z']; C['z']+=1
            if mode in('zlose','zlate') and k in zks: o=[] if mode=='zlose' else [(late,r)]
            if mode in('zwin','zlatewin') and w0*.5<=t-S['z']<w0*.5+wl: o=[] if mode=='zwin' else [(late,r)]
        return o
    trig=R.choice(['w','z','z','sil','sil','gb'])
    tw=R.uniform(0,4.5); tz=R.uniform(0,3.2); g=R.uniform(.05,.6); tgb=R.uniform(0,.4)
    who=R.choice(['bus','bus','local']) 
    def go_(t):
        S['en']=t
        if L:
            d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        elif who=='bus':
            for i in range(1,5): d.ram[412,i]=1
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000; d.ram[434,0]=3
            for i in range(1,5): d.ram[434,i]=3
        else:
            for i in range(1,5): d.ram[412,i]=44; d.ram[434,i]=3
            d.o['contact_start']=True; d.ram[484,0]=3000
        d.mark(t,'EN')
    def ev(dd,t):
        tick(t)
        return en_at is not None and 'c' in S and t-S['c']>=en_at
    d.events=[(ev,lambda dd,t:go_(t))]
    ln=Line([d],fate)
    try: r=run2(ln,['-a',str(d.adr)]+a,d)
    finally: ln.close()
    t1=r['t1']; en=S.get('en')
    hist=[(t,n) for t,n in d.hist if t>=t1]
    nend=r['nend']
    turning=abs(nend)>1e-6
    drv=[t for t in getattr(d,'dr',[]) if t>t1]
    txt=r['out']+r['err']
    cap='STILL TURN' in txt
    gap=(t1-en) if en and en<t1 else None
    import re
    words=' | '.join(x.strip() for x in r['out'].splitlines() if re.match(r'\s*(stop|running|state)\s',x)) if not js else ' '.join(re.findall(r'"(?:acknowledged|standing|running)": \w+',r['out']))
    fl=''
    if r['rc']=='HANG': fl+='HANG '
    if gap is not None and gap>.1 and (turning or drv):
        if r['rc']==0: fl+='FALSE0 '
        elif not cap: fl+='NOCAPS '
        if 'acknowledged' in words and 'NOT acknowledged' not in words and '"acknowledged": false' not in words: fl+='ACKWORD '
    if gap is None and r['rc']!=0: fl+='RC%s-NOEN '%r['rc']
    if gap is None and cap: fl+='CAPS-NOEN '
    last=[x[0] for x in ln.log if x[1]=='>'][-1]
    line='%d %-5s %-10s %-8s %-3s %-5s rc %-3s took %.2f en %s gap %s n %.1f drv %s quiet %.2f cap %d %s :: %s'%(seed,fam,kind,mode,trig,who,r['rc'],r['took'],'%.2f'%(en-r['t0']) if en else '-','%.2f'%gap if gap is not None else '-',nend,bool(drv),t1-last,cap,fl,words)
    if r['tout']: line+=' OUT@%.2f'%(r['tout']-r['t0'])
    open('out/h4b-%d-%s.txt'%(seed,tag),'w').write(line+'\n'+' '.join(a)+'\nks %s zks %s late %.2f w0 %.2f wl %.2f\n'%(ks,zks,late,w0,wl)+r['out']+'\n'+r['err']+'\nMARKS %s\nWRITES\n'%[(m[1],round(m[0]-r['t0'],3)) for m in d.marks or []]+'\n'.join('%.3f %s'%(w[0]-r['t0'],w[1:]) for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log)+'\nHIST\n'+'\n'.join('%.3f %.1f'%(t-r['t0'],n) for t,n in d.hist[::15]))
    from blind import shaft
    lk=[x[0] for x in ln.log if x[1]=='>' and shaft(fam,x[2]) and x[0]<t1]
    return line,r,S,(lk[-1] if lk else None),fl,turning,en

def run2(line,args,drive):
    cmd=[BIN,'-p',line.path,'--no-config','-v']+args+['--yes']
    t0=time.time(); p=subprocess.Popen(cmd,stdout=subprocess.PIPE,stderr=subprocess.PIPE,stdin=subprocess.DEVNULL)
    T={}; O=[]; E=[]
    def rd(f,L,k):
        while True:
            b=os.read(f.fileno(),65536)
            if not b: break
            T.setdefault(k,time.time()); L.append(b)
    a=[threading.Thread(target=rd,args=x) for x in((p.stdout,O,'o'),(p.stderr,E,'e'))]
    [x.start() for x in a]
    try: rc=p.wait(120)
    except subprocess.TimeoutExpired: p.kill(); rc='HANG'
    t1=time.time(); nend=drive.n; [x.join() for x in a]
    time.sleep(.2)
    return dict(rc=rc,out=b''.join(O).decode(),err=b''.join(E).decode(),t0=t0,t1=t1,nend=nend,took=t1-t0,tout=T.get('o'))
def two(seed):
    try:
        l,r,S,lk,fl,_,_=one(seed)
        blind=(r['t1']-lk) if lk else -1
        o='P1 blind %.2f out-before-end %.2f %s'%(blind,(r['t1']-r['tout']) if r['tout'] else -1,l[:170])
        if r['rc']==0 and blind>.3 and 'c' in S:
            at=lk-S['c']+.06
            l2,r2,S2,lk2,fl2,tu,en=one(seed,at,'p2')
            o+='\nP2 %s %s'%('**MISSED**' if 'FALSE0' in fl2 else '',l2)
        return o
    except Exception as e: return 'ERR %d %r'%(seed,e)

def sw(j):
    global FORCE
    fam,kind,mode,k,late=j; FORCE=dict(fam=fam,kind=kind,mode=mode,zks=[k],late=late)
    seed=900000+abs(hash(j))%10000; seed=int.from_bytes(repr(j).encode()[-6:],'big')%100000+100000
    return 'zk %d late %.1f %s'%(k,late,two(seed))
if __name__=='__main__':
    if len(sys.argv)>2:   # h4s.py 1 FAM KIND zlose|zlate K LATE
        A=sys.argv[:]; del sys.argv[2:]
        print(sw((A[2],A[3],A[4],int(A[5]),float(A[6])))); sys.exit()
    jobs=[(f,kd,m,k,l) for k in range(0,13) for kd in('disable','qs','zero','dv','ramp','coast','quick-stop','enable') for f in('lx','rtu','ascii','vabus') for m,l in(('zlose',0),)+((('zlate',1.0),) if k%3==1 else ())]
    random.Random(1).shuffle(jobs)
    with Pool(int(sys.argv[1]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(sw,jobs): print(x,flush=True)
