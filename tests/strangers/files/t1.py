from ds import *
d=Drive()
open(W+'/small.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"372" = "1450 1/min"\n"480@2" = "-12.50 Hz"\n"601@3"="-5.0 %"\n"549"="6.00 %"\n"419"="60.00 Hz"\n')
for x in ([],['--yes']):
    d.clr(); b=d.snap()
    r=run(['dataset','load','small.toml']+x,d); print(d.n,d.nw,d.wlog,d.cnt()); show(r,6000)
for l in d.log: print(l)
r=run(['dataset','check','small.toml'],d,js=False); show(r)
d.clr()
r=run(['dataset','undo','small.undo.toml','--yes'],d); print(d.n,d.nw,d.wlog,d.snap()==b); show(r,3000)
