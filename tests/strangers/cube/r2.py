from judge import *
for k in range(2):
    d=Drive(life=30,p412=1,m44_keypad=1,log='log/r2.log',addr=3); r=Run(['read','411','372@2','481','480','482','483','210','241','211','228','282'],d,addr=3,at=[(0.12,lambda r:d.cmd('hangup'))]); print(r.rc,(r.j or {}).get('error')); d.stop()
    d=Drive(life=30,p412=1,m44_keypad=1,log='log/r2.log',addr=3); r=Run(['--yes','sollwert','10Hz','--enable','--hold'],d,addr=3,at=[(2,lambda r:d.cmd('hangup'))]); print(r.rc,((r.j or {}).get('error') or {}).get('context')); d.stop()
    d=Drive(life=30,p412=1,m44_keypad=1,log='log/r2.log',addr=3); r=Run(['monitor','210','--format','ndjson'],d,addr=3,json_=False,at=[(1.5,lambda r:d.cmd('hangup'))]); print(r.rc,[json.loads(x)['error']['context'] for x in r.out.splitlines() if (json.loads(x).get('error') or {}).get('context') is not None][:2]); d.stop()
case('zero until 2',['sollwert','0','--until','reached'],dict(p412=1,fmin=0),pre=['p 484 2000','set cw 15',2],after=2)
case('qs wd 2',['statemachine','quick-stop','--watchdog','2s'],dict(p412=1),pre=['p 484 2000','set cw 15',2],after=2)
case('prof nodur 2',['--yes','sollwert','--profile','/tmp/nov22.prof','--enable','--hold'],dict(p412=1,fmin=0),limit=25,after=1)
from b2 import sh
sh('stdout full ndjson 2','true','--yes sollwert 10Hz --enable --hold --duration 3s --format ndjson >/dev/full'); sh('ulimit 6 again','ulimit -n 6','read 411'); sh('ulimit 7 again','ulimit -n 7','read 411')
