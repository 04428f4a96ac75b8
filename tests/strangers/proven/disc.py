import sys,drv,random,subprocess,os,time,signal,tomllib,json
os.makedirs(f'{drv.WD}/d',exist_ok=True); os.chdir(f'{drv.WD}/d'); os.system('rm -rf *')
kind=sys.argv[1] if len(sys.argv)>1 else 'mbtcp'
d=drv.Drive('acu',2,random.Random(5))
for n in (700,1300,1599,0+12,5): d.w[n]=16; d.ee[n,0]=n&0xff; d.ram[n,0]=n&0xff
for n in (800,1250): 
    d.w[n]=32; d.four.add(n)
    for k in range(1,5): d.ee[n,k]=d.ram[n,k]=70000+k*(n==800)
s=drv.Server(kind,[d],delay=0.0002)
A=[drv.B,'--no-config','-p',s.port,'-a','2']+(['--protocol',kind] if kind!='mbtcp' else [])
def R(*a,**k):
    r=subprocess.run(A+list(a),capture_output=True,text=True,timeout=200); print('$',*a,'->',r.returncode,(r.stderr.strip().splitlines() or [''])[0][:160]); return r
r=R('dataset','save','--discover','ref.toml'); print([l for l in r.stdout.splitlines() if l[:6] in('values','comple','signat')],d.tel)
ref=tomllib.load(open('ref.toml','rb'))
def norm(t): return {k:v for k,v in t['values'].items()}
bad=0
for sig,at in ((signal.SIGINT,100),(signal.SIGINT,1500),(signal.SIGKILL,900),(signal.SIGKILL,2500),(signal.SIGTERM,2000),(signal.SIGKILL,40),('cut',1200),('cutback',700)):
    fn=f'x{sig if isinstance(sig,str) else int(sig)}-{at}.toml'
    st={'n':0}
    def hook(sv,dd,isw,msg):
        st['n']+=1
        if st['n']==at:
            if isinstance(sig,str): sv.cut=True
            else: sv.proc.send_signal(sig)
    s.end=hook; t0=d.tel; s.cut=False
    p=subprocess.Popen(A+['dataset','save','--discover',fn],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,start_new_session=True); s.proc=p
    o,e=p.communicate(timeout=200); s.end=None; s.cut=False
    fl=sorted(x for x in os.listdir('.') if x.startswith(fn))
    t1=d.tel
    print(sig,at,'rc',p.returncode,fl,'tel',t1-t0,(e.strip().splitlines() or [''])[0][:200])
    # change the drive in between? no.
    # second interruption at resume, then resume
    r=R('dataset','save','--discover',fn,'--resume'); t2=d.tel
    if r.returncode!=0 and not any(x.endswith('.part') for x in fl): r=R('dataset','save','--discover',fn)
    t=tomllib.load(open(fn,'rb'))
    ok=norm(t)==norm(ref) and t['not-held']==ref['not-held']
    print('   resumed tel',t2-t1,'sum',t2-t0,'same',ok, os.listdir('.') and [x for x in os.listdir('.') if x.startswith(fn)])
    if not ok:
        a,b=norm(t),norm(ref); print({k:(a.get(k),b.get(k)) for k in set(a)|set(b) if a.get(k)!=b.get(k)}, {k:(t['not-held'].get(k),ref['not-held'].get(k)) for k in set(t['not-held'])|set(ref['not-held']) if t['not-held'].get(k)!=ref['not-held'].get(k)})
# resume with other options
s.end=None
st={'n':0}
def hook(sv,dd,isw,msg):
    st['n']+=1
    if st['n']==800: sv.proc.send_signal(signal.SIGINT)
s.end=hook
p=subprocess.Popen(A+['dataset','save','--discover','y.toml'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,start_new_session=True); s.proc=p; p.communicate(); s.end=None
r=R('dataset','save','y.toml','--resume'); print(r.stderr[:300]); 
r=R('dataset','save','--changed','y.toml','--resume'); print(r.stderr[:300]); print(os.listdir('.'))
r=R('dataset','save','y.toml'); print(r.stderr[:300])
# another drive in between: value changed, other address
d.ee[372,1]=d.ram[372,1]=999
r=R('dataset','save','--discover','y.toml','--resume'); print(r.stderr[:300]); t=None
if os.path.exists('y.toml'):
    t=tomllib.load(open('y.toml','rb')); print({k:v for k,v in t['values'].items() if '372' in k},t['saved'])
r=R('dataset','check','ref.toml'); print(r.stdout[-400:])
r=R('dataset','check','y.toml'); print(r.stdout[-400:],r.stderr[-300:])
s.close()
