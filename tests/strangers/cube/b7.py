from judge import *
os.environ['ACU']='acu2.py'
R=['--yes','sollwert','10Hz','--enable','--hold','--duration','2s','--take-control']





W=['--yes','write','480@2=12.34Hz','376@4=1.5kW','372@1=1400']
for n,c in (('w dup',dict(dup=0.05)),('w late2',dict(late_every=2,late_by=0.6)),('w late3',dict(late_every=3,late_by=1.2)),('w dead',dict(dead_after_writes=1))):
    r,e,l=case(n,W,c,limit=150,json_=False); print(r.out); print(r.err[-500:])
for n,c in (('d dup',dict(dup=0.05)),('d late2',dict(late_every=2,late_by=0.6)),('d late3',dict(late_every=3,late_by=1.2))):
    case('stop '+n,['statemachine','disable'],dict(p412=1,**c),pre=['p 484 2000','set cw 15',2.2],limit=60)
