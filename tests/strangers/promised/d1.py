"""dice: random drive, verb, line, signals; judged automatically. python3 d1.py SEED0 N"""
from nov import *
import io,contextlib,traceback
def one(seed,show_it=False):
    r=random.Random(seed)
    fam=r.choice(['act','acu','acu','lxm'])
    proto=r.choice(['rtu','rtu','vabus']) if fam!='lxm' else 'rtu'
    desc=[fam,proto]
    running=r.random()<.3
    if fam=='lxm':
        k=dict(mode_change_turning=r.choice(['refused','accepted']),setpoints=r.choice(['kept','zeroed']),control7=r.choice(['coasts','brakes','refused']),
          guard_state=r.choice(['quick-stop','fault']),guard_fed_by=r.choice(['all','writes']),fc43=r.choice(['answers','answers','refused']),
          quick_stop_ends=r.choice(['stays','by-itself']),dither=r.choice([0,0,5]),halt=r.choice(['honoured','ignored']),limits=r.choice(['refused','clipped']))
        left=r.choice(['','PVn_target=900','GEARreference=1,DCOMopmode=4','RAMPacc=300,RAMPdecel=300'])
        if left: k['left']=left
        if running: k['turning']=r.choice([300.,-857.])
        d=Lx(1,**k); desc.append(str(k))
    else:
        o='--family %s --set 418=%d --command-by %s --read-back %s --set-character %s --unknown %d --wrong-width %d --x-bits %d --coast-shows %s --start-lost %s --coast %g --set 392=%d --set 638=%d '%(
          fam,r.choice([0,0,350]),r.choice(['level','edge']),r.choice(['eeprom','force']),r.choice(['asked','folded']),r.choice([2,4]),r.choice([2,4]),r.choice([0,1]),r.choice(['zero','zero','shaft']),
          r.choice(['coast','ramp']),r.choice([8,40]),r.choice([2,2,2,0]),r.choice([5,5,10,0]))
        if r.random()<.3: o+='--set 434=%d '%r.choice([1,2])
        if r.random()<.3: o+='--internal %g '%r.choice([5,-10])
        if r.random()<.3: o+='--left %g '%r.choice([15,-8])
        if r.random()<.2: o+='--set 412=%d '%r.choice([0,2,44])
        if r.random()<.2: o+='--set 421=500 --set 423=500 --set 424=800 --set 425=800 '
        if running: o+='--running '+('--left 20 ' if '--left' not in o else '')
        d=Cube(o,1,proto); desc.append(o)
    sp='300rpm' if fam=='lxm' else '10Hz'
    v=r.choice(['hold','hold','hold','enhold','quick-stop','disable','disable-voltage','zero'])
    ex=r.choice(['ramp','ramp','quick-stop','coast'])
    if v=='hold':
        a=['sollwert',sp,'--enable','--hold','--duration',r.choice(['800ms','2s']),'--yes','--on-exit',ex]
        if fam!='lxm' and r.random()<.5: a+=['--source',r.choice(['line','sum'])]
        if fam!='lxm' and r.random()<.4: a+=['--take-control']
        if r.random()<.4: a+=['--watchdog','2s']
    elif v=='enhold':
        a=['statemachine','enable','--hold','--duration','1s','--yes','--on-exit',ex]+(['--take-control'] if fam!='lxm' and r.random()<.5 else [])
    elif v=='zero': a=['sollwert','0']
    else: a=['statemachine',v]
    # line
    line=r.choice(['good','good','late400','late900','late2500','jit','dbl','dblevery','lose','loseburst','twin','babble','master','garble','echo','mutewin','cut'])
    when=r.choice(['always','enabled'])
    rr=random.Random(seed+1); cnt=[0]; base=r.choice([.005,.01,.03])
    def hook(c,f,rep,now,dd):
        if rep is None: return []
        cnt[0]+=1
        if when=='enabled' and d.enabled is None: return [(base,rep)]
        if line=='late400': return [(.4,rep)]
        if line=='late900': return [(.9,rep)]
        if line=='late2500': return [(2.5,rep)]
        if line=='jit': return [(rr.choice([.01,.01,.2,.7]),rep)]
        if line=='dbl': return [(base,rep),(base+P,rep)]
        if line=='dblevery': return [(base,rep)]+([(base+P,rep)] if cnt[0]%K==0 else [])
        if line=='lose': return [] if cnt[0]%K==0 else [(base,rep)]
        if line=='loseburst': return [] if (now%4)<1.0 else [(base,rep)]
        if line=='twin':
            o=bytearray(rep)
            if proto=='rtu' and len(o)>=7: o[4]^=1; o=bytearray(crc(bytes(o[:-2])))
            return [(base,rep),(base+P,bytes(o))]
        if line=='garble':
            if cnt[0]%K==0: o=bytearray(rep); o[rr.randrange(len(o))]^=1<<rr.randrange(7); return [(base,bytes(o))]
        if line=='cut' and cnt[0]%K==0: return [(base,rep[:-2])]
        return [(base,rep)]
    P=r.choice([.02,.1,.3,.45]); K=r.choice([2,3,4,5])
    inj=[]
    if line=='babble': inj=[(0,.02,b'\x55')]
    if line=='master': inj=[(0,.05,crc(bytes([5,3,1,0x9b,0,1]))),(.025,.05,crc(bytes([5,3,2,2,0x17])))]
    echo='whole' if line=='echo' else None
    tr=[]
    m0,m1=r.uniform(.3,2.5),r.uniform(.3,4)
    if line=='mutewin': tr+=[(T(m0),lambda c:setattr(c,'mute',True)),(T(m0+m1),lambda c:setattr(c,'mute',False))]
    sg=r.choice(['none','none','int','int2','int3','term','hup','intterm'])
    t=r.uniform(.1,3.2); gaps=[r.uniform(.05,1.2) for _ in range(3)]
    S={'none':[],'int':[INT],'int2':[INT,INT],'int3':[INT,INT,INT],'term':[TERM],'hup':[HUP],'intterm':[INT,TERM]}[sg]
    for i,s in enumerate(S): tr.append((T(t),s)); t+=gaps[i]
    ev=r.choice(['none','none','none','enlost','enblink','trip','silent','startblink'])
    if fam!='lxm' and ev!='none' :
        et=r.uniform(0,1.5); el=r.choice([.03,.3,1.5])
        def put(n,x):
            def setx(c): d.d.advance(time.monotonic()); setattr(d.d,n,x)
            return setx
        if ev=='enlost': tr+=[(EN(et),put('enable',False))]
        if ev=='enblink': tr+=[(EN(et),put('enable',False)),(EN(et+el),put('enable',True))]
        if ev=='startblink': tr+=[(EN(et),put('start',False)),(EN(et+el),put('start',True))]
        if ev=='trip': tr+=[(EN(et),lambda c:d.d.trip(0x0500,time.monotonic()))]
        if ev=='silent': tr+=[(EN(et),lambda c:(setattr(d,'dead',True)))]
        ev+=' %.2f %.2f'%(et,el)
    elif fam=='lxm' and ev in('trip','enlost','enblink'):
        et=r.uniform(0,1.5); tr+=[(EN(et),lambda c:d.d.fault())]; ev='fault %.2f'%et
    else: ev='none'
    a=(['--protocol','vabus'] if proto=='vabus' else [])+['-a','1']+a+['--json']
    known={'lxm':'lxm05'}.get(fam,fam)
    if r.random()<.5: a=['--drive',known]+a
    d.advance(time.monotonic())
    c=run([d],a,hook=hook,inject=inj,triggers=tr,echo=echo,maxt=100,quiet=True,after=.6)
    bad=[]
    desc+=[line,when,'P%.2f K%d'%(P,K) if line in('dbl','dblevery','lose','garble','cut','twin') else '',sg,ev]
    try: doc=json.loads(c.out)
    except Exception: doc=None; bad.append('NOJSON')
    text=c.out+c.err
    est,esp=c.end[0]; lst,lsp=c.later[0]
    unit=5 if fam=='lxm' else .2
    turning=abs(esp)>unit; later=abs(lsp)>unit
    powered=est in('enabled','quick stop')
    data=(doc or {}).get('data') or {}
    if 'drives' in data: data=data['drives'][0].get('motion') or {}
    stop=data.get('stop') or {}
    may='MAY STILL TURN' in text or 'keeps running' in text.lower() or 'still turns' in text or 'turns on' in text or 'coasts' in text
    if c.hang: bad.append('HANG')
    if c.rc not in(0,1,2,3,4,5,6,7,8,9,130): bad.append('RC%s'%c.rc)
    if doc and (doc['ok']!=(c.rc==0)): bad.append('OK!=RC')
    if turning and powered and data.get('running') is False: bad.append('FALSE running no at %.1f in %s'%(esp,est))
    if turning and data.get('standing') is True: bad.append('FALSE standing at %.1f in %s'%(esp,est))
    if powered and est=='enabled' and abs(lsp)>unit and v in('hold','enhold') and any(not w.startswith('!') for _,w in c.words) and d.enabled is not None and line not in('mutewin',) and not ev.startswith('silent'):
        bad.append('LEFT TURNING %.1f rc %s%s'%(lsp,c.rc,' told' if may else ' UNTOLD'))
    if v in('quick-stop','disable','disable-voltage') and running and est=='enabled' and abs(lsp)>unit and not(fam!='lxm' and d.d.value(412)!=1): bad.append('NOT STOPPED %.1f rc %s'%(lsp,c.rc))
    if turning and not may and any(not w.startswith('!') for _,w in c.words): bad.append('TURNS %.1f in %s, untold, rc %s'%(esp,est,c.rc))
    if lst=='enabled' and est!='enabled': bad.append('STARTED AGAIN')
    if not turning and est not in('enabled',) and data.get('running') is True: bad.append('FALSE running yes, %s'%est)
    if not turning and 'MAY STILL TURN' in text and est!='enabled' and line=='good' and ev=='none': bad.append('ALARM stands in %s rc %s'%(est,c.rc))
    df=d.diff(); df={k:x for k,x in df.items() if k not in('DCOMcontrol','DCOMopmode','484','PVn_target') }
    ng='NOT given back' in text or any(not x.get('restored',True) for x in data.get('changed',[]) if isinstance(x,dict)) or 'not given back' in text.lower()
    if df and not ng and v in('hold','enhold'): bad.append('NOT BACK untold %s'%df)
    if df and ng and line=='good' and sg=='none' and ev=='none': bad.append('NOT BACK told %s'%df)
    if v in('hold','enhold'):
        if fam!='lxm' and d.d.line_setpoint not in(0,round(d.opt.left*100)) and est!='enabled' and '484' not in text: bad.append('P.484 left %d'%d.d.line_setpoint)
        if fam=='lxm' and d.d.value['PVn_target']!=d.before['PVn_target'] and d.d.value['PVn_target']!=0: bad.append('PVn left %d'%d.d.value['PVn_target'])
    if c.rc==0 and sg!='none' and v in('hold','enhold') and any('!2' in w or '!15' in w for _,w in c.words): bad.append('rc0 though interrupted')
    if c.rc==0 and v=='hold' and d.enabled is None: bad.append('rc0 never enabled')
    w=d.wear()
    if w: bad.append('EEPROM %s'%w)
    pk=max(abs(h[1][0][1]) for h in c.hist); 
    sins=[s for s in d.sins if s[1] not in('unknown-function','function code not in 5.2','odd address or count','bad-telegram')]
    sn={}
    for s in sins: sn.setdefault(s[1],s)
    if 'enabled-onto-turning-shaft' in sn: bad.append('sin '+str(sn['enabled-onto-turning-shaft']))
    print('%s seed %d rc %s %.1fs end %s later %s peak %.1f | %s | %s'%('BAD' if bad else 'ok ',seed,c.rc,c.dur,c.end[0],c.later[0],pk,' '.join(a),' '.join(map(str,desc))),flush=True)
    if bad: print('      !!',bad)
    if sn: print('      sins',list(sn.values())[:4])
    if show_it: show(c,True)
    return bad
if __name__=='__main__':
    s0,n=int(sys.argv[1]),int(sys.argv[2])
    if n==1: one(s0,True)
    else:
        for s in range(s0,s0+n):
            try: one(s)
            except Exception: traceback.print_exc(limit=3)
