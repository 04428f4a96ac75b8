from h import *
S=signal
for name,sg in [('QUIT',S.SIGQUIT),('USR1',S.SIGUSR1),('ALRM',S.SIGALRM),('HUP',S.SIGHUP),('TERM',S.SIGTERM),('TSTP',S.SIGTSTP),('XCPU',S.SIGXCPU),('PIPE',S.SIGPIPE)]:
    with act() as d:
        r=run(d,RUN+['--json'],[(0.8,sig(sg))],limit=20,after=1)
        show(name,r,True)
