# ml.py FAM KIND DT [DT2]: two ports (a plant file); drive A (port 1) stands early, drive B (port 2) slows for long; A is enabled again DT behind standing, while B is being stopped, and once more DT2 behind its second standstill
import sys
from vb import *
import h4s
fam,kind,dt=sys.argv[1],sys.argv[2],float(sys.argv[3])
L=fam=='lx'
ds=[(LXM if L else ACU)(1) for _ in(0,1)]
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
def ev2(d,t):
    if 'a' not in S or t-S['a']<.05: return False
    if abs(d.n)>1: S['m']=1
    if d.n or 'm' not in S: return False
    S.setdefault('z2',t); return t-S['z2']>=dt2
def go2(d,t): go(d,t); S['a2']=t
dt2=float(sys.argv[4]) if len(sys.argv)>4 else None
ds[0].events=[(ev,go)]+([] if dt2 is None else [(ev2,go2)])
last,least=('a',.15) if dt2 is None else ('a2',.3)
l1,l2=Line([ds[0]]),Line([ds[1]])
f=tempfile=__import__('tempfile').mktemp(suffix='.toml')
open(f,'w').write('[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[drives.fan]\nport="left"\naddress=1\ndrive="%s"\n[drives.pump]\nport="right"\naddress=1\ndrive="%s"\n'%(l1.path,l2.path,'lxm05' if L else 'acu','lxm05' if L else 'acu'))
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
t0=time.time(); p=subprocess.run([BIN,'--config',f,'-v','-a','all']+a+['--yes'],capture_output=True,text=True,timeout=120,stdin=subprocess.DEVNULL); t1=time.time()
n=[round(d.n,1) for d in ds]; st=[d.st for d in ds]
lk=[x[0] for x in l1.log if x[1]=='>' and x[0]<t1]
print(fam,kind,dt,'rc',p.returncode,'took %.2f'%(t1-t0),'gapA','a' in S and round(t1-S['a'],2),*(() if dt2 is None else ('gapA2','a2' in S and round(t1-S['a2'],2))),'last telegram to A %.2f before the end'%(t1-lk[-1]) if lk else 'none','n',n,st,'cap','STILL TURN' in p.stdout+p.stderr, '**FALSE0**' if p.returncode==0 and abs(n[0])>1e-6 and last in S and t1-S[last]>least else '')
open('out/ml-%s-%s-%s.txt'%(fam,kind,dt),'w').write(' '.join(a)+'\n'+p.stdout+p.stderr)
l1.close();l2.close()
