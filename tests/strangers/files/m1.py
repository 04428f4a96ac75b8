from mat import *
def at(k,act): return lambda d,n,b: act if n==k else None
def wfrom(k,act):
    return lambda d,n,b: act if (b[1] in(6,101) and d.nw==k-1) else None
r,p,d=one('none',None); N=d.n; print('telegrams',N)
for l in d.log: print(l)
for k in(1,3):
    r,p,d=one('refuse write %d'%k,wfrom(k,('exc',4,6))); 
    if k==3: show(r,5000)
r,p,d=one('deadafter 18',at(18,'deadafter')); print(r.out[:200],r.err)
