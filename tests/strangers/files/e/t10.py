from mat import *
import t6
from t6 import plant,two,P
rnd=random.Random(5); T=time.monotonic()+95; i=0
def mk(d,k,kind,p):
    def hook(kk,f):
        if kk!=k: return None
        if kind in('drop','lost','garble','dup'): return kind
        if kind=='late': return .25
        if kind=='late6': return .62
        if kind in('int','term','kill'): p().send_signal({'int':2,'term':15,'kill':9}[kind])
        if kind=='pow':
            d.off=True; threading.Timer(.4,lambda:(d.power(),setattr(d,'off',False))).start(); return 'drop'
        if kind=='fail': d.eefail=lambda p,ds: True
        if kind=='failone':
            n0=d.nw; d.eefail=lambda p,ds: d.nw<=n0+1
        if kind=='run': d.run=True
    return hook
K=['drop','lost','garble','late','late6','int','term','kill','pow','fail','failone','run']
st={'ok':0,'bad':0}
def rep(tag,c):
    st['bad' if c else 'ok']+=1; print(tag,'; '.join(c) or 'ok',flush=True)
while time.monotonic()<T:
    kind=K[i%len(K)]; mode=('undo','ram','atomic')[(i//len(K))%3]; i+=1
    dl=rnd.choice((0,.008))
    if mode in('undo','ram'):
        d=Drv(delay=dl); b=d.snap()
        if mode=='undo':
            r=load(d); m=d.snap(); d.reset(); k=rnd.randint(12,62); d.hook=mk(d,k,kind,lambda:d.proc)
            r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); tgt=b
        else:
            clean(); d.reset(); m=b; k=rnd.randint(12,62); d.hook=mk(d,k,kind,lambda:d.proc); r=run(d,'dataset','load',W+'/m.toml','--yes','--ram'); tgt=None
        if kind=='pow' : time.sleep(.5)
        a=d.snap(); c=[]; end=((r.j or {}).get('data') or {}).get('ended')
        rows={(v['param'],v['data_set']):v['result'] for v in (((r.j or {}).get('data') or {}).get('values') or [])}
        row=lambda q: rows.get((q[0],q[1]+1),rows.get((q[0],0)))
        if mode=='undo' and r.rc==0 and kind!='pow' and diffs(b,a): c.append('FALSE DONE %s'%diffs(b,a))
        if mode=='undo' and r.rc==0 and kind=='pow' and any(q[2]=='ee' for q in diffs(b,a)): c.append('FALSE DONE')
        if mode=='undo' and r.rc not in(0,-9):
            for q in diffs(b,a):
                if row(q) in('restored','unchanged'): c.append('differs though row %s: %s %s'%(row(q),q,diffs(b,a)[q]))
            if 'nothing' in (r.j or {}).get('error',{}).get('message','') and diffs(m,a) and kind!='pow': c.append('nothing changed? %s %s'%(r.j['error']['message'],diffs(m,a)))
        if mode=='ram':
            if d.wr: c.append('EEPROM WRITTEN %s'%d.wr)
            if r.rc==0: c+=['FALSE DONE %s'%(q,) for q in TG if a[q[0],q[1],'ram']!=TG[q]]
            elif end in('untouched','back') and diffs(b,a): c.append('FALSE %s %s'%(end,diffs(b,a)))
            elif r.rc!=-9: c+=['row %s for differing %s'%(row(q),q) for q in diffs(b,a) if row(q) not in('unrestored',)]
        if d.eqw: c.append('EQ %s'%d.eqw)
        if d.runw: c.append('RUN %s'%d.runw)
        if max(d.wr.values(),default=0)>1: c.append('WEAR %s'%{q:w for q,w in d.wr.items() if w>1})
        if r.rc in(70,101,-11,-6) or 'HANG' in r.e: c.append('CRASH/HANG')
        rep('%s %s@%d dl=%s rc=%s end=%s t=%.1f'%(mode,kind,k,dl,r.rc,end,r.t),c); d.stop=True
        if mode=='undo' and r.rc!=0:
            d.hook=None; d.run=False; d.eefail=lambda p,ds:False; d.reset(); d.stop=False
            d2=d; threading.Thread(target=d.loop,daemon=True).start(); r=run(d,'dataset','undo',W+'/m.undo.toml','--yes'); x={q:v for q,v in diffs(b,d.snap()).items() if q[2]=='ee'}
            rep('    second undo rc=%s'%r.rc,(['LEFT %s'%x] if x else [])+(['EQ %s'%d.eqw] if d.eqw else [])); d.stop=True
    else:
        a,b=two(); a.delay=b.delay=dl; plant(a); sa,sb=a.snap(),b.snap(); k=rnd.randint(12,55); x=rnd.choice((a,b)); x.hook=mk(x,k,kind,lambda:a.proc)
        r=run(a,'apply','--atomic','--yes',cwd=P,port=False)
        if kind=='pow': time.sleep(.5)
        da,db=diffs(sa,a.snap()),diffs(sb,b.snap()); c=[]
        dr=(((r.j or {}).get('data') or {}).get('drives')) or [{},{}]; e=[q.get('ended') for q in dr]
        for nm,df,q in(('fan',da,dr[0]),('pump',db,dr[1] if len(dr)>1 else {})):
            if r.rc==0 and len(df)!=18: c.append('FALSE DONE '+nm)
            if q.get('ended') in('back','untouched','skipped') and df and kind!='pow': c.append('FALSE %s %s %s'%(q.get('ended'),nm,df))
            if q.get('ended')=='done' and len(df)!=18: c.append('FALSE done '+nm)
            rows={(v['param'],v['data_set']):v['result'] for v in q.get('values',[])}
            if q.get('ended')=='torn': c+=['row %s for differing %s %s'%(rows.get((z[0],z[1]+1),rows.get((z[0],0))),nm,z) for z in df if rows.get((z[0],z[1]+1),rows.get((z[0],0))) !='unrestored']
        for q in(a,b):
            if q.eqw: c.append('EQ %s'%q.eqw)
            if q.runw: c.append('RUN %s'%q.runw)
            if max(q.wr.values(),default=0)>2: c.append('WEAR')
        rep('atomic %s@%d of %d dl=%s rc=%s %s t=%.1f fan %d pump %d'%(kind,k,x.addr,dl,r.rc,e,r.t,len(da),len(db)),c); a.stop=b.stop=True
print(st)
