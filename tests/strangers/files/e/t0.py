from drv import *
d=Drv()
open('m.toml','w').write('antrieb = 1\n[drive]\nfamily = "act"\n[values]\n"372@2" = "1450"\n"480@2" = "-12.50 Hz"\n"419" = "60.00 Hz"\n"549" = "7.00 %"\n"601@3"="12"\n"412@4"="2"\n')
for f in os.listdir('.'):
    if '.undo' in f: os.remove(f)
r=run(d,'dataset','save','x.toml','--force'); print(r.rc,r.t,r.e[-300:],r.o[:300])
d.reset(); b=d.snap(); r=run(d,'dataset','load','m.toml','--yes'); print(r.rc,r.t,r.e[-600:],r.o); print(diffs(b,d.snap())); print(d.n,d.wr,d.eqw)
print(open('m.undo.toml').read())
d.reset(); r=run(d,'dataset','undo','m.undo.toml','--yes'); print(r.rc,r.t,r.e,r.o); print(diffs(b,d.snap()),d.wr)
