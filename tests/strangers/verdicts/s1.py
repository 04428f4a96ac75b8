"""sweep: something happens at telegram k.  python3 s1.py KIND FAM [from to step]"""
from j import *
def mk(f):
    if f=='acu': return Cube('--family acu --set 418=0 --set 412=0 --no-start --set 434=3 --set 638=5',1)
    if f=='acu1': return Cube('--family acu --set 418=0 --set 412=1 --set 434=3 --set 638=5 --internal 3',1)
    if f=='act': return Cube('--family act --set 418=0 --set 412=1 --set 434=3 --set 638=5',1)
    if f=='lx': d=Lx(1,left='RAMPacc=300,PVn_target=900,DCOMopmode=3'); return d
    if f=='lxg': d=Lx(1,left='DCOMopmode=-2,GEARreference=1',guard_state='quick-stop'); return d
def args(f,ex='ramp'):
    if f.startswith('lx'): return ['--drive','lxm05','-a','1','sollwert','300rpm','--enable','--hold','--duration','700ms','--yes','--on-exit',ex,'--watchdog','2s','--set','RAMPacc=2000','--json']
    return ['-a','1']+(['--take-control'] if False else [])+['sollwert','10Hz','--source','line','--enable','--hold','--duration','700ms','--yes','--on-exit',ex,'--watchdog','2s','--json']+(['--take-control'] if f=='acu' else [])
kind,fam=sys.argv[1:3]; ks=range(*map(int,sys.argv[3:6])) if len(sys.argv)>3 else range(1,70)
for k in ks:
    d=mk(fam); hook=None; tr=[]
    if kind in('int','term','hup'): tr=[(N(k),{'int':INT,'term':TERM,'hup':HUP}[kind])]
    if kind=='int2': tr=[(N(k),INT),(N(k,.15),INT)]
    if kind=='int3': tr=[(N(k),INT),(N(k,.1),INT),(N(k,.2),INT)]
    if kind=='dead': tr=[(N(k),mute(True))]
    if kind=='deaf': tr=[(N(k),lambda c:setattr(c,'mute',True))]
    if kind=='gap': tr=[(N(k),mute(True)),(N(k,2.5),mute(False))]
    if kind=='gapint': tr=[(N(k),lambda c:setattr(c,'mute',True)),(N(k,.3),INT),(N(k,3),lambda c:setattr(c,'mute',False))]
    if kind=='unplug': tr=[(N(k),lambda c:c.unplug())]
    if kind=='exc': hook=lambda c,f,r,now,dd:[(.01,crc(bytes([f[0],f[1]|0x80,4])) if c.n==k else r)]
    if kind=='excall':
        hook=lambda c,f,r,now,dd:[(.01,crc(bytes([f[0],f[1]|0x80,6])) if c.n>=k else r)]
    if kind=='lost': hook=lambda c,f,r,now,dd:[] if c.n==k else [(.01,r)]
    if kind=='late': hook=lambda c,f,r,now,dd:[(.9 if c.n==k else .01,r)]
    if kind=='late26': hook=lambda c,f,r,now,dd:[(2.6 if c.n==k else .01,r)]
    if kind=='dbl': hook=lambda c,f,r,now,dd:[(.01,r)]+([(.35,r)] if c.n>=k else [])
    if kind=='prev':
        st={}
        def hook(c,f,r,now,dd):
            o=st.get('p',r); st['p']=r; return [(.01,o if c.n==k else r)]
    if kind=='trip': tr=[(N(k),setx(lambda x:x.trip(0x0500,time.monotonic()) if hasattr(x,'trip') else x.fault()))]
    if kind=='enlost': tr=[(N(k),setx(lambda x:setattr(x,'enable',False)))]
    if kind=='enblink': tr=[(N(k),setx(lambda x:setattr(x,'enable',False))),(N(k,.3),setx(lambda x:setattr(x,'enable',True)))]
    if kind=='reboot': tr=[(N(k),setx(lambda x:x.reboot(time.monotonic()) if hasattr(x,'reboot') else x.power_cycle()))]
    if kind=='set2': tr=[(N(k),setx(lambda x:setattr(x,'contact_set',2)))]
    d.advance(time.monotonic())
    c=run([d],args(fam),hook=hook,triggers=tr,maxt=90,quiet=True,after=.6)
    bad,doc=judge(c,d,clean=kind in('int','term','hup','lost','exc'))
    if c.n<k: bad.append('(n %d)'%c.n)
    line('%s %s k%d'%(kind,fam,k),c,bad,'n=%d'%c.n)
    if [b for b in bad if not b.startswith('(')]: show(c) if '-v' in sys.argv else None
    if c.n<k: break
