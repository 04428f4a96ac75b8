from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
import shutil
random.seed(5)
d=Drive()
def S(*a,**k): 
    k.setdefault('limit',90); return run(['dataset','save',*a,'--timeout','150ms'],d,**k)
def vals(f): return sorted(l.strip() for l in open(W+'/'+f) if l.startswith('"'))
def sv(r): return 'rc=%s t=%.1f | %s | hint %s | err %s'%(r.rc,r.t,((r.j or {}).get('error') or {}).get('message','')[:250],((r.j or {}).get('error') or {}).get('hint'),[l[:150] for l in r.err.splitlines()[-3:]])
def rm():
    for f in os.listdir(W):
        if f.startswith(('r','.r')): os.remove(W+'/'+f)
rm(); d.clr(); r=S('ref.toml'); N=d.n; ref=vals('ref.toml'); sig=[l for l in open(W+'/ref.toml') if 'signature' in l]
res={}
for sg in(signal.SIGINT,signal.SIGTERM,signal.SIGKILL,signal.SIGHUP):
    for t in range(4):
        rm(); k=random.randrange(4,N-1); d.clr(); first=True
        d.hook=lambda d,n,b:(os.kill(CUR[0].pid,sg),time.sleep(0.02))[0] if n==k else None
        r=S('r.toml'); d.hook=None; n1=d.n; part=os.path.exists(W+'/r.toml.part'); full=os.path.exists(W+'/r.toml')
        lit=[f for f in os.listdir(W) if f.startswith('.r')]
        d.clr(); r2=S('r.toml','--resume'); ok=os.path.exists(W+'/r.toml') and vals('r.toml')==ref and [l for l in open(W+'/r.toml') if 'signature' in l]==sig
        print(sg.name,k,'rc',r.rc,'part',part,'full',full,lit,'resume rc',r2.rc,'n',n1,'+',d.n,'ok',ok,'left',[f for f in os.listdir(W) if 'r.toml' in f], '' if r2.rc==0 else sv(r2), (r.err.splitlines() or [''])[-1][:160] if t==0 else '')
# dead line, then resume after the drive has changed a value already saved
rm(); d.clr(); d.hook=lambda d,n,b:'dead' if n==200 else None; r=S('r.toml'); print('dead',sv(r)); d.hook=None; d.dead=False; 
b=d.P[372]['ee'][0]; d.set(372,0,1111); d.clr(); r=S('r.toml','--resume'); print('resume changed drive',sv(r),[l for l in vals('r.toml') if '"372' in l],d.n); d.P=table()
r=run(['dataset','check','r.toml'],d); print('check',r.rc)
# resume on another family/address, on complete file, part edited
rm(); r=S('ref.toml'); r=S('ref.toml','--resume'); print('resume complete',sv(r)); r=S('rnone.toml','--resume'); print('resume nothing',sv(r))
rm(); d.hook=lambda d,n,b:'dead' if n==200 else None; r=S('r.toml'); d.hook=None; d.dead=False; shutil.copy(W+'/r.toml.part',W+'/rp.toml')
r=run(['dataset','check','rp.toml'],d); print('check part',s(r)); r=run(['dataset','load','rp.toml','--yes'],d); print('load part',s(r)); r=S('r.toml'); print('save without --resume while part',sv(r),[f for f in os.listdir(W) if 'r.toml' in f])
rm(); shutil.copy(W+'/rp.toml',W+'/r.toml.part') if os.path.exists(W+'/rp.toml') else None
rm(); d.hook=lambda d,n,b:'dead' if n==200 else None; r=S('r.toml'); d.hook=None; d.dead=False; d.addr=2; r=S('r.toml','--resume'); print('resume addr2',sv(r)); d.addr=1; r=S('r.toml','--resume','--changed'); print('resume as changed',sv(r))
r=S('r.toml','--resume','--discover'); print('resume as discover',sv(r))
open(W+'/r.toml.part','ab').write(b'\xff\xfe') if os.path.exists(W+'/r.toml.part') else None; r=S('r.toml','--resume'); print('resume broken part',sv(r))
# discover
def P60():
    P=table(); k=0
    for n in range(700,712): P[n]=dict(t=(U,L,S_,U)[k%4],ds=k%2==0,acc='rw',lo=None,hi=None,ee=[k]*(4 if k%2==0 else 1),ram=[k]*(4 if k%2==0 else 1),run=True,w=[0]*4,rw=[0]*4); k+=1
    P[700]['ee']=[1,2,3,4]; P[700]['ram']=[1,2,3,4]; P[701]['ee']=[-5]; P[701]['ram']=[-5]; P[702]['ee']=[-7]*4;P[702]['ram']=[-7]*4
    return P
S_='i16'
rm(); d.P=P60(); print('params',len(d.P)); d.clr(); r=S('rd.toml','--discover'); print('discover',sv(r),d.n); dv=vals('rd.toml') if os.path.exists(W+'/rd.toml') else []
held={int(l.split('"')[1].split('@')[0]) for l in dv}; print('not held',sorted(set(d.P)-held),'count',len(dv)); print([l for l in dv if l.startswith('"70') or l.startswith('"71')]); print(open(W+'/rd.toml').read().split('[values]')[0][-900:])
for t in range(3):
    k=random.randrange(50,d.n if t==0 else 1500)
    for f in glob.glob(W+'/re*'): os.remove(f)
    d.clr(); d.hook=lambda d,n,b:(os.kill(CUR[0].pid,signal.SIGINT),time.sleep(0.02))[0] if n==k else None
    r=S('re.toml','--discover'); d.hook=None; n1=d.n; d.clr(); r2=S('re.toml','--resume','--discover'); print('discover INT',k,r.rc,'resume',r2.rc,n1,d.n,vals('re.toml')==dv if r2.rc==0 else sv(r2))
d.clr(); r=run(['dataset','check','rd.toml'],d); print('check discovered',r.rc,d.n,s(r)[:200])
d.set(701,0,9); r=run(['dataset','load','rd.toml','--yes'],d); print('load discovered',d.P[701]['ee'],s(r)[:600])
d.stop()
