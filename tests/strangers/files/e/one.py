# finding 1 and 2 once more, table output
from mat import *
d=Drv(ramread='refused'); d.eefail=lambda p,ds:p==480 and ds<5; r=load(d,json_=False); print(r.rc,r.e[-700:]); d.eefail=lambda p,ds:False; d.power; r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); print(r.rc,r.j['data']['ended'],[(v['param'],v['result']) for v in r.j['data']['values']],'RAM of 480@2',d.ram[480][1])
