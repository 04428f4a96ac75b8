from mat import *
def show(tag,d,b,r):
    a=d.snap(); data=((r.j or {}).get('data') or {}); print('###',tag,'rc',r.rc,'end',data.get('ended'),'diffs',{k:v for k,v in diffs(b,a).items()} if len(diffs(b,a))<9 else len(diffs(b,a)),'wr',max(d.wr.values(),default=0),'eq',d.eqw); print('     rows',[(v['param'],v['data_set'],v['result']) for v in data.get('values',[])]); print('     err',(r.j or {}).get('error') and r.j['error']['message'][-260:],'| hint',(r.j or {}).get('error') and (r.j['error'].get('hint') or '')[:160],'| warn',[w['message'][:140] for w in (r.j or {}).get('warnings',[])],flush=True); d.stop=True
for n in(419,480,412):
    d=Drv(ramread='refused'); d.eefail=lambda p,ds,n=n:p==n and ds<5; b=d.snap(); r=load(d); show('RAM unreadable, takes RAM, EEPROM refused at %d'%n,d,b,r)
for n in(419,480):
    d=Drv(ramread='inforce'); d.eefail=lambda p,ds,n=n:p==n and ds<5; b=d.snap(); r=load(d); show('inforce, takes RAM, EEPROM refused at %d'%n,d,b,r)
for n in(419,480):
    d=Drv(ramread='refused'); d.eekeep=lambda p,ds,n=n:p==n and ds<5; b=d.snap(); r=load(d); show('RAM unreadable, acknowledges, EEPROM keeps old at %d'%n,d,b,r)
d=Drv(ramread='inforce'); d.eekeep=lambda p,ds:p==480 and ds<5; b=d.snap(); r=load(d); show('inforce, acknowledges, EEPROM keeps old at 480 (not knowable)',d,b,r)
# refusal once, EEPROM sees it anyway: takes EEPROM + RAM then answers exception 4
d=Drv(); 
orig=d.write
def w(a,v,bits,orig=orig,d=d):
    orig(a,v,bits)
    if a==0x21e0 and v in(0xFFFFFB1E,) : d.p11=6; raise E(4)
d.write=w; b=d.snap(); r=load(d); show('takes both, then answers exception 4 at 480@2',d,b,r)
# undo with RAM-taking/EEPROM-refusing drive
d=Drv(); b=d.snap(); r=load(d); m=d.snap(); d.reset(); d.eefail=lambda p,ds:p==480 and ds<5; r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); show('undo: EEPROM refused at 480 (vs before load)',d,b,r)
d=Drv(); b=d.snap(); r=load(d); d.reset(); d.eekeep=lambda p,ds:p==480 and ds<5; r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); show('undo: EEPROM keeps at 480 (vs before load)',d,b,r)
d=Drv(ramread='refused'); b=d.snap(); r=load(d); d.reset(); d.eefail=lambda p,ds:p==480 and ds<5; r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); show('undo, RAM unreadable: EEPROM refused at 480',d,b,r)
# --ram with a drive whose RAM write also lands in EEPROM? drive that changes another cell (419@0 write changes only set 1..3)
d=Drv(); orig2=d.write
def w2(a,v,bits,orig=orig2,d=d):
    if a==0x01a3: 
        x=d.ee[419][3],d.ram[419][3]; orig(a,v,bits); d.ee[419][3],d.ram[419][3]=x
    else: orig(a,v,bits)
d.write=w2; b=d.snap(); r=load(d); show('set 0 writes only sets 1-3',d,b,r)
# clamp: drive rounds 480 to 10s, no exception
d=Drv(); orig3=d.write
def w3(a,v,bits,orig=orig3,d=d): orig(a,(v//100*100 if a&0xfff==480 and bits==32 and v<1<<31 else v),bits)
d.write=w3; open(W+'/c.toml','w').write('antrieb = 1\n[drive]\nfamily = "act"\n[values]\n"480" = "12.34"\n"481"="3.00"\n'); b=d.snap(); r=load(d,f='c.toml'); show('drive rounds 12.34 to 12.00',d,b,r)
# doubled replies on write telegrams (wear)
for k in(32,40):
    d=Drv(delay=.008); b=d.snap(); d.hook=lambda kk,f,k=k:'dup' if kk==k else None; r=load(d); print('### dup@%d load rc %s t=%.1f wr max %d n=%d'%(k,r.rc,r.t,max(d.wr.values(),default=0),d.n),flush=True); d.stop=True
