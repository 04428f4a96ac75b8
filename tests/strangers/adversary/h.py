import sys,os,pty,time,signal,subprocess,json,threading,select,fcntl,termios,struct,tempfile
HERE=os.path.dirname(os.path.abspath(__file__)); sys.path[:0]=[HERE+'/../active',HERE+'/../lexium']
import active_drive as ad
A=os.environ.get('ANTRIEB','target/debug/antrieb')
FAST="--set 418=0 --set 420=5000 --set 421=5000 --set 422=5000 --set 423=5000 --set 424=10000 --set 425=10000"
def act(opts="", cls=None):
    o=ad.parser().parse_args((FAST+" --for 120 "+opts).split())
    return (cls or ad.DriveServer)(o)
class LX:
    def __init__(s, text="", **kw):
        import shlex,argparse
        from lexium05 import Readings
        from wire import Disturbances, add_options, taken, Line
        p=argparse.ArgumentParser(); add_options(p,Readings); add_options(p,Disturbances)
        o=p.parse_args(shlex.split(text))
        s.l=Line(taken(o,Readings),taken(o,Disturbances))
    def __enter__(s): s.l.start(); s.path=s.l.path; return s
    def __exit__(s,*a): s.l.stop()
    def look(s):
        x=s.l.look(); return x['state'],x['speed'],x['speed']
    @property
    def first_enabled(s): return s.l.enabled_seen
def firsten(d):
    return d.first_enabled if isinstance(d,LX) else d.drive.first_enabled
def env():
    e=dict(os.environ); e.pop('ANTRIEB_PORT',None); e['LC_ALL']='C.UTF-8'; return e
def cmd(d,args):
    return [A,'-p',d.path,'--no-config','--no-progress']+args
def run(d,args,script=(),limit=40,out=None,err=None,stdin=subprocess.DEVNULL,base='enabled',after=2.0,pre=None):
    """script: [(t after base, fn(proc))]"""
    fo=out or tempfile.TemporaryFile(); fe=err or tempfile.TemporaryFile()
    t0=time.monotonic()
    p=subprocess.Popen(cmd(d,args),stdin=stdin,stdout=fo,stderr=fe,env=env(),preexec_fn=pre)
    todo=list(script); hang=False
    while p.poll() is None:
        n=time.monotonic(); b=t0 if base=='start' else firsten(d)
        while todo and b is not None and n>=b+todo[0][0]: 
            todo.pop(0)[1](p)
        if n-t0>limit:
            hang=True; p.kill(); p.wait(); break
        time.sleep(0.003)
    r={'code':p.returncode,'s':round(time.monotonic()-t0,2),'hang':hang,'end':d.look()}
    time.sleep(after); r['later']=d.look()
    for n,f in(('out',fo),('err',fe)):
        if hasattr(f,'seek'):
            try: f.seek(0); r[n]=f.read().decode('utf8','replace')
            except Exception as e: r[n]='?'
    return r
def sig(s): return lambda p: p.send_signal(s)
def show(name,r,full=False):
    print(f"{name}: exit {r['code']} {r['s']}s hang={r['hang']} end={r['end']} later={r['later']}",flush=True)
    if full: print('  OUT',r.get('out'),'\n  ERR',r.get('err'),flush=True)
RUN=['-a','1','sollwert','20Hz','--source','line','--enable','--hold','--duration','6s','--yes']
