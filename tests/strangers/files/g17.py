from mat import *
from collections import Counter
clean(); d=Drive(delay=0.002)
d.hook=lambda d,n,b:('exc',4,6) if b[1]==101 else None
for i in range(2): r=run(['dataset','load','m.toml','--yes'],d); print(r.rc,r.j['data']['ended'],r.j['data']['undo_file'])
d.hook=None; print(sorted(os.path.basename(x) for x in glob.glob(W+'/m.und*')))
d.clr()
for f in ('tele.toml',): 
    if os.path.exists(W+'/'+f): os.remove(W+'/'+f)
r=run(['dataset','save','tele.toml'],d); c=Counter((l[1][2:4],l[2][:2] if l[2][:1] in '8e' else 'ok', 'P11' if l[1].endswith('000b0001') else '') for l in d.log if len(l)==3); print(d.n,c)
t=open(W+'/tele.toml').read(); import re
ref=re.search(r'refused = "(.*)"',t).group(1); k=0
for x in ref.split(','):
    a=x.strip().split('-'); k+=1 if len(a)==1 else int(a[1])-int(a[0])+1
print('values',t.split('[values]')[1].count('\n"'),'refused',k)
d.stop()
# finding 1 again, twice
