from ds import *
import glob
FILE='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480@2" = "-12.50 Hz"\n"601@3"="-5 %"\n"549"="6.00 %"\n"419"="60.00 Hz"\n"412@4"="2"\n'
TGT=[(480,2,-1250),(601,3,-5),(549,0,600),(419,0,6000),(412,4,2)]
def cells(snap): return {(n,i,m):v for n,(e,r) in snap.items() for m,l in(('ee',e),('ram',r)) for i,v in enumerate(l)}
def tgt(snap,ram=True,T=TGT):
    s=cells(snap)
    for n,ds,v in T:
        for (a,i,m) in list(s):
            if a==n and (ds==0 or i==ds-1): s[(a,i,m)]=v
    return s
def rowsof(j): return ((j or {}).get('data') or {}).get('values') or []
def named(j):
    out=set()
    for v in rowsof(j):
        if v['result'] in('unrestored','unknown','failed','unproven'): out.add((v['param'],v['data_set']))
    return out
def isnamed(nm,n,i,d):
    return (n,i+1) in nm or (n,0) in nm
STAT={}
def judge(tag,r,d,b,T=TGT,quiet=False,mem=('ee','ram')):
    prob=[]
    d.th.is_alive()
    a=cells(d.snap()); B=cells(b)
    j=r.j; en=((j or {}).get('data') or {}).get('ended') 
    if r.hung: prob.append('HANG')
    if r.rc in(101,70) or 'panicked' in r.err: prob.append('CRASH')
    if r.rc==0:
        G=tgt(b,T=T); G={k:(G[k] if k[2] in mem else B[k]) for k in G}; G={k:(G[k] if k[2] in mem else B[k]) for k in G}; bad={k:(G[k],a[k]) for k in a if a[k]!=G[k]}
        if bad: prob.append('FALSE DONE %s'%bad)
    elif r.rc>0:
        bad={k:(B[k],a[k]) for k in a if a[k]!=B[k]}
        nm=named(j)
        tcc={(n,i) for (n,ds,v) in T for i in range(len(b[n][0])) if ds==0 or i==ds-1}
        un={k:v for k,v in bad.items() if not isnamed(nm,k[0],k[1],d) and not (tag.startswith('pow') and (k[0],k[1]) not in tcc and k[2]=='ram')}
        if un: prob.append('UNNAMED %s'%un)
        if bad and en and 'before' in str(en) and 'not' not in str(en).lower(): prob.append('FALSE BEFORE')
        over=[x for x in nm if not any(k[0]==x[0] and (x[1]==0 or k[1]==x[1]-1 or len(b[k[0]][0])==1) for k in bad)]
    c=d.cnt(); tc={(n,i) for (n,ds,v) in T for i in range(len(b[n][0])) if ds==0 or i==ds-1}
    for k,w in c.items():
        if k not in tc: prob.append('WEAR foreign cell %s'%(k,))
        elif w>(1 if r.rc==0 else 2): prob.append('WEAR %s x%d'%(k,w))
    da=(j or {}).get('data') or {}
    if da.get('eeprom_writes') is not None and sum(c.values())>da['eeprom_writes']+(0 if r.rc==0 else (da.get('eeprom_writes_back') or 0)): prob.append('WEAR plan %s+%s got %d'%(da['eeprom_writes'],da.get('eeprom_writes_back'),sum(c.values())))
    eqw=[w for w in d.wlog if w[4]]
    if eqw: prob.append('EQUAL WRITTEN %s'%eqw[:3])
    er=(j or {}).get('error') or {}
    rs={}
    for v in rowsof(j): rs[v['result']]=rs.get(v['result'],0)+1
    key=(tag.split()[0],r.rc,en); STAT[key]=STAT.get(key,0)+1
    if not quiet or prob: print('%-22s rc=%s t=%.1f ended=%s n=%d nw=%d rows=%s | %s | %s: %s'%(tag,r.rc,r.t,en,d.n,d.nw,rs,'; '.join(prob) or '-',er.get('code'),(er.get('message') or '')[:110])); 
    for w in (j or {}).get('warnings',[]): 
        if not quiet or prob: print('      warn',str(w)[:200])
    sys.stdout.flush()
    return prob
def undo(tag,d,b,uf,extra=(),quiet=True,eeonly=False):
    "bring the drive to life and undo"
    d.hook=None; d.dead=False; d.silent=0; d.clr()
    if not os.path.exists(uf): 
        A=d.snap()
        if {k:v[0] for k,v in A.items()}!={k:v[0] for k,v in b.items()}: print(tag,'NO UNDO FILE and EEPROM differs')
        return None
    r=run(['dataset','undo',uf,'--yes',*extra],d)
    A=d.snap(); bad={k:(b[k],A[k]) for k in A if A[k][0]!=b[k][0] or (not eeonly and A[k][1]!=b[k][1])}
    eq=[w for w in d.wlog if w[4]]
    if r.rc!=0 or bad or eq or not quiet: print('   UNDO',tag,'rc',r.rc,'bad',bad,'eqwritten',eq,((r.j or {}).get('data') or {}).get('ended'),(r.j or {}).get('error'))
    return r
def clean():
    for f in glob.glob(W+'/m*.undo*.toml'): os.remove(f)
def one(tag,hook,ram='cells',args=(),on=None,T=TGT,file='m.toml',doundo=True,limit=120,quiet=False,prep=None,eeonly=True,P=None,mem=('ee','ram')):
    clean()
    d=Drive(ram=ram,P=P); 
    if prep: prep(d)
    b=d.snap(); d.hook=hook; d.clr()
    if hook and hasattr(hook,'reset'): hook.reset()
    r=run(['dataset','load',file,'--yes',*args],d,on=on,limit=limit)
    p=judge(tag,r,d,b,T,quiet=quiet,mem=mem)
    uf=W+'/'+file.replace('.toml','.undo.toml')
    if doundo and r.rc!=0: undo(tag,d,b,uf,eeonly=eeonly)
    d.stop()
    return r,p,d
open(W+'/m.toml','w').write(FILE)
