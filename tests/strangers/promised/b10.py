from nov import *
L=lambda x:(lambda c,f,r,now,d:[(x,r)])
def g(o,sp,late,rep=1,v=False,extra=()):
    for _ in range(rep):
        d=Cube(o); c=run([d],['-a','1','sollwert','--enable','--hold','--duration','1s','--yes',*extra,'--',sp],hook=L(late),quiet=True,maxt=60)
        en=[h[1][0][1] for h in c.hist if h[1][0][0]=='enabled']
        print('late %g %s | %s | rc %s shaft from %s to %s'%(late,sp,o,c.rc,min(en) if en else None,max(en) if en else None))
        print('   told:',' | '.join(l.strip() for l in c.err.split('\n') if 'Hz' in l)); print('   out:',' | '.join(l.strip() for l in c.out.split('\n') if 'Hz' in l or 'note' in l))
        print('   words',' '.join('%.2f %s'%x for x in c.words[:6]),flush=True)
        if v: show(c,True)
if __name__=='__main__':
    g('--set 418=0 --set 434=3 --internal 40','-35Hz',.01,2)
    g('--set 418=0 --set 434=3 --internal 40','-35Hz',.1,1)
    g('--set 418=0 --set 434=3 --internal 40','-35Hz',.4,2)
    g('--set 418=1000 --set 434=2','-15Hz',.01,1)
    g('--set 418=1000 --set 434=2','-15Hz',.4,2)
    g('--set 418=0 --set 434=3 --internal 40','-40Hz',.4,1)
