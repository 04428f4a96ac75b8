import sys
from j import *
import re
RUN='--running --left 20 --set 418=0 --set 638=10 '
def go(n,ds,a,rep=2,**k):
    for i in range(rep):
        D=ds(); c=run(D,a,quiet=True,maxt=120,label=n,**k)
        print('##',n,'|',' '.join(a),'rc',c.rc,'%.1fs'%c.dur,'HANG' if c.hang else '','end',c.end,'later',c.later); print('   words',' '.join('%.2f %s'%w for w in c.words)[:400]); print('   out',c.out.strip().replace('\n',' | ')[:700]); print('   err',c.err.strip().replace('\n',' | ')[:500],flush=True)
def hk(per):
    """per: {addr: kind}"""
    rnd=random.Random(3); st={}
    def h(c,f,r,now,d):
        k=per.get(d.addr,'ok')
        if k=='ok': return [(.01,r)]
        if k=='dbl450': return [(.01,r),(.45,r)]
        if k=='dbl700': return [(.01,r),(.7,r)]
        if k=='lose2': st[d.addr]=st.get(d.addr,0)+1; return [] if st[d.addr]%2 else [(.01,r)]
        if k=='late400': return [(.4,r)]
        if k=='late700': return [(.7,r)]
        if k=='prev': o=st.get(d.addr,r); st[d.addr]=r; return [(.01,o)]   # always one reply behind
        if k=='stuck':  # repeats the reply of before the stop for 2 s (a caching gateway)
            key_=f[:6]; st.setdefault(key_,r); return [(.01,st[key_])]
        if k=='garble': b=bytearray(r); b[rnd.randrange(len(b))]^=1<<rnd.randrange(8); return [(.01,bytes(b))] if rnd.random()<.5 else [(.01,r)]
        return [(.01,r)]
    return h
if __name__=='__main__':
    qs=['-a','1,2,3','statemachine','quick-stop']; mk=lambda: [Cube(RUN,1),Cube(RUN,2),Cube(RUN,3)]
    C={
    'dbl450':lambda:go('2 doubled after 450',mk,qs,hook=hk({2:'dbl450'})),
    'dbl700':lambda:go('2 doubled after 700',mk,qs,hook=hk({2:'dbl700'})),
    'lose2':lambda:go('2 loses every 2nd',mk,qs,hook=hk({2:'lose2'})),
    'prev':lambda:go('single, always one reply behind',lambda:[Cube(RUN,1)],['-a','1','statemachine','quick-stop'],hook=hk({1:'prev'})),
    'cache':lambda:go('single, caching gateway repeats first replies; the drive ignores the stop',lambda:[Cube(RUN,1)],['-a','1','statemachine','quick-stop'],hook=hk({1:'stuck'})),
    'garble':lambda:go('single garbled half',lambda:[Cube(RUN,1)],['-a','1','statemachine','quick-stop'],hook=hk({1:'garble'})),
    'late700g':lambda:go('2 late 700',mk,qs,hook=hk({2:'late700'}),rep=1),
    'enlate':lambda:go('held run late700',lambda:[Cube('--set 418=0 --set 638=10 ',1)],['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],hook=hk({1:'late700'}),rep=1),
    'hold-prev':lambda:go('held run, replies one behind',lambda:[Cube('--set 418=0 --set 638=10 ',1)],['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],hook=hk({1:'prev'})),
    'hold-dbl700':lambda:go('held run, doubled 700',lambda:[Cube('--set 418=0 --set 638=10 ',1)],['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],hook=hk({1:'dbl700'})),
    }
    for n in sys.argv[1:] or C: C[n]()
