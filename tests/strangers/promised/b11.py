from nov import *
def g(o,sp,fam='acu',v=False,extra=(),n=1):
  for _ in range(n):
    d=Cube(o); c=run([d],['-a','1','sollwert','--enable','--hold','--duration','1s','--yes',*extra,'--',sp],quiet=True,maxt=60)
    en=[h[1][0][1] for h in c.hist if h[1][0][0]=='enabled']
    print('%s | %s | rc %s shaft from %s to %s'%(sp,o,c.rc,min(en) if en else None,max(en) if en else None))
    print('   told:',' | '.join(l.strip() for l in (c.err+c.out).split('\n') if 'Hz' in l))
    rd=['%d@%d'%(struct.unpack('>H',f[2:4])[0]&0xFFF,struct.unpack('>H',f[2:4])[0]>>12) for t,f in c.frames if f[1] in(3,0x64) and struct.unpack('>H',f[2:4])[0]&0xFFF not in(411,210,211,249,250,260)]
    print('   read',rd[:24],flush=True)
g('--set 418@2=350 --set 418@1=0 --set 434=2 --contact-set 2','0.00Hz',n=2)
g('--set 418@2=350 --set 418@1=0 --set 434=2 --contact-set 2','1Hz',n=2)
g('--set 418=0 --set 419@2=900 --set 434=3 --internal 12 --contact-set 2','10Hz',n=2)
g('--set 418=0 --set 419@2=900 --set 434=2 --contact-set 2','10Hz',n=1)
g('--set 418=0 --set 419=900 --set 434=3 --internal 12','10Hz',n=2)
g('--set 418=0 --set 419=900 --set 434=3 --internal 12','5Hz',n=1)
g('--set 418=0 --set 419=900 --set 434=3 --internal 3','10Hz',n=1)
g('--set 418=350 --set 434=2','0.00Hz',n=1)
g('--set 418=350 --set 434=2','1Hz',n=1)
