from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
def f(n,t): open(W+'/'+n,'w').write(H+t)
clean()
d=Drive(); b0=d.snap()
L=lambda *a: run(['dataset',*a,'--timeout','150ms'],d)
UN=lambda *a: L('undo','m.undo.toml','--yes',*a)
def ld(): clean(); d.P=table(); d.run=False; d.clr(); r=L('load','m.toml','--yes'); assert r.rc==0,r.err; b=d.snap(); d.clr(); return b
ld(); r=UN(); print('undo1',d.snap()==b0,d.nw,s(r)); d.clr(); r=UN(); print('undo2',d.snap()==b0,'writes',d.nw,s(r))
ld(); d.set(480,2,4321); d.set(549,0,1); r=UN(); print('changed drive',d.P[480]['ee'],d.P[549]['ee'],d.nw,s(r)); print(r.err[-600:]); r=UN('--force'); print('force',d.snap()==b0,s(r))
ld(); d.set(480,3,4321); r=UN(); print('other set changed',d.P[480]['ee'],s(r))
ld(); d.set(419,2,4321); r=UN(); print('419 one set changed (not-set param?)',d.P[419]['ee'],s(r))
ld(); d.run=True; r=UN(); print('running',d.nw,s(r)); r=UN('--force'); print('running force',d.nw,s(r)); 
ld(); d.addr=2; r=UN(); print('addr 2',d.nw,s(r)); r=UN('--force'); print('addr 2 force',d.nw,s(r)); d.addr=1
ld(); d.hook=lambda d,n,b:('exc',4,6) if b[1] in(6,101) and b[2:4]==bytes.fromhex('21e0') else None; r=UN(); print('refuse 480 in undo',d.nw,s(r)); d.hook=None; r=UN(); print(' again',d.snap()==b0,s(r))
ld(); d.hook=lambda d,n,b:('exc',2,11) if b[1] in(3,100) and b[2:4]==bytes.fromhex('21e0') else None; r=UN(); print('unreadable 480 in undo',d.nw,d.P[480]['ee'],s(r)); d.hook=None
# signals / kills mid-undo, all telegrams
ld(); UN(); N=d.n; bad=0; c={}
for sg in(signal.SIGINT,signal.SIGKILL):
    for k in range(3,N+1,2):
        ld(); d.hook=lambda d,n,b:(os.kill(CUR[0].pid,sg),time.sleep(0.03))[0] if n==k else None
        r=UN(); d.hook=None; w=d.cnt(); w1=max(w.values() or [0]) if w else 0
        dif={n:(x,b0[n]) for n,x in d.snap().items() if x!=b0[n]}
        en=((r.j or {}).get('data') or {}).get('ended'); c[(sg.name,r.rc,en)]=c.get((sg.name,r.rc,en),0)+1
        nm=named(r.j)
        if sg==signal.SIGINT and dif:
            un=[n for n in dif if not any(x[0]==n for x in nm)]
            if un and en is not None and en!='untouched': print('undo INT at',k,'unnamed',un,s(r)); bad+=1
        if r.rc==0 and dif: print('FALSE DONE',k,dif)
        r2=UN(); 
        if d.snap()!=b0 or r2.rc: print('second undo',sg.name,k,s(r2)); bad+=1
        w=d.cnt()
        if any(v>2 for v in w.values()): print('wear',k,w)
        if any(x[4] for x in d.wlog): print('equal',k,[x for x in d.wlog if x[4]])
print('mid-undo',c,'bad',bad)
print('--- --ram undo')
clean(); d.P=table(); r=L('load','m.toml','--yes','--ram'); print(s(r)); q=d.snap(); d.power(); d.clr(); r=UN(); print('after power loss: undo',d.nw,d.snap()==b0,s(r))
clean(); d.P=table(); d.set(480,2,999,ee=False); bb=d.snap(); r=L('load','m.toml','--yes','--ram'); d.clr(); r=UN(); print('ram base differing',d.snap()==bb,d.nw,d.cnt(),s(r))
clean(); d.P=table(); d.set(480,2,999,ee=False); bb=d.snap(); r=L('load','m.toml','--yes'); d.clr(); r=UN(); print('ee load w/ ram differing: undo',d.P[480],d.nw,s(r))
d.stop()
