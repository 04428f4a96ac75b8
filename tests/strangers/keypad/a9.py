from k import *
import a2; a2.want=sys.argv[1:]; case=a2.case
from a3 import SLOW
U='\x1b[A'; S=signal
DW='--disturb-when enabled '
K2=[1,U,.5,U,.5,' ',3,'q']
c=case
c('lose 2',K2,opts=DW+'--lose 2',dur='9s')
c('late 400',K2,opts=DW+'--late 400 --late-every 1',dur='9s')
c('late 700 overtake',K2,opts=DW+'--late 700 --late-every 2 --overtake',dur='9s')
c('garble 2',K2,opts=DW+'--garble 2',dur='9s')
c('babble',K2,opts=DW+'--babble',dur='9s')
c('flood',K2,opts=DW+'--flood',dur='9s',wait=40)
c('other master',K2,opts=DW+'--other-master 30',dur='9s')
c('silent at 1.5',[2.5,U,.3,' ',.3,'q',.3,'q'],opts='--silent-at 1.5',dur='9s',wait=60)
c('silent at 1.5, C-c',[2.5,'\x03',.5,'\x03'],opts='--silent-at 1.5',dur='9s',wait=60)
c('silent 1.5 to 4',[5,'q'],opts='--silent-at 1.5:4',dur='9s',wait=60)
c('unplug at 1.5',[3,' ',1,'q'],opts='--unplug-at 1.5',dur='9s',wait=60)
c('q in silence then back',[.7,'q'],opts='--silent-at 1.5:4.5',dur='9s',wait=60)
c('trip',[2,U,1,'d',1,'q'],opts='--trip-at 1.5',dur='9s')
c('contact lost',[2,U,1,'q'],opts='--contact-lost 1.5:3',dur='9s')
c('restart',[2,U,1,'q'],opts='--restart-at 1.5',dur='9s',wait=60)
