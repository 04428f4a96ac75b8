# tw.py FAM KIND TSIG SLOW [other] : one port with two settings (d1, d2 both running), 'other': a second port beside; SIGINT at TSIG s; was d2 ever told its stop, is it told?
import sys
from vb import *
import h4s,tempfile
fam,kind,ts,slow=sys.argv[1],sys.argv[2],float(sys.argv[3]),float(sys.argv[4]); oth='other' in sys.argv[5:]
L=fam=='lx'; ds=[(LXM if L else ACU)(i+1) for i in range(2)]; B=(LXM if L else ACU)(1)
for d in ds+[B]: (h4s.runsl if L else h4s.runsa)(d)
fate=lambda i,t,q,r,d:[(slow if d is ds[0] else 0,r)]
l=Line(ds,fate); l2=Line([B])
dr='lxm05' if L else 'acu'
SAME='same' in sys.argv[5:]
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=38400\nparity="even"\n'%(l.path,l.path)
if oth: s+='[ports.other]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[drives.pump]\nport="other"\naddress=1\ndrive="%s"\n'%(l2.path,dr)
s+='[drives.da]\nport="left"\naddress=1\ndrive="%s"\n[drives.db]\nport="%s"\naddress=2\ndrive="%s"\n'%(dr,'left' if SAME else 'right',dr)
f=tempfile.mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.Popen([BIN,'--config',f,'-a','all']+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
time.sleep(ts); al=p.poll() is None; p.send_signal(signal.SIGTERM if "term" in sys.argv else signal.SIGINT)
out,err=p.communicate(timeout=70); t1=time.time()
asked=[round(t-t0,2) for t,k,b in l.log if k=='>' and b[:1]==b'\x02']
print('tw',*sys.argv[1:],'alive',al,'rc',p.returncode,'took %.2f'%(t1-t0),[(d.st,round(d.n,1)) for d in ds+[B]],'d2 writes',len(ds[1].wr),'asked',asked[:2],len(asked),'cap','STILL TURN' in out+err,'|',' / '.join(x for x in out.splitlines() if x.strip())[:700],'| ERR',err.strip()[:400],flush=True)
