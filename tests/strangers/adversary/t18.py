from h import *
with act('--running --left 20') as d:
    r=run(d,['-v','--drive','lxm05','-a','1','statemachine','quick-stop'],limit=40,after=0,base='start'); print(r['err'][-1800:])
    r=run(d,['-v','--drive','lxm05','-a','1','sollwert','0'],limit=40,after=0,base='start'); print(r['err'][-3800:]); print(r['out'])
with LX('--turning 857') as d:
    r=run(d,['-v','--drive','act','-a','1','statemachine','quick-stop'],limit=40,after=0,base='start'); print(r['err'][-2500:])
