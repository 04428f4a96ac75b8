# the adapter is pulled in the run: which words, which code
from wr import *
def one(j):
    nm,mk,p,b,adr,n,oe=j
    d=mk(); ln=Line([d]); st={}
    def th():
        f=ev_after(turn,.6)
        while not f(d,time.time()): time.sleep(.005)
        ln.stop=True; ln.th.join(); os.close(ln.sl); os.close(ln.m); st['t']=time.time()
    T=threading.Thread(target=th,daemon=True); T.start()
    r=run(ln,['-a',str(adr)]+p+b+['--jog','3s','--on-exit',oe],d)
    ln.stop=True
    cap='STILL TURN' in r['err']+r['out']
    print('lost-%s-%s rc %s took %.2f end +%.2f cap %d'%(nm,oe,r['rc'],r['took'],r['t1']-st.get('t',0),cap),flush=True)
for f in F4:
    for oe in('ramp','quick-stop','coast'): one(f+(oe,))
