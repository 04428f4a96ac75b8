from h import *
def w(n,d,args,**k):
    with d:
        r=run(d,args,limit=40,after=0.8,base='start',**k); show(n,r); print('    ',r['err'][-420:].replace('\n',' / '))
for i in range(1):
    w('act running, --drive lxm05 quick-stop',act('--running --left 20'),['--drive','lxm05','-a','1','statemachine','quick-stop'])
    w('act running, --drive lxm05 sollwert 0',act('--running --left 20'),['--drive','lxm05','-a','1','sollwert','0'])
    w('act running, --drive acu quick-stop',act('--running --left 20'),['--drive','acu','-a','1','statemachine','quick-stop'])
    w('act, --drive lxm05 run',act(),['--drive','lxm05','-a','1','sollwert','300rpm','--enable','--hold','--duration','1s','--yes'])
    w('act, --drive acu run',act(),['--drive','acu']+[a.replace('6s','1s') for a in RUN])
    w('acu, --drive act run',act('--family acu'),['--drive','act']+[a.replace('6s','1s') for a in RUN])
    w('lxm turning, --drive act quick-stop',LX('--turning 857'),['--drive','act','-a','1','statemachine','quick-stop'])
    w('lxm turning, --drive act sollwert 0',LX('--turning 857'),['--drive','act','-a','1','sollwert','0'])
    w('lxm, --drive act run',LX(),['--drive','act','-a','1','sollwert','20Hz','--enable','--hold','--duration','1s','--yes'])
    w('lxm, --drive act write',LX(),['--drive','act','-a','1','write','480=10Hz','--yes'])
    w('act, wrong protocol ascii quick-stop',act('--running --left 20'),['--protocol','ascii','-a','1','statemachine','quick-stop'])
    w('act, wrong baud quick-stop',act('--running --left 20'),['-b','9600','-a','1','statemachine','quick-stop'])
