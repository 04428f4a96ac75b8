# ml6.py FAM KIND NA DTB DTA: two ports; A has NA drives (the last slow to stop), B one drive standing early. B is enabled (fast, long ramp) DTB behind A's LAST standstill; A1 is enabled DTA behind that.
import sys
from vb import *
import h4s
fam,kind,na,dtb,dta=sys.argv[1],sys.argv[2],int(sys.argv[3]),float(sys.argv[4]),float(sys.argv[5])
first=len(sys.argv)>6 and sys.argv[6]=='b'
L=fam=='lx'
A=[(LXM if L else ACU)(i+1) for i in range(na)]; B=(LXM if L else ACU)(1)
for d in A+[B]: (h4s.runsl if L else h4s.runsa)(d)
if L: A[-1].n=1500; A[-1].p[6938]=1500; B.p[1556]=200
else: A[-1].n=30; A[-1].ram[484,0]=3000
S={}
def go(d,t,x):
    if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=x
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=x
def evb(d,t):
    if 'z' not in S and all(x.n==0 and x.wr for x in A+[B]): S['z']=t
    if 'z' not in S: return False
    if 'q' not in S:
        lg=[(x[0],x[2]) for x in list(l1.log) if x[1]=='>' and x[0]>S['z']]
        k=[i for i,x in enumerate(lg) if x[1][1:4]==b'\x03\x16\x08']
        if k:
            m=[x for x in lg[k[-1]:] if x[1][:4]==b'\x01\x03\x1e\x14']
            if len(m)>=2: S['q']=t
    return 'q' in S and t-S['q']>=dtb
def evb_(d,t):
    if any(x.n or not x.wr for x in A+[B]): return False if 'z' not in S else t-S['z']>=dtb
    S.setdefault('z',t); return t-S['z']>=dtb
def gob(d,t): S['b']=t; go(d,t,0)
def eva(d,t): return 'b' in S and t-S['b']>=dta
def goa(d,t): S['a']=t; go(d,t,500 if L else 3000)
B.events=[(evb,gob)]; A[0].events=[(eva,goa)]
l1,l2=Line(A),Line([B])
f=__import__('tempfile').mktemp(suffix='.toml')
dr='lxm05' if L else 'acu'
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n'%(l1.path,l2.path)
for d in A: s+='[drives.fan%d]\nport="left"\naddress=%d\ndrive="%s"\n'%(d.adr,d.adr,dr)
s+='[drives.pump]\nport="right"\naddress=1\ndrive="%s"\n'%dr
open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.run([BIN,'--config',f,'-v','-a','all']+a+['--yes'],capture_output=True,text=True,timeout=120,stdin=subprocess.DEVNULL); t1=time.time()
g=lambda l:[t1-x[0] for x in l.log if x[1]=='>' and x[0]<t1][-1:]
n=[round(d.n,1) for d in (A[0],B)]
cap='STILL TURN' in p.stdout+p.stderr
bad=any(abs(x)>1e-6 for x in n)
print('ml6',*sys.argv[1:],'rc',p.returncode,'took %.2f'%(t1-t0),'z->end %s'%('z' in S and round(t1-S['z'],2)),'gapB','b' in S and round(t1-S['b'],2),'gapA','a' in S and round(t1-S['a'],2),'lastA %.2f lastB %.2f'%(g(l1)[0],g(l2)[0]),'nA1,B',n,'cap',cap,'**FALSE0**' if p.returncode==0 and bad else 'NOCAPS' if bad and not cap else '',flush=True)
open('out/ml6-%s.txt'%'-'.join(sys.argv[1:]),'w').write('t0 %.3f end %.3f z %s b %s a %s\n'%(t0,t1-t0,*[k in S and round(S[k]-t0,3) for k in 'zba'])+p.stdout+p.stderr+'\nA\n'+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l1.log)+'\nB\n'+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l2.log))
l1.close();l2.close()
