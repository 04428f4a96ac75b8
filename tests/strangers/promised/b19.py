from nov import *
L=lambda x:(lambda c,f,r,now,d:[(x,r)])
for late in (.1,.2,.4):
  for hold in (5,10,20):
    d=Cube('--set 418=0 --set 638=%d'%hold); c=run([d],['--drive','acu','-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','1s','--yes'],hook=L(late),quiet=True,maxt=90)
    print('hold late %g P.638 %.1fs rc %s %.1fs | %s | %s'%(late,hold/10,c.rc,c.dur,[l for l in c.out.split('\n') if l.startswith('stop')],[l for l in c.err.split('\n') if l.startswith('error')]),flush=True)
    d=Cube('--set 418=0 --set 638=%d --running --left 20'%hold); c=run([d],['--drive','acu','-a','1','statemachine','quick-stop'],hook=L(late),quiet=True,maxt=90)
    print('qs   late %g P.638 %.1fs rc %s %.1fs words %s| %s'%(late,hold/10,c.rc,c.dur,['%.2f'%t for t,w in c.words],[l for l in c.err.split('\n') if l.startswith('error')]),flush=True)
d=Lx(1,turning=600.); c=run([d],['--drive','lxm05','-a','1','statemachine','quick-stop'],hook=L(.4),label='lx qs .4')
d=Lx(1); c=run([d],['--drive','lxm05','-a','1','sollwert','300rpm','--enable','--hold','--duration','1s','--yes'],hook=L(.4),label='lx hold .4')
