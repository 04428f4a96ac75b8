from k import *
for extra in ([],['--view']):
    with act('--set 412=0') as d:
        t=T(d,RUN+['--take-control','--duration','1s']+extra); t.wait(12); time.sleep(.3); 
        if t.p.poll() is None: t.key('q'); t.wait(9)
        report('tc',t,d,0.2); print([(n,s,v) for _,n,s,v in d.drive.writes if n!=484]); print(d.drive.value(412)); t.kill()
