import subprocess, time, os, signal, json, sys, threading, pty, tty, select
from slave import *
BIN=os.path.abspath(os.environ.get('ANTRIEB','target/debug/antrieb'))
ENV=dict(os.environ,LC_ALL='C',HOME=WD+'/home',TERM='xterm',COLUMNS='100',LINES='40'); ENV.pop('ANTRIEB_PORT',None)
os.makedirs(WD+'/home',exist_ok=True); os.makedirs(WD+'/cwd',exist_ok=True)
def cmd(s,*a,yes=True,drive=None):
    c=[BIN,'-p',s.path,'--baud',str(s.o['baud']),'-a',str(s.o['addr']),'--protocol','dp','--no-config']
    if yes: c.append('--yes')
    if drive: c+=['--drive',drive]
    return c+[str(x) for x in a]
class R: pass
def run(s,*a,yes=True,timeout=90,sig=None,stdin=subprocess.DEVNULL,drive=None,quiet=False,raw=None,tail=12):
    "sig: list of (time or callable(s), signal)"
    c=raw or cmd(s,*a,yes=yes,drive=drive); t=time.monotonic()
    p=subprocess.Popen(c,stdin=stdin,stdout=subprocess.PIPE,stderr=subprocess.PIPE,env=ENV,cwd=WD+'/cwd',text=True)
    stop=[]
    def sigs():
        for cond,sg in (sig or []):
            t1=time.monotonic()
            while p.poll() is None and not (cond(s) if callable(cond) else time.monotonic()-t1>=cond): time.sleep(0.005)
            if p.poll() is None: s.log('--> signal %s'%sg); p.send_signal(sg)
    th=threading.Thread(target=sigs,daemon=True); th.start()
    r=R()
    try: r.out,r.err=p.communicate(timeout=timeout); r.rc=p.returncode; r.hang=False
    except subprocess.TimeoutExpired:
        p.kill(); r.out,r.err=p.communicate(); r.rc='HANG'; r.hang=True
    r.t=time.monotonic()-t; s.log('--> antrieb ended rc=%s'%r.rc)
    if not quiet:
        print('$ antrieb',' '.join(c[8:]),' -> rc',r.rc,'%.1fs'%r.t)
        o=r.out.strip().splitlines(); e=r.err.strip().splitlines()
        for x in (o if len(o)<=tail else o[:tail//2]+['   ...']+o[-tail//2:]): print('   |',x)
        for x in (e if len(e)<=tail else e[:tail//2]+['   ...']+e[-tail//2:]): print('   !',x)
    try: r.j=json.loads(r.out)
    except Exception: r.j=None
    return r
def report(s,n=12):
    time.sleep(0.05)
    print('   PEER: sins=%d turning=%s out=%.2f dx=%d req=%d state=%s minidle=%.2fms writes=%s wdexp=%s stw=%s'%(len(s.sins),s.turning,s.out,s.dx_count,s.nreq,s.state,s.minidle*1e3,[w[1:] for w in s.writes][-14:],getattr(s,'wd_exp',0),' '.join('%04X/%04X'%x[1:] for x in s.stws[-n:])))
    for t,m in s.sins[:8]: print('   SIN %.3f %s'%(t,m))
class Slv:
    def __init__(s,name,**o): s.s=Slave(name,**o)
    def __enter__(s): s.s.start(); return s.s
    def __exit__(s,*a): s.s.close()
