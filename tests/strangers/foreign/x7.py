# x1.py COUNT WORKERS SEED : dice on the end of a stop. env KINDS FAMS NS FATES EVS MASTER(0|period) ; seeds repeat: ONLY=seed
import sys,os
sys.path.insert(0,os.path.dirname(os.path.abspath(__file__)))
from vb import *
from multiprocessing import Pool
import h4s,re
E=os.environ.get
OUT='out/'; os.makedirs(OUT,exist_ok=True)
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
def fr(b): return b+crc(b)
class SL(Line):
    def foreign(s,d,q):
        t0=time.time()
        while time.time()-t0<1:
            last=s.log[-1][0] if s.log else 0
            if time.time()-max(last,s.tb)>.008 and not s.q and not s.buf: break
            time.sleep(.001)
        os.write(s.m,q); s.log.append((time.time(),'f',q)); time.sleep(len(q)*11/s.baud+.004)
        r=d.handle(q,time.time())
        if r: time.sleep(len(r)*11/s.baud); os.write(s.m,r); s.log.append((time.time(),'g',r))
def one(seed):
  try:
    R=random.Random(seed)
    C=lambda k,d: R.choice(E(k,d).split(','))
    fam=C('FAMS','lx,lx,rtu,ascii,vabus'); kind=C('KINDS','disable,qs,dv,zero,ramp,jqs,coast'); L=fam=='lx'
    run_=kind in('ramp','jqs','coast'); n=1 if run_ else int(C('NS','1,1,2,3'))
    fate_=C('FATES','clean,clean,late1,late1,lost1,dup,lag,loss'); evk=C('EVS','en,en,en0,off,none'); per=float(E('MASTER','0'))
    if kind=='zero' and evk=='en0': evk='en'
    if per and fam not in('lx','rtu'): fam='rtu'
    ds=[]
    for a in range(1,n+1):
        d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](a)
        if fam=='ascii': d.ascii=True
        if not run_: (h4s.runsl if L else h4s.runsa)(d)
        elif not L: d.ram.update({(418,i):0 for i in range(1,5)}); d.ee.update({(418,i):0 for i in range(1,5)})
        ds.append(d)
    slow=R.random()<.5
    if n>1 and slow:
        if L: ds[1].n=1500; ds[1].p[6938]=1500
        else: ds[1].n=30; ds[1].ram[484,0]=3000
    js=R.random()<.25
    args=[] if fam not in('ascii','vabus') else ['--protocol',fam]
    if run_: args+=['sollwert','300rpm' if L else '5Hz']+([] if L else ['--take-control'])+(['--enable','--hold','--duration','600ms'] if E('HOLD') else ['--jog','600ms'])+['--on-exit',{'ramp':'ramp','jqs':'quick-stop','coast':'coast'}[kind]]
    else: args+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
    if js: args+=['--json']
    v=R.randrange(n); vd=ds[v]
    ref=R.choice(['own','own','own','all','word']); dt=R.choice([R.uniform(0,.3),R.uniform(0,1),R.uniform(0,2)])
    dt=float(E('DT').split(',')[seed%len(E('DT').split(','))]) if E('DT') else dt; ref=E('REF',ref)
    if evk=='off': ref=R.choice(['word','word','own']); off=R.choice([.3,.8,2,60])
    else: off=0
    k0=R.randrange(0,int(E('KMAX','16'))); dtf=float(C('DTF','.005,.03,.06,.1,.2')); late=R.choice([.2,.3,.45,.6,1.0]); lag=float(C('LAG','.05,.15,.3')); p=R.choice([.03,.1]); 
    S={'k':0}
    def began():
        if not run_: return all(x.wr for x in ds)
        if abs(vd.n)>(5 if L else .5): S['tn']=1
        return 'tn' in S
    def fate(i,t,q,r,d):
        o=[(0,r)]
        b=began()
        if fate_=='lag' : return [(R.uniform(0,lag) if seed%2 else lag,r)]
        if not b and fate_ not in('slow','slowk','dupall','dupall2'): return o
        if fate_ in('late1','lost1') and (vd.n==0 or 'z' in S):
            k=S['k']; S['k']+=1
            if k==k0: S['f']=t; return [] if fate_=='lost1' else [(late,r)]
        if fate_=='cleank' and (vd.n==0 or 'z' in S):
            k=S['k']; S['k']+=1
            if k==k0: S['f']=t
            return o
        if fate_ in('dupall','dupall2'):
            if vd.n==0 or 'z' in S:
                k=S['k']; S['k']+=1
                if k==k0: S['f']=t
            D=float(C('DUPD','.03,.06,.1,.2,.4')) if fate_=='dupall2' else dupd
            return [(lag,r),(lag+D,r)]
        if fate_ in('lateN','lateNd','lostN') and (vd.n==0 or 'z' in S):
            k=S['k']; S['k']+=1
            if k==k0: S['f']=t
            if k0<=k<k0+mN: return [] if fate_=='lostN' else [(late*R.uniform(.7,1),r)]+([(late+R.choice([.02,.2,.5]),r)] if fate_=='lateNd' else [])
            return o
        if fate_ in('slow','slowk'):
            if fate_=='slowk' and (vd.n==0 or 'z' in S):
                k=S['k']; S['k']+=1
                if k==k0: S['f']=t
            return [(lag*R.uniform(.8,1.2),r)]
        if fate_=='dup' and R.random()<p*3: return [(0,r),(R.choice([.003,.02,R.uniform(0,late)]),r)]
        if fate_=='loss' and R.random()<p: return []
        return o
    def ev(d,t):
        if not began(): return False
        if run_:
            # word: shaft slower than before or en. gone
            if 'pk' not in S or abs(d.n)>S['pk']: S['pk']=abs(d.n)
            word=abs(d.n)<S['pk']*.95
        else: word=True
        if d.n==0: S.setdefault('z',t)
        if ref=='word':
            if word: S.setdefault('r',t)
        elif ref=='own':
            if d.n==0: S.setdefault('r',t)
        elif all(x.n==0 for x in ds): S.setdefault('r',t)
        if E('FOLLOW') and fate_ not in('clean','slow','dup','loss','lag'): return 'f' in S and t-S['f']>=dtf
        return 'r' in S and t-S['r']>=dt
    sp=int(E('SP')) if E('SP') else R.choice([500,60]) if L else R.choice([3000,300])
    def go(d,t):
        if evk=='none' or not d.power: return
        if evk=='off': d.reboot(t,off); S['a']=t; return
        if per: S['want']=t; return
        S['a']=t
        x=sp if evk!='en0' else 0
        if evk=='pull': d.n=(200 if L else 20)*R.choice([1,-1]); return
        if evk=='brief': d.events.append((lambda dd,tt:tt-t>=brf,lambda dd,tt:(d.control(0,tt) if L else d.ctl(0,tt))))
        if L: d.mode=3; d.p[6918]=3; d.p[6938]=x; d.control(6,t); d.control(15,t)
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ram[484,0]=x; d.ctl(0,t); d.ctl(6,t); d.ctl(15,t)
    dupd=float(C('DUPD','.03,.06,.1,.2,.4')); mN=R.choice([2,3,4,6]); brf=R.choice([.1,.2,.35]); vd.events=[(ev,go)]
    ln=SL(ds,fate); stop=[False]
    def master():
        nxt=time.time(); A=vd.adr
        while not stop[0]:
            time.sleep(.002); t=time.time()
            if 'want' in S and 'a' not in S:
                x=sp if evk=='en' else 0
                if L:
                    for w in(6,15): ln.foreign(vd,fr(bytes([A,16])+struct.pack('>HHBI',6914,2,4,w)))
                    ln.foreign(vd,fr(bytes([A,16])+struct.pack('>HHBI',6918,2,4,3))); ln.foreign(vd,fr(bytes([A,16])+struct.pack('>HHBI',6938,2,4,x)))
                else:
                    for w in(0,6,15): ln.foreign(vd,fr(bytes([A,6])+struct.pack('>HH',410,w)))
                    ln.foreign(vd,fr(bytes([A,0x65])+struct.pack('>HI',484,x)))
                S['a']=time.time(); continue
            if t>=nxt:
                nxt=t+per; dd=R.choice(ds)
                ln.foreign(dd,fr(bytes([dd.adr,3])+struct.pack('>HH',6916,2)) if L else fr(bytes([dd.adr,3])+struct.pack('>HH',411,1)))
    th=None
    if per: th=threading.Thread(target=master,daemon=True); th.start(); time.sleep(.2)
    try: r=h4s.run2(ln,['-a',','.join(str(x.adr) for x in ds)]+args,vd)
    finally:
        stop[0]=True
        if th: th.join()
        ln.close()
    t1=r['t1']; txt=r['out']+r['err']; cap='STILL TURN' in txt; ga=t1-S['a'] if 'a' in S else None
    fl=[]
    if r['rc']=='HANG': fl.append('**HANG**')
    info=[]
    for d in ds:
        sh=[x for x in d.sh if x[0]<=t1]; st,en,tu=sh[-1][1]
        # since when turning / enabled
        ts=te=t1
        for x in reversed(sh):
            if x[1][2]: ts=x[0]
            else: break
        for x in reversed(sh):
            if x[1][1]: te=x[0]
            else: break
        nn=[m for t,m in d.hist if t<=t1][-1]
        info.append('%s n%.1f tu%.2f en%.2f'%(st,nn,t1-ts if tu else 0,t1-te if en else 0))
        if kind=='dv' and not en: tu=False
        bad=(tu and t1-ts>.3) or (en and kind!='zero' and t1-te>.3)
        if bad and r['rc']==0: fl.append('**FALSE0**')
        if bad and r['rc']!=0 and not cap: fl.append('NOCAPS')
        if tu is False and en is False and cap: fl.append('capsnone')
    if evk=='none' and fate_ in('clean',) and r['rc']!=0: fl.append('**RC-CLEAN**')
    if evk=='none' and r['rc']!=0: fl.append('rcnone')
    l='%d %-5s %-7s n%d%s v%d %s %s(k%d late%.2f lag%.2f p%.2f) ev %s ref %s dt%.2f off%.1f sp%d rc %s took %.2f ga %s cap %d %s %s'%(seed,fam,kind,n,'s' if slow else '',v,'js' if js else '',fate_,k0,late,lag,p,evk,ref,dt,off,sp,r['rc'],r['took'],ga and '%.2f'%ga,cap,info,' '.join(fl))
    open(OUT+'x7-%d-%s.txt'%(seed,E('TAG','x')),'w').write(l+'\n'+' '.join(args)+'\n'+r['out']+'\n'+r['err']+'\nSH\n'+'\n'.join('%d %.3f %s %.1f'%(d.adr,x[0]-r['t0'],x[1],x[2]) for d in ds for x in d.sh)+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex:
    import traceback; return 'ERR %d '%seed+traceback.format_exc()[-400:]
if __name__=='__main__':
    s=int(sys.argv[3]); J=[int(x) for x in E('ONLY').split(',')] if E('ONLY') else [s*1000+i for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,J): print(x,flush=True)
