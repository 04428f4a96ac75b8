from k import *
from a4 import stopt
U='\x1b[A'
want=sys.argv[1:]
def go(name,mk,args,keys):
    if want and not any(w in name for w in want): return
    with mk() as d:
        t=T(d,args); n=time.monotonic(); 
        while h.firsten(d) is None and time.monotonic()<n+12 and t.p.poll() is None: time.sleep(.02)
        time.sleep(1.5); seen=[]
        for k in keys:
            if isinstance(k,(int,float)): time.sleep(k); seen.append(d.look()[:2])
            else: t.key(k)
        ok=t.wait(20); e=d.look(); time.sleep(1)
        print(f'## {name}: exit {t.p.poll()} {"" if ok else "HANG"} seen {seen} end {e} later {d.look()}\n  {t.term()}\n   |',t.tail(900).strip().replace('\n','\n   | '),flush=True); t.kill()
keys=[U,1,U,1,'\x1b[B',1,' ',2,U,1,' ',.5,'q']
if __name__=='__main__':
    go('acu rtu',lambda:act('--family acu'),['--drive','acu']+VIEW,keys)
    go('act vabus',lambda:act('--protocol vabus'),['--protocol','vabus']+VIEW,keys)
    go('acu ascii',lambda:act('--family acu --protocol ascii'),['--protocol','ascii']+VIEW,keys)
    V=['-a','1','--drive','lxm05','sollwert','300rpm','--mode','velocity','--enable','--hold','--yes','--view','--step','50rpm','--max','400rpm','--set','RAMPacc=3000']
    go('lxm velocity',lambda:LX(),V,keys)
    go('lxm speed',lambda:LX(),[x if x!='velocity' else 'speed' for x in V],keys)
    go('lxm jog',lambda:LX(),['-a','1','sollwert','1','--mode','jog','--enable','--hold','--yes','--view'],[1,' ',1,'q'])
    go('lxm position step',lambda:LX(),['-a','1','sollwert','16384usr','--mode','position','--enable','--hold','--yes','--view','--step','1000usr'],[U,1,'q'])
    go('lxm dead-man',lambda:LX(),[x for x in V if x!='--view']+['--dead-man','--duration','8s'],['\r',.5,'\r',1,'q'])
    go('lxm max only above',lambda:LX(),V,[U,1,U,1,U,1,U,1,'q'])
