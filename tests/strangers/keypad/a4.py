from k import *
want=sys.argv[1:]
DM=RUN+['--dead-man','--step','1Hz','--min','0Hz','--max','30Hz','--duration','12s']
def on(name): return not want or any(w in name for w in want)
def hold(t,key,dur,rate=0.033,first=0.5):
    t.key(key); time.sleep(first); n=time.monotonic()+dur-first
    while time.monotonic()<n: t.key(key); time.sleep(rate)
def stopt(d,mark): 
    w=[(round(tt-mark,2),v) for tt,n,s,v in d.drive.writes if n==410]
    return w
def dm(name,f,opts="",size=(24,80),base=DM):
    if not on(name): return
    with act(opts) as d:
        t=T(d,base,size=size); time.sleep(1.5)
        pre=d.look(); mark=f(t,d)
        done=t.wait(20)
        report(name+('' if done else ' HANG'),t,d,1.0)
        print('   before key',pre,'words rel. to mark',stopt(d,mark),'setpoints',[v for _,n,s,v in d.drive.writes if n==484][-12:])
        t.kill()
def f1(t,d):
    hold(t,'\r',3); return time.monotonic()
def f2(t,d):
    t.key('\r'); return time.monotonic()
def f3(t,d):
    hold(t,'\x1b[A',3); return time.monotonic()
def f4(t,d): # flood pasted: 500 enters at once
    t.key('\r'*500); return time.monotonic()
def f5(t,d): # hold 2s, 1 s pause, hold again
    hold(t,'\r',2); m=time.monotonic(); time.sleep(1.5); hold(t,'\r',2); time.sleep(1); t.key('q'); return m
def f6(t,d): # paste of many CRs in bracketed paste
    t.key('\x1b[200~'+'\r'*50+'\x1b[201~'); m=time.monotonic(); time.sleep(2); t.key('q'); return m
def f7(t,d): # other keys held
    hold(t,'x',2); m=time.monotonic(); time.sleep(1);t.key('q'); return m
def f8(t,d): # buffered backlog: held for 3 s while the process is stopped, then continued
    hold(t,'\r',1); t.sig(signal.SIGSTOP); n=time.monotonic()
    while time.monotonic()<n+3: t.key('\r'); time.sleep(.033)
    m=time.monotonic(); time.sleep(.5); t.sig(signal.SIGCONT); time.sleep(2); t.key('q'); return m
def f9(t,d): # slow auto repeat 0.4 s
    n=time.monotonic()
    while time.monotonic()<n+3: t.key('\r'); time.sleep(.4)
    m=time.monotonic(); time.sleep(1); t.key('q'); return m
def f10(t,d): # bursts over ssh: 15 keys at once every 0.5 s
    n=time.monotonic()
    while time.monotonic()<n+3: t.key('\r'*15); time.sleep(.5)
    m=time.monotonic(); time.sleep(1); t.key('q'); return m
def f11(t,d): # hold, then hang up
    hold(t,'\r',2); m=time.monotonic(); t.hang(); return m
def f12(t,d): # enter held with space
    hold(t,'\r',2); m=time.monotonic(); t.key(' '); hold(t,'\r',2); t.key('q'); return m
def f13(t,d): # nobody presses at all
    m=time.monotonic(); time.sleep(6); t.key('q'); return m
if __name__=='__main__':
    for n,f in(('hold enter 3 s',f1),('tap',f2),('hold arrow up 3 s',f3),('500 enters at once',f4),('hold, pause, hold',f5),('bracketed paste of CR',f6),('other key held',f7),('backlog in a stopped process',f8),('slow repeat .4',f9),('bursts',f10),('hangup',f11),('space in between',f12),('nobody presses',f13)): dm('dead-man '+n,f)
