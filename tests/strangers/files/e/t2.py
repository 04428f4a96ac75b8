from mat import *
rnd=random.Random(int(sys.argv[1])); T=time.monotonic()+float(sys.argv[2]); kinds=sys.argv[3].split(',')
cnt={}
i=0
while time.monotonic()<T:
    kind=kinds[i%len(kinds)]; i+=1
    k=rnd.randint(10,70); dl=rnd.choice((0,.008)); ramd=rnd.random()<.4
    d=Drv(delay=dl, unknown=rnd.choice((2,4)))
    if ramd: d.set(419,3,4321,ee=False); d.set(480,2,777,ee=False)
    b=d.snap(); foreign={}
    def hook(kk,f,d=d,k=k,kind=kind):
        if kk!=k: return None
        if kind in('drop','lost','garble','dup'): return kind
        if kind=='late': return .25
        if kind=='late6': return .62
        if kind=='late9': return .95
        if kind=='kill': d.proc.kill(); return None
        if kind=='int': d.proc.send_signal(2); return None
        if kind=='term': d.proc.send_signal(15); return None
        if kind=='intint':
            d.proc.send_signal(2); threading.Timer(.08,lambda:d.proc.send_signal(2)).start(); return None
        if kind=='hup': d.proc.send_signal(1); return None
        if kind in('pow','powlong'):
            d.off=True
            def on(): d.power(); d.off=False
            threading.Timer(.4 if kind=='pow' else 6,on).start(); return 'drop'
        if kind=='change':   # somebody at the keypad changes P.482@1 (not in file)... and 480@2
            d.set(480,2,1234); foreign.update({(480,1,'ee'):1234,(480,1,'ram'):1234}); return None
        if kind=='fail': d.eefail=lambda p,ds: True; return None
    d.hook=hook; r=load(d,'--undo-file',W+'/m.undo.toml',timeout=120)
    reached=d.n>=k
    if kind in('pow','powlong') and d.off: time.sleep(6)
    a=d.snap()
    tag='%s@%d dl=%s ramd=%d reached=%d'%(kind,k,dl,ramd,reached)
    if kind in('kill',) and r.rc==-9:
        pass
        line='%s killed nw=%d wr=%s'%(tag,d.nw,max(d.wr.values(),default=0)); print(line); OUT.write(line+'\n')
    elif kind in('pow','powlong'):
        # RAM is lost by the drive itself
        c=judge(tag,d,{**b,**({} if not reached else {kk:a[kk] for kk in b if kk[2]=='ram' and a[kk]!=b[kk] and a[kk]==a[kk[0],kk[1],'ee'] and b[kk[0],kk[1],'ee']==a[kk]})},a,r)
    else: judge(tag,d,b,a,r,foreign=foreign)
    # undo afterwards
    uf=W+'/m.undo.toml'
    if os.path.exists(uf) and r.rc!=0 or kind=='kill' and os.path.exists(uf):
        d.hook=None; d.eefail=lambda p,ds:False; n1=dict(d.wr); d.reset(); r2=run(d,'dataset','undo',uf,'--yes')
        a2=d.snap(); c=[]
        for kk,(o,x) in diffs(b,a2).items():
            if kk in foreign: continue
            if kk[2]=='ee' or not ramd: c.append('UNDO LEFT %s %s->%s'%(kk,o,x))
        for kk,v in foreign.items():
            if reached and a2[kk]!=v and a[kk]==v: c.append('UNDO OVERWROTE %s %s->%s'%(kk,v,a2[kk]))
        if d.eqw: c.append('UNDO EQUAL WRITES %s'%d.eqw)
        if max(d.wr.values(),default=0)>1: c.append('UNDO WEAR %s'%d.wr)
        if r2.rc!=0 and not foreign: c.append('undo rc %s %s'%(r2.rc,r2.e[-300:]))
        line='    undo rc=%s end=%s %s'%(r2.rc,((r2.j or {}).get('data') or {}).get('ended'),'; '.join(c) or 'ok'); print(line,flush=True); OUT.write(line+'\n'); OUT.flush()
    d.stop=True
