from mat import *
from t6 import plant,two,P
from t3 import ask
for i in range(2):
    st={}
    a,b=two(); plant(a)
    def hb(k,f):
        if f[1] in(6,101) and not st: st['x']=1; a.set(480,2,1234); b.eefail=lambda p,ds:True
    b.hook=hb; r=run(a,'apply','--yes','--atomic',cwd=P,port=False); print('2c rc',r.rc,[x['ended'] for x in r.j['data']['drives']],'fan 480@2',a.ee[480][1],a.ram[480][1],'1234' in r.o or '12.34' in r.o+r.e)
for i in range(2):
    a,b=two(); plant(a); r=ask(a,['apply','--atomic'],b'y\n',lambda:setattr(b,'run',True),cwd=P,port=False); print('5 rc',r.rc,'fan nw',a.nw,'max/cell',max(a.wr.values()),'pump',b.nw,r.o[-330:].replace('\n',' '))
# check vs plan
d=Drv(); d.set(480,2,777,ee=False)
open(W+'/k.toml','w').write('antrieb = 1\n[drive]\nfamily = "act"\n[values]\n"480@2" = "5.00 Hz"\n')
r=run(d,'dataset','check',W+'/k.toml'); print('7 check rc',r.rc,(r.j or {}).get('warnings'))
