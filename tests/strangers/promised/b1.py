from nov import *
RUN='--running --left 20 --set 418=0 '
def ign(d):
    d.d._command=lambda w,n:(setattr(d.d,'word',w)); return d
def late(per):
    def h(c,f,r,now,d): return [(.010+per.get(d.addr,0),r)]
    return h
def dbl(a,after):
    def h(c,f,r,now,d): return [(.01,r)]+([(.01+after,r)] if d.addr==a else [])
    return h
def dead(d): d.dead=True; return d
qs=['-a','1,2,3','statemachine','quick-stop']
mk=lambda: [Cube(RUN,1),Cube(RUN,2),Cube(RUN,3)]
cases={
'dead2':lambda: run([Cube(RUN,1),dead(Cube(RUN,2)),Cube(RUN,3)],qs,label='2 dead'),
'ign1':lambda: run([ign(Cube(RUN,1)),Cube(RUN,2),Lx(3,turning=600.)],qs,label='1 ignores'),
'late2':lambda: run(mk(),qs,hook=late({2:.4}),label='2 late 400'),
'late2500':lambda: run(mk(),qs,hook=late({2:2.5}),label='2 late 2.5 s'),
'lateall2500':lambda: run(mk(),qs,hook=late({1:2.5,2:2.5,3:2.5}),label='all late 2.5 s'),
'dbl2':lambda: run(mk(),qs,hook=dbl(2,.3),label='2 doubled after 300'),
'slow1':lambda: run([Cube(RUN+'--set 424=300',1),Cube(RUN,2),Cube(RUN,3)],qs,label='1 needs 7 s'),
'zero':lambda: run([Cube(RUN+'--set 434=2',1),Cube(RUN+'--internal 5',2),Lx(3,turning=600.)],['-a','1,2,3','sollwert','0'],label='zero; 2 has internal 5 Hz'),
'dv':lambda: run([Cube(RUN,1),Cube(RUN+'--coast-shows shaft',2),Lx(3,turning=600.,friction=60.)],['-a','1,2,3','statemachine','disable-voltage'],label='coast'),
'p412':lambda: run([Cube(RUN+'--set 412=0',1),Cube(RUN,2),Cube(RUN+'--set 412=44',3)],qs,label='1 contacts, 3 keypad'),
'babble':lambda: run(mk(),qs,inject=[(0,.02,b'\x55')],label='babble'),
'int1':lambda: run([Cube(RUN+'--set 424=300',1),Cube(RUN+'--set 424=300',2),Lx(3,turning=600.)],qs,triggers=[(T(1.0),INT)],label='INT at 1.0'),
'int2':lambda: run([Cube(RUN+'--set 424=300',1),Cube(RUN+'--set 424=300',2),Lx(3,turning=600.)],qs,triggers=[(T(1.0),INT),(T(1.8),INT)],label='INT at 1.0 1.8'),
'hup':lambda: run([Cube(RUN+'--set 424=300',1),Cube(RUN+'--set 424=300',2),Lx(3,turning=600.)],qs,triggers=[(T(1.0),HUP)],label='HUP at 1.0'),
'term05':lambda: run(mk(),qs,triggers=[(T(.15),TERM)],label='TERM at .15'),
'unplug':lambda: run(mk(),qs,triggers=[(T(.5),lambda c:c.unplug())],label='unplug at .5'),
'mute':lambda: run(mk(),qs,triggers=[(W('3:P410'),lambda c:setattr(c,'mute',True))],label='replies lost behind the words'),
}
if __name__=="__main__":
  for n in (sys.argv[1:] or cases):
      print("#####",n); cases[n]()
