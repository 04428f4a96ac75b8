from bench import *
import sys
def turning(x): return x is not None and abs(x['shaft'])>0.05
SEEN=[]
def case(name,args,cfg=None,at=(),expect=None,limit=90,keep=None,after=4,show=False,json_=True,**kw):
    cfg=dict(cfg or {}); cfg.setdefault('life',limit+40); cfg.setdefault('m44_keypad',1)
    cfg['log']='/tmp/cube-'+name.replace(' ','_').replace('/','-')+'.log'
    d=Drive(**cfg); init=d.dump()
    pre=kw.pop('pre',None)
    if pre:
        for c in pre:
            if isinstance(c,(int,float)): time.sleep(c)
            else: d.cmd(c)
        time.sleep(0.05); init=d.dump()
    r=Run(args,d,at=[(t,(lambda f:(lambda rr:f(rr,d)))(f)) for t,f in at],limit=limit,json_=json_,**kw)
    e=r.atend; prob=[]
    time.sleep(min(after,0.3)); l1=d.dump() if e else None
    if turning(e):
        t0=time.monotonic()
        while turning(l1) and time.monotonic()-t0<after: time.sleep(0.4); l1=d.dump()
    l=l1
    if r.hung: prob.append('HANG')
    if r.rc==70 or 'panicked' in r.err: prob.append('CRASH')
    if r.rc is not None and r.rc<0: prob.append('KILLED %d'%r.rc)
    if json_ and r.j is None and '--dry-run' not in args and '--format' not in args: prob.append('NO JSON')
    if r.j:
        if bool(r.j.get('ok'))!=(r.rc in(0,)): prob.append('ok!=rc')
        dat=r.j.get('data') or {}
        if isinstance(dat,dict):
            if dat.get('standing') is True and turning(e): prob.append('FALSE standing, shaft %.2f'%e['shaft'])
            if dat.get('running') is False and e and e['state'] in('OE','QSA','FRA') : prob.append('FALSE running=false in '+e['state'])
            if dat.get('running') is True and e and e['state'] not in('OE',): prob.append('FALSE running=true in '+e['state'])
    if e:
        if turning(e): prob.append('TURNS at exit %.2f (%s)'%(e['shaft'],e['state']))
        if turning(l): prob.append('STILL TURNS %.1fs later %.2f (%s)'%(l['t']-e['t'],l['shaft'],l['state']))
        if e['state']=='OE': prob.append('ENABLED at exit')
        if l and e['state']!='OE' and l['state']=='OE': prob.append('STARTED AGAIN after exit')
        for k in('p412','p413','p434','p412ee','p413ee'):
            if e[k]!=init[k]: prob.append('%s %s->%s'%(k,init[k],e[k]))
        if e['eew']: prob.append('EEPROM %s'%e['eew'])
        if e['viol']: prob.append('VIOL %d %s'%(len(e['viol']),e['viol'][0]))
        if e['line'] : prob.append('P484 left %d'%e['line'])
    msg=brief(r)
    st=(r.j or {}).get('data') if r.j else None
    stop=st.get('stop') if isinstance(st,dict) else None
    print('== %-34s rc=%s t=%.1f maxf=%s starts=%s end=%s/%s | %s'%(name,r.rc,r.t,e and e['maxf'],e and e['starts'],e and e['state'],e and e['word'],'; '.join(prob) or '-'))
    er=(r.j or {}).get('error')
    if er: print('     err %s: %s | hint: %s'%(er.get('code'),er.get('message'),er.get('hint')))
    if stop: print('     stop',json.dumps({k:(v if k!='state' else (v or {}).get('slug')) for k,v in stop.items()}), 'standing',st.get('standing'),'running',st.get('running'),'notes',st.get('notes'),'warn',(r.j or {}).get('warnings'))
    elif isinstance(st,dict): print('     data to=%s standing=%s running=%s notes=%s warn=%s'%((st.get('to') or {}).get('slug') if isinstance(st.get('to'),dict) else st.get('to'),st.get('standing'),st.get('running'),st.get('notes'),(r.j or {}).get('warnings')))
    if show: print(r.out[-3000:]); print(r.err[-3000:])
    SEEN.append((name,r.rc,prob)); sys.stdout.flush()
    d.stop()
    return r,e,l
