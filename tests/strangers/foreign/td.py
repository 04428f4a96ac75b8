# td.py FAM KIND WHAT: one port two settings (da on the first, db on the second). WHAT: dead (da never answers) | dies (da dies .3 s after its write) | two (2 Ctrl-C, at .15 and .5) | json (Ctrl-C at .15, --json)
import sys
from vb import *
import h4s,tempfile
fam,kind,what=sys.argv[1:4]
L=fam=='lx'; ds=[(LXM if L else ACU)(i+1) for i in range(2)]
for d in ds: (h4s.runsl if L else h4s.runsa)(d)
T={}
def fate(i,t,q,r,d):
    if d is ds[0]:
        if what=='dead': return []
        if what=='dies' and d.wr:
            T.setdefault('w',t)
            if t-T['w']>.3: return []
    return [(0,r)]
l=Line(ds,fate); dr='lxm05' if L else 'acu'
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=38400\nparity="even"\n[drives.da]\nport="left"\naddress=1\ndrive="%s"\n[drives.db]\nport="right"\naddress=2\ndrive="%s"\n'%(l.path,l.path,dr,dr)
f=tempfile.mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.Popen([BIN,'--config',f,'-a','all']+(['--json'] if what=='json' else [])+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
if what in('two','json'):
    time.sleep(.15); p.send_signal(signal.SIGINT)
    if what=='two': time.sleep(.35); p.send_signal(signal.SIGINT)
try: out,err=p.communicate(timeout=70)
except subprocess.TimeoutExpired: p.kill(); out,err=p.communicate(); print('HANG')
t1=time.time(); w=[round(x[0]-t0,2) for x in ds[1].wr][:3]
print('td',*sys.argv[1:],'rc',p.returncode,'took %.2f'%(t1-t0),[(d.st,round(d.n,1)) for d in ds],'db writes at',w,'cap','STILL TURN' in out+err,'|',' / '.join(x.strip() for x in out.splitlines() if x.strip())[-1500 if what=='json' else -420:],'| ERR',err.strip()[:400].replace('\n',' // '),flush=True)
