from k import *
from a4 import stopt
# after terminal hangup of a view: what is left behind in the drive
for name,args,opts in (('fast',['--watchdog','2s'],''),('slow ramp',['--watchdog','2s'],'--set 421=200 --set 425=400'),('fast json',['--json'],''),('take-control',['--take-control','--watchdog','2s'],'--set 412=0')):
    with act(opts) as d:
        b=dict(d.drive.eeprom)
        r0=dict(getattr(d.drive,'ram',{}))
        t=T(d,VIEW+['--duration','8s']+args); ok=t.enabled(); time.sleep(1); m=time.monotonic(); t.hang(); t.wait(25)
        print('##',name,'exit',t.p.poll(),f'{time.monotonic()-m:.1f}s after hangup',d.look()); 
        print('   writes',[(round(tt-m,2),n,s,v) for tt,n,s,v in d.drive.writes if n!=484 or tt>m-.5],flush=True)
        time.sleep(2.5); print('   2.5 s later',d.look(),'fault',getattr(d.drive,'fault',None))
        if t.p.poll() is None: t.p.kill()
