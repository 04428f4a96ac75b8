from g3 import *
NW=tuple(x for x in RUN if x not in('--watchdog','1s'))
# foreign master in a run with P.703=0, no watchdog set
S('h1-f703',*NW,opts=dict(p703=0),setup=lambda s:master(s,.05,lambda s:s.out>15,3,'dx'),after=6,msg=True)
S('h1-fB620',*BRUN,opts=dict(getcfg='basic',basic_lost='either',p620=1),setup=lambda s:master(s,.05,lambda s:s.out>15,3,'dx'),after=6,msg=True,drive='l200')
# port lost: close the pty master
def plost(s):
    def f(s):
        s.log('PORT LOST'); s.lostport=True
        os.close(s.m)
    s.when(lambda s:s.out>15,f,'lost')
for nm,a,o,d in (('h1-port',RUN,{},None),('h1-portB',BRUN,dict(getcfg='basic'),'l200'),('h1-portread',('read','F002','F003','614'),{},None)):
    s=Slave(nm,**o); s.start()
    if 'read' in nm: s.when(lambda s:s.dx_count>5,lambda s:os.close(s.m),'lost')
    else: plost(s)
    # slave side kept open by us: close it too so the tool gets EIO/HUP
    os.close(s.sl)
    try:
        r=run(s,*a,'--json',quiet=True,timeout=40,drive=d)
        e=(r.j or {}).get('error') or {}
        print(nm,'rc',r.rc,'%.1f'%r.t,summ(r),'\n   ',e.get('message'),'|',e.get('hint'))
    except Exception as x: print(nm,x)
    s.stopme=True
# pty that takes no bytes: stop reading (peer thread frozen) 
# closed pipe
def pipe(nm,a,o={},d=None,setup=None):
    s=Slave(nm,**o); s.start()
    if setup: setup(s)
    c=cmd(s,*a,drive=d)
    p=subprocess.Popen(c,stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE,env=ENV)
    t=time.monotonic()
    while not (s.out>15 or time.monotonic()-t>4): time.sleep(.01)
    p.stdout.close(); p.stderr.close()
    try: p.wait(30); print(nm,'rc',p.returncode,'%.1f'%(time.monotonic()-t),'turn',s.turning,'sins',s.sins[:2],[w[1:] for w in s.writes])
    except subprocess.TimeoutExpired: p.kill(); print(nm,'HANG turn',s.turning)
    time.sleep(1); s.close()
pipe('h1-pipe',RUN); pipe('h1-pipe2',('monitor','--interval','0','--format','ndjson')); pipe('h1-pipe3',BRUN,dict(getcfg='basic'),'l200')
