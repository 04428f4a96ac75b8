from j import *
RUN='--family acu --running --left 20 --set 418=0 --set 434=2 --set 638=10 '
def go(n,ds,a,rep=2,**k):
    for i in range(rep):
        D=ds(); c=run(D,a,quiet=True,maxt=150,**k)
        print('##',n,'|',' '.join(a),'rc',c.rc,'%.1fs'%c.dur,'HANG' if c.hang else '','end',c.end,'later',c.later); print('   words',' '.join('%.2f %s'%w for w in c.words)[-300:]); print('   out',c.out.strip().replace('\n',' | ')[:500]); print('   err',(c.err+c.ttys).strip().replace('\n',' | ')[-500:],flush=True)
def two(dt):
    return lambda c,f,r,now,d:[(.01 if d is c.drives[0] else .01+dt,r)]
ST=crc(bytes([1,3,2,2,0x50])); F0=crc(bytes([1,0x64,0,0,0,0])); 
qs=['-a','1','statemachine','quick-stop']
H=['-a','1','sollwert','10Hz','--enable','--hold','--duration','1s','--yes']
ign=RUN.replace('--family acu','--family acu --set 412=0').replace('434=2','434=1')+'--internal 20 '
C={
 'tw30':lambda:go('twin runs by contacts, 30 ms behind',lambda:[Cube(RUN,1),Cube(ign,1)],qs,hook=two(.03)),
 'tw5':lambda:go('twin runs by contacts, same time +2ms (collides, here whole)',lambda:[Cube(RUN,1),Cube(ign,1)],qs,hook=two(.002)),
 'twr30':lambda:go('twin stands and answers first; the other ignores the stop',lambda:[Cube('--family acu --set 418=0',1),Cube(ign,1)],qs,hook=two(.03)),
 'twr200':lambda:go('twin stands and answers first, 200 ms',lambda:[Cube('--family acu --set 418=0',1),Cube(ign,1)],qs,hook=two(.2)),
 'twr600':lambda:go('twin stands and answers first, 600 ms',lambda:[Cube('--family acu --set 418=0',1),Cube(ign,1)],qs,hook=two(.6)),
 'inj':lambda:go('injected: status 0250, P.210 = 0, every 20 ms; drive ignores',lambda:[Cube(ign,1)],qs,inject=[(0,.02,ST),(.01,.02,F0)]),
 'inj100':lambda:go('injected every 100 ms',lambda:[Cube(ign,1)],qs,inject=[(0,.1,ST),(.05,.1,F0)]),
 'injq':lambda:go('another master polls the same drive 411 and 210 with true answers (gap 40 ms), quick stop',lambda:[Cube(RUN,1)],qs,inject=[(0,.08,lambda c:crc(bytes([1,3,1,0x9b,0,1]))),(.02,.08,lambda c:c.drives[0].rtu(crc(bytes([1,3,1,0x9b,0,1])),time.monotonic())),(.04,.08,lambda c:crc(bytes([1,0x64,0,210]))),(.06,.08,lambda c:c.drives[0].rtu(crc(bytes([1,0x64,0,210])),time.monotonic()))]),
 'injlag':lambda:go('the same poll, answers of 1.5 s ago (a repeater with memory): held run whose ramp is ignored',lambda:[Cube(RUN,1)],qs,inject=[(0,.05,lambda c:crc(bytes([1,3,2,2,0x50]))),]),
 'injh':lambda:go('held run, injected status 0250 each 150 ms',lambda:[Cube('--family acu --set 418=0 --set 434=2 --set 638=10 ',1)],H,inject=[(0,.15,ST)],rep=1),
 'twh':lambda:go('held run, twin standing with P.412=1, +30 ms',lambda:[Cube('--family acu --set 418=0 --set 434=2 --set 638=10 ',1),Cube('--family acu --set 418=0 --set 434=2 --no-enable',1)],H,hook=two(.03),rep=1),
}
for n in sys.argv[1:] or C: C[n]()
