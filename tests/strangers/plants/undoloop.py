# load (healthy), then undo with a random end at a random telegram, then undo again on a healthy line
import sys,os,random,subprocess,json,time,shutil,threading

from drive import *
import prop
A=prop.A; cells=prop.cells
KINDS=['kill9','int','term','hup','int2','cut','cutfor','hangup','exc','excafter','garble','lostw','power_w','power','other','starts','refuse_ram','other_before','ram_before','drop','double']
def run(seed,kind=None):
    R=random.Random(seed); random.seed(seed); kind=kind or R.choice(KINDS)
    reading=R.choice(('eeprom','eeprom','eeprom','refused'))
    dirn=os.environ['WD']+'/uruns/%s'%seed; shutil.rmtree(dirn,ignore_errors=True); os.makedirs(dirn)
    d=Drive(1,reading); ns=R.sample(prop.CAND,R.randint(1,5)); want={}; L=[]
    for n in ns:
        v=prop.rv(n,None); L.append('"%d" = "%s"'%(n,prop.text(n,v)))
        for c in cells(n): want[c]=v
    ram=R.random()<.2 and reading!='refused'
    open(dirn+'/f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'+'\n'.join(L)+'\n')
    ee0=dict(d.ee); ram0=dict(d.ram); st={'armed':False,'fired':False}; proc=[None]; touched={}
    at=R.randint(1,10+9*len(want)); wn=R.randint(1,len(want)); bothw=R.random()<.5; dur=R.choice((.5,2,5)); exc=R.choice((1,2,3,4,6)); tgt=R.choice(list(want))
    def other(how):
        c=R.choice(list(want)); v=prop.rv(c[0],None)
        for _ in range(9):
            if v in (want[c],ee0[c]): v=prop.rv(c[0],v)
        if v in (want[c],ee0[c]): return
        if how!='ram': d.ee[c]=v
        d.ram[c]=v; touched[c]=(how,v,d.n)
    def hook(b,d,t,w):
        if not st['armed']: return
        if w: st['w']=st.get('w',0)+1
        st['n']=st.get('n',0)+1
        trig=not st['fired'] and ((w and st['w']==wn) if bothw else st['n']==at)
        if kind in('kill9','int','term','hup','int2') and trig:
            st['fired']=True; proc[0].send_signal({'kill9':9,'int':2,'int2':2,'term':15,'hup':1}[kind]); time.sleep(.01)
            if kind=='int2': threading.Timer(.05,lambda:proc[0].send_signal(2)).start()
        if kind=='cut' and trig: st['fired']=True; b.cut=True
        if kind=='cutfor' and trig: st['fired']=True; d.off_until=time.time()+dur
        if kind=='hangup' and trig: st['fired']=True; d.handle(t); b.hangup(); return ('lost',)
        if kind=='exc' and w and st['w']==wn: st['fired']=True; return ('exc',exc)
        if kind=='excafter' and w and st['w']==wn: st['fired']=True; d.handle(t); return ('exc',exc)
        if kind=='garble' and R.random()<.2: return ('garble',)
        if kind=='lostw' and w and R.random()<.5: return ('lost',)
        if kind=='drop' and R.random()<.15: return R.choice((('drop',),('lost',)))
        if kind=='double' and R.random()<.2: return ('double',R.choice((0,.002,.01,.05)))
        if kind=='power_w' and w and st['w']==wn: st['fired']=True; return ('power',R.choice((.05,.4,dur)))
        if kind=='power' and trig: st['fired']=True; d.power(); d.off_until=time.time()+R.choice((0,.2,dur))
        if kind=='other' and trig: st['fired']=True; other(R.choice(('both','ram')))
        if kind=='starts' and trig: st['fired']=True; d.running=True
    link='/tmp/n23u_%s'%seed; b=Bus([d],link,hook); b.start(); bad=[]
    base=[A,'-p',link,'-b','115200','-a','1','--timeout','150ms','--json','--no-config','dataset']
    def go(*c,to=200):
        p=proc[0]=subprocess.Popen(base+list(c),cwd=dirn,stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
        try: o,e=p.communicate(timeout=to)
        except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); bad.append('HANG')
        try: J=json.loads(o)
        except Exception: J=None
        return p.returncode,J,o,e
    rc,J,o,e=go('load','f.toml','--yes',*(['--ram'] if ram else []))
    if rc: 
        b.stop=True; b.join(); os.unlink(link); return dict(seed=seed,kind='noload',rc=rc,code=(J or {}).get('error'),bad=[])
    if kind=='other_before': other('both')
    if kind=='ram_before': other('ram')
    if kind=='refuse_ram': d.wmode=lambda n,k,ds:'refuse-ram' if n==tgt[0] and ds<5 else None
    ee1=dict(d.ee);ram1=dict(d.ram); st['armed']=True; w0=d.eew
    rc,J,o,e=go('undo','f.undo.toml','--yes'); dt=0
    open(dirn+'/out.json','w').write(o); open(dirn+'/err.txt','w').write(e)
    if J is None and kind!='kill9': bad.append('no JSON')
    data=(J or {}).get('data') or {}; ended=data.get('ended')
    def named(J):
        s={ (v['param'],v['data_set']) for v in ((J or {}).get('data') or {}).get('values',[]) if v.get('result') not in('verified','restored','unchanged','equal')}
        t=json.dumps((J or {}).get('warnings'))+json.dumps((J or {}).get('error'))
        return lambda c: c in s or (c[0],0) in s or 'P.%d'%c[0] in t
    nm=named(J); mem=(lambda c:(d.ram[c],ram0[c])) if ram else (lambda c:(d.ee[c],ee0[c]))
    if J:
        for c in want:
            a,w=mem(c)
            if rc==0 and a!=w : bad.append('undo 0 but %s=%s want %s %s'%(c,a,w,touched.get(c)))
            if rc==0 and d.ram[c]!=ram0[c] and not touched.get(c) and reading=='eeprom': bad.append('undo 0 but ram %s=%s'%(c,d.ram[c]))
            if rc!=0 and a!=w and not nm(c) and ended not in('untouched',): bad.append('undo %s %s: %s=%s unnamed'%(rc,ended,c,a))
            if ended=='back' and c not in touched and (d.ee[c]!=ee1[c] or (d.ram[c]!=ram1[c] and not kind.startswith('power'))): bad.append('undo back but %s ee %s/%s ram %s/%s'%(c,d.ee[c],ee1[c],d.ram[c],ram1[c]))
        for c,(how,v,tn) in touched.items():
            now=d.ram[c] if how=='ram' else d.ee[c]
            if now!=v and how!='ram': bad.append('other lost %s'%str((c,how,v,now,rc,ended)))
        ew=data.get('eeprom_writes')
        if ew is not None and d.eew-w0>ew+(data.get('eeprom_writes_back') or 0): bad.append('writes %s>%s'%(d.eew-w0,ew))
    st['armed']=False; d.off_until=0; b.cut=False; d.running=False; d.wmode=lambda *a:None
    if b.hung: time.sleep(.1); b=Bus([d],link,hook); b.start()
    rc2,J2,o2,e2=go('undo','f.undo.toml','--yes'); nm2=named(J2)
    for c in want:
        a,w=mem(c)
        if a!=w and rc2==0: bad.append('2nd undo 0 but %s=%s'%(c,a))
        if a!=w and c not in touched and not nm2(c) : bad.append('2nd undo %s: %s=%s unnamed'%(rc2,c,a))
        if a!=w and c not in touched and not(ram and kind.startswith('power')): bad.append('2nd undo left %s=%s rc %s %s'%(c,a,rc2,'named' if nm2(c) else ''))
    rc3=None
    if rc2!=0:
        rc3,J3,o3,e3=go('undo','f.undo.toml','--yes','--force')
        if not ram:
            for c in want:
                if d.ee[c]!=ee0[c]: bad.append('undo --force rc %s left %s=%s'%(rc3,c,d.ee[c]))
        open(dirn+'/out3.json','w').write(o3)
    open(dirn+'/out2.json','w').write(o2)
    b.stop=True; b.join(); open(dirn+'/tele.txt','w').write('\n'.join(b.dump))
    try: os.unlink(link)
    except OSError: pass
    return dict(seed=seed,kind=kind,reading=reading,ram=ram,rc=rc,ended=ended,rc2=rc2,e2=((J2 or {}).get('data')or{}).get('ended'),rc3=rc3,fired=st['fired'],touched={str(k):v for k,v in touched.items()},n=len(want),bad=bad)
if __name__=='__main__':
    a,bb=int(sys.argv[1]),int(sys.argv[2]); end=float(os.environ.get('UNTIL','1e18')); f=open('undoloop.%d.ndjson'%a,'a')
    for s in range(a,bb):
        if time.time()>end: break
        try: r=run(s)
        except Exception as e:
            import traceback; r=dict(seed=s,bad=['HARNESS '+traceback.format_exc()])
        f.write(json.dumps(r)+'\n'); f.flush()
        if r['bad']: print(json.dumps(r),flush=True)
