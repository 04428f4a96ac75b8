# ml3.py FAM KIND DT ORDER: ONE port, two settings (baud 19200/38400): drive 1 on the first line, drive 2 on the second; B (slow); A is enabled DT behind its own standstill
import sys
from vb import *
import h4s
fam,kind,dt=sys.argv[1],sys.argv[2],float(sys.argv[3]); L=fam=='lx'
ds=[(LXM if L else ACU)(a) for a in(1,2)]
for d in ds: (h4s.runsl if L else h4s.runsa)(d)
if L: ds[1].n=1500; ds[1].p[6938]=1500; ds[1].p[1556]=200
else: ds[1].n=30; ds[1].ram[484,0]=3000
S={}
def ev(d,t):
    if d.n or not d.wr: return False
    S.setdefault('z',t); return t-S['z']>=dt
def go(d,t):
    S['a']=t
    if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
ds[0].events=[(ev,go)]
l=Line(ds)
f=__import__('tempfile').mktemp(suffix='.toml'); b2=sys.argv[4] if len(sys.argv)>4 else '38400'
open(f,'w').write('[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=%s\nparity="even"\n[drives.fan]\nport="left"\naddress=1\ndrive="%s"\n[drives.pump]\nport="right"\naddress=2\ndrive="%s"\n'%(l.path,l.path,b2,'lxm05' if L else 'acu','lxm05' if L else 'acu'))
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
t0=time.time(); p=subprocess.run([BIN,'--config',f,'-a','all']+a+['--yes'],capture_output=True,text=True,timeout=60,stdin=subprocess.DEVNULL); t1=time.time()
g={}
for t,k,b in l.log:
    if k=='>' and t<t1: g[b[0]]=round(t1-t,2)
print(fam,kind,dt,'rc',p.returncode,'took %.2f'%(t1-t0),'gapA','a' in S and round(t1-S['a'],2),'last asked',g,'n',[d.n for d in ds],[d.st for d in ds],'cap','STILL TURN' in p.stdout+p.stderr,'**FALSE0**' if p.returncode==0 and abs(ds[0].n)>0 else '',p.stderr[:300],flush=True)
l.close()
