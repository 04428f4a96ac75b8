# ml2.py FAM KIND DTB DTA SLOWB: two ports; both stand; B (port 2) is enabled again DTB behind its standstill (fast speed, long ramp), and A (port 1) DTA behind B's enabling
import sys
from vb import *
import h4s
fam,kind,dtb,dta=sys.argv[1],sys.argv[2],float(sys.argv[3]),float(sys.argv[4])
L=fam=='lx'
ds=[(LXM if L else ACU)(1) for _ in(0,1)]
for d in ds: (h4s.runsl if L else h4s.runsa)(d)
if L: ds[1].n=1500; ds[1].p[6938]=1500; ds[1].p[1556]=200
else: ds[1].n=30; ds[1].ram[484,0]=3000
S={}
def go(d,t,x):
    if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=x
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=x
def evb(d,t):
    if d.n or not d.wr: return False
    S.setdefault('zb',t); return t-S['zb']>=dtb
def gob(d,t): S['b']=t; go(d,t,1500 if L else 3000); d.n=1500 if L else 30
def eva(d,t): return 'b' in S and t-S['b']>=dta and d.wr and d.n==0
def goa(d,t): S['a']=t; go(d,t,500 if L else 3000)
ds[1].events=[(evb,gob)]; ds[0].events=[(eva,goa)]
l1,l2=Line([ds[0]]),Line([ds[1]])
f=tempfile=__import__('tempfile').mktemp(suffix='.toml')
open(f,'w').write('[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[drives.fan]\nport="left"\naddress=1\ndrive="%s"\n[drives.pump]\nport="right"\naddress=1\ndrive="%s"\n'%(l1.path,l2.path,'lxm05' if L else 'acu','lxm05' if L else 'acu'))
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.run([BIN,'--config',f,'-v','-a','all']+a+['--yes'],capture_output=True,text=True,timeout=120,stdin=subprocess.DEVNULL); t1=time.time()
n=[round(d.n,1) for d in ds]; st=[d.st for d in ds]
g=lambda l:[t1-x[0] for x in l.log if x[1]=='>' and x[0]<t1][-1:]
print(fam,kind,dtb,dta,'rc',p.returncode,'took %.2f'%(t1-t0),'zB->end %s'%('zb' in S and round(t1-S['zb'],2)),'gapB','b' in S and round(t1-S['b'],2),'gapA','a' in S and round(t1-S['a'],2),'lastA %.2f lastB %.2f'%(g(l1)[0],g(l2)[0]),'n',n,st,'cap','STILL TURN' in p.stdout+p.stderr, '**FALSE0**' if p.returncode==0 and any(abs(x)>1e-6 for x in n) else '',flush=True)
open('out/ml2-%s-%s-%s-%s.txt'%(fam,kind,dtb,dta),'w').write(' '.join(a)+'\n'+p.stdout+p.stderr)
l1.close();l2.close()
