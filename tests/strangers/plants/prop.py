import sys,os,random,subprocess,json,time,signal,shutil,threading

from drive import *
A=os.environ['ANTRIEB']
CAND=[372,375,376,418,419,424,425,434,480,481,482,483,485,486,487,488,518,519,549,600,601,602,603,604,632,637,638,400,392,405,406,475,412,30,381,382]
KINDS=['none','kill9','int','term','hup','int2','cut','cutfor','hangup','exc','excafter','refuse_ee','refuse_ram','garble','lostw','drop','power','power_w','other','other_then_cut','starts','late','keeps','clamp','notinforce','busy','double','int_other','cut_other']
def dec(n):
    return {375:2,418:2,419:2,424:2,425:2,480:2,481:2,482:2,483:2,485:2,486:2,487:2,488:2,518:2,519:2,549:2,600:1,603:1,604:2,632:1,637:1,638:1,376:1,382:1,450:2}.get(n,0)
def cells(n): return [(n,k) for k in ((1,2,3,4) if P[n][1] else (0,))]
def text(n,v):
    d=dec(n)
    if n==604: return 'raw %d'%v
    return ('%.*f'%(d,v/10**d)).replace('.',random.choice('.,')) if d else str(v)
def rv(n,cur):
    w,f,d,lo,hi=P[n]
    for _ in range(50):
        if n==30: v=random.choice((110,111,210,211,410,411))
        elif n==412: v=random.choice((0,1,2,3,4,44))
        else: v=random.randint(max(lo,-20000),min(hi,30000))
        if n==375: v=max(v,1001)
        if n==637: v=min(v,1000)
        if v!=cur: return v
    return cur
def run(seed,kind=None,verbose=False,timeout=150):
    R=random.Random(seed); random.seed(seed); 
    kind=kind or R.choice(KINDS)
    reading=R.choice(('eeprom','eeprom','in-force','refused'))
    dirn=os.environ['WD']+'/runs/%s'%seed; shutil.rmtree(dirn,ignore_errors=True); os.makedirs(dirn)
    d=Drive(1,reading); 
    ns=R.sample(CAND,R.randint(1,6))
    for n in P:
        if R.random()<.3 and n in CAND and n not in(30,412):
            for c in cells(n):
                if P[n][1] and (n in(372,375,376,480,481,482,412) ):
                    d.ee[c]=rv(n,None)
            if not P[n][1]: d.ee[n,0]=rv(n,None)
    d.ram=dict(d.ee)
    ramdiff=[]
    if R.random()<.25:
        n=R.choice(ns); c=R.choice(cells(n))
        if n not in (418,419,601,602,600,603,604,518,519,30): d.ram[c]=rv(n,d.ee[c]); ramdiff.append(c)
    want={}; lines=[]
    useram=R.random()<.15
    for n in ns:
        if P[n][1] and n in(372,375,376,480,481,482,412) and R.random()<.6:
            for k in R.sample((1,2,3,4),R.randint(1,3)):
                v=rv(n,d.ee[n,k]); want[n,k]=v; lines.append('"%d@%d" = "%s"'%(n,k,text(n,v)))
        else:
            v=rv(n,None); lines.append('"%d" = "%s"'%(n,text(n,v)))
            for c in cells(n): want[c]=v
    open(dirn+'/f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'+'\n'.join(lines)+'\n')
    ee0=dict(d.ee); ram0=dict(d.ram)
    at=R.randint(1,12+9*len(want)); awn=R.randint(1,max(1,len(want)))
    proc=[None]; touched={}; st={'fired':False}; notes=[]
    def sig(s_):
        b.dump.append("      SIGNAL %s"%s_)
        try: proc[0].send_signal(s_)
        except Exception: pass
    def other(d):
        b.dump.append('      SOMEBODY changes')
        c=R.choice(list(want)); v=rv(c[0],d.ee[c]); 
        if v in (want[c],ee0[c]): v=rv(c[0],v)
        how=R.choice(('both','both','ram','all'))
        for cc in (cells(c[0]) if how=='all' else [c]):
            if how!='ram': d.ee[cc]=v
            d.ram[cc]=v; touched[cc]=(how,v,d.n); b.dump.append('      SOMEBODY sets %s %s = %d'%(how,cc,v))
    garb=R.choice((1,2,3,5)); cutw=R.choice((True,False))
    target=R.choice(list(want))
    def wmode(n,k,ds):
        hit=(n==target[0])
        if not hit: return None
        if kind=='refuse_ee' : return 'refuse' if ds<5 else None
        if kind=='refuse_ram': return 'refuse-ram' if ds<5 else None
        if kind=='keeps': return 'keeps' if ds<5 else None
        if kind=='clamp': return 'clamp'
        if kind=='notinforce': return 'notinforce' if ds<5 else None
    d.wmode=wmode
    exccode=R.choice((1,2,3,4,5,6)); dur=R.choice((.5,1.5,3.0,6.0)); bothw=R.random()<.5
    def hook(b,d,t,w):
        if not st.get('armed'): return None
        trig=(d.wn==awn and w) if bothw else d.n-st['n0']==at
        if kind in('int','term','hup','kill9','int2') and trig and not st['fired']:
            st['fired']=True; when=R.choice(('before','after'))
            s_={'int':2,'int2':2,'term':15,'hup':1,'kill9':9}[kind]
            if kind=='int2':
                sig(2); threading.Timer(R.choice((.02,.1,.3)),lambda: sig(2)).start()
            elif when=='before':
                sig(s_); time.sleep(.01)
            else: threading.Timer(.002,lambda: sig(s_)).start()
        if kind in('int_other','cut_other','other_then_cut') and trig and not st['fired']:
            st['fired']=True; other(d)
            threading.Timer(R.choice((.03,.1)),lambda:(sig(2) if kind=='int_other' else setattr(b,'cut',True))).start()
            if kind=='cut_other': threading.Timer(dur,lambda:setattr(b,'cut',False)).start()
        if kind=='other' and trig and not st['fired']: st['fired']=True; other(d)
        if kind=='starts' and trig and not st['fired']: st['fired']=True; d.running=True
        if kind=='cut' and trig: 
            st['fired']=True
            if cutw: b.cut=True; return
            b.cut=True; d.handle(t)
        if kind=='cutfor' and trig and not st['fired']:
            st['fired']=True; d.off_until=time.time()+dur
            if R.random()<.5: d.handle(t)
        if kind=='hangup' and trig: st['fired']=True; d.handle(t); b.hangup(); return ('lost',)
        if kind=='power' and trig and not st['fired']: st['fired']=True; d.power(); d.off_until=time.time()+R.choice((0.0,.2,dur))
        if kind=='power_w' and w and d.wn==awn and not st['fired']: st['fired']=True; return ('power',R.choice((.05,.4,dur)))
        if kind=='exc' and w and d.wn==awn: st['fired']=True; return ('exc',exccode)
        if kind=='excafter' and w and d.wn==awn: st['fired']=True; d.handle(t); return ('exc',exccode)
        if kind=='busy' and R.random()<.2: return ('exc',R.choice((5,6)))
        if kind=='garble' and R.random()<garb/10: return ('garble',)
        if kind=='lostw' and w and R.random()<.5: return ('lost',)
        if kind=='drop' and R.random()<.2: return R.choice((('drop',),('lost',)))
        if kind=='late' and R.random()<.15: return ('late',R.choice((.05,.12,.18,.3,.5)))
        if kind=='double' and R.random()<.2: return ('double',R.choice((0,.002,.01,.05)))
        return None
    link='/tmp/n23a_%s'%seed
    b=Bus([d],link,hook); b.start()
    docd=bool(ramdiff) and reading!='eeprom'
    st['armed']=True; st['n0']=d.n
    base=[A,'-p',link,'-b','115200','-a','1','--timeout','150ms','--json','--no-config']
    cmd=base+['dataset','load','f.toml','--yes']+(['--ram'] if useram else [])
    t0=time.time()
    proc[0]=pr=subprocess.Popen(cmd,cwd=dirn,stdout=subprocess.PIPE,stderr=subprocess.PIPE,stdin=subprocess.DEVNULL,text=True)
    bad=[]
    try: out,err=pr.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        pr.kill(); out,err=pr.communicate(); bad.append('HANG')
    dt=time.time()-t0; rc=pr.returncode
    open(dirn+'/out.json','w').write(out); open(dirn+'/err.txt','w').write(err)
    ee1=dict(d.ee); ram1=dict(d.ram); eew=d.eew; wlog=list(d.log)
    data=None; ended=None; J=None
    if kind!='kill9' or out:
        try: J=json.loads(out)
        except Exception as e: 
            if kind!='kill9': bad.append('no JSON: %r'%out[:80])
    named=set(); ew=None
    if J:
        data=J.get('data') or {}
        if not data and J.get('error'): data=J['error'].get('data') or {}
        ended=data.get('ended'); ew=data.get('eeprom_writes')
        for r in data.get('values',[]):
            if r.get('result') not in ('verified','restored','not_written','as_before','equal','planned','unchanged'): 
                for c in (cells(r['param']) if r['data_set']==0 else [(r['param'],r['data_set'])]): named.add(c)
    results={r.get('result') for r in (data or {}).get('values',[])} if data else set()
    wtext=json.dumps((J or {}).get('warnings',[]))+json.dumps((J or {}).get('error'))
    def nm(c):
        return c in named or ('P.%d'%c[0]) in wtext
    fc=[c for n in ns for c in cells(n)]
    allc=list(ee0)
    files=sorted(os.listdir(dirn)); st['q']=4+2*len(want)+2
    undo='f.undo.toml' in files
    extra=[f for f in files if f not in('f.toml','f.undo.toml','out.json','err.txt')]
    if extra: bad.append('extra files %s'%extra)
    outside=[c for c in allc if c not in want and c not in touched and c[0] not in ns and (ee1[c]!=ee0[c] or (ram1[c]!=ram0[c] and not kind.startswith('power')))]
    if outside: bad.append('cells outside the file changed %s'%outside)
    mem=(lambda c:(ram1[c],ram0[c])) if useram else (lambda c:(ee1[c],ee0[c]))
    powered=kind.startswith('power') and st['fired']
    if kind!='kill9' and 'HANG' not in bad:
        if J and rc==0:
            if ended!='done': bad.append('rc 0, ended %s'%ended)
            for c,v in want.items():
                if not useram and ee1[c]!=v: bad.append('done but ee %s=%s want %s'%(c,ee1[c],v))
                if ram1[c]!=v and not (reading=='refused' and kind=='notinforce'): bad.append('done but ram %s=%s want %s'%(c,ram1[c],v))
        elif ended=='done': bad.append('ended done rc %s'%rc)
        elif ended in('untouched','back') or (ended is None):
            for c in allc:
                if c in touched: continue
                if ee1[c]!=ee0[c]: bad.append('%s but ee %s=%s was %s'%(ended,c,ee1[c],ee0[c]))
                if ram1[c]!=ram0[c] and not (powered and ram1[c]==ee1[c]):
                    (None if docd else bad.append)  and bad.append('%s but ram %s=%s was %s%s'%(ended,c,ram1[c],ram0[c],' NAMED' if nm(c) else ''))
            if ended in('untouched',None) and wlog: 
                if ended: bad.append('untouched but writes %s'%wlog)
            if ended=='untouched' and undo: bad.append('untouched but undo file stays')
        elif ended in('torn','stored'):
            for c in allc:
                if c in touched or nm(c): continue
                if ee1[c]!=ee0[c] and not(ended=='stored' and want.get(c)==ee1[c]): bad.append('%s: ee %s=%s was %s not named'%(ended,c,ee1[c],ee0[c]))
                if ram1[c]!=ram0[c] and not(ended=='stored' and want.get(c)==ram1[c]) and not (powered and ram1[c]==ee1[c]): bad.append('%s: ram %s=%s was %s not named'%(ended,c,ram1[c],ram0[c]))
            if rc!=9: bad.append('%s rc %s'%(ended,rc))
        else: bad.append('ended?? %s rc %s'%(ended,rc))
        # touched by others and overwritten?
        for c,(how,v,tn) in touched.items():
            if v in (want.get(c),ee0[c]): continue
            now=ram1[c] if how=='ram' else ee1[c]
            if now!=v and rc!=0: bad.append('other\'s value lost %s=%s he set %s (%s) ended %s%s'%(c,now,v,how,ended,' named' if nm(c) else ''))
        if ended in ('back','torn') and rc!=9: bad.append('%s rc %s'%(ended,rc))
        if ew is not None and eew>ew+(data.get('eeprom_writes_back') or 0): bad.append('eeprom writes %d > %s+%s'%(eew,ew,data.get('eeprom_writes_back')))
        if ended=='done' and ew is not None and eew>ew: bad.append('done with eeprom writes %d > %s'%(eew,ew))
    undores=None
    if undo and ended!='untouched':
        open(dirn+'/f.undo.copy','w').write(open(dirn+'/f.undo.toml').read())
        # healthy line again
        kind0=kind; st['armed']=False; d.off_until=0; b.cut=False; d.running=False; d.wmode=lambda n,k,ds:None
        if b.hung:
            time.sleep(.1); b=Bus([d],link,hook); b.start()
        u=subprocess.run(base+['dataset','undo','f.undo.toml','--yes'],cwd=dirn,capture_output=True,text=True,timeout=timeout,stdin=subprocess.DEVNULL)
        open(dirn+'/undo.json','w').write(u.stdout); open(dirn+'/undo.err','w').write(u.stderr)
        try: UJ=json.loads(u.stdout)
        except Exception: UJ={}; bad.append('undo no JSON')
        ud=UJ.get('data') or {}
        undores=(u.returncode,ud.get('ended'))
        unamed=set(); 
        for r in ud.get('values',[]):
            if r.get('result') not in ('verified','equal'):
                for c in (cells(r['param']) if r['data_set']==0 else [(r['param'],r['data_set'])]): unamed.add(c)
        ut=json.dumps(UJ.get('warnings'))+json.dumps(UJ.get('error'))
        for c in want:
            n_=c in unamed or 'P.%d'%c[0] in ut
            if not useram:
                if d.ee[c]!=ee0[c] and c not in touched and not n_: bad.append('after undo ee %s=%s was %s unnamed rc %s'%(c,d.ee[c],ee0[c],u.returncode))
                if d.ee[c]!=ee0[c] and u.returncode==0 and not docd and not(c in touched and touched[c][2]<st['q']): bad.append('undo rc 0 but ee %s=%s was %s%s'%(c,d.ee[c],ee0[c],' touched' if c in touched else ''))
                if d.ram[c]!=ee0[c] and u.returncode==0 and reading=='eeprom' and not(c in touched and touched[c][2]<st['q']): bad.append('undo rc 0 but ram %s=%s ee0 %s ram0 %s reading %s'%(c,d.ram[c],ee0[c],ram0[c],reading))
            else:
                if d.ram[c]!=ram0[c] and not n_ and c not in touched: bad.append('after ram undo ram %s=%s was %s unnamed rc %s'%(c,d.ram[c],ram0[c],u.returncode))
                if d.ram[c]!=ram0[c] and u.returncode==0: bad.append('ram undo rc 0 but ram %s=%s was %s'%(c,d.ram[c],ram0[c]))
        for c,(how,v,tn) in touched.items():
            now=d.ram[c] if how=='ram' else d.ee[c]
            was=ram1[c] if how=='ram' else ee1[c]
            if was==v and now!=v and how!='ram' and v not in (want.get(c),ee0[c]): bad.append('undo took other\'s %s=%s away (%s) now %s, rc %s%s'%(c,v,how,now,u.returncode,' named' if c in unamed else ''))
    b.stop=True; b.join(); open(dirn+'/tele.txt','w').write('\n'.join(b.dump))
    try: os.unlink(link)
    except OSError: pass
    rec=dict(seed=seed,kind=kind,reading=reading,useram=useram,rc=rc,ended=ended,undo=undores,dt=round(dt,2),at=at,awn=awn,bothw=bothw,fired=st['fired'],n=len(want),ramdiff=[str(c) for c in ramdiff],touched={str(k):v for k,v in touched.items()},eew=eew,ew=ew,results=sorted(map(str,results)),code=((J or {}).get('error') or {}).get('code'),bad=bad)
    return rec
if __name__=='__main__':
    a,bb,mod,k=int(sys.argv[1]),int(sys.argv[2]),int(sys.argv[3]),int(sys.argv[4]); kinds=sys.argv[5:] 
    f=open(os.environ['WD']+'/prop.%d.%d.ndjson'%(a,k),'a')
    end=float(os.environ.get('UNTIL','1e18'))
    for s in range(a,bb):
        if s%mod!=k: continue
        if time.time()>end: break
        try: r=run(s,kinds[s%len(kinds)] if kinds else None)
        except Exception as e:
            import traceback; r=dict(seed=s,bad=['HARNESS '+traceback.format_exc()])
        f.write(json.dumps(r)+'\n'); f.flush()
        if r['bad'] : print(json.dumps(r)); sys.stdout.flush()
