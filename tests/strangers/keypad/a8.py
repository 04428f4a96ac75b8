from k import *
import a2; a2.want=sys.argv[1:]; case=a2.case
U,D_='\x1b[A','\x1b[B'
B=['-a','1','sollwert']
H=['--source','line','--enable','--hold','--yes','--view']
def c(n,sp,rest,keys,**k): case(n,keys,base=B+sp+H+rest,**k)
c('neg setpoint -10, up x15',['--','-10Hz'][:0]+['-10Hz'],['--step','1Hz'],[x for i in range(15) for x in (U,.05)]+[1,'q'])
c('neg setpoint -10, down x5',['-10Hz'],['--step','1Hz'],[x for i in range(5) for x in (D_,.05)]+[1,'q'])
c('min above setpoint',['20Hz'],['--step','1Hz','--min','25Hz','--max','30Hz'],[U,.5,D_,.5,'q'])
c('min>max',['20Hz'],['--step','1Hz','--min','30Hz','--max','10Hz'],['q'])
c('step 0',['20Hz'],['--step','0Hz'],[U,.5,'q'])
c('step negative',['20Hz'],['--step','-1Hz'],[U,1,'q'])
c('step huge, max 1000 Hz',['20Hz'],['--step','500Hz','--max','1000Hz'],[U,2,'q'])
c('step percent at Hz',['20Hz'],['--step','1%'],[U,.5,'q'])
c('step rpm at Hz',['20Hz'],['--step','30rpm','--max','900rpm'],[U,1,'q'])
c('step tiny',['20Hz'],['--step','0.001Hz','--max','30Hz'],[U,.5,'q'])
c('min -10: through zero',['2Hz'],['--step','1Hz','--min','-10Hz'],[x for i in range(6) for x in (D_,.2)]+[1,'q'])
c('step without max',['20Hz'],['--step','1Hz'],[U,U,U,1,'q'])
c('max over P.419 (50.00)',['20Hz'],['--step','10Hz','--max','90Hz'],[x for i in range(8) for x in (U,.3)]+[1,'q'],opts='--set 419=5000')
c('ramp and arrows',[],['--ramp','5Hz:25Hz:5s','--step','1Hz','--max','40Hz'],[1.5,U,.3,U,.3,U,2,'q'],dur='8s')
c('jog and view',['20Hz'],['--jog','3s'],[U,'q'])
c('percent mode',['20%'],['--mode','percent','--step','1%','--max','30%'],[U,.5,'q'])
