from nov import *
L=lambda x:(lambda c,f,r,now,d:[(x,r)])
for late,h in ((.2,10),(.3,10),(.4,10),(.4,20),(.4,20)):
    c=run([Cube('--set 418=0 --running --left 20 --set 638=%d'%h)],['-a','1','statemachine','quick-stop'],hook=L(late),quiet=True,maxt=60)
    print('qs auto late %g P.638 %g rc %s %.1fs words %d first %.2f'%(late,h/10,c.rc,c.dur,len(c.words),c.words[0][0]),[l[:110] for l in c.err.split('\n') if l.startswith('error')],flush=True)
c=run([Cube('--set 418=0 --running --left 20 --set 434=2')],['-a','1','sollwert','0'],hook=L(.4),quiet=True,maxt=60)
print('zero auto .4 rc',c.rc,c.end,c.dur,[l[:150] for l in c.err.split('\n') if l.startswith('error')])
