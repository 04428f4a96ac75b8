# shr.py COUNT WORKERS SEED : a master that is HEARD on the line polls drive 1 every PER s and enables it again (visible telegrams) at a random time; 1 or 2 drives
import sys
from vb import *
from multiprocessing import Pool
import h4s
from grp2 import look
EARLY=os.environ.get('EARLY','1')=='1'; GAP=float(os.environ.get('GAP','1.0'))
class SL(Line):
    fq=None
    def foreign(s,d,q):
        # wait for a silent line
        t0=time.time()
        while time.time()-t0<1:
            last=s.log[-1][0] if s.log else 0
            if time.time()-max(last,s.tb)>.008 and not s.q and not s.buf: break
            time.sleep(.001)
        os.write(s.m,q); s.log.append((time.time(),'f',q)); time.sleep(len(q)*11/s.baud+.004)
        r=d.handle(q,time.time())
        if r: time.sleep(len(r)*11/s.baud); os.write(s.m,r); s.log.append((time.time(),'g',r))
def fr(b): return b+crc(b)
def one(j):
  try:
    seed,fam,kind,n,per,dt,how=j
    R=random.Random(seed)
    ds=[]; L=fam=='lx'
    for a in range(1,n+1):
        d={'lx':LXM,'rtu':ACU}[fam](a); (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    if n>1:
        if L: ds[1].n=1500; ds[1].p[6938]=1500
        else: ds[1].n=30; ds[1].ram[484,0]=3000
    a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
    ln=SL(ds); S={}
    stop=[False]
    def master():
        nxt=time.time()
        while not stop[0]:
            time.sleep(.002); t=time.time()
            if 'b' not in S and ('a' in S or not EARLY) and all(x.wr and x.n==0 for x in ds):
                lk1=[x[0] for x in list(ln.log) if x[1]=='>' and x[2][0]==1]
                if lk1 and t-lk1[-1]>GAP:
                    if L:
                        ln.foreign(ds[0],fr(bytes([1,16])+struct.pack('>HHBI',6918,2,4,3)))
                        for w in(0,6,15): ln.foreign(ds[0],fr(bytes([1,16])+struct.pack('>HHBI',6914,2,4,w)))
                        ln.foreign(ds[0],fr(bytes([1,16])+struct.pack('>HHBI',6938,2,4,500)))
                    else:
                        for w in(0,6,15): ln.foreign(ds[0],fr(bytes([1,6])+struct.pack('>HH',410,w)))
                        ln.foreign(ds[0],fr(bytes([1,0x65])+struct.pack('>HI',484,3000)))
                    S['b']=time.time()
            if 'a' not in S and EARLY:
                z=(ds[0] if how=='own' else ds[-1])
                if all(x.wr for x in ds) and z.n==0 and ds[0].n==0:
                    S.setdefault('z',t)
                    if t-S['z']>=dt:
                        if L: 
                            for w in(6,15): ln.foreign(ds[0],fr(bytes([1,16])+struct.pack('>HHBI',6914,2,4,w)))
                            ln.foreign(ds[0],fr(bytes([1,16])+struct.pack('>HHBI',6938,2,4,500)))
                        else:
                            for w in(0,6,15): ln.foreign(ds[0],fr(bytes([1,6])+struct.pack('>HH',410,w)))
                            ln.foreign(ds[0],fr(bytes([1,0x65])+struct.pack('>HI',484,3000)))
                        S['a']=time.time(); continue
            if t>=nxt and per:
                nxt=t+per
                ln.foreign(ds[0],fr(bytes([1,3])+struct.pack('>HH',6916,2)) if L else fr(bytes([1,3])+struct.pack('>HH',411,1)))
    th=threading.Thread(target=master,daemon=True); th.start()
    time.sleep(.2)
    try: r=h4s.run2(ln,['-a',','.join(str(x.adr) for x in ds)]+a,ds[0])
    finally: stop[0]=True; th.join(); ln.close()
    t1=r['t1']; ga=t1-S['a'] if 'a' in S else None
    lk=[[t for t,k,b in ln.log if k=='>' and t<t1 and look(fam,b,x.adr)] for x in ds]
    cap='STILL TURN' in r['out']+r['err']
    gb=t1-S['b'] if 'b' in S else None
    l='gapB %s '%(gb and '%.2f'%gb)+'%d %-4s %-7s n%d per %.2f %s dt %.2f rc %s took %.2f gapA %s blind %s n %s %s cap %d'%(seed,fam,kind,n,per,how,dt,r['rc'],r['took'],ga and '%.2f'%ga,['%.2f'%(t1-x[-1]) if x else '-' for x in lk],[round(x.n,1) for x in ds],[x.st for x in ds],cap)
    if any(abs(x.n)>1e-6 for x in ds) and r['rc']==0 and max(ga or 0,gb or 0)>.1: l+=' **FALSE0**'
    open('out/shr2-%d-%s.txt'%(seed,os.environ.get('TAG','x')),'w').write(l+'\n'+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for d in ds for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex:
    import traceback; return 'ERR '+traceback.format_exc()[-300:]
FAMS=os.environ.get('FAMS','lx,rtu').split(',');PERS=[float(x) for x in os.environ.get('PERS','.3,.6').split(',')];NS=[int(x) for x in os.environ.get('NS','1,2').split(',')]
if __name__=='__main__':
    R=random.Random(int(sys.argv[3])); jobs=[(int(sys.argv[3])*100+i,R.choice(FAMS),R.choice(os.environ.get('KINDS','disable,qs,zero').split(',')),R.choice(NS),R.choice(PERS),R.choice([.02,.1,.3,.6,1]),R.choice(['own','last'])) for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,jobs): print(x,flush=True)
