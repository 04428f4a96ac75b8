# saves: signals at every kind of telegram, cut, resume, unwritable, symlink, fifo, full disk
import sys,subprocess,json,os,random,time,signal,threading,resource,shutil
from drive import *
A=os.environ['ANTRIEB']
D=os.environ['WD']+'/save'; shutil.rmtree(D,ignore_errors=True); os.makedirs(D); os.chdir(D)
def mk(): 
    d=Drive(1); R=random.Random(5)
    for n in (372,480,481): 
        for k in (1,2,3,4): d.ee[n,k]=R.randint(100,900)
    d.ram=dict(d.ee); return d
d=mk(); st={}
def hook(b,d,t,w):
    st['n']=st.get('n',0)+1
    if st.get('at')==st['n']:
        if st['what']=='cut': b.cut=True
        elif isinstance(st['what'],int): 
            if st['what']: st['p'].send_signal(st['what'])
b=Bus([d],'/tmp/n23_save',hook,delay=0.001); b.start()
def run(*c,pre=None,to=120):
    p=subprocess.Popen([A,'-p','/tmp/n23_save','-b','115200','-a','1','--no-config','--timeout','100ms',*c],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL,preexec_fn=pre); st['p']=p
    try: o,e=p.communicate(timeout=to)
    except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); print('HANG',c); return -99,o,e
    return p.returncode,o,e
rc,o,e=run('dataset','save','ref.toml'); total=st['n']; print('ref',rc,total)
vals=lambda f:[l for l in open(f) if l.startswith('"')]
ref=vals('ref.toml'); R=random.Random(1); res={}
T0=time.time()
for i in range(60):
    if time.time()-T0>100: break
    for f in os.listdir('.'):
        if f.startswith('s.'): os.unlink(f)
    what=R.choice([2,15,1,9,'cut']); at=R.randint(1,total); st.update(n=0,at=at,what=what)
    rc,o,e=run('dataset','save','s.toml'); fs=sorted(f for f in os.listdir('.') if f!='ref.toml'); st['at']=None; b.cut=False
    rc2=None
    if 's.toml.part' in fs:
        rc2,o2,e2=run('dataset','save','s.toml','--resume')
    else: rc2,o2,e2=run('dataset','save','s.toml','--resume')
    fs2=sorted(f for f in os.listdir('.') if f!='ref.toml')
    ok=os.path.exists('s.toml') and vals('s.toml')==ref
    print(i,what,at,rc,fs,rc2,fs2,ok,round(time.time()-T0,1),flush=True)
    k=(what,rc,tuple(fs),rc2,tuple(fs2),ok); res.setdefault(k,[]).append(at)
for k,v in sorted(res.items(),key=str): print(k,len(v),v[:8])
