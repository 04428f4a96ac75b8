from h import *
for args in (['sollwert','0'],['statemachine','quick-stop'],['statemachine','disable-voltage'],['statemachine','disable']):
  for i in range(2):
    with act('--running --left 20') as d:
        r=run(d,['--drive','lxm05','-a','1']+args+['--json'],limit=40,after=0.5,base='start'); show('ACT running, --drive lxm05 '+' '.join(args),r)
        x=json.loads(r['out']); D=x['data'] or {}; print('   ',x['error']['message'],'|',x['error']['hint'],'| running',D.get('running'),'standing',D.get('standing'),'stop',D.get('stop'),'from',D.get('from'),'to',D.get('to'))
with LX('--turning 857') as d:
    for args in (['statemachine','quick-stop'],['statemachine','disable']):
        r=run(d,['--drive','act','-a','1']+args+['--json'],limit=40,after=0.5,base='start'); show('LXM turning --drive act '+' '.join(args),r); x=json.loads(r['out']); D=x['data'] or {}; print('   ',x['error']['message'],'|',x['error']['hint'],'| running',D.get('running'))
