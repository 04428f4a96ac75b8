from mat import *
from t3 import ask
P=HERE+'/p'
def plant(d,extra='',files=('m.toml','m.toml'),names=('fan','pump')):
    shutil.rmtree(P,ignore_errors=True); os.makedirs(P); shutil.copy(W+'/m.toml',P+'/m.toml')
    open(P+'/antrieb.toml','w').write('[ports.left]\npath = "%s"\nprotocol = "rtu"\nbaud = 19200\nparity = "even"\n'%d.tty+''.join('[drives.%s]\nport = "left"\naddress = %d\ndrive = "act"\nfiles = ["%s"]\n'%(n,i+1,f) for i,(n,f) in enumerate(zip(names,files)))+'[groups]\nall2 = ["fan", "pump"]\n'*(names==('fan','pump'))+extra)
def two(**k):
    b=Drv(addr=2); a=Drv(addr=1,others=[b],**k); return a,b
def R(d,*a,**k): return run(d,*a,cwd=P,port=False,**k)
def summ(r):
    j=(r.j or {}).get('data') or {}
    dr=j.get('drives') or []
    return [(x.get('name'),x.get('address'),x.get('ended') or x.get('result') or x.get('state'),[(v['param'],v['data_set'],v['result']) for v in x.get('values') or [] if v['result'] not in('verified','restored')]) for x in dr]
def chk(tag,a,b,ba,bb,r,want=None):
    print('=== %s rc=%s t=%.1f a:%d diffs b:%d diffs wr a<=%d b<=%d eqw %s %s runw %s %s'%(tag,r.rc,r.t,len(diffs(ba,a.snap())),len(diffs(bb,b.snap())),max(a.wr.values(),default=0),max(b.wr.values(),default=0),a.eqw,b.eqw,a.runw,b.runw)); print('   ',summ(r),(r.j or {}).get('error'),[w['message'][:150] for w in (r.j or {}).get('warnings',[])]); print('    files',sorted(os.listdir(P))); sys.stdout.flush()
def go(tag,args,pre=lambda a,b:None,hooka=None,hookb=None,keep=False,**k):
    a,b=two(); plant(a); pre(a,b); ba,bb=a.snap(),b.snap(); a.reset(); b.reset(); a.proc=None
    if hooka: a.hook=lambda kk,f: hooka(a,b,kk,f)
    if hookb: b.hook=lambda kk,f: hookb(a,b,kk,f)
    r=R(a,*args,**k); chk(tag,a,b,ba,bb,r)
    return a,b,ba,bb,r
if __name__=='__main__':
    a,b=two(); shutil.rmtree(P,ignore_errors=True); os.makedirs(P)
    r=run(a,'-p',a.tty,'init','--within','6s',cwd=P,port=False,json_=False); print('init',r.rc,r.t,r.e[-300:],r.o[-400:]); print(open(P+'/antrieb.toml').read() if os.path.exists(P+'/antrieb.toml') else None)
    r=run(a,'plan',cwd=P,port=False,json_=False); print('plan on bare init',r.rc,r.o,r.e)
    plant(a); ba,bb=a.snap(),b.snap()
    r=run(a,'plan',cwd=P,port=False,json_=False); print('plan',r.rc,r.o,r.e)
    r=R(a,'apply','--yes'); chk('apply',a,b,ba,bb,r); print(r.e[-1500:]); json.dump(r.j,open(HERE+'/apply.json','w'),indent=1)
    for v in('plan','check'): r=R(a,v); print(v,r.rc,summ(r))
    b.set(480,2,777); 
    for v in('plan','check'): r=R(a,v); print(v,'drift',r.rc,summ(r))
    b.set(480,2,-1250,ram=False)
    for v in('plan','check'): r=R(a,v); print(v,'RAM drift',r.rc,summ(r),[w['message'] for w in (r.j or {}).get('warnings',[])])
    f=lambda a,b: setattr(b,'eefail',lambda p,ds:p==480)
    go('b refuses 480',['apply','--yes'],f); go('b refuses 480 atomic',['apply','--yes','--atomic'],f)
    f=lambda a,b: setattr(b,'run',True)
    go('b runs',['apply','--yes'],f); go('b runs atomic',['apply','--yes','--atomic'],f)
    def h(a,b,kk,fr):
        if fr[1] in(6,101) and not b.run: b.run=True
    go('b starts at a\'s first write',['apply','--yes'],hooka=h); go('b starts at a\'s first write atomic',['apply','--yes','--atomic'],hooka=h)
    # a changed by somebody after it is done, while b writes; then b fails: atomic
    st={}
    def hb(a,b,kk,fr):
        if fr[1] in(6,101) and not st.get('x'): st['x']=1; a.set(480,2,1234); b.eefail=lambda p,ds:True
    st.clear(); x=go('atomic: a.480@2 changed to 12.34 after done, b fails',['apply','--yes','--atomic'],hookb=hb); print('    a.480@2 now',x[0].ee[480],x[0].ram[480]); print(x[4].e[-600:])
    st.clear(); x=go('a.480@2 changed to 12.34 after done, b fails, not atomic',['apply','--yes'],hookb=hb); print('    a.480@2 now',x[0].ee[480],x[0].ram[480]); print(x[4].e[-400:])
    # b changed at a's first write (between plan and b's turn)
    def hc(a,b,kk,fr):
        if fr[1] in(6,101) and not st.get('y'): st['y']=1; b.set(480,2,1234)
    st.clear(); x=go('b.480@2 changed to 12.34 while a is written',['apply','--yes'],hooka=hc); print('    b.480@2 now',x[1].ee[480],x[1].ram[480]); print(x[4].e[-400:])
    # signals
    for sig in(2,15):
        for at in(True,False):
            for k in(2,5):
                cnt={'n':0}
                def hs(a,b,kk,fr,cnt=cnt,k=k,sig=sig):
                    if fr[1] in(6,101):
                        cnt['n']+=1
                        if cnt['n']==k: a.proc.send_signal(sig)
                go('sig %d at b write %d atomic=%s'%(sig,k,at),['apply','--yes']+['--atomic']*at,hookb=hs)
    cnt={'n':0}
    def hk(a,b,kk,fr):
        if fr[1] in(6,101):
            cnt['n']+=1
            if cnt['n']==3: a.proc.kill()
    a,b,ba,bb,r=go('kill at b write 3',['apply','--yes'],hookb=hk); a.hook=b.hook=None
    for n in('fan','pump'): 
        r=R(a,'-a',n,'dataset','undo',n+'.undo.toml','--yes'); print('  undo',n,r.rc,r.e[-200:] if r.rc else '')
    print('  left',diffs(ba,a.snap()),diffs(bb,b.snap()))
    r=R(a,'-a','pump','dataset','undo','fan.undo.toml','--yes'); print('wrong undo file',r.rc,(r.j or {}).get('error'))
