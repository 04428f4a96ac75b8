from sc import *
I=signal.SIGINT;T=signal.SIGTERM;K=signal.SIGKILL
def left(stw=0x47F,hsw=0x2000,**kw):
    def f(s):
        with s.lock:
            s.gw[928]=1; s.gw[703]=kw.get('p703',0); s.stw=stw; s.hsw=hsw; s.last_valid=(stw,hsw); s.bus_run=True; s.lostact='keep'; s.mode_b=False; s.out=25.0; s.shaft=25.0; s.seen_any=True
    return f
def bleft(s):
    with s.lock: s.basic=[0x4051,2500,20,20]; s.basic_sp=25.; s.bus_run=True; s.lostact='keep'; s.mode_b=True; s.out=25.; s.shaft=25.;s.basic_acc=s.basic_dec=2.
B=dict(getcfg='basic')
def nth(n): return lambda s:s.dx_count>=n
dx=lambda s:s.state=='dx'
wc=lambda s:s.state in('wait_cfg','dx')
C=[('left read',('read','F002'),left(),None,{},None),
('left diag',('diag',),left(),None,{},None),('left disable',('statemachine','disable'),left(),None,{},None),('left dv',('statemachine','disable-voltage'),left(),None,{},None),
('left qs',('statemachine','quick-stop'),left(),None,{},None),('left soll0',('sollwert','0Hz'),left(),None,{},None),('left sm',('statemachine',),left(),None,{},None),
('left live',('profibus','live'),left(),None,{},None),('left monitor',('monitor','--interval','100ms','--duration','2s'),left(),None,{},None),
('left b10 freeze disable',('statemachine','disable'),left(),None,dict(b10='freeze'),None),('left b10 local contact disable',('statemachine','disable'),left(),None,dict(b10='local',contact=True),None),
('left int@dx',('read','F002'),left(),[(dx,I)],{},None),('left int@cfg',('read','F002'),left(),[(wc,I)],{},None),('left int@dx freeze',('read','F002'),left(),[(dx,I)],dict(b10='freeze'),None),
('left int@3',('read','F002'),left(),[(nth(3),I)],{},None),('left int@dx contact local',('read','F002'),left(),[(dx,I)],dict(b10='local',contact=True),None),
('left kill@dx',('read','F002'),left(),[(nth(2),K)],{},None),
('contact read',('read','F002'),None,None,dict(contact=True),None),('contact disable',('statemachine','disable'),None,None,dict(contact=True),None),('contact 928=1 read',('read','F002'),None,None,dict(contact=True,p928=1),None),
('contact 928=1 b10local read',('read','F002'),None,None,dict(contact=True,p928=1,b10='local'),None),('contact run',RUN,None,None,dict(contact=True),None),('contact 928=1 disable',('statemachine','disable'),None,None,dict(contact=True,p928=1),None),
('contact soll0',('sollwert','0Hz'),None,None,dict(contact=True),None),
('B left disable',('statemachine','disable'),bleft,None,B,'l200'),('B left show',('statemachine','show'),bleft,None,B,'l200'),('B left diag',('diag',),bleft,None,B,'l200'),('B left soll0',('sollwert','0Hz'),bleft,None,B,'l200'),
('B left int@dx',('statemachine','show'),bleft,[(dx,I)],B,'l200'),('B contact disable',('statemachine','disable'),None,None,dict(getcfg='basic',contact=True),'l200'),('B contact run',BRUN,None,None,dict(getcfg='basic',contact=True),'l200'),
('B contact monitor',('monitor','--interval','200ms','--duration','2s'),None,None,dict(getcfg='basic',contact=True),'l200'),('B left monitor',('monitor','--interval','200ms','--duration','2s'),bleft,None,B,'l200'),
('B contact closes in run',BRUN,lambda s:s.when(lambda s:s.out>15,lambda s:s.o.update(contact=True),'contact closed'),None,B,'l200'),
('contact closes in run',RUN,lambda s:s.when(lambda s:s.out>15,lambda s:s.o.update(contact=True),'contact closed'),None,{},None),
('contact closes in run b10local 928=1',RUN,lambda s:s.when(lambda s:s.out>15,lambda s:s.o.update(contact=True),'contact closed'),None,dict(p928=1,b10='local'),None),
]
if __name__=='__main__':
    k=int(sys.argv[1]); n=int(sys.argv[2])
    for i,(nm,a,su,sg,o,dr) in enumerate(C):
        if i%n!=k: continue
        print('#',nm,o); S('c3-%d'%i,*a,opts=o,sig=sg,setup=su,after=1.5,drive=dr,msg=True)
