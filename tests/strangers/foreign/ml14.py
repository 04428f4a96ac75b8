# ml14.py FAM KIND NA FATE EVT SEED: two ports, one setting each; A has NA drives, first one damaged (FATE alt|los|lat|slow behind standstill); B one prompt drive, enabled EVT behind all stand
import sys
from vb import *
import h4s
fam,kind,na,ft,evt,seed=sys.argv[1],sys.argv[2],int(sys.argv[3]),sys.argv[4],float(sys.argv[5]),int(sys.argv[6])
L=fam=='lx'; RR=random.Random(seed)
ds=[(LXM if L else ACU)(i+1) for i in range(na)]; B=(LXM if L else ACU)(1)
for d in ds+[B]: (h4s.runsl if L else h4s.runsa)(d)
S={'g':0}; SL=float(os.environ.get('SLOW','.3'))
def ev(d,t):
    if 'z' not in S and all(x.n==0 and x.wr for x in ds+[B]): S['z']=t
    return 'z' in S and t-S['z']>=evt
def go(d,t):
    S['a']=t
    if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
B.events=[(ev,go)]
def fate(i,t,q,r,d):
    if d is ds[0]:
        if ft=='slow': return [(SL,r)]
        if 'z' in S:
            if ft=='alt':
                S['g']+=1
                if S['g']%2: return []
            if ft=='los' and RR.random()<.3: return []
            if ft=='lat' and RR.random()<.4: return [(RR.uniform(.1,.6),r)]
    return [(0,r)]
l=Line(ds,fate); l2=Line([B]); dr='lxm05' if L else 'acu'
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.other]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n'%(l.path,l2.path)
for i,d in enumerate(ds): s+='[drives.d%d]\nport="left"\naddress=%d\ndrive="%s"\n'%(d.adr,d.adr,dr)
s+='[drives.pump]\nport="other"\naddress=1\ndrive="%s"\n'%dr
f=__import__('tempfile').mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.run([BIN,'--config',f,'-a','all']+a+['--yes'],capture_output=True,text=True,timeout=90,stdin=subprocess.DEVNULL); t1=time.time()
g={}
for t,k,b in l.log:
    if k=='>' and t<t1: g[b[0]]=round(t1-t,2)
gb=[round(t1-x[0],2) for x in l2.log if x[1]=='>' and x[0]<t1][-1]
cap='STILL TURN' in p.stdout+p.stderr; bad=abs(B.n)>0 or (kind!='zero' and B.st=='OE')
print('ml14',*sys.argv[1:],'SLOW',SL,'rc',p.returncode,'took %.2f'%(t1-t0),'z->end','z' in S and round(t1-S['z'],2),'gap','a' in S and round(t1-S['a'],2),'last asked',g,'B',gb,'n',B.n,B.st,'cap',cap,'**FALSE0**' if p.returncode==0 and bad else 'NOCAPS' if bad and not cap else '',flush=True)
open('out/ml14-%s.txt'%('-'.join(sys.argv[1:])),'w').write('t0->z %s a %s end %s\n'%('z' in S and S['z']-t0,'a' in S and S['a']-t0,t1-t0)+p.stdout+p.stderr+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l.log)+'\nB\n'+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l2.log))
l.close();l2.close()
