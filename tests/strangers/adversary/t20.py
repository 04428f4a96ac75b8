from h import *
S=signal
for name,sg in [('USR1',S.SIGUSR1),('USR2',S.SIGUSR2),('ALRM',S.SIGALRM),('TSTP',S.SIGTSTP)]:
    with act() as d:
        r=run(d,[a.replace('6s','3s') for a in RUN]+['--json'],[(0.8,sig(sg))],limit=9,after=0.5); show(name,r)
import resource
for i in range(1):
    try: os.remove('/tmp/advf/t')
    except OSError: pass
    with act() as d:
        r=run(d,['--trace','/tmp/advf/t']+[a.replace('6s','8s') for a in RUN],limit=30,after=0.5,pre=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,(6000,6000))); show('FSIZE',r)
# LXM, QUIT, and enable --hold
with LX() as d:
    r=run(d,['--drive','lxm05','-a','1','sollwert','300rpm','--enable','--hold','--duration','4s','--yes'],[(0.8,sig(S.SIGQUIT))],limit=20,after=1); show('LXM QUIT',r)
# trace on a really full disk
os.system('mountpoint -q /tmp/advf/small || mount -t tmpfs -o size=4k tmpfs /tmp/advf/small')
for i in range(2):
    with act() as d:
        try: os.remove('/tmp/advf/small/t')
        except OSError: pass
        r=run(d,['--trace','/tmp/advf/small/t']+[a.replace('6s','5s') for a in RUN],limit=30,after=0.5); show('trace full disk',r); print('   ',r['err'][-420:].replace('\n',' / ')); os.system('ls -l /tmp/advf/small')
    # plain read with --trace
    with act() as d:
        os.system('rm -f /tmp/advf/small/*'); r=run(d,['--trace','/tmp/advf/small/t','-a','1','read','@all','--json'],limit=30,after=0.1,base='start'); show('trace full disk read',r); print('   ',r['err'][-300:].replace('\n',' / '))
os.system('umount /tmp/advf/small')
