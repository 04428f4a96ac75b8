from nov import *
from b1 import late,dbl,RUN,dead
V=lambda a,o='':Cube(RUN+'--set 638=10 '+o,a,'vabus')
vq=['--protocol','vabus','-a','1,2,3','statemachine','quick-stop']
v1=['--protocol','vabus','-a','1','--drive','acu','statemachine','quick-stop']
mk=lambda:[V(1),V(2),V(3)]
def addr(per):
    def h(c,f,r,now,d): return [(.010+per.get(d.addr,0),r)]
    return h
def echolate(delay):
    def e(c,x,now): c.send(now+delay,x)
    return e
hold=['--protocol','vabus','-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','1500ms','--yes']
cases={
'plain':lambda: run(mk(),vq,label='plain'),
'dead2':lambda: run([V(1),dead(V(2)),V(3)],vq,label='2 dead'),
'echo':lambda: run(mk(),vq,echo='whole',label='echo'),
'echolate':lambda: run(mk(),vq,echo=echolate(.06),label='echo 60 ms late'),
'late2':lambda: run(mk(),vq,hook=addr({2:.4}),label='2 late .4'),
'dbl2':lambda: run(mk(),vq,hook=lambda c,f,r,now,d:[(.01,r)]+([(.31,r)] if d.addr==2 else []),label='2 doubled'),
'babble':lambda: run(mk(),vq,inject=[(0,.02,b'U')],label='babble U'),
'digits':lambda: run(mk(),vq,inject=[(0,.005,b'A\x02001050')],label='endless digits'),
'eot':lambda: run(mk(),vq,inject=[(0,.02,b'\x04')],label='babble EOT'),
'late1':lambda: run([V(1)],v1,hook=addr({1:.4}),label='late .4'),
'late1_9':lambda: run([V(1)],v1,hook=addr({1:.9}),label='late .9'),
'late600id':lambda: run([V(1)],['--protocol','vabus','-a','1','identify'],hook=addr({1:.6}),label='identify late .6'),
'late600run':lambda: run([V(1).__class__('--set 418=0 --set 638=10',1,'vabus')],hold+['--watchdog','2s'],hook=addr({1:.6}),label='run late .6',triggers=[(T(14),INT)]),
'zero':lambda: run([V(1)],['--protocol','vabus','-a','1','sollwert','0'],hook=addr({1:.4}),label='zero late .4'),
'nak':lambda: run([Cube(RUN+'--set 412=0 --nak-lock silent',1,'vabus')],['--protocol','vabus','-a','1','statemachine','quick-stop'],label='412=0'),
}
if __name__=='__main__':
  for n in (sys.argv[1:] or cases): print('#####',n); cases[n]()
