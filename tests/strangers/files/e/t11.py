from mat import *
from t6 import plant,two,P
from t3 import ask
# (b) rollback overwrites a value changed by somebody during the load
for rep_ in range(3):
    d=Drv(); d.eefail=lambda p,ds:p==412 and ds<5
    def h(k,f,d=d):
        if f[1]==6 and (f[2]<<8|f[3])==0x419c and d.ee[480][1]==-1250: d.set(480,2,1234)
    d.hook=h; r=load(d); print('### B load: 480@2 written, somebody sets 12.34, then 412 refused: rc',r.rc,r.j['data']['ended'],'480@2 =',d.ee[480][1],d.ram[480][1],[ (v['param'],v['result']) for v in r.j['data']['values']],r.j['error']['message'][-160:]); d.stop=True
# same with ram
d=Drv()
def h(k,f,d=d):
    if f[1]==6 and (f[2]<<8|f[3])==0x919c:
        d.set(480,2,1234,ee=False); d.T[412]=(16,4,'r',0,44,44,1)
d.hook=h; r=load(d,'--ram'); print('### B --ram: rc',r.rc,r.j['data']['ended'],'480@2 =',d.ee[480][1],d.ram[480][1],(r.j['error'] or {}).get('message')); d.stop=True
# (c) undo window
for rep_ in range(2):
    d=Drv(); r=load(d); d.reset(); st={}
    def h(k,f,d=d,st=st):
        if f[1] in(6,101) and not st: st['x']=1; d.set(419,3,4321)
    d.hook=h; r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); print('### C undo: 419@3 set to 43.21 at the undo\'s first write: rc',r.rc,r.j['data']['ended'],d.ee[419],r.j['error'],d.wr); d.stop=True
# (d) order while running in the roll-back
d=Drv(); d.eefail=lambda p,ds:p==412 and ds<5
def h(kk,f):
    if f[1]==6 and (f[2]<<8|f[3])==0x419c: d.run=True
d.hook=h; r=load(d,json_=False); print('### D',r.rc,d.runw); print([f for t,f in d.log[44:]]); print(r.e[-1500:]); print(r.o); d.stop=True
# (a) plant
a,b=two(); plant(a); j={}
def h(k,f):
    if f[1] in(6,101) and not j: j['x']=1; b.set(480,2,1234)
a.hook=h; r=run(a,'apply','--atomic','--yes',cwd=P,port=False,json_=False); print('### A atomic rc',r.rc,a.wr); print(r.o); print(r.e[-900:])
# changed before y, but atomic: is b looked at before a is written?
a,b=two(); plant(a); r=ask(a,['apply','--atomic'],b'y\n',lambda:setattr(b,'run',True),cwd=P,port=False); print('### A2 b starts while the question stands, --atomic: rc',r.rc,'a.wr',a.wr,'b.wr',b.wr); print(r.o[-900:])
# 419 changed as a set in '419' done
# (e) check vs plan with RAM difference
d=Drv(); [d.set(n,i+1 if len(d.ee[n])>1 else 0,v) for (n,i),v in TG.items()]; d.set(480,2,777,ee=False)
r=run(d,'dataset','check',W+'/m.toml',json_=False); print('### E check, RAM differs:',r.rc,r.o,r.e)
r=run(d,'dataset','load',W+'/m.toml','--dry-run',json_=False); print('### E dry-run:',r.rc,r.o[-300:],r.e[-200:])
r=run(d,'dataset','load',W+'/m.toml','--yes',json_=False); print('### E load:',r.rc,d.wr,d.eqw,r.e[-500:],r.o[-500:])
