from h import *
S=signal
def one(n,d,args,sc,limit=30,base='enabled',want=(130,)):
    with d:
        r=run(d,args+['--json'],sc,limit=limit,base=base,after=0.8)
        try: x=json.loads(r['out']); D=x['data'] or {}; e=x['error'] or {}; st=D.get('stop') or {}
        except Exception: D={};e={'message':'NO DOC '+r['out'][:100]+r['err'][-200:]};st={}
        bad = r['hang'] or r['code'] not in want or (abs(r['end'][2])>0.6 and not st.get('note') and 'TURN' not in r['err']) or r['later'][0]=='enabled'
        print('BAD' if bad else 'ok ',n,r['code'],r['s'],r['end'],r['later'],'stop',st.get('choice'),st.get('escalated'),st.get('acknowledged'),st.get('standing'),'|',(e.get('message') or '')[:120],'| back',[(c['name'],c['restored']) for c in D.get('changed',[])],flush=True)
H=RUN
burst=lambda t,k,g,sg=S.SIGINT: [(t+i*g,sig(sg)) for i in range(k)]
for i in range(2):
    one('5 INT in 50 ms',act(),H,burst(0.8,5,0.01)); one('20 INT in 2 s',act('--set 421=200'),H,burst(0.8,20,0.1)); one('INT HUP TERM',act('--set 421=300'),H,[(0.8,sig(S.SIGINT)),(1.0,sig(S.SIGHUP)),(1.2,sig(S.SIGTERM))])
    one('5 INT, late 100',act('--late 100'),H,burst(1.2,5,0.03))
    one('5 INT, lose every 2nd',act('--lose 2 --disturb-when enabled'),H,burst(1.2,5,0.03))
    for p in ('ascii','vabus'):
        one(p+' INT',act('--protocol '+p),['--protocol',p]+H,[(0.5,sig(S.SIGINT))]); one(p+' 3 INT',act('--protocol '+p),['--protocol',p]+H,burst(0.5,3,0.05))
    one('contacts HUP',act('--set 412=2'),['-a','1','statemachine','contacts','S1IND','S2IND','--hold','--duration','6s','--yes'],[(0.8,sig(S.SIGHUP))])
    one('goto TERM at end',act(),['-a','1','statemachine','goto','operation-enabled','--hold','--duration','1s','--yes'],[(1.0,sig(S.SIGTERM))],want=(0,130))
    for t in (1.0,1.3,1.6,1.9): one(f'INT near the end +{t}',act(),[a.replace('6s','1s') for a in H],[(t,sig(S.SIGINT))],want=(0,130))
    one('acu 2 INT',act('--family acu'),H,burst(0.8,2,0.3))
    one('keep + INT',act(),H+['--on-exit','keep'],[(0.8,sig(S.SIGINT))])
    one('keep + 3 INT',act(),H+['--on-exit','keep'],burst(0.8,3,0.3))
    one('multi address',act('--neighbour 2'),['-a','1,2','sollwert','20Hz','--source','line','--enable','--hold','--duration','2s','--yes'],[],want=(0,2,8))
    one('broadcast run',act(),['-a','0','sollwert','20Hz','--enable','--hold','--duration','2s','--yes'],[],want=(2,8),base='start')
    one('broadcast quick-stop',act('--running --left 20'),['-a','0','statemachine','quick-stop'],[],want=(2,8),base='start')
    one('sollwert without hold, INT',act(),['-a','1','sollwert','20Hz','--source','line','--enable','--until','reached','--yes'],[(0.1,sig(S.SIGINT))])
