from mat import *
# F3 stderr of undo where RAM alone was changed by somebody
for ch,tag in((lambda d:d.set(480,2,777,ee=False),'480@2 RAM only'),(lambda d:d.set(419,3,4321,ee=False),'419@3 RAM only')):
    d=Drv(); r=load(d); ch(d); r=run(d,'dataset','undo',W+'/m.undo.toml','--yes',json_=False); print('###',tag,r.rc); print(r.e); print(r.o)
# same on 'check' / 'plan'
# F2: window: 4x many values; somebody changes the LAST one at the FIRST write
big={}
for n,v in((418,'4.00'),(419,'60.00'),(424,'12.00'),(425,'13.00'),(480,'6.00'),(481,'7.00'),(482,'8.00'),(483,'9.00'),(600,'6.0'),(601,'12'),(602,'30'),(603,'390.0'),(604,'45.00'),(372,'1450'),(376,'1.1')):
    for s in(1,2,3,4): big['%d@%d'%(n,s)]=(('%s'%(v if s!=3 else v)),)
open(W+'/big.toml','w').write('antrieb = 1\n[drive]\nfamily = "act"\n[values]\n'+''.join('"%s" = "%s"\n'%(k,v[0]) for k,v in big.items() if k[-1] in '124')+'"412@4" = "2"\n')
for what in('412 both','412 ram'):
    d=Drv(delay=.01); st={}
    def h(k,f,d=d,st=st,what=what):
        if f[1] in(6,101) and 't' not in st: st['t']=time.monotonic(); d.set(412,4,3,ee='both' in what)
        if f[1] in(6,101) and (f[2]<<8|f[3])==0x419c: st['w']=time.monotonic()
    d.hook=h; b=d.snap(); r=load(d,f='big.toml'); print('### big, 412@4 changed to 3 by somebody (%s) at the first write: rc %s end %s t=%.1f n=%d; 412@4 now %s/%s; written %.1f s after the change'%(what,r.rc,r.j['data']['ended'],r.t,d.n,d.ee[412][3],d.ram[412][3],st.get('w',0)-st['t'])); print(r.e[-300:])
# run starts in the midst of the big file
for k in (5,20,40):
    d=Drv(delay=.01); c={'n':0}
    def h(kk,f,d=d,k=k,c=c):
        if f[1] in(6,101):
            c['n']+=1
            if c['n']==k: threading.Timer(.012,lambda:setattr(d,'run',True)).start()
    d.hook=h; b=d.snap(); r=load(d,f='big.toml'); print('### big, run after write %d rc %s end %s runw %s wr max %s'%(k,r.rc,r.j['data']['ended'],d.runw,max(d.wr.values()))); print(r.e[-500:]); 
    df=diffs(b,d.snap()); rows={(v['param'],v['data_set']):v['result'] for v in r.j['data']['values']}
    un=[(k2,rows.get((k2[0],k2[1]+1),rows.get((k2[0],0)))) for k2 in df if rows.get((k2[0],k2[1]+1),rows.get((k2[0],0))) not in('unrestored','unknown','unproven')]; print('   differing cells not rowed:',un[:6],len(un),'of',len(df))
# run, then rollback while running; and run after the last write
for k in(47,52,58):
    d=Drv(); d.hook=lambda kk,f,d=d,k=k: setattr(d,'run',True) if kk==k else None; r=load(d); print('### run at',k,'rc',r.rc,r.j['data']['ended'],[w['message'] for w in r.j['warnings']],r.j['error'])
# stop while running at rollback: telegram after refusal
d=Drv(); d.eefail=lambda p,ds:p==412
def h(kk,f):
    if f[1]==6 and (f[2]<<8|f[3])==0x419c: d.run=True
d.hook=h; b=d.snap(); r=load(d); print('### 412 refused and runs: rc',r.rc,r.j['data']['ended'],d.runw); print(r.e[-700:])
