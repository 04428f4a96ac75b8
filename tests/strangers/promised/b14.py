"""values under a hostile line: wrong ones counted"""
from nov import *
import traceback
tot=wrong=miss=0
def one(seed):
    global tot,wrong,miss
    r=random.Random(seed); proto=r.choice(['rtu','rtu','vabus'])
    names=[]; o=''
    vals={}
    for n,lo,hi in((372,60,60000),(376,1,9999),(480,-99900,99900),(481,-99900,99900),(482,-99900,99900),(483,-99900,99900)):
        for s in(1,2,3,4): v=r.randint(lo,hi); vals[n,s]=v; o+='--set %d@%d=%d '%(n,s,v); names.append('%d@%d'%(n,s))
    r.shuffle(names); names=names[:6]
    kind='overtake'; proto='rtu'
    K=r.randint(2,7); P=r.choice([.002,.02,.06,.2,.45]); rr=random.Random(seed)
    cnt=[0]
    twin=Cube('--set 372@1=111 '+' '.join('--set %d@%d=%d'%(n,s,777+s) for n in(372,376,480,481,482,483) for s in(1,2,3,4)),1,proto)
    def hook(c,f,rep,now,d):
        cnt[0]+=1
        if kind=='dblK': return [(.01,rep)]+([(.01+P,rep)] if cnt[0]%K==0 else [])
        if kind=='dblall': return [(.01,rep),(.01+rr.choice([.02,.2,.45]),rep)]
        if kind=='latejit': return [(rr.choice([.01,.01,.3,.6,1.2]),rep)]
        if kind=='overtake': return [(rr.choice([.01,.01,.01,.75,2.6]),rep)]
        if kind=='twin':
            t=twin.rtu(f,now) if proto=='rtu' else (lambda q:q[0][0] if q else None)(twin.p.feed(f,now))
            return [(.01,rep),(.01+P,t)]
        if kind=='lossjit': return [] if rr.random()<.2 else [(rr.choice([.01,.4]),rep)]
        if kind=='dbllate': return [(.3,rep),(.3+P,rep)]
        if kind=='garble' and cnt[0]%K==0: q=bytearray(rep); q[rr.randrange(len(q))]^=1<<rr.randrange(7); return [(.01,bytes(q))]
        return [(.01,rep)]
    inj=[(0,.04,crc(bytes([1,3,0x11,0x74,0,1]))),(.02,.04,crc(bytes([1,3,2,0,99])))] if kind=='master' and proto=='rtu' else []
    d=Cube(o,1,proto)
    c=run([d],(['--protocol','vabus'] if proto=='vabus' else [])+['-a','1','read',*names,'--json']+(['--drive','acu'] if r.random()<.5 else []),hook=hook,inject=inj,quiet=True,maxt=240)
    if len(sys.argv)>3: show(c,True); print(vals)
    try: j=json.loads(c.out)
    except Exception: print('NOJSON',seed,kind,c.rc,c.err[-200:]); return
    w=[];m=0
    for v in (j['data'] or {}).get('values',[]) if isinstance(j['data'],dict) else []:
        k=(v['param'],v['data_set']); 
        if v.get('error') is None and v.get('raw') is not None:
            tot+=1
            if vals.get(k)!=v['raw']: w.append((k,v['raw'],vals.get(k))); wrong+=1
        else: m+=1
    miss+=m
    print('%s seed %d %s %s K%d P%.3f rc %s %.1fs %s wrong %s missing %d | note %s'%('BAD' if w or c.hang or (m and c.rc==0) else 'ok',seed,proto,kind,K,P,c.rc,c.dur,'HANG' if c.hang else '',w,m,c.err.strip().split('\n')[0][:140]),flush=True)
for s in range(int(sys.argv[1]),int(sys.argv[2])):
    try: one(s)
    except Exception: traceback.print_exc(limit=2)
    if s%10==0: print('TOTAL',tot,'wrong',wrong,'missing',miss,flush=True)
