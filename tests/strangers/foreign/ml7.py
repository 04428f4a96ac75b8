# ml7.py FAM KIND N1 N2 [EVT]: ONE port, two settings; nobody enables (or, EVT given: first drive of 2nd line EVT behind all stand); prints unseen per drive
import sys
from vb import *
import h4s
fam,kind,n1,n2=sys.argv[1],sys.argv[2],int(sys.argv[3]),int(sys.argv[4]); evt=float(sys.argv[5]) if len(sys.argv)>5 else None
L=fam=='lx'
ds=[(LXM if L else ACU)(i+1) for i in range(n1+n2)]
for d in ds: (h4s.runsl if L else h4s.runsa)(d)
S={}
def ev(d,t):
    if any(x.n or not x.wr for x in ds): return 'z' in S and evt is not None and t-S['z']>=evt
    S.setdefault('z',t); return evt is not None and t-S['z']>=evt
def go(d,t):
    S['a']=t
    if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
v=ds[n1]; v.events=[(ev,go)]
SL=float(os.environ.get('SLOW','0')); fate=lambda i,t,q,r,d:[(SL if d is ds[0] else 0,r)]
l=Line(ds,fate); dr='lxm05' if L else 'acu'
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=38400\nparity="even"\n'%(l.path,l.path)
for i,d in enumerate(ds): s+='[drives.d%d]\nport="%s"\naddress=%d\ndrive="%s"\n'%(d.adr,'left' if i<n1 else 'right',d.adr,dr)
f=__import__('tempfile').mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
t0=time.time(); p=subprocess.run([BIN,'--config',f,'-a','all']+a+['--yes'],capture_output=True,text=True,timeout=60,stdin=subprocess.DEVNULL); t1=time.time()
g={}
for t,k,b in l.log:
    if k=='>' and t<t1: g[b[0]]=round(t1-t,2)
cap='STILL TURN' in p.stdout+p.stderr; bad=abs(v.n)>0 or (kind!='zero' and v.st=='OE')
print('ml7',*sys.argv[1:],'rc',p.returncode,'took %.2f'%(t1-t0),'z->end','z' in S and round(t1-S['z'],2),'gap','a' in S and round(t1-S['a'],2),'last asked',g,'v',v.n,v.st,'cap',cap,'**FALSE0**' if p.returncode==0 and bad else 'NOCAPS' if bad and not cap else '',flush=True)
open('out/ml7-%s-%s.txt'%('-'.join(sys.argv[1:]),SL),'w').write(p.stdout+p.stderr+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l.log))
l.close()
