from j import *
O='--family acu --set 418=0 --set 638=5 '
def go(n,a,o=O,tr=(),rep=2,**k):
    for i in range(rep):
        d=Cube(o); c=run([d],['-a','1']+a,triggers=tr,quiet=True,maxt=60,after=2,**k)
        print('##',n,'| tool',' '.join(a),'| drive',o,'\n  rc',c.rc,'%.1fs'%c.dur,'end',c.end,'later',c.later,'speeds',[h[1][0][1] for h in c.hist][::12])
        print('   words',' '.join('%.2f %s'%w for w in c.words)); print('   out',c.out.strip().replace('\n',' | ')[:900]); print('   err',(c.err+c.ttys).strip().replace('\n',' | ')[:900]); print('  diff',d.diff(),flush=True)
if __name__=='__main__':
    R=['sollwert','10Hz','--enable','--yes']
    go('keep, source line, internal 20',R+['--source','line','--hold','--duration','1s','--on-exit','keep'],O+'--internal 20 --set 434=3 ')
    go('no hold, source line, internal 20',R+['--source','line'],O+'--internal 20 --set 434=3 ')
    go('keep, take-control from 0 contacts closed',R+['--source','line','--take-control','--hold','--duration','1s','--on-exit','keep'],O+'--set 412=0 --internal 5 ')
    go('keep, take-control from 44 no start',R+['--take-control','--hold','--duration','1s','--on-exit','keep','--watchdog','2s'],O+'--set 412=44 ')
    go('no hold, take-control',R+['--take-control'],O+'--set 412=44 ')
    go('no hold, watchdog 2s',R+['--watchdog','2s'],O,rep=1)
    go('until reached bit10 stuck, stiff',R+['--hold','--until','reached','--duration','1s'],O+'--stiff --set 549=2000 ')
