from k import *
import os; B=os.environ.get('ANTRIEB','target/debug/antrieb')
def one(name,d,args):
    t0=time.monotonic(); b=d.look()[:2]
    p=subprocess.run([B,'-p',d.path,'--no-config','--no-progress']+args,capture_output=True,text=True,env=env(),stdin=subprocess.DEVNULL,timeout=60)
    e=d.look(); time.sleep(1.5); print(f'## {name}: exit {p.returncode} {time.monotonic()-t0-1.5:.1f}s before {b} end {e[:2]} later {d.look()[:2]}\n{p.stdout[-400:]}\n{p.stderr[-700:]}',flush=True)
for args in (['--drive','lxm05','-a','1','sollwert','0'],['--drive','lxm05','-a','1','statemachine','quick-stop']):
  for o in ('--running --left 20 --set 434=2','--running --left 20 --set 434=2 --protocol vabus'):
    with act(o) as d: one(' '.join(args)+' '+o,d,(['--protocol','vabus'] if 'vabus' in o else [])+args)
