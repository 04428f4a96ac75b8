from mat import *
def fresh(**k):
    d=Drv(**k); d.set(419,3,4321,ee=False); return d
# V1 eefail per parameter
for n in (419,549,372,480,412):
    d=Drv(); d.eefail=lambda p,ds,n=n: p==n and ds<5; b=d.snap(); r=load(d); judge('eefail %d'%n,d,b,d.snap(),r); d.stop=True
d=fresh(); d.eefail=lambda p,ds: p==480; b=d.snap(); r=load(d); judge('eefail 480 ramdiff419',d,b,d.snap(),r)
for n in (419,480,412):
    d=Drv(); d.eekeep=lambda p,ds,n=n: p==n; b=d.snap(); r=load(d); judge('eekeep %d'%n,d,b,d.snap(),r)
for n in (419,480):
    d=Drv(); d.ramkeep=lambda p,ds,n=n: p==n; b=d.snap(); r=load(d); judge('ramkeep %d'%n,d,b,d.snap(),r)
    d=Drv(); d.ramkeep=lambda p,ds,n=n: p==n and ds<5; b=d.snap(); r=load(d); judge('ramkeep(ds<5) %d'%n,d,b,d.snap(),r)
# ee fails from the k-th write on for ever, also during rollback
for k in (3,5):
    d=Drv(); st={'on':False}
    d.eefail=lambda p,ds,k=k,d=d: d.nw>=k; b=d.snap(); r=load(d); judge('eefail from write %d for ever'%k,d,b,d.snap(),r)
# ramdiff plain, RAM diff all
d=fresh(); b=d.snap(); r=load(d); judge('ramdiff plain',d,b,d.snap(),r)
# run starts at k
for k in (14,20,26,28,30,32,34,38,42,46,50,56):
    d=Drv(); d.hook=lambda kk,f,k=k,d=d: setattr(d,'run',True) if kk==k else None; b=d.snap(); r=load(d); judge('run from %d'%k,d,b,d.snap(),r)
# inforce + ram difference
d=Drv(ramread='inforce'); d.set(419,3,4321,ee=False); b=d.snap(); r=load(d); judge('inforce done',d,b,d.snap(),r)
d=Drv(ramread='inforce'); d.set(480,2,888,ee=False); d.eefail=lambda p,ds: p==412; b=d.snap(); r=load(d); judge('inforce 412 refused, 480 ram only',d,b,d.snap(),r); print(r.e[-900:])
d=Drv(ramread='refused'); b=d.snap(); r=load(d); judge('ram unreadable',d,b,d.snap(),r)
d=Drv(ramread='refused'); b=d.snap(); r=load(d,'--ram'); judge('ram unreadable --ram',d,b,d.snap(),r,ram=True)
