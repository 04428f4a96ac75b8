# mv.py FAM KIND SIGS SLOW NSET NPER [other] [json]: SIGS like I.15,I.45 or T.1,T.1 (abs times)
import sys,re
from vb import *
import h4s,tempfile
fam,kind,sigs,slow,ns,npr=sys.argv[1],sys.argv[2],sys.argv[3],float(sys.argv[4]),int(sys.argv[5]),int(sys.argv[6])
L=fam=='lx'; C=LXM if L else ACU; ds=[C(i+1) for i in range(ns*npr)]; B=C(1)
for d in ds+[B]: (h4s.runsl if L else h4s.runsa)(d)
first=ds[:npr]; oth='other' in sys.argv; dead='dead' in sys.argv
l=Line(ds,lambda i,t,q,r,d:[] if dead and d is ds[0] else [(slow if d in first else 0,r)]); l2=Line([B]); dr='lxm05' if L else 'acu'
s=''
for k in range(ns): s+='[ports.p%d]\npath="%s"\nprotocol="rtu"\nbaud=%d\nparity="even"\n'%(k,l.path,[19200,38400,9600][k])
if oth: s+='[ports.other]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[drives.pump]\nport="other"\naddress=1\ndrive="%s"\n'%(l2.path,dr)
for i,d in enumerate(ds): s+='[drives.d%d]\nport="p%d"\naddress=%d\ndrive="%s"\n'%(i+1,i//npr,i+1,dr)
f=tempfile.mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.Popen([BIN,'--config',f,'-a','all']+(['--json'] if 'json' in sys.argv else [])+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
for x in sigs.split(','):
    w=float(x[1:])-(time.time()-t0)
    if w>0: time.sleep(w)
    alv=p.poll() is None
    p.send_signal(signal.SIGTERM if x[0]=='T' else signal.SIGINT)
try: out,err=p.communicate(timeout=50)
except subprocess.TimeoutExpired: p.kill(); out,err=p.communicate(); print('HANG')
t1=time.time(); st=[(d.st,round(d.n,1),len(d.wr)) for d in ds+([B] if oth else [])]
fl=(err.strip().splitlines() or [''])[0]
print('BAD' if any(x[2]==0 for x in st) else 'ok','mv',*sys.argv[1:],'alive',alv,'rc',p.returncode,'took %.2f'%(t1-t0),st,'w@',[round(d.wr[0][0]-t0,2) if d.wr else None for d in ds],'cap',('err1' if re.search('[A-Z]{4,} [A-Z]{4,}',fl) else 'err' if re.search('[A-Z]{4,} [A-Z]{4,}',err) else 'out' if re.search('[A-Z]{4,} [A-Z]{4,}',out) else '-'),'|',' / '.join(x.strip() for x in out.splitlines() if x.strip())[:500],'| ERR',err.strip()[:500].replace('\n',' // '),flush=True)
