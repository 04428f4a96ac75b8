# keys that outlive the view: they go to the shell
from k import *
def tm(*a): return subprocess.run(['tmux','-L','adv3',*a],capture_output=True,text=True).stdout
def rep(keys,dur,gap=.04,first=.5):
    tm('send-keys','-t','b',keys); time.sleep(first); n=time.monotonic()+dur-first
    while time.monotonic()<n: tm('send-keys','-t','b',keys); time.sleep(gap)
for name,extra in (('dead-man',['--dead-man']),('view',['--view'])):
    with act() as d:
        tm('-f','/dev/null','new-session','-d','-x','80','-y','24','-s','b','bash --norc'); time.sleep(.7)
        tm('send-keys','-t','b','unset HISTFILE; history -c; clear','Enter'); time.sleep(.3)
        tm('send-keys','-t','b',' '.join(h.cmd(d,RUN+extra+['--step','1Hz','--max','30Hz','--duration','3s'])),'Enter')
        time.sleep(1.5)
        rep('Up',6); time.sleep(.5)
        print('##',name,'after ↑ held 6 s, duration 3 s:',d.look(),[v for _,n,s,v in d.drive.writes if n==410])
        print('   screen:\n','\n'.join(tm('capture-pane','-t','b','-p').rstrip().split('\n')[-6:]))
        rep('Enter',2.5); 
        print('   after Enter held 2.5 s:',d.look(),[v for _,n,s,v in d.drive.writes if n==410],flush=True)
        time.sleep(1); print('\n'.join(tm('capture-pane','-t','b','-p').rstrip().split('\n')[-6:]))
        tm('kill-server'); time.sleep(3); print('   killed',d.look(),flush=True)
