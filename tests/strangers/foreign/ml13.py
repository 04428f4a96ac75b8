# ml13.py FAM KIND N1 N2 EVT [WHO]: port 1 with two settings (N1, N2 drives; SLOW: first is slow, SL2: last of port 1), port 2 with one prompt drive B, enabled EVT behind all stand
import sys
from vb import *
import h4s
fam,kind,n1,n2=sys.argv[1],sys.argv[2],int(sys.argv[3]),int(sys.argv[4]); evt=float(sys.argv[5])
L=fam=='lx'
ds=[(LXM if L else ACU)(i+1) for i in range(n1+n2)]; B=(LXM if L else ACU)(1)
for d in ds+[B]: (h4s.runsl if L else h4s.runsa)(d)
S={}
def ev(d,t):
    if 'z' not in S and all(x.n==0 and x.wr for x in ds+[B]): S['z']=t
    return 'z' in S and t-S['z']>=evt
def go(d,t):
    S['a']=t
    if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
    else:
        for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
        d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
VI=int(os.environ.get("VI","-1")); V=B if VI<0 else ds[VI]; V.events=[(ev,go)]
import signal,threading
SG=float(os.environ["SG"])
SL=float(os.environ.get('SLOW','0')); SL2=float(os.environ.get('SL2','0'))
def fate(i,t,q,r,d): return [(SL if d is ds[0] else SL2 if d is ds[-1] else 0,r)]
l=Line(ds,fate); l2=Line([B]); dr='lxm05' if L else 'acu'
s='[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="rtu"\nbaud=38400\nparity="even"\n[ports.other]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n'%(l.path,l.path,l2.path)
for i,d in enumerate(ds): s+='[drives.d%d]\nport="%s"\naddress=%d\ndrive="%s"\n'%(d.adr,'left' if i<n1 else 'right',d.adr,dr)
s+='[drives.pump]\nport="other"\naddress=1\ndrive="%s"\n'%dr
f=__import__('tempfile').mktemp(suffix='.toml'); open(f,'w').write(s)
a={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}[kind]
t0=time.time(); p=subprocess.Popen([BIN,'--config',f,'-a','all']+a+['--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
def sg():
    while p.poll() is None:
        if "z" in S and time.time()-S["z"]>=SG: S["s"]=time.time(); p.send_signal(getattr(signal,os.environ.get("SN","SIGINT"))); return
        time.sleep(.003)
threading.Thread(target=sg,daemon=True).start()
O,EE=p.communicate(timeout=90); t1=time.time()
g={}
for t,k,b in l.log:
    if k=='>' and t<t1: g[b[0]]=round(t1-t,2)
gb=[round(t1-x[0],2) for x in l2.log if x[1]=='>' and x[0]<t1][-1]
cap='STILL TURN' in O+EE; bad=abs(V.n)>0 or (kind!='zero' and V.st=='OE')
print('ml13',*sys.argv[1:],'SLOW',SL,SL2,'rc',p.returncode,'took %.2f'%(t1-t0),'z->end','z' in S and round(t1-S['z'],2),'gap','a' in S and round(t1-S['a'],2),'last asked',g,'B',gb,'sig','s' in S and round(t1-S['s'],2),'n',V.n,V.st,'cap',cap,'**FALSE0**' if p.returncode==0 and bad else 'NOCAPS' if bad and not cap else '',flush=True)
open('out/ml13-%s-%s.txt'%('-'.join(sys.argv[1:]),SL),'w').write('t0->z %s a %s end %s\n'%('z' in S and S['z']-t0,'a' in S and S['a']-t0,t1-t0)+O+EE+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l.log)+'\nB\n'+'\n'.join('%.3f %s %s'%(t-t0,k,b.hex()) for t,k,b in l2.log))
l.close();l2.close()
