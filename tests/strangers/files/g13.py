from mat import *
for ramm in ('ramval','cells'):
  for k in (29,30):
   for rep in range(2):
    clean(); d=Drive(ram=ramm); b=d.snap(); d.clr()
    d.hook=lambda d,n,b:(os.kill(CUR[0].pid,9),time.sleep(0.03))[0] if n==k else None
    r=run(['dataset','load','m.toml','--yes','--timeout','150ms'],d); d.hook=None
    n1=d.n; w1=list(d.wlog); d.clr(); r2=run(['dataset','undo','m.undo.toml','--yes'],d); print(ramm,k,r.rc,n1,len(w1),'undo',r2.rc,d.n,'eq',[w for w in d.wlog if w[4]],[w[:4] for w in d.wlog],d.cnt())
    if [w for w in d.wlog if w[4]] or rep==0 and ramm=='ramval' and k==29: 
        for l in d.log: print('  ',l)
    d.stop()
