# at.py NAME[,NAME..] [SEED] : own attacks (cd /tmp/judge/foreign && ANTRIEB=/tmp/b/antrieb python3 ../new/at.py bcast,echo,closed,sig,creep,rev,lagto,power,contacts,fault,stopcont)
import sys,os; sys.path.insert(0,os.getcwd())
from vb import *
import h4s
R=random.Random(int(sys.argv[2]) if len(sys.argv)>2 else 1)
L_=lambda: LXM(3); A_=lambda: ACU(1,set={418:0})
def rn(d): (h4s.runsl if isinstance(d,LXM) else h4s.runsa)(d); return d
V={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0'],'dv':['statemachine','disable-voltage']}
def state(d): return '%s n%.1f'%(d.st,d.n)
def rep(name,rc,took,out,err,ds,extra='',bad=''):
    cap='STILL TURN' in out+err; first=(err.strip().splitlines() or ['-'])[0][:110]
    print('%-40s rc %s took %.2f %s cap %d first[%s] %s %s'%(name,rc,took,[state(d) for d in ds],cap,first,extra,bad),flush=True)
    open('out/at-%s.txt'%name.replace(' ','_').replace('/','-'),'w').write('%s\n%s\n%s\n'%(name,out,err))
def pop(ln,args,**k):
    return subprocess.Popen([BIN,'-p',ln.path,'--no-config']+args+['--yes'],stdin=subprocess.DEVNULL,**k)
def sp(d): return ['sollwert','300rpm','--enable','--hold'] if isinstance(d,LXM) else ['sollwert','5Hz','--take-control','--enable','--hold']
def bcast():
    for fam,mk in(('lx',L_),('rtu',A_)):
        for k,v in V.items():
            d=rn(mk()); ln=Line([d]); r=run(ln,['-a','0']+v,d,verbose=False); ln.close()
            rep('bcast %s %s'%(fam,k),r['rc'],r['took'],r['out'],r['err'],[d],bad='**' if r['rc']==0 and (d.n or d.st=='OE') else '')
def echo():
    class EL(Line):
        def cut_in(s,t,b): os.write(s.m,b); s.log.append((t,'e',b)); return s.dead
    for fam,mk in(('lx',L_),('rtu',A_)):
        for k,v in V.items():
            for dead in(True,False):
                d=rn(mk()); ln=EL([d]); ln.dead=dead; r=run(ln,['-a',str(d.adr)]+(['--drive','lxm05' if fam=='lx' else 'acu'] if R.random()<.5 else [])+v,d,verbose=False); ln.close()
                rep('echo %s %s dead%d'%(fam,k,dead),r['rc'],r['took'],r['out'],r['err'],[d],bad='**' if (r['rc']==0 or 'STILL TURN' not in r['err']) and (d.n or d.st=='OE') else '')
def closed():
    for fam,mk in(('lx',L_),('rtu',A_)):
        for how in('out','err','both','outfull','errfull'):
            for v in ('hold','disable','zero'):
                d=mk(); 
                if v!='hold': rn(d)
                ln=Line([d]); full=open('/dev/full','w')
                o=full if how in('outfull',) else subprocess.PIPE; e=full if how=='errfull' else subprocess.PIPE
                a=['-v','-a',str(d.adr)]+(sp(d)+['--duration','1s'] if v=='hold' else V[v])
                t0=time.time(); p=pop(ln,a,stdout=o,stderr=e)
                if how in('out','both'): p.stdout.close()
                if how in('err','both'): p.stderr.close()
                mx=0
                while p.poll() is None and time.time()-t0<30: time.sleep(.01); mx=max(mx,abs(d.n))
                t1=time.time(); rc=p.poll(); 
                if rc is None: p.kill(); rc='HANG'
                er=p.stderr.read().decode() if e==subprocess.PIPE and not p.stderr.closed else ''
                st=state(d); time.sleep(.3); ln.close()
                rep('closed %s %s %s'%(fam,how,v),rc,t1-t0,'',er,[d],'max %.0f'%mx,'**' if d.n or d.st=='OE' else '')
def sig():
    for fam,mk in(('lx',L_),('rtu',A_)):
        for s in(signal.SIGHUP,signal.SIGQUIT,signal.SIGTERM,signal.SIGPIPE,signal.SIGUSR1,signal.SIGALRM,signal.SIGTSTP):
            d=mk(); ln=Line([d]); t0=time.time(); p=pop(ln,['-a',str(d.adr)]+sp(d)+['--duration','2s'],stdout=subprocess.PIPE,stderr=subprocess.PIPE)
            while abs(d.n)<2 and p.poll() is None and time.time()-t0<10: time.sleep(.01)
            time.sleep(.3); p.send_signal(s); ts=time.time()
            if s==signal.SIGTSTP: time.sleep(1); print('tstp: n',d.n,d.st); p.send_signal(signal.SIGCONT)
            try: o,e=p.communicate(timeout=20); rc=p.returncode
            except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); rc='HANG'
            t1=time.time(); time.sleep(.2); ln.close()
            rep('sig %s %s'%(fam,s.name),rc,t1-t0,o.decode(),e.decode(),[d],'after signal %.2f'%(t1-ts),'**' if d.n or d.st=='OE' else '')
def sigstop():
    # signals in a group stop
    for fam,cls in(('lx',LXM),('rtu',ACU)):
        for k,v in V.items():
            ds=[rn(cls(i)) for i in(1,2,3)]; s=R.choice([signal.SIGHUP,signal.SIGTERM,signal.SIGINT]); w=R.uniform(0.02,.6)
            ln=Line(ds); t0=time.time(); p=pop(ln,['-a','1-3']+v,stdout=subprocess.PIPE,stderr=subprocess.PIPE); time.sleep(w); p.send_signal(s)
            try: o,e=p.communicate(timeout=60); rc=p.returncode
            except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); rc='HANG'
            t1=time.time(); st=[(abs(d.n)>0 and k!='dv') or (d.st=='OE' and k!='zero') for d in ds]; ln.close()
            cap=b'STILL TURN' in e
            rep('sigstop %s %s %s %.2f'%(fam,k,s.name,w),rc,t1-t0,o.decode(),e.decode(),ds,str(st),'**' if any(st) and not cap else '')
def creep():
    # somebody else's slow demand: a shaft that creeps; does sollwert 0 call it reached, disable: stands
    for fam,mk,xs in(('lx',L_,(0.3,1,2,5)),('rtu',A_,(.05,.1,.3))):
        for x in xs:
            d=rn(mk()); L=isinstance(d,LXM)
            # offset in the drive: zero setpoint yields x
            old=d.demand if L else d.dem
            f=lambda old=old,x=x: (x if abs(old())<1e-9 and d.st=='OE' else old())
            if L: d.demand=f
            else: d.dem=f
            ln=Line([d]); r=run(ln,['-a',str(d.adr)]+V['zero'],d,verbose=True); ln.close()
            rep('creep %s %s'%(fam,x),r['rc'],r['took'],r['out'],r['err'],[d],bad='**' if r['rc']==0 and abs(d.n)>1e-6 else '')
def rev():
    # at the moment of sollwert 0 the shaft is driven through zero by another master's negative setpoint, slowly
    for fam,mk in(('lx',L_),('rtu',A_)):
        for dt in(.0,.3,.6,.9):
            d=rn(mk()); L=isinstance(d,LXM)
            if L: d.p[1558]=750; d.n=600; d.p[6938]=600
            def ev(dd,t): return bool(dd.wr) and abs(dd.n)<(200 if L else 2)-dt*(150 if L else 1.5)
            def go(dd,t):
                if L: dd.p[6938]=-300&0xffffffff
                else: dd.ram[484,0]=-600&0xffffffff; 
            d.events=[(ev,go)]; ln=Line([d]); r=run(ln,['-a',str(d.adr)]+V['zero'],d,verbose=True); t1=r['t1']; ln.close()
            rep('rev %s %.1f'%(fam,dt),r['rc'],r['took'],r['out'],r['err'],[d],'nend %.1f'%r['nend'],bad='**' if r['rc']==0 and abs(r['nend'])>1e-6 else '')
def lagto():
    # drive answers later than --timeout: every reply arrives behind a later question
    from cpy import VAL
    for to,lag,re in((50,.06,2),(50,.09,0),(50,.12,2),(100,.13,1),(30,.05,0),(100,.21,2),(50,.055,6)):
        for jit in(0,.03):
            d=VAL(1); d.setup('acu')
            ln=Line([d],lambda i,t,q,r,dd:[(lag+R.uniform(0,jit),r)])
            P=[p for p in d.val if p in d.w and not d.move][:60]; P=R.sample(P,12)
            r=run(ln,['-a','1','--drive','acu','--timeout','%dms'%to,'--retries',str(re),'read']+[str(p) for p in P]+['--json'],None,extra=(),verbose=False); ln.close()
            bad=[];ok=0
            def walk(x):
                nonlocal ok
                if isinstance(x,dict):
                    if isinstance(x.get('raw'),int) and 'param' in x:
                        e=d.expect(x['param'],x.get('data_set') or 0)
                        if e is not None:
                            if e==x['raw']: ok+=1
                            else: bad.append((x['param'],x['raw'],e))
                    for v in x.values(): walk(v)
                elif isinstance(x,list):
                    for v in x: walk(v)
            try: import json; walk(json.loads(r['out']))
            except Exception as e: pass
            rep('lagto %d %.3f re%d jit%.2f'%(to,lag,re,jit),r['rc'],r['took'],r['out'],r['err'],[d],'ok %d wrong %s'%(ok,bad),'**' if bad else '')
def lagstop():
    for fam,cls in(('lx',LXM),('rtu',ACU)):
        for k,v in V.items():
            to,lag,re=R.choice([(50,.06,2),(50,.09,1),(100,.13,1),(100,.21,2),(50,.055,6)])
            d=rn(cls(3 if fam=='lx' else 1)); ln=Line([d],lambda i,t,q,r,dd:[(lag,r)])
            r=run(ln,['-a',str(d.adr),'--timeout','%dms'%to,'--retries',str(re)]+v,d,verbose=True); t1=r['t1']
            b=(abs(r['nend'])>0 and k!='dv') or (d.st=='OE' and k!='zero'); ln.close()
            rep('lagstop %s %s %d %.3f re%d'%(fam,k,to,lag,re),r['rc'],r['took'],r['out'],r['err'],[d],bad='**' if b and (r['rc']==0 or 'STILL TURN' not in r['err']) else '')
def power():
    # drive loses its supply while slowing, in a group; comes back after x
    for fam,cls in(('lx',LXM),('rtu',ACU)):
        for k,v in V.items():
            off=R.choice([.3,1,3,99]); ds=[rn(cls(i)) for i in(1,2)]
            if fam=='lx': ds[0].n=1500
            else: ds[0].n=30
            ds[0].events=[(lambda d,t: bool(d.wr),lambda d,t:d.reboot(t,off))]
            ln=Line(ds); r=run(ln,['-a','1,2']+v,ds[0],verbose=True); 
            b=any(abs([m for t,m in d.hist if t<=r['t1']][-1])>1e-6 for d in ds) and k!='dv'; ln.close()
            rep('power %s %s %.1f'%(fam,k,off),r['rc'],r['took'],r['out'],r['err'],ds,'nend %.1f'%r['nend'],'**' if b and (r['rc']==0 or 'STILL TURN' not in r['err']) else '')
def contacts():
    # ACU driven by its contacts (P.412 != 1), the line has no say
    for k,v in V.items():
        d=ACU(1,contact_start=True,internal=20,set={412:44,418:0,434:1}); d.st='OE'; d.n=20
        ln=Line([d]); time.sleep(.1); r=run(ln,['-a','1']+v,d,verbose=True); ln.close()
        rep('contacts %s'%k,r['rc'],r['took'],r['out'],r['err'],[d],'nend %.1f'%r['nend'],'**' if abs(r['nend'])>0 and (r['rc']==0 or 'STILL TURN' not in r['err']) else '')
def fault():
    for fam,cls in(('lx',LXM),('rtu',ACU)):
        for k,v in V.items():
            d=rn(cls(3 if fam=='lx' else 1)); 
            if fam=='lx': d.n=1500
            else: d.n=30
            w=R.uniform(.05,.4)
            d.events=[(ev_after(lambda d,t:bool(d.wr),w),lambda d,t:d.trip(t))]
            ln=Line([d]); r=run(ln,['-a',str(d.adr)]+v,d,verbose=True); ln.close()
            rep('fault %s %s %.2f'%(fam,k,w),r['rc'],r['took'],r['out'],r['err'],[d],'nend %.1f'%r['nend'],'**' if abs(r['nend'])>0 and k!='dv' and (r['rc']==0 or 'STILL TURN' not in r['err']) else '')
def stopcont():
    # the program is frozen (SIGSTOP) in a stop, behind the proof, someone enables, then goes on
    for fam,cls in(('lx',LXM),('rtu',ACU)):
        for k in('disable','qs','zero'):
            for w in(.05,.15,.3):
                d=rn(cls(3 if fam=='lx' else 1)); L=fam=='lx'; ln=Line([d]); t0=time.time(); p=pop(ln,['-v','-a',str(d.adr)]+V[k],stdout=subprocess.PIPE,stderr=subprocess.PIPE)
                while not(d.wr and d.n==0) and p.poll() is None and time.time()-t0<10: time.sleep(.005)
                time.sleep(w*.4); 
                if p.poll() is not None: print('over'); p.communicate(); ln.close(); continue
                p.send_signal(signal.SIGSTOP); time.sleep(.2)
                t=time.time()
                if L: d.mode=3; d.p[6918]=3; d.p[6938]=500; d.control(6,t); d.control(15,t)
                else:
                    for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
                    d.ram[484,0]=3000; d.ctl(0,t); d.ctl(6,t); d.ctl(15,t)
                time.sleep(1); p.send_signal(signal.SIGCONT); tc=time.time()
                try: o,e=p.communicate(timeout=40); rc=p.returncode
                except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); rc='HANG'
                t1=time.time(); nn=d.n; ln.close(); b=abs(nn)>1e-6 or (d.st=='OE' and k!='zero')
                rep('stopcont %s %s %.2f'%(fam,k,w),rc,t1-t0,o.decode(),e.decode(),[d],'cont->end %.2f n %.1f'%(t1-tc,nn),'**' if b and (rc==0 or b'STILL TURN' not in e) else '')
if __name__=='__main__':
    for n in sys.argv[1].split(','):
        try: globals()[n]()
        except Exception as ex:
            import traceback; print('ERR',n,traceback.format_exc()[-600:],flush=True)
