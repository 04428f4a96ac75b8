# wd.py (as lz.py, but the reply to the watchdog read at rest - 5644 / P.413 - is the late one): COUNT WORKERS SEED FAMS KINDS : one drive, its k-th reply at rest (and, NL=2, the m-th after) is late; dt behind that question somebody enables it. exit 0 with a turning shaft untold?
import sys
from vb import *
from multiprocessing import Pool
import h4s
from grp2 import look
def wdq(fam,b):
    try:
        if fam=='lx': return b[1]==3 and int.from_bytes(b[2:4],'big')==5644
        if fam=='ascii': b=bytes.fromhex(b[1:-2].decode())
        if fam in('ascii','rtu'): return b[1]==3 and int.from_bytes(b[2:4],'big')&0xfff==413
        return b[-4:-1]==b'413'
    except Exception: return False
def one(j):
  try:
    seed,fam,kind,k,late,dt,k2=j
    L=fam=='lx'; d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](1)
    if fam=='ascii': d.ascii=True
    a=[] if fam not in('ascii','vabus') else ['--protocol',fam]
    run_=kind in('ramp','jog','jqs')
    if run_:
        if not L: d.ram.update({(418,i):0 for i in range(1,5)}); d.ee.update({(418,i):0 for i in range(1,5)})
        a+=['sollwert','300rpm' if L else '5Hz']+([] if L else ['--take-control'])+['--jog','600ms','--on-exit','quick-stop' if kind=='jqs' else 'ramp']
    else:
        (h4s.runsl if L else h4s.runsa)(d)
        a+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
    S={'k':0}
    def rest(): 
        if abs(d.n)>1: S['tn']=1
        return d.wr and d.n==0 and (not run_ or 'tn' in S)
    def fate(i,t,q,r,dd):
        if rest():
            if wdq(fam,q) and 'l' not in S: S['l']=t; return [(late,r)]
        return [(0,r)]
    def ev(dd,t): rest(); return dt is not None and 'l' in S and t-S['l']>=dt
    def go(dd,t):
        S['a']=t
        if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000; d.ram[434,0]=3
    d.events=[(ev,go)]
    ln=Line([d],fate)
    try: r=h4s.run2(ln,['-a','1']+a,d)
    finally: ln.close()
    t1=r['t1']; ga=t1-S['a'] if 'a' in S else None
    lk=[t for t,kk,b in ln.log if kk=='>' and t<t1 and look(fam,b,1)]
    n1=[n for t,n in d.hist if t<=t1][-1]
    cap='STILL TURN' in r['out']+r['err']; told='still turns' in r['out'] or 'whether the shaft stands' in r['out']
    l='%d %-5s %-7s k%d late %.2f dt %s k2 %d rc %s took %.2f gapA %s blind %.2f n %s %s cap %d told %d'%(seed,fam,kind,k,late,dt,k2,r['rc'],r['took'],ga and '%.2f'%ga,t1-lk[-1],round(n1,1),d.st,cap,told)
    if abs(n1)>1e-6 and r['rc']==0 and (ga or 0)>.2: l+=' **FALSE0**'
    if dt is None and r['rc']: l+=' RC-NOEN'
    open('out/wd-%d.txt'%(seed),'w').write(l+'\n'+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nWRITES\n'+'\n'.join('%d %.3f %s'%(d.adr,w[0]-r['t0'],w[1:]) for w in d.wr)+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return l
  except Exception as ex:
    import traceback; return 'ERR '+traceback.format_exc()[-300:]
if __name__=='__main__':
    s=int(sys.argv[3]); R=random.Random(s); F=(sys.argv[4] if len(sys.argv)>4 else 'lx,rtu,ascii,vabus').split(','); K=(sys.argv[5] if len(sys.argv)>5 else 'disable,qs,zero,ramp,jqs').split(',')
    nodt=len(sys.argv)>6
    jobs=[(s*100+i,f,k,0,l,.06,0) for i,(f,k,l) in enumerate((f,k,l) for f in F for k in K for l in(.3,.45))]
    R.shuffle(jobs); _=[(s*100+i,R.choice(F),R.choice(K),R.randrange(0,10),R.choice([.3,.6,1.0]),None if nodt else round(R.choice([.05,.2,R.uniform(.05,1)]),2),R.choice([0,0,1,2,3])) for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2]),maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,jobs): print(x,flush=True)
