from nov import *
for dr in (['--drive','acu'],[]):
  for i in range(4):
    d=Cube('--set 418=0 --set 638=5'); c=run([d],dr+['-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','1s','--yes'],quiet=True,maxt=40)
    t7=[t for t,w in c.words if w.endswith('=0x7')][-1]
    print(dr,'rc',c.rc,'%.1fs'%c.dur,'first word %.2f'%c.words[0][0],[l[:120] for l in c.err.split('\n') if l.startswith('error')],flush=True)
    if c.rc:
        off=[h[0] for h in c.hist if h[1][0][0]=='switched on' and h[0]>t7][:1]; zero=[h[0] for h in c.hist if h[1][0][1]==0 and h[0]>t7][:1]
        print('  0x7 at %.2f zero at %s off at %s'%(t7,zero,off)); print('\n'.join('   %.3f %s %s'%l for l in c.log if t7-.05<l[0]<t7+2))
