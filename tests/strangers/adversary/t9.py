from h import *
# 1. adapter that takes no bytes: flow stopped on the slave during the run, forever / for 2 s
def flow(resume):
    with act() as d:
        fd=[None]
        def off(p):
            fd[0]=os.open(d.path,os.O_RDWR|os.O_NOCTTY|os.O_NONBLOCK); termios.tcflow(fd[0],termios.TCOOFF)
        def on(p): termios.tcflow(fd[0],termios.TCOON)
        sc=[(0.8,off)]+([(0.8+resume,on)] if resume else [])
        r=run(d,[a.replace('6s','4s') for a in RUN]+['--json'],sc,limit=60,after=1)
        show(f'flow stopped, resumes {resume}',r)
        try: x=json.loads(r['out']); print('  ',x['error'] and x['error']['message'],x['data'] and x['data'].get('stop'),x['data'] and x['data'].get('running'))
        except Exception as e: print('  no doc',r['out'][:200])
        print('  ',r['err'][-600:])
        if not resume and fd[0]:
            termios.tcflow(fd[0],termios.TCOON); time.sleep(1.5); print('   after flow on again:',d.look())
for res in (None,1.0,3.5,6.0): 
    try: flow(res)
    except OSError as e: print('flow',e)
# 2. trace on a full disk
os.system('mkdir -p /tmp/advf/small; mountpoint -q /tmp/advf/small || mount -t tmpfs -o size=16k tmpfs /tmp/advf/small')
for i in range(2):
    with act() as d:
        try: os.remove('/tmp/advf/small/t')
        except OSError: pass
        r=run(d,['--trace','/tmp/advf/small/t']+[a.replace('6s','10s') for a in RUN],limit=30); show('trace full disk',r); print('   ',r['err'][-500:], os.system('ls -l /tmp/advf/small; df /tmp/advf/small'))
# file size limit: SIGXFSZ
import resource
with act() as d:
    try: os.remove('/tmp/advf/t')
    except OSError: pass
    r=run(d,['--trace','/tmp/advf/t']+[a.replace('6s','8s') for a in RUN],limit=30,pre=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,(6000,6000))); show('trace RLIMIT_FSIZE',r); print('   ',r['err'][-500:])
