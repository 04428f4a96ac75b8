from nov import *
O='--set 418=0 --set 638=10 '
def g(n,o,a,tr=(),**k):
    c=run([Cube(o)],a,triggers=tr,label=n,maxt=60,after=3,**k); print('speeds',[(h[1][0][0][:2],h[1][0][1]) for h in c.hist][::20]); return c
H=['-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','1s','--yes']
cases={
'tc0run':lambda: g('runs by contacts at 20 Hz, take control',O+'--set 412=0 --internal 20 --running',H+['--take-control']),
'tc0stand':lambda: g('P.412 = 0, contacts closed, drive enabled at 0 Hz internal',O+'--set 412=0 --running',H+['--take-control']),
'tc44run':lambda: g('keypad, runs at 20 Hz',O+'--set 412=44 --internal 20 --running',H+['--take-control']),
'tc2':lambda: g('P.412=2 word 3 running 20 Hz',O+'--set 412=2 --internal 20 --word 3 --running',H+['--take-control']),
'tc0qs':lambda: g('runs by contacts, quick-stop --take-control',O+'--set 412=0 --internal 20 --running',['-a','1','statemachine','quick-stop','--take-control','--yes']),
'zero0':lambda: g('runs by contacts, sollwert 0',O+'--set 412=0 --internal 20 --running',['-a','1','sollwert','0']),
'pct':lambda: g('sollwert 0% while P.484 = 20 runs',O+'--set 434=2 --running --left 20',['-a','1','sollwert','0%']),
'neg0':lambda: g('-0Hz',O+'--set 434=2 --running --left 20',['-a','1','sollwert','--','-0Hz']),
'tiny':lambda: g('0.004Hz',O+'--set 434=2 --running --left 20',['-a','1','sollwert','0.004Hz']),
'min':lambda: g('sollwert 0 with P.418 = 3.5, P.434 = 2, running -20',O.replace('418=0','418=350')+'--set 434=2 --running --left -20',['-a','1','sollwert','0']),
'b0':lambda: g('-a 0 quick-stop',O+'--set 434=2 --running --left 20',['-a','0','statemachine','quick-stop']),
'b0dv':lambda: g('-a 0 disable-voltage',O+'--set 434=2 --running --left 20',['-a','0','statemachine','disable-voltage']),
'b0z':lambda: g('-a 0 sollwert 0',O+'--set 434=2 --running --left 20',['-a','0','sollwert','0']),
'cont':lambda: g('contacts none',O+'--set 412=2 --word 3 --internal 20 --running',['-a','1','statemachine','contacts']),
'keepcc':lambda: g('keep + Ctrl-C twice',O,[x for x in H if x!='1s' and x!='--duration']+['--on-exit','keep'],tr=[(EN(1),INT),(EN(1.2),INT)]),
'dur0':lambda: g('duration 0s',O,H[:-2]+['0s','--yes']),
}
if __name__=='__main__':
  for n in (sys.argv[1:] or cases): print('#####',n); cases[n]()
