import sys,os,random,subprocess,json,time,shutil,threading

from drive import *
import prop
A=prop.A; cells=prop.cells
def run(seed,kind=None,atomic=None,timeout=200,np_=3,nd=4):
    R=random.Random(seed); random.seed(seed)
    kind=kind or R.choice(['none','off','swap','exc','excall','int','term','int2','kill9','cut','cutfor','hangup','runs','power','late','other','refuse_ram','starts','offlate'])
    atomic=R.random()<.5 if atomic is None else atomic
    dirn=os.environ['WD']+'/pruns/%s'%seed; shutil.rmtree(dirn,ignore_errors=True); os.makedirs(dirn)
    st={'fired':False,'armed':True}; buses=[]; proc=[None]; drives={}
    toml='timeout = "150ms"\n'; allw=0
    for b in range(np_):
        ds=[]
        for a in range(1,nd+1):
            d=Drive(a,R.choice(('eeprom','eeprom','refused'))); d.name='p%dd%d'%(b,a); ds.append(d); drives[d.name]=d; d.bus=b
            ns=R.sample(prop.CAND,R.randint(1,3)); d.want={}; L=[]
            for n in ns:
                v=prop.rv(n,None); L.append('"%d" = "%s"'%(n,prop.text(n,v)))
                for c in cells(n): d.want[c]=v
            if R.random()<.1:
                for c,v in d.want.items(): d.ee[c]=v; d.ram[c]=v
            open(dirn+'/%s.toml'%d.name,'w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'+'\n'.join(L)+'\n')
            toml+='[drives.%s]\nport = "P%d"\naddress = %d\ndrive = "acu"\nfiles = ["%s.toml"]\n'%(d.name,b,a,d.name)
        link='/tmp/n23p_%s_%d'%(seed,b); buses.append((ds,link))
        toml+='[ports.P%d]\npath = "%s"\nbaud = 115200\nprotocol = "rtu"\n'%(b,link)
    toml+='[groups]\nwater = ["p0d1","p1d2","p2d4"]\n'
    open(dirn+'/antrieb.toml','w').write(toml)
    victim=R.choice(list(drives.values())); at=R.randint(1,70); wn=R.randint(1,6); dur=R.choice((.5,2,6)); late=R.random()
    if kind=='off': victim.dead=True
    if kind=='runs': victim.running=True
    if kind=='swap': victim.acu=False
    if kind=='refuse_ram':
        t=R.choice(list(victim.want)); victim.wmode=lambda n,k,ds: 'refuse-ram' if n==t[0] and ds<5 else None
    for d in drives.values(): d.ee0=dict(d.ee); d.ram0=dict(d.ram); d.touched={}
    def hook(b,d,t,w):
        if not st['armed']: return None
        st['n']=st.get('n',0)+1
        if w: st['w']=st.get('w',0)+1
        if d.dead: return ('drop',)
        if kind=='swap' and d is victim and t[1]==3 and (t[2]<<8|t[3])==411: d.p11=0; 
        trig=(w and st['w']==wn and not st['fired'])
        if kind in('int','term','int2','kill9') and trig:
            st['fired']=True; s={'int':2,'term':15,'int2':2,'kill9':9}[kind]; proc[0].send_signal(s)
            if kind=='int2': threading.Timer(.1,lambda:proc[0].send_signal(2)).start()
            time.sleep(.01)
        if kind=='cut' and trig: st['fired']=True; b.cut=True
        if kind=='hangup' and trig: st['fired']=True; d.handle(t); b.hangup(); return ('lost',)
        if kind=='cutfor' and trig: st['fired']=True; b.cut=True; threading.Timer(dur,lambda:setattr(b,'cut',False)).start()
        if kind=='exc' and w and d is victim: st['fired']=True; return ('exc',4)
        if kind=='excall' and w and d is victim and d.wn>1: return ('exc',4)
        if kind=='power' and trig: st['fired']=True; d.powered=True; return ('power',dur)
        if kind=='starts' and trig: st['fired']=True; victim.running=True
        if kind=='offlate' and trig: st['fired']=True; victim.dead=True
        if kind=='other' and trig:
            st['fired']=True; c=R.choice(list(victim.want)); v=prop.rv(c[0],None)
            for _ in range(9):
                if v in(victim.want[c],victim.ee0[c]): v=prop.rv(c[0],v)
            victim.ee[c]=v; victim.ram[c]=v; victim.touched[c]=v
        if kind=='late' and R.random()<.1: return ('late',R.choice((.05,.16,.3)))
        return None
    bs=[Bus(ds,l,hook) for ds,l in buses]
    for b in bs: b.start()
    t0=time.time(); bad=[]
    proc[0]=p=subprocess.Popen([A,'--json','apply','--yes']+(['--atomic'] if atomic else []),cwd=dirn,stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
    try: out,err=p.communicate(timeout=timeout)
    except subprocess.TimeoutExpired: p.kill(); out,err=p.communicate(); bad.append('HANG')
    dt=time.time()-t0; rc=p.returncode
    open(dirn+'/out.json','w').write(out); open(dirn+'/err.txt','w').write(err)
    J=None
    try: J=json.loads(out)
    except Exception:
        if kind!='kill9': bad.append('no JSON')
    rows={}
    if J:
        for r in ((J.get('data') or {}).get('drives') or []): rows[r['called']]=r
        if not rows: bad.append('no rows: %s'%str(J)[:200])
        wt=json.dumps(J.get('warnings'))
        for nme,d in drives.items():
            r=rows.get(nme)
            if r is None: bad.append('%s has no row'%nme); continue
            s=r.get('state'); d.s=s
            isw=all(d.ee[c]==v and d.ram[c]==v for c,v in d.want.items())
            isb=all(d.ee[c]==d.ee0[c] for c in d.ee if c not in d.touched); isrb=all(d.ram[c]==d.ram0[c] for c in d.ram if c not in d.touched)
            vals=r.get('values') or []
            unn={ (v['param'],v['data_set']) for v in vals if v.get('result') in('unrestored','unknown','torn','refused','stored')}
            if s in('done','equal') and not isw and not d.touched: bad.append('%s %s but not as wanted'%(nme,s))
            if s in('back','untouched','left_out','skipped') and not isb: bad.append('%s %s but ee changed'%(nme,s))
            if s in('back','untouched','left_out','skipped') and not isrb and not getattr(d,'powered',0): bad.append('%s %s but ram changed'%(nme,s))
            if s in('untouched','left_out','skipped') and d.log: bad.append('%s %s but written %s'%(nme,s,d.log[:2]))
            if s=='torn':
                for c in d.ee:
                    if d.ee[c]!=d.ee0[c] and c not in d.touched and not any(u[0]==c[0] for u in unn) and 'P.%d'%c[0] not in json.dumps(r): bad.append('%s torn %s unnamed'%(nme,c))
            for c,v in d.touched.items():
                if d.ee[c]!=v and s!='done': bad.append('%s other\'s value %s lost (%s)'%(nme,c,s))
        ss={d.s for d in drives.values() if hasattr(d,'s')}
        if rc==0 and not ss<={'done','equal'}: bad.append('rc 0 with %s'%ss)
        if ss<={'done','equal'} and rc!=0: bad.append('rc %s with %s'%(rc,ss))
        if atomic and 'done' in ss and not ss<={'done','equal'}: bad.append('atomic but %s'%ss)
    st['armed']=False
    # undo whatever left an undo file
    nund=0
    if not any(b.hung for b in bs):
        for b in bs: b.cut=False
        for d in drives.values(): d.dead=False; d.off_until=0; d.running=False; d.wmode=lambda n,k,ds:None
        for nme,d in drives.items():
            f='%s.undo.toml'%nme
            if os.path.exists(dirn+'/'+f):
                nund+=1
                u=subprocess.run([A,'--json','-a',nme,'dataset','undo',f,'--yes'],cwd=dirn,capture_output=True,text=True,stdin=subprocess.DEVNULL)
                for c in d.want:
                    if d.ee[c]!=d.ee0[c]:
                        if u.returncode==0 : bad.append('%s undo 0 but %s=%s was %s%s'%(nme,c,d.ee[c],d.ee0[c],' touched' if d.touched else ''))
                        elif 'P.%d'%c[0] not in u.stdout: bad.append('%s undo %s unnamed'%(nme,c))
            elif any(d.ee[c]!=d.ee0[c] for c in d.want if c not in d.touched): bad.append('%s changed and no undo file'%nme)
    for b in bs: b.stop=True
    for b in bs: b.join()
    for _,l in buses:
        try: os.unlink(l)
        except OSError: pass
    from collections import Counter
    return dict(seed=seed,kind=kind,atomic=atomic,rc=rc,dt=round(dt,1),victim=victim.name,fired=st['fired'],states=dict(Counter(getattr(d,'s',None) for d in drives.values())),undos=nund,code=((J or {}).get('error')or{}).get('code'),bad=bad)
if __name__=='__main__':
    a,bb=int(sys.argv[1]),int(sys.argv[2]); kinds=sys.argv[3:]; end=float(os.environ.get('UNTIL','1e18'))
    f=open(os.environ['WD']+'/plant.%d.ndjson'%a,'a')
    for s in range(a,bb):
        if time.time()>end: break
        try: r=run(s,kinds[s%len(kinds)] if kinds else None)
        except Exception as e:
            import traceback; r=dict(seed=s,bad=['HARNESS '+traceback.format_exc()])
        f.write(json.dumps(r)+'\n'); f.flush(); print(json.dumps(r),flush=True)
