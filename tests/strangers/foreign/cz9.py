# cz9.py FAM KIND TSIG N PORTS FAST : N drives on each of PORTS ports (one setting each), all at FAST speed, SIGINT at TSIG: exit with shaft turning, capitals?
import sys
from vb import *
import h4s,tempfile
fam,kind,ts,n,np_,fast=sys.argv[1],sys.argv[2],float(sys.argv[3]),int(sys.argv[4]),int(sys.argv[5]),int(sys.argv[6])
L=fam=='lx'; P=[[(LXM if L else ACU)(i+1) for i in range(n)] for _ in range(np_)]; al=[d for p in P for d in p]
for d in al:
    (h4s.runsl if L else h4s.runsa)(d)
    if fast:
        if L: d.n=1500; d.p[6938]=1500
        else: d.n=30; d.ram[484,0]=3000
ls=[Line(p) for p in P]; s=''
for i,l in enumerate(ls):
    s+='[ports.p%d]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n'%(i,l.path)
for i,p in enumerate(P):
    for d in p: s+='[drives.d%d%d]\nport="p%d"\naddress=%d\ndrive="%s"\n'%(i,d.adr,i,d.adr,'lxm05' if L else 'acu')
f=tempfile.mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.Popen([BIN,'--config',f,'-a','all']+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
time.sleep(ts); p.send_signal(signal.SIGINT); out,err=p.communicate(timeout=70); t1=time.time()
print('cz9',*sys.argv[1:],'rc',p.returncode,'took %.2f'%(t1-t0),[(d.st,round(d.n,1)) for d in al],'cap','STILL TURN' in out+err,'turning',sum(abs(d.n)>1e-6 for d in al),'|',' / '.join(x for x in out.splitlines() if x.strip())[:260],'| ERR',err.strip()[:260].replace('\n',' // '),flush=True)
