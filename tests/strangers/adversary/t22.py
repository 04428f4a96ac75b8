from h import *
def tm(*a): return subprocess.run(['tmux','-L','strg2',*a],capture_output=True,text=True).stdout
for keys in (['C-z'],['C-\\'],):
    for i in range(2 if keys==['C-z'] else 1):
        with act() as d:
            tm('-f','/dev/null','new-session','-d','-x','80','-y','24','-s','b','bash --norc'); time.sleep(.7)
            tm('send-keys','-t','b',' '.join(cmd(d,[a.replace('6s','4s') for a in RUN])),'Enter')
            t=time.time()
            while firsten(d) is None and time.time()-t<8: time.sleep(.05)
            time.sleep(1)
            for k in keys: tm('send-keys','-t','b',k)
            time.sleep(7); print('tmux bash',keys,'7 s later (duration 4s):',d.look()); print('\n'.join(tm('capture-pane','-t','b','-p').split('\n')[-12:]).strip()[-300:])
            tm('kill-server'); time.sleep(1.5 if keys==['C-z'] else .5); print('  after the shell and its terminal were killed:',d.look(),flush=True)
