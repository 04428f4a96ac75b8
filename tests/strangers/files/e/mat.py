from drv import *
W=HERE+'/w'; shutil.rmtree(W,ignore_errors=True); os.makedirs(W)
OUT=open(HERE+'/out_mat.txt','a')
VALS={'372@2':('1450',372,[1],1450),'480@2':('-12.50 Hz',480,[1],-1250),'419':('60.00 Hz',419,[0,1,2,3],6000),'549':('7.00 %',549,[0],700),'601@3':('12',601,[2],12),'412@4':('2',412,[3],2)}
def mfile(p=W+'/m.toml',vals=VALS):
    open(p,'w').write('antrieb = 1\n[drive]\nfamily = "act"\n[values]\n'+''.join('"%s" = "%s"\n'%(k,v[0]) for k,v in vals.items()))
TG={(n,i):v for _,n,ix,v in VALS.values() for i in ix}
def named(r,n,i):
    rows=[]
    for v in (((r.j or {}).get('data') or {}).get('values') or []):
        if v['param']==n and (v['data_set'] in(0,i+1)): rows.append((v['data_set'],v['store'],v['result'],(v.get('error') or {}).get('kind') if isinstance(v.get('error'),dict) else v.get('error'),v.get('note')))
    return rows
def judge(tag,d,b,a,r,ram=False,wmax=None,foreign={}):
    """list of complaints"""
    c=[]; data=((r.j or {}).get('data') or {}); end=data.get('ended'); df=diffs(b,a)
    if r.rc is None or r.rc<0 or r.rc in(70,101): c.append('CRASH rc %s'%r.rc)
    if 'HANG' in r.e: c.append('HANG')
    if r.j is None: c.append('no json')
    if r.rc==0:
        for (n,i),v in TG.items():
            for m in(('ram',) if ram else('ee','ram')):
                if a[n,i,m]!=v: c.append('FALSE DONE %s %s %s=%s'%(n,i+1,m,a[n,i,m]))
    for k,(o,x) in df.items():
        if (k[0],k[1]) not in TG and k not in foreign: c.append('FOREIGN CELL %s %s->%s'%(k,o,x))
    if end in('untouched','back'):
        for k,(o,x) in df.items():
            if k in foreign and x==foreign[k]: continue
            c.append('FALSE %s: %s %s->%s rows %s'%(end,k,o,x,named(r,k[0],k[1])))
    if end not in('done','untouched','back') and r.rc!=0:
        for k,(o,x) in df.items():
            rows=named(r,k[0],k[1]); bad=[w for w in rows if w[2] in('unrestored','unknown','unproven')]
            wtxt=json.dumps((r.j or {}).get('warnings'))
            if not bad: c.append('UNROWED %s %s->%s rows %s, in warnings: %s'%(k,o,x,rows,'P.%d'%k[0] in wtxt))
    for k,v in foreign.items():
        if a[k]!=v and v is not None: c.append('FOREIGN VALUE OVERWRITTEN %s: %s -> %s end %s rows %s'%(k,v,a[k],end,named(r,k[0],k[1])))
    for k,w in d.wr.items():
        if w>(1 if r.rc==0 else 2): c.append('WEAR %s %d times'%(k,w))
    if d.eqw: c.append('EQUAL WRITES %s'%d.eqw)
    if d.runw: c.append('RUNNING WRITES %s'%d.runw)
    ex={'done':(0,),'untouched':(1,2,3,4,5,6,7,8,130),'back':(9,130),}.get(end)
    if ex and r.rc not in ex: c.append('rc %s for ended %s'%(r.rc,end))
    line='%s rc=%s end=%s t=%.1f n=%d nw=%d %s'%(tag,r.rc,end,r.t,d.n,d.nw,'; '.join(c) if c else 'ok')
    print(line,flush=True); OUT.write(line+'\n'); OUT.flush()
    if c:
        OUT.write('   stderr: '+r.e[-700:].replace('\n','\n     ')+'\n   warnings: '+json.dumps((r.j or {}).get('warnings'))+' err '+json.dumps((r.j or {}).get('error'))+'\n'); OUT.flush()
    return c
def clean():
    for f in os.listdir(W):
        if 'undo' in f: os.remove(W+'/'+f)
def load(d,*x,f='m.toml',**k):
    clean(); d.reset(); return run(d,'dataset','load',W+'/'+f,'--yes',*x,**k)
mfile()
