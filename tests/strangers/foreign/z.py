from s2 import *
for nm,st in (('a1-clean',{}),('a1-clean-f0',{418:0})):
    for v,a in (('zero',['sollwert','0']),):
        grp(nm+v,a,[('a',1,0)],prep=lambda d,st=st:(runs(d),d.ram.update({(418,i):st.get(418,350) for i in range(1,5)}))[0])
grp('a2-f0-dead',['sollwert','0'],[('a',1,0),('a',2,'dead'),('a',3,.3)],prep=lambda d:(runs(d),d.ram.update({(418,i):0 for i in range(1,5)}))[0])
