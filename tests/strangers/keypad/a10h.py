from k import *
def tm(*a): return subprocess.run(['tmux','-L','adv3',*a],capture_output=True,text=True).stdout
def rep(keys,dur,gap=.04,first=.5):
    tm('send-keys','-t','b',keys); time.sleep(first); n=time.monotonic()+dur-first
    while time.monotonic()<n: tm('send-keys','-t','b',keys); time.sleep(gap)
def start(d,args,run=RUN,size=('80','24')):
    tm('-f','/dev/null','new-session','-d','-x',size[0],'-y',size[1],'-s','b','bash --norc'); time.sleep(.7)
    tm('send-keys','-t','b','unset HISTFILE; history -c; clear','Enter'); time.sleep(.3)
    tm('send-keys','-t','b',' '.join(h.cmd(d,run+args)),'Enter')
