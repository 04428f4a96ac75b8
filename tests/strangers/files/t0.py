from ds import *
d=Drive()
r=run(['dataset','save','whole.toml','--force'],d); print(d.n,d.nw); show(r,1500)
r=run(['dataset','save','chg.toml','--changed','--force'],d,js=False); print(d.n,d.nw); show(r,1500); 
print(d.viol)
open(W+'/small.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"372" = "1450 1/min"\n"480@2" = "-12.50 Hz"\n"601@3"="5 %"\n"549"="6.00 Hz"\n"420"="7.00 Hz/s"\n')
for x in ([],['--yes']):
    d.clr(); b=d.snap()
    r=run(['dataset','load','small.toml']+x,d); print(d.n,d.nw,d.wlog,d.cnt()); show(r,6000)
d.clr()
r=run(['dataset','check','small.toml'],d,js=False); show(r)
r=run(['dataset','undo','small.undo.toml','--yes'],d); print(d.n,d.nw,d.wlog,d.snap()==b); show(r,3000)
