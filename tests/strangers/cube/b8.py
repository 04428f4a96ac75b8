import random,subprocess,sys,time
from b1 import BIN,ENV
random.seed(22)
V=['scan','identify','read','write','dataset','diag','statemachine','sollwert','monitor','protocol','line','params','decode','sniff','simulate','schema','completions','man','setpoint','state']
T=['show','enable','disable','quick-stop','reset','goto','contacts','switched-on','S1IND','set','active','select','copy','diff','line','import','export','telegram','trace','status','control','warnings','fault','error','411','372@2','480-483','480=7','412=1','@all','@actual','-1','0','65535','65536','4294967296','99999999999999999999','0x','0xFFFFFFFF','F0500','','\u0000'.replace('\0','~'),'ä','🛑','-0','1,5','10Hz','-10Hz','1e9Hz','100%','1450rpm','5A','2/3','0Hz:50Hz:1s','0Hz:0Hz:0s','--hold','--enable','--take-control','--yes','--json','--format','csv','ndjson','table','--lang','de','--duration','500ms','0s','99999999h','1ns','--interval','--count','0','3','--timeout','1ms','--retries','255','--watchdog','2s','--on-exit','coast','--until','reached','--mode','frequency','velocity','--source','line','--jog','--ramp','--dry-run','--force','-v','-vvv','-q','--type','int','long','--decimals','2','300','--link-test','5','--check','--drive','act','acu','lxm05','--protocol','ascii','vabus','mbtcp','--word-order','high','--baud','auto','115200','--parity','none','--data-bits','7','--stop-bits','2','--for','--base','--as','mbmap','--column','id=Nr','ok.csv','num.csv','1','2','bash','01 03 21 74 00 01 CE 2C','0103','ff'*300,':010321740001','--wait','--step','1Hz','--min','--max','--until-first','--rs485','rts','--follow']
n=bad=0; rcs={}; t0=time.monotonic()
while time.monotonic()-t0<110:
    a=['-p','sim','-a',random.choice(['1','2','1,2','9','0','1-3'])] if random.random()<.85 else []
    a+=[random.choice(V)]+random.choices(T,k=random.randrange(0,6))
    if a and 'simulate' in a: a+=['--for','100ms']
    if 'sniff' in a: a+=['--for','100ms']
    if 'monitor' in a and '--count' not in a: a+=['--count','1']
    n+=1
    try: p=subprocess.run(['timeout','-s','INT','12',BIN]+a,stdin=subprocess.DEVNULL,capture_output=True,env=ENV,cwd='/tmp/adv22',timeout=30)
    except subprocess.TimeoutExpired: print('HANG',a); bad+=1; continue
    except Exception as e: continue
    rcs[p.returncode]=rcs.get(p.returncode,0)+1
    if p.returncode in(70,101,134,139) or b'panicked' in p.stderr: print('CRASH',a,p.stderr[-300:]); bad+=1
    if p.returncode==124: print('LONG',' '.join(a)[:200])
print(n,'runs',bad,'bad',rcs)
