from h import *
import random
# signal sweep for several runs
def sweep(make,args,sigs,ts,name,limit=20,base='start',second=None):
    bad=0
    for t in ts:
        for sg in sigs:
            with make() as d:
                sc=[(t,sig(sg))]
                if second: sc+=[(t+second,sig(sg)),(t+2*second,sig(sg))]
                r=run(d,args,sc,limit=limit,base=base,after=0.7)
                st,_,sp=r['later']
                ok = r['code']==130 and abs(sp)<0.6 and st not in('enabled',) and not r['hang']
                # EEPROM/give back
                gb=''
                if not isinstance(d,LX):
                    gb=str({k:v for k,v in d.drive.ram.items()}) if hasattr(d.drive,'ram') else ''
                if not ok: bad+=1; show(f'{name} t={t:.3f} {sg.name}',r); print('   ',r['err'][-500:])
    print(name,'bad',bad,'of',len(ts)*len(sigs),flush=True)
S=signal
g=[i*0.02+0.01 for i in range(0,30)]
if sys.argv[1]=='act':
  sweep(act,RUN+['--json'],[S.SIGINT],g,'act hold int')
  sweep(act,['-a','1','sollwert','20Hz','--source','line','--jog','5s','--watchdog','2s','--yes','--json'],[S.SIGTERM],g,'act jog term')
  sweep(act,RUN+['--json'],[S.SIGHUP],g[5:25:2],'double hup',second=0.02)
else:
  sweep(lambda:LX(),['--drive','lxm05','-a','1','sollwert','300rpm','--enable','--hold','--duration','5s','--yes','--watchdog','2s','--json'],[S.SIGINT],g,'lxm int')
  sweep(lambda:LX(),['--drive','lxm05','-a','1','sollwert','1','--mode','jog','--enable','--hold','--duration','5s','--yes','--json'],[S.SIGTERM],g[::2],'lxm jog term')
  sweep(lambda:LX('--left PVn_target=500'),['--drive','lxm05','-a','1','statemachine','enable','--hold','--duration','5s','--yes','--json'],[S.SIGHUP],g[::2],'lxm enable hup')
