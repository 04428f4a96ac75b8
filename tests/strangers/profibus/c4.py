from sc import *
# line faults
rnd=random.Random(3)
def turn_only(f):
    def h(s,req,b): 
        return f(s,req,b) if s.turning else [(0,b)]
    return h
def drop(p): return lambda s,q,b: None if rnd.random()<p else [(0,b)]
def garble(p):
    def f(s,q,b):
        if rnd.random()<p:
            b=bytearray(b); b[rnd.randrange(len(b))]^=1<<rnd.randrange(8); b=bytes(b)
        return [(0,b)]
    return f
def bad(p): # bytes lost
    def f(s,q,b):
        if rnd.random()<p: b=b[:rnd.randrange(len(b))]
        return [(0,b)] if b else None
    return f
def dbl(p): return lambda s,q,b: [(0,b),(0.0,b)] if rnd.random()<p else [(0,b)]
def late(p,d): return lambda s,q,b: [(d,b)] if rnd.random()<p else [(0,b)]
def echo(s,q,b): return [(0,b)]
def noise(p): return lambda s,q,b: [(0,b),(0.001,bytes(rnd.randrange(256) for _ in range(5)))] if rnd.random()<p else [(0,b)]
def other(p): # reply from another station
    def f(s,q,b):
        if rnd.random()<p and b[0]==0x68:
            x=bytearray(b); x[5]=(x[5]&0x80)|7; x[-2]=sum(x[4:-2])&255; return [(0,bytes(x))]
        return [(0,b)]
    return f
def mute_after(t):
    def su(s): s.when(lambda s:s.out>15,lambda s:setattr(s,'mute',True),'mute')
    return su
def mute_for(t):
    def su(s):
        def on(s): s.mute=True; t1=time.monotonic(); s.when(lambda s:time.monotonic()-t1>t,lambda s:setattr(s,'mute',False),'unmute')
        s.when(lambda s:s.out>15,on,'mute')
    return su
def hk(h,always=True): return lambda s:setattr(s,'hook',h if always else turn_only(h))
def power(t=None):
    def su(s):
        def off(s):
            s.poweroff(); t1=time.monotonic()
            if t is not None: s.when(lambda s:time.monotonic()-t1>t,lambda s:s.poweron(),'on')
        s.when(lambda s:s.out>15,off,'off')
    return su
def ev(f,nm,cond=lambda s:s.out>15): return lambda s:s.when(cond,f,nm)
def setgw(k,v): return lambda s:s.gw.__setitem__(k,v)
B=dict(getcfg='basic')
NW=tuple(x for x in RUN if x not in('--watchdog','1s'))
C=[]
for nm,h in [('drop10',drop(.1)),('drop30',drop(.3)),('garble10',garble(.1)),('garble30',garble(.3)),('cut20',bad(.2)),('dbl30',dbl(.3)),('late20x40ms',late(.2,.04)),('late10x100ms',late(.1,.1)),('late5x400ms',late(.05,.4)),('noise20',noise(.2)),('other20',other(.2)),('late all 20ms',late(1,.02))]:
    C.append((nm,RUN,hk(h),{},None)); 
    if nm in('drop30','garble30','late20x40ms','noise20','dbl30','late5x400ms'): C.append(('B '+nm,BRUN,hk(h),B,'l200'))
C+=[('mute',RUN,mute_after(0),{},None),('mute .3',RUN,mute_for(.3),{},None),('mute .8',RUN,mute_for(.8),{},None),('mute 1.6 (wd 1)',RUN,mute_for(1.6),{},None),('mute 1.6 p703=0 nowd',NW,mute_for(2.6),dict(p703=0),None),('mute 8s',RUN,mute_for(8),{},None),
 ('B mute',BRUN,mute_after(0),B,'l200'),('B mute 1.0',BRUN,mute_for(1.),B,'l200'),('B mute 3',BRUN,mute_for(3.),B,'l200'),
 ('power off',RUN,power(),{},None),('power off/on 1',RUN,power(1),{},None),('power off/on 3',RUN,power(3),{},None),('B power off/on .2',BRUN,power(.2),B,'l200'),
 ('trip',RUN,ev(lambda s:s.do_trip(),'trip'),{},None),('trip nodiag',RUN,ev(lambda s:s.do_trip(),'trip'),dict(trip_diag='none',dh_on_trip=False),None),('B trip',BRUN,ev(lambda s:s.do_trip(),'trip'),B,'l200'),('B trip nodh cause0',BRUN,ev(lambda s:s.do_trip(0,1),'trip'),dict(getcfg='basic',trip_diag='none',dh_on_trip=False),'l200'),
 ('trip in stop',RUN,ev(lambda s:s.do_trip(),'trip',lambda s:s.stw==0x47e and s.out>5 and len(s.stws)>3),{},None),
 ('trip reset by hand',RUN,ev(lambda s:(s.do_trip(),s.reset_fault('hand')),'trip'),dict(restart='standing'),None),
 ('frs',RUN,ev(lambda s:setattr(s,'frs',True),'frs'),{},None),('B frs',BRUN,ev(lambda s:setattr(s,'frs',True),'frs'),B,'l200'),
 ('P928->0',RUN,ev(setgw(928,0),'928'),{},None),('P928->0 contact',RUN,ev(setgw(928,0),'928'),dict(contact=True),None),('forced local contact',RUN,ev(lambda s:setattr(s,'forced_local',True),'loc'),dict(contact=True),None),
 ('leave dx',RUN,ev(lambda s:s.leave('wd'),'leave'),{},None),('leave dx p703=0',NW,ev(lambda s:s.leave('wd'),'leave'),dict(p703=0),None),('B leave',BRUN,ev(lambda s:s.leave('wd'),'leave'),B,'l200'),
 ('no start',RUN,lambda s:setattr(s,'no_start',True),{},None),('B no start',BRUN,lambda s:setattr(s,'no_start',True),B,'l200'),('stuck',RUN,ev(lambda s:setattr(s,'stuck',True),'stuck'),{},None),('B stuck',BRUN,ev(lambda s:setattr(s,'stuck',True),'stuck'),B,'l200'),
 ('foreign token',RUN,ev(lambda s:(setattr(s,'foreign',time.monotonic()+.002),s.raw(bytes.fromhex('dc0202'))),'tok'),{},None),
 ('already tripped',RUN,lambda s:s.do_trip(),{},None),('B already tripped',BRUN,lambda s:s.do_trip(),B,'l200'),
]
if __name__=='__main__':
    k=int(sys.argv[1]); n=int(sys.argv[2]); sel=sys.argv[3:] 
    for i,(nm,a,su,o,dr) in enumerate(C):
        if (sel and str(i) not in sel) or (not sel and i%n!=k): continue
        print('#',nm,o); S('c4-%d'%i,*a,opts=o,setup=su,after=1.5,drive=dr,msg=True)
