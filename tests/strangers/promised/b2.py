from nov import *
from b1 import late,dbl,RUN
def L(x): return lambda c,f,r,now,d:[(x,r)]
def ign(d):
    d.d._command=lambda w,n:None; return d
cases={}
for ms in (.4,.9,2.5):
  for v in ('quick-stop','disable-voltage','zero'):
    a=['sollwert','0'] if v=='zero' else ['statemachine',v]
    cases['cube %s %g'%(v,ms)]=lambda ms=ms,a=a,v=v: run([Cube(RUN+'--set 434=2 --set 638=10')],['--drive','acu','-a','1']+a,hook=L(ms),label='%s late %g'%(v,ms))
cases['lx qs .9']=lambda: run([Lx(1,turning=857.)],['--drive','lxm05','-a','1','statemachine','quick-stop'],hook=L(.9),label='lx late .9',verbose_line=True)
cases['ign1']=lambda: run([ign(Cube(RUN))],['--drive','acu','-a','1','statemachine','quick-stop'],label='ignores')
if __name__=='__main__':
  for n in cases:
    if not sys.argv[1:] or sys.argv[1] in n: cases[n]()
