# hd.py FAM ONEXIT SIGS [to]: held run on a pty drive; SPEED=2000rpm for a faster one
import sys,re
from vb import *
import tempfile
fam,ox,sigs=sys.argv[1:4]
L=fam=='lx'; d=(LXM if L else ACU)(1)
if not L:
    for i in range(1,5): d.ram[412,i]=d.ee[412,i]=1; d.ram[418,i]=d.ee[418,i]=0
l=Line([d]); dr='lxm05' if L else 'acu'
cmd=[BIN,'-p',l.path,'-a','1','sollwert',os.environ.get('SPEED') or ('300rpm' if L else '6Hz')]+(['--mode','velocity'] if 0 else [])+['--enable','--hold','--on-exit',ox,'--yes']
if 'to' in sys.argv: cmd=['timeout','--preserve-status',sigs]+cmd; 
t0=time.time(); p=subprocess.Popen(cmd,stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL,start_new_session=True)
w0=None; n0=None
if 'to' not in sys.argv:
  for x in sigs.split(','):
    w=float(x[1:])-(time.time()-t0)
    if w>0: time.sleep(w)
    if w0 is None: w0=len(d.wr); n0=(d.st,round(d.n,1))
    p.send_signal(signal.SIGTERM if x[0]=='T' else signal.SIGINT)
else:
    time.sleep(float(sigs)); w0=len(d.wr); n0=(d.st,round(d.n,1))
try: out,err=p.communicate(timeout=50)
except subprocess.TimeoutExpired: p.kill(); out,err=p.communicate(); print('HANG')
print('hd',*sys.argv[1:],'rc',p.returncode,'took %.2f'%(time.time()-t0),'before',n0,'end',(d.st,round(d.n,1)),'wr',[(round(x[0]-t0,2),)+tuple(x[1:]) for x in d.wr[w0:]][:9],'|',' / '.join(x.strip() for x in out.splitlines() if re.search('stop|interr|TURN|coast',x))[:300],'| ERR',err.strip()[-350:].replace('\n',' // '),flush=True)
