from c3 import left,bleft
from sc import *
import sys
I=signal.SIGINT;K=signal.SIGKILL
wc=lambda s:s.state in('wait_cfg','dx'); dx=lambda s:s.state=='dx'
def over(**kw):
    def su(s):
        if 'hiw' in kw: s.hiw=lambda:kw['hiw']
        if 'hiw_run' in kw:
            o=s.hiw; s.hiw=lambda: kw['hiw_run'] if s.turning else o()
        if 'p614' in kw:
            o=s.value; s.value=lambda p,sub=0: kw['p614'] if p==614 else o(p,sub)
        if 'p611' in kw:
            o=s.value; s.value=lambda p,sub=0: kw['p611'] if p==611 else o(p,sub)
        if 'p600' in kw:
            o=s.value; s.value=lambda p,sub=0: kw['p600'] if p==600 else o(p,sub)
        if 'zsw' in kw: s.zsw=lambda:kw['zsw']
        if 'zor' in kw:
            o2=s.zsw; s.zsw=lambda:o2()|kw['zor']
    return su
def dhper(T):
    def su(s):
        def f():
            while not s.stopme:
                time.sleep(T)
                with s.lock:
                    if s.state=='dx': s.dh=True
        threading.Thread(target=f,daemon=True).start()
    return su
def ans(fc,p,cond=lambda s:s.turning):
    def su(s):
        def h(s,q,b):
            if b[0]==0x68 and cond(s) and len(b)>16 and random.random()<p: return [(0,s.sd1(0,3,fc))]
            return [(0,b)]
        s.hook=h
    return su
def sd3(s):
    def h(s,q,b):
        if b[0]==0x68 and b[1]==11: return [(0,b'\xa2'+b[4:])]
        return [(0,b)]
    s.hook=h
def wronglen(p):
    def su(s):
        def h(s,q,b):
            if s.turning and b[0]==0x68 and len(b)>16 and random.random()<p:
                x=b[4:-2]+b'\0\0'; return [(0,b'\x68'+bytes([len(x)]*2)+b'\x68'+x+bytes([sum(x)&255,0x16]))]
            return [(0,b)]
        s.hook=h
    return su
def stale(n):
    "every reply is the one n exchanges before"
    def su(s):
        q_=[]
        def h(s,q,b):
            if b[0]==0x68 and len(b)>16: q_.append(b); 
            else: q_.clear()
            return [(0,q_[-1-n] if b[0]==0x68 and len(b)>16 and len(q_)>n else b)]
        s.hook=h
    return su
NW=tuple(x for x in RUN if x not in('--watchdog','1s'))
C=[('F2 freeze keep int@cfg',('read','F002'),left(),[(wc,I)],dict(dx_keep=True,b10='freeze'),None),('F2 freeze keep int@dx',('read','F002'),left(),[(dx,I)],dict(dx_keep=True,b10='freeze'),None),('F2 disable int@dx',('statemachine','disable'),left(),[(dx,I)],dict(dx_keep=True,b10='freeze'),None),('F2 B int@dx contact',('statemachine','show'),bleft,[(dx,I)],dict(getcfg='basic',contact=True,dx_keep=True),'l200'),('F2 B disable term@dx contact',('statemachine','disable'),bleft,[(dx,signal.SIGTERM)],dict(getcfg='basic',contact=True,dx_keep=True),'l200'),
('HIW 0 always',RUN,over(hiw=0),None,{},None),('HIW stuck run',RUN,over(hiw_run=0x1999),None,{},None),('P614 stuck',RUN,over(p614=500),None,{},None),('P614 stuck read',('read','F002'),over(p614=500),None,{},None),('P614 0 always',RUN,over(p614=0),None,{},None),('P611 0',RUN,over(p611=0),None,{},None),('P600 0',RUN,over(p600=0),None,{},None),('P600 1',RUN,over(p600=1),None,{},None),('ZSW bit7',RUN,over(zor=0x80),None,{},None),('ZSW hi bits',RUN,over(zor=0xF800),None,{},None),('ZSW bit6',RUN,over(zor=0x40),None,{},None),('ZSW 0',RUN,over(zsw=0),None,{},None),('ZSW 0 disable left',('statemachine','disable'),lambda s:(left()(s),over(zsw=0)(s)),None,{},None),
('DH each 300ms',RUN,dhper(.3),None,{},None),('DH each 40ms',RUN,dhper(.04),None,{},None),('DH B',BRUN,dhper(.2),None,dict(getcfg='basic'),'l200'),('DH monitor',('monitor','--duration','2s','--interval','100ms'),dhper(.3),None,{},None),
('RR 20%',RUN,ans(2,.2),None,{},None),('NR 20%',RUN,ans(9,.2),None,{},None),('UE once-ish',RUN,ans(1,.05),None,{},None),('RS 100%',RUN,ans(3,1.0),None,{},None),('sd3 replies',BRUN,sd3,None,dict(getcfg='basic'),'l200'),('wrong len 20%',RUN,wronglen(.2),None,{},None),('stale 1',RUN,stale(1),None,{},None),('stale 3',RUN,stale(3),None,{},None),('stale 3 B',BRUN,stale(3),None,dict(getcfg='basic'),'l200'),
('reset no fault',('statemachine','reset'),None,None,{},None),('reset sticky',('statemachine','reset'),lambda s:(s.do_trip(),setattr(s,'sticky',True)),None,{},None),('reset standing contact',('statemachine','reset'),lambda s:s.do_trip(),None,dict(contact=True),None),('reset contact 928=1',('statemachine','reset'),lambda s:s.do_trip(),None,dict(contact=True,p928=1),None),('B reset contact',('statemachine','reset'),lambda s:s.do_trip(),None,dict(getcfg='basic',contact=True),'l200'),('B reset sticky',('statemachine','reset'),lambda s:(s.do_trip(),setattr(s,'sticky',True)),None,dict(getcfg='basic'),'l200'),('reset left run standing',('statemachine','reset'),lambda s:(left()(s),s.do_trip()),None,dict(restart='standing'),None),
]
if __name__=='__main__':
    k=int(sys.argv[1]); n=int(sys.argv[2]); sel=sys.argv[3:]
    for i,(nm,a,su,sg,o,dr) in enumerate(C):
        if (sel and str(i) not in sel) or (not sel and i%n!=k): continue
        print('#',i,nm,o); S('k1-%d'%i,*a,opts=o,setup=su,sig=sg,after=1.5,drive=dr,msg=True,json_='monitor' not in a)
