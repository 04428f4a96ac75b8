# ml11.py KIND DEC EVT: two ports, one LXM each; A ramps down slowly (1556=DEC from 1500), B stands; B enabled EVT s after start
import sys
from vb import *
import h4s
kind,dec,evt=sys.argv[1],int(sys.argv[2]),float(sys.argv[3])
A,B=LXM(1),LXM(1)
for d in (A,B): h4s.runsl(d)
A.n=1500; A.p[6938]=1500; A.p[1556]=dec
S={}
def go(d,t): S['a']=t; d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
B.events=[(lambda d,t:'T0' in S and t-S['T0']>=evt and d.n==0,go)]
l,l2=Line([A]),Line([B])
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.other]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[drives.fan]\nport="left"\naddress=1\ndrive="lxm05"\n[drives.pump]\nport="other"\naddress=1\ndrive="lxm05"\n'%(l.path,l2.path)
f=__import__('tempfile').mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
t0=S['T0']=time.time(); p=subprocess.run([BIN,'--config',f,'-v','-a','all']+a+['--yes'],capture_output=True,text=True,timeout=300,stdin=subprocess.DEVNULL); t1=time.time()
gb=[round(t1-x[0],2) for x in l2.log if x[1]=='>' and x[0]<t1][-1]; ga=[round(t1-x[0],2) for x in l.log if x[1]=='>' and x[0]<t1][-1]
cap='STILL TURN' in p.stdout+p.stderr; bad=abs(B.n)>0 or (kind!='zero' and B.st=='OE')
az=[t for t,n in A.hist if abs(n)>1e-6][-1]
print('ml11',*sys.argv[1:],'rc',p.returncode,'took %.2f'%(t1-t0),'A standstill at %.1f'%(az-t0),'gap','a' in S and round(t1-S['a'],2),'lastA',ga,'lastB',gb,'nA %.1f nB %.1f'%(A.n,B.n),B.st,'cap',cap,'**FALSE0**' if p.returncode==0 and bad else 'NOCAPS' if bad and not cap else '',flush=True)
open('out/ml11-%s.txt'%'-'.join(sys.argv[1:]),'w').write(p.stdout+p.stderr+'\nA\n'+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l.log[-300:])+'\nB\n'+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l2.log[-300:]))
l.close();l2.close()
