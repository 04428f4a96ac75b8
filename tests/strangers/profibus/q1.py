from c4 import *
def M(nm,args,opts={},su=None,drive=None,sig=None):
    s=Slave(nm,**opts); 
    if su: su(s)
    s.start(); r=run(s,'monitor',*args,'--format','ndjson',quiet=True,drive=drive,sig=sig,timeout=60)
    L=[]
    for x in r.out.splitlines():
        try: L.append(json.loads(x))
        except Exception: L.append({'type':'BADJSON','x':x[:80]})
    ty={}
    for x in L: ty[x['type']]=ty.get(x['type'],0)+1
    sm=[x for x in L if x['type']=='sample']
    def val(x): return [(v['param'],v['value']) for v in (x.get('values') or []) if v['param'] in(701,614,611,700,239)]
    print('##',nm,'rc',r.rc,'%.1f'%r.t,ty,'last',{k:L[-1].get(k) for k in('ok','summary','error')} if L else None)
    for x in sm[:1]+sm[len(sm)//2:len(sm)//2+1]+sm[-1:]: print('    ',round(x['t'],2),(x.get('state') or {}).get('slug'),val(x),(x.get('error') or {}))
    print('   ',r.err.strip()[-250:].replace('\n',' / ')); print('    sins',[y[1][:100] for y in s.sins[:3]],'turn',s.turning); s.close()
dxn=lambda n:(lambda s:s.dx_count>n)
