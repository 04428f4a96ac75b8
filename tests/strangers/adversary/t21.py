from h import *
from t19g import Gate
def j(r):
    try: x=json.loads(r['out'])
    except Exception: return r['out'][:300]
    D=x['data'] or {}; return json.dumps({'err':(x['error'] or {}).get('message'),'state':D.get('state'),'d':str(D)[:260]})
for i in range(2):
    with act('--running --left 20') as d:
        for v in (['statemachine'],['diag'],['scan','-a','1']):
            r=run(d,['--drive','lxm05']+(['-a','1'] if v[0]!='scan' else [])+v+['--json'],after=0,base='start'); show('ACT as lxm05 '+v[0],r); print('   ',j(r))
    d=act('--running --left 20',Gate); d.code=6; d.cut=None
    with d:
        for v in (['statemachine'],['diag'],['monitor','--count','1'],['statemachine','quick-stop'],['sollwert','0']):
            r=run(d,['--drive','act','-a','1']+v+['--json'],after=0,base='start'); show('ACT busy '+' '.join(v),r); print('   ',j(r)[:520])
