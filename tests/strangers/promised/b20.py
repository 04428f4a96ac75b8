from nov import *
L=lambda x:(lambda c,f,r,now,d:[(x,r)])
for late in (.02,.03,.05,.07,.1):
    for dr in (['--drive','acu'],[]):
        d=Cube('--set 418=0 --set 638=10 --running --left 20'); c=run([d],dr+['-a','1','statemachine','quick-stop'],hook=L(late),quiet=True,maxt=90)
        print('qs   late %g %s rc %s %.1fs words %s| %s'%(late,dr,c.rc,c.dur,['%.2f'%t for t,w in c.words],[l for l in c.err.split('\n') if l.startswith('error')]),flush=True)
d=Cube('--set 418=0 --set 638=10 --running --left 20'); c=run([d],['--drive','acu','-a','1','statemachine','quick-stop'],hook=L(.1),label='qs .1',verbose_line=True)
