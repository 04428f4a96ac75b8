import os, sys, json, time, subprocess, signal, select, pty, threading
HERE=os.path.dirname(os.path.abspath(__file__))
BIN=os.path.abspath(os.environ.get('ANTRIEB','target/debug/antrieb'))
ENV={k:v for k,v in os.environ.items() if not k.startswith('ANTRIEB')}; ENV.update(LANG='C.UTF-8',HOME='/tmp/nov22home',TERM='xterm-256color'); ENV.pop('LC_ALL',None)
os.makedirs('/tmp/nov22home',exist_ok=True)
class Drive:
    def __init__(s,**c):
        c.setdefault('log','/tmp/cube-last.log'); s.logf=c['log']
        s.p=subprocess.Popen([sys.executable,HERE+'/'+os.environ.get('ACU','acu.py'),json.dumps(c)],stdin=subprocess.PIPE,stdout=subprocess.PIPE)
        a=json.loads(s.p.stdout.readline()); s.tty=a['pty']; s.pid=a['pid']
    def cmd(s,l):
        try: s.p.stdin.write((l+'\n').encode()); s.p.stdin.flush()
        except BrokenPipeError: pass
    def dump(s):
        s.cmd('dump')
        l=s.p.stdout.readline()
        return json.loads(l) if l else None
    def kill(s): s.p.kill(); s.p.wait()
    def stop(s):
        s.cmd('quit')
        try: s.p.wait(3)
        except Exception: s.p.kill()
        try: s.p.stdin.close()
        except OSError: pass
    def log(s): return open(s.logf).read()
class Run:
    "runs the tool; at: list of (seconds, callable)"
    def __init__(s,args,drive=None,json_=True,at=(),limit=90,env=None,stdin=subprocess.DEVNULL,cwd='/tmp',addr=1,pre=()):
        a=[BIN]
        if drive is not None: a+=['-p',drive if isinstance(drive,str) else drive.tty]
        if addr is not None and drive is not None: a+=['-a',str(addr)]
        a+=list(args)
        if json_ and '--format' not in a and '--json' not in a: a+=['--json']
        s.args=a
        e=dict(ENV); e.update(env or {})
        t0=time.monotonic()
        s.p=subprocess.Popen(a,stdin=stdin,stdout=subprocess.PIPE,stderr=subprocess.PIPE,env=e,cwd=cwd,start_new_session=True)
        s.hung=False; s.atend=None
        def ticker():
            for d,f in sorted(at,key=lambda x:x[0]):
                w=t0+d-time.monotonic()
                if w>0: time.sleep(w)
                if s.p.poll() is not None: break
                f(s)
        th=threading.Thread(target=ticker,daemon=True); th.start()
        try: o,e2=s.p.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            s.hung=True; s.p.kill(); o,e2=s.p.communicate()
        s.t=time.monotonic()-t0
        if isinstance(drive,Drive): 
            try: s.atend=drive.dump()
            except Exception as x: s.atend=None
        s.out=o.decode(errors='replace'); s.err=e2.decode(errors='replace'); s.rc=s.p.returncode
        try: s.j=json.loads(s.out)
        except Exception: s.j=None
    def sig(sg): return lambda r: r.p.send_signal(sg)
INT=Run.sig(signal.SIGINT); TERM=Run.sig(signal.SIGTERM); HUP=Run.sig(signal.SIGHUP)
def brief(r):
    j=r.j or {}
    e=j.get('error') or {}
    return 'rc=%s%s t=%.1f ok=%s code=%s msg=%r hint=%r'%(r.rc,' HUNG' if r.hung else '',r.t,j.get('ok'),e.get('code'),e.get('message'),e.get('hint'))
