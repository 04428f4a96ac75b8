# ic.py : SIGINT into group stops and single stops at times; shafts must stop; who is still turning must be told
import sys
from vb import *
import h4s
from multiprocessing import Pool
def one(j):
    fam,kind,n,ts=j
    L=fam=='lx'; ds=[]
    for a in range(1,n+1):
        d={'lx':LXM,'rtu':ACU}[fam](a); (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    for d in ds[1:]:
        if L: d.n=1500; d.p[6938]=1500
        else: d.n=30; d.ram[484,0]=3000
    a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
    ln=Line(ds); t0=time.time()
    p=subprocess.Popen([BIN,'-p',ln.path,'--no-config','-v','-a',','.join(str(x.adr) for x in ds)]+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,stdin=subprocess.DEVNULL,text=True)
    def k():
        for t in ts:
            time.sleep(max(0,t0+t-time.time()))
            if p.poll() is None: p.send_signal(signal.SIGINT)
    threading.Thread(target=k,daemon=True).start()
    try: o,e=p.communicate(timeout=60); rc=p.returncode
    except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); rc='HANG'
    t1=time.time(); nend=[round(d.n,1) for d in ds]; st=[d.st for d in ds]; time.sleep(4); n4=[round(d.n,1) for d in ds]; ln.close()
    open('out/ic-%s-%s-%d-%s.txt'%(fam,kind,n,ts),'w').write(o+e)
    cap='STILL TURN' in o+e; coast='coasts' in o or 'still turns' in o
    return 'ic %s %s n%d %s rc %s took %.2f nend %s %s after4s %s cap %s coastword %s %s'%(fam,kind,n,ts,rc,t1-t0,nend,st,n4,cap,coast,'UNTOLD' if any(nend) and not cap and not coast else '')
if __name__=='__main__':
    J=[(f,k,n,ts) for f in('lx','rtu') for k,n in(('disable',2),('qs',2),('zero',2),('qs',1),('zero',1)) for ts in((.3,),(.6,.9),(.02,))]
    random.Random(3).shuffle(J)
    with Pool(int(sys.argv[1])) as p:
        for x in p.imap_unordered(one,J[:int(sys.argv[2])]): print(x,flush=True)
