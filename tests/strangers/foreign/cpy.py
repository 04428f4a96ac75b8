# cpy.py SEED0 COUNT WORKERS : copies on the line, every parameter its own value
import sys,json
from vb import *
from multiprocessing import Pool
CAT={f:json.load(open('/tmp/judge/%s.json'%f))['data']['params'] for f in('acu','act','lxm')}
class VAL(VACU):
    """every parameter of the catalogue its own value"""
    def setup(s,fam,equal=1,move=False):
        s.move=move; s.cnt={}
        s.w={};s.val={}
        for i,p in enumerate(CAT[fam]):
            n=p['param']; t=p['data_type']
            if t=='string' or p['access']=='w': continue
            w=16 if t in('uint','int','word') else 32 if t=='long' else (16 if n%2 else 32)
            s.w[n]=w; s.ds_=None
            j=i//equal
            s.val[n]=(1000+j*45 if w==16 else 100000+j*1000, p['data_sets'])
        # which a run needs as they are
        for n in (411,260,270,11,249,250,412,413,34,410,30,414): s.val.pop(n,None)
        s.L16=dict(s.L16); s.L32=dict(s.L32)
    def expect(s,n,d):
        if n in s.val:
            b,_=s.val[n]; return b+(d if d<5 else d-5) if n in s.DS else b
        return None
    def access(s,p,d,w,val,t):
        if val is None and p in s.val:
            if s.w[p]!=w: s.err11=14; return 4,0
            b,_=s.val[p]
            if d%5 and p not in s.DS: s.err11=2; return 4,0
            v=b+(d%5 if p in s.DS else 0)
            if s.move and p in(210,211,217,213,218,241,222,228,229,230):
                s.cnt[p]=s.cnt.get(p,0)+1; v=b+s.cnt[p]%(40 if w==16 else 900)
            return 0,v
        return super().access(p,d,w,val,t)
    pr='rtu'
    def handle(s,q,t):
        if s.pr!='vabus': return ACU.handle(s,q,t)
        if s.pend: q=s.pend+q; s.pend=b''
        i=q.rfind(b'\x04')
        if i<0: return None
        q=q[i+1:]
        if not q or q[0]-64!=s.adr: return None
        if len(q)==1: s.pend=b'\x04'+q; return None
        if q[-1]!=5: return bytes([q[0],0x15])
        x=q[1:-1].decode(); dd=int(x[1]); c=x[2]
        p=int(x[2:5]) if c.isdigit() else (ord(c)-55)*100+int(x[3:5])
        w=s.w.get(p) or (16 if p in s.L16 else 32)
        c,v=s.access(p,dd,w,None,t)
        if c: return bytes([q[0],0x15])
        b=x+('04%04X'%(v&0xffff) if w==16 else '08%08X'%(v&0xffffffff))
        b=b.encode()+b'\x03'
        return bytes([q[0],2])+b+bytes([bcc(b)])
class LV(LXM):
    def setup(s,equal=1,move=False):
        s.move=move; s.mc={}; s.val={}
        for i,p in enumerate(CAT['lxm']):
            a=p['address'] or p['param']
            if p['access']=='w': continue
            s.val[a]=(1000000+(i//equal)*2000) if p['data_type']=='long' else 500+(i//equal)*11
            if a not in s.p: s.p[a]=0
        for a in(6914,6916,6918,6920,5640,5646,15362,15364,15366,15368): s.val.pop(a,None)
    def rd(s,a):
        if a in s.val:
            v=s.val[a]
            if s.move and a in(7700,7696,7698): s.mc[a]=s.mc.get(a,0)+1; v+=s.mc[a]%1900
            return v
        return super().rd(a)
def one(seed):
    R=random.Random(seed)
    fam=R.choice(['acu','acu','act','lxm']); fam=os.environ.get('FAM',fam); pr='rtu' if fam=='lxm' else R.choice(['rtu','rtu','ascii','vabus'])
    equal=R.choice([1,1,1,3]); move=R.random()<.5
    if fam=='lxm':
        d=LV(3); d.setup(equal,move)
    else:
        d=VAL(1,act=fam=='act',wo484=fam!='act'); d.pr=pr; d.ascii=pr=='ascii'; d.setup(fam,equal,move)
    P=[p['param'] for p in CAT[fam] if p['access']!='w' and p['data_type']!='string']
    verb=R.choice(['read','read','read','read','read','identify','diag','monitor','state'] if seed%25 else ['all'])
    if len(sys.argv)>5: verb=sys.argv[5]
    k=R.randrange(3,25)
    if verb=='read':
        L=R.sample(P,min(k,len(P)))
        if fam!='lxm':
            L=[('%d@%s'%(x,R.choice('1234')) if x in VAL.DS and R.random()<.5 else '%d'%x) for x in L]
            if R.random()<.15: L=['480@all','372@all','481-483@2','420-423']+L[:6]
        else: L=[str(x) for x in L]
        a=['read']+L+['--json']
    elif verb=='all': a=['read','@all','--json']
    elif verb=='monitor':
        L=[str(x) for x in R.sample(P,min(5,len(P)))]
        if fam=='lxm' and move: L=['7700']+L
        if fam!='lxm' and move: L=['210','211']+L[:4]
        a=['monitor']+L+['--interval','100ms','--count','12','--format','ndjson']
    elif verb=='state': a=['statemachine','show','--json']
    else: a=[verb,'--json']
    mode=sys.argv[4] if len(sys.argv)>4 and sys.argv[4]!='-' else R.choice(['dupN','dupN','dupP','inplace','inplace','early','mix','first','lostdup'])
    N=R.choice([1,2,3,4,5,7,10,20]); dl=R.uniform(0,.5); fixed=R.random()<.5; jit=R.choice([0,0,.02,.1]); lp=R.choice([0,0,.03]); latep=R.choice([0,0,.05]); off=R.randrange(1,30)
    if mode=='clean': jit=lp=latep=0
    if mode=='jit': lp=latep=0; jit=float(os.environ.get('JIT','.05'))
    st={'k':0,'prev':None,'hist':[],'ncop':0}
    def fate(i,t,q,r,dd):
        if mode=='clean': return [(0,r)]
        if mode=='jit': return [(R.uniform(0,jit),r)]
        k=st['k']; st['k']+=1; prev=st['prev']; st['prev']=r; st['hist'].append(r)
        j=R.uniform(0,jit) if jit else 0
        if lp and R.random()<lp: return []
        x=R.uniform(.1,.9) if latep and R.random()<latep else 0
        o=[(j+x,r)]
        D=dl if fixed else R.uniform(0,.5)
        if mode=='dupN' and k%N==0: o.append((j+x+D,r)); st['ncop']+=1
        elif mode=='dupP' and R.random()<.3: o.append((j+x+D,r)); st['ncop']+=1
        elif mode=='inplace' and prev is not None and k%max(N,2)==off%max(N,2): o=[(R.uniform(0,.03),prev)]; st['ncop']+=1
        elif mode=='early' and prev is not None and k%max(N,2)==off%max(N,2): o=[(R.uniform(-.012,0),prev)]; st['ncop']+=1
        elif mode=='first' and prev is not None and k>=off and st['ncop']<R.choice([1,2,3]): 
            o=[(R.uniform(-.012,.02),R.choice([prev]+st['hist'][-4:]))]; st['ncop']+=1
        elif mode=='lostdup' and k%max(N,3)==0: o.append((j+x+.008+dl*.1,r)); st['lose']=True; st['ncop']+=1
        elif mode=='lostdup' and st.pop('lose',False): return []
        elif mode=='mix' and prev is not None:
            y=R.random()
            if y<.1: o=[(R.uniform(-.012,.1),prev)]; st['ncop']+=1
            elif y<.2: o.append((j+D,r)); st['ncop']+=1
            elif y<.25: o=[]
            elif y<.3: o=[(R.uniform(-.01,.05),prev),(R.uniform(0,.1),r)]; st['ncop']+=1
        return o
    ln=Line([d],fate)
    t0=time.time()
    try: r=run(ln,['-a',str(d.adr)]+(['--protocol',pr] if pr!='rtu' else [])+a,None,timeout=200,extra=(),verbose=True)
    finally: ln.close()
    nq=sum(1 for x in ln.log if x[1]=='>')
    wrong=[];ok=0;err=0;ers=set()
    def chk(n,ds,raw,where):
        nonlocal ok
        if fam=='lxm':
            e=d.val.get(n)
            if e is None: return
            if d.move and n in(7700,7696,7698): good=e<=raw<e+1900
            else: good=raw==e
        else:
            e=d.expect(n,ds or 0)
            if e is None: return
            if d.move and n in(210,211,217,213,218,241,222,228,229,230):
                b=d.val[n][0]; good=b<=raw<b+(40 if d.w[n]==16 else 900)
            else: good=raw==e
        if good: ok+=1
        else: wrong.append((where,n,ds,raw,e))
    def walk(x,where=''):
        nonlocal err
        if isinstance(x,dict):
            if 'param' in x and 'raw' in x:
                if x['raw'] is not None and isinstance(x['raw'],int): chk(x['param'],x.get('data_set'),x['raw'],where)
                elif x.get('error'): err+=1; ers.add(str(x['error'].get('code') if isinstance(x['error'],dict) else x['error'])[:40])
            for k,v in x.items(): walk(v,where+'/'+k)
        elif isinstance(x,list):
            for v in x: walk(v,where)
    lastv={}; stale=0
    try:
        if verb=='monitor':
            for l in r['out'].splitlines():
                j=json.loads(l); walk(j,'m')
                def st_(x):
                    nonlocal stale
                    if isinstance(x,dict):
                        if x.get('param') in(210,211,7700) and isinstance(x.get('raw'),int) and d.move:
                            if x['raw']<=lastv.get(x['param'],-1): stale+=1
                            lastv[x['param']]=x['raw']
                        for v in x.values(): st_(v)
                    elif isinstance(x,list):
                        for v in x: st_(v)
                st_(j)
        else: walk(json.loads(r['out']))
    except Exception as e: ers.add('JSON '+repr(e)[:60])
    line='%d %-4s %-5s %-8s %-7s N%d eq%d mv%d jit%s lp%s late%s cop %d tel %d rc %s took %.1f ok %d err %d %s stale %d %s'%(seed,fam,pr,verb,mode,N,equal,move,jit,lp,latep,st['ncop'],nq,r['rc'],r['took'],ok,err,sorted(ers),stale,('WRONG%s'%wrong) if wrong else '')
    if wrong or stale or r['rc'] not in(0,) or os.environ.get('KEEP'): open('out/cpy-%s-%d.txt'%('-'.join(sys.argv[4:]),seed),'w').write(line+'\n'+' '.join(a)+'\n'+r['out']+'\n'+r['err']+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    return line
if __name__=='__main__':
    s,n,w=int(sys.argv[1]),int(sys.argv[2]),int(sys.argv[3])
    with Pool(w,maxtasksperchild=10) as p:
        for x in p.imap_unordered(one,range(s,s+n)): print(x,flush=True)
