from j import *
RUN='--family acu --running --left 20 --set 418=0 --set 434=2 '
for v in (['statemachine','quick-stop'],['statemachine','disable'],['sollwert','0']):
  for dr in ([],['--drive','acu']):
    for k in (1,2,4):
      for i in (1,2):
        d=Cube(RUN); c=run([d],dr+['-a','1']+v,triggers=[(N(k),lambda c:c.unplug())],quiet=True,hook=lambda c,f,r,n,dd:[(.01,r)] if c.n<k else [])
        print(v,dr,'unplugged after telegram',k,'rc',c.rc,'%.2fs'%c.dur,'end',c.end,'words',c.words,'| out',c.out.strip().replace('\n',' | ')[:160],'| err',c.err.strip().replace('\n',' | ')[:160],flush=True)
for i in (1,2):
    d=Lx(1,turning=600.); c=run([d],['-a','1','statemachine','quick-stop'],triggers=[(N(1),lambda c:c.unplug())],quiet=True,hook=lambda c,f,r,n,dd:[])
    print('lx','rc',c.rc,'end',c.end,'words',c.words,'| err',c.err.strip().replace('\n',' | ')[:160],flush=True)
