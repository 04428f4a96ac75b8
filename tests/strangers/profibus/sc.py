from h import *
import random, traceback
def summ(r):
    j=r.j
    if not j: return 'nojson err=%r'%(r.err.strip()[-160:],)
    e=j.get('error') or {}; d=j.get('data')
    if isinstance(d,list) and d: d=d[0]
    x=[]
    if isinstance(d,dict):
        for k in ('running','standing'):
            if k in d: x.append('%s=%s'%(k[:5],d[k]))
        st=d.get('stop')
        if isinstance(st,dict): x.append('stop(%s,%s,ack=%s,esc=%s)'%(st['choice'],st['because'],st['acknowledged'],st['escalated']))
        sp=d.get('setpoint')
        if isinstance(sp,dict): x.append('sp %s act %s reach %s'%(sp['value'],sp['actual'],sp['reached']))
        if d.get('changed'): x.append('chg '+str([(c['param'],c.get('restored',c.get('given_back',c.get('state')))) for c in d['changed']]))
        if d.get('fault'): x.append('fault')
    return 'ok=%s %s %s W%s'%(j['ok'],e.get('code'),' '.join(x),[w.get('code') for w in j.get('warnings',[])])
def S(name,*args,opts={},setup=None,sig=None,drive=None,yes=True,timeout=70,after=0,show=False,msg=False,json_=True):
    s=Slave(name,**opts); s.start()
    try:
        if setup: setup(s)
        a=list(args)+(['--json'] if json_ else [])
        r=run(s,*a,yes=yes,sig=sig,drive=drive,quiet=True,timeout=timeout)
        tn=s.turning; out=s.out
        if after: time.sleep(after)
        flags=[]
        if r.hang: flags.append('HANG')
        if s.turning: flags.append('TURNS-AFTER')
        if tn: flags.append('TURNED-AT-EXIT')
        if s.sins: flags.append('SINS%d'%len(s.sins))
        if any('PEER CRASH' in l[1] for l in s.lines): flags.append('PEERCRASH')
        if r.rc not in (0,) : pass
        mx=max([abs(x[0]) for x in [(0,)]]) 
        print('%-22s rc=%-4s %5.1fs %s | %s | dx%d w%s wdx%d src=%s'%(name,r.rc,r.t,','.join(flags) or '-',summ(r),s.dx_count,[w[1:] for w in s.writes][-8:],getattr(s,'wd_exp',0),s.run_by),flush=True)
        for t,m in s.sins[:3]: print('      SIN %.2f %s'%(t,m))
        if msg or show:
            m=(r.j or {}).get('error') or {}
            print('      MSG',m.get('message'),'| HINT',m.get('hint'))
            for w in (r.j or {}).get('warnings',[]): print('      WARN',w.get('code'),w['message'][:260])
        if show: print('      ERR',r.err.strip()[-600:]); print('      OUT',r.out.strip()[-1500:])
        return s,r
    except Exception: traceback.print_exc()
    finally: s.close()
RUN=('sollwert','20Hz','--enable','--hold','--duration','2s','--take-control','--watchdog','1s')
BRUN=('sollwert','20Hz','--enable','--hold','--duration','2s','--set','F002=2s','--set','F003=2s','--mode','basic')
