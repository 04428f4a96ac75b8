from h import *
from t10e import Echo
def echo(delay,args,proto='rtu'):
    d=act(f'--protocol {proto}',Echo); d.delay=delay
    with d:
        r=run(d,['--protocol',proto]+args,limit=90,after=0.5); show(f'{proto} echo {delay*1000:.0f} ms {args[2]}',r); print('   ',r['err'][-330:].replace('\n',' / '),'|',r['out'][-200:].replace('\n',' ') if r['code'] else '')
for proto in ('rtu','vabus','ascii'):
  for dl in (0.025,0.045,0.08):
    echo(dl,['-a','1','read','480@2','481@2','482@2','372@1'],proto)
    echo(dl,[a.replace('6s','2s') for a in RUN],proto)
