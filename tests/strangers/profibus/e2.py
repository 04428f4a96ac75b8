from sc import *
def ign(*ps):
    def su(s):
        o=s.do_write
        def dw(p,v,how):
            if p in ps: s.log('IGNORED write P.%d=%d'%(p,v)); s.writes.append((0,p,('ign',v))); return None
            return o(p,v,how)
        s.do_write=dw
    return su
def ign_after(p,n):
    def su(s):
        o=s.do_write; c=[0]
        def dw(q,v,how):
            if q==p:
                c[0]+=1
                if c[0]>n: s.log('IGNORED write P.%d=%d'%(p,v)); s.writes.append((0,p,('ign',v))); return None
            return o(q,v,how)
        s.do_write=dw
    return su
def refuse_after(p,n,e):
    def su(s):
        o=s.do_write; c=[0]
        def dw(q,v,how):
            if q==p:
                c[0]+=1
                if c[0]>n: s.log('REFUSED write'); return e
            return o(q,v,how)
        s.do_write=dw
    return su
def noans(p,execute,wonly=True):
    def su(s):
        o=s.pkw_exec
        def ex(q,now):
            pp=(q[0]<<8|q[1])&0x7FF
            if pp==p and (not wonly or q[0]>>4 in(2,7)):
                if execute: o(q,now)
                s.log('no answer'); return None
            return o(q,now)
        s.pkw_exec=ex
    return su
def D(**k): return k
C=[('w ignored',('write','F002=5s'),ign(7),{},None),('w noans exec',('write','F002=5s'),noans(7,True),{},None),('w noans noexec',('write','F002=5s'),noans(7,False),{},None),('r noans',('read','F002','614'),noans(7,False,False),{},None),
('928 ignored',RUN,ign(928),{},None),('928 refused',RUN,refuse_after(928,0,17),{},None),('703 ignored p703=0',RUN,ign(703),dict(p703=0),None),('703 refused p703=0',RUN,refuse_after(703,0,11),dict(p703=0),None),
('928 giveback ign',RUN,ign_after(928,1),{},None),('928 giveback refused',RUN,refuse_after(928,1,17),{},None),('703 giveback refused',RUN,refuse_after(703,1,17),dict(p703=0),None),('703 giveback noans',RUN,lambda s:s.when(lambda s:s.out>15,lambda s:noans(703,False)(s),'x'),dict(p703=0),None),
('all pkw dies in run',RUN,lambda s:s.when(lambda s:s.out>15,lambda s:setattr(s,'pkw_exec',lambda q,n:None),'x'),{},None),
('pkw 101 in run',RUN,lambda s:s.when(lambda s:s.out>15,lambda s:s.gw.__setitem__(927,0),'x'),{},None),
('w 915.1=34',('write','915.1=34'),None,{},None),('w 915.1=605',('write','915.1=605'),None,{},None),('w 915.9',('write','915.9=34'),None,{},None),('w 614',('write','614=1'),None,{},None),('w 928=1 contact',('write','928=1'),None,dict(contact=True),None),
('w 605=1 928',('write','605=1'),None,dict(p928=1),None),('w 927=0',('write','927=0'),None,{},None),('w 927=1 locked',('write','927=1'),None,dict(p927=0),None),('w 704=2',('write','704=2'),None,{},None),('w 703=7',('write','703=7'),None,{},None),('w 703=0',('write','703=0'),None,{},None),('w F002=99.99s',('write','F002=99.99s'),None,{},None),('w F002=100s',('write','F002=100s'),None,{},None),('w F002=3000s',('write','F002=3000s'),None,dict(neg_pwe='FFFF'),None),('w F002=0.01s',('write','F002=0.01s'),None,dict(neg_pwe='FFFF'),None),('w F002=99.995',('write','F002=99.995s'),None,{},None),('w same',('write','F002=2s'),None,{},None),
('w multi partial',('write','F002=5s','F003=6s','A038=5Hz'),refuse_after(9,0,17),{},None),
('pkw every write',('write','F002=5s'),None,dict(pkw_repeat='every'),None),('w A004',('write','A004=60Hz'),None,{},None),
('userprm needed',('read','F002'),None,dict(pd_userprm=b'\x00\x00'),None),('userprm needed prm',('read','F002'),None,dict(pd_userprm=b'\x00\x00',wrong_series='prm',modes=('ppo1',)),None),('userprm given',('read','F002','--user-prm','00 00'),None,dict(pd_userprm=b'\x00\x00'),None),
('only basic',('read','F002'),None,dict(modes=('basic',),getcfg='basic'),None),('only basic run',RUN,None,dict(modes=('basic',),getcfg='basic'),None),
('B wrong series cfg',BRUN,None,dict(getcfg='basic',series='sj200'),'l200'),('B wrong series prm',BRUN,None,dict(getcfg='basic',series='x200',wrong_series='prm',modes=('basic',)),'l200'),('B x200',BRUN,None,dict(getcfg='basic',series='x200'),'x200'),('B prefix',BRUN+('--user-prm','00 00 00 C7 FF FF'),None,dict(getcfg='basic',prefix=b'\0\0\0'),None),
('never ready',('read','F002'),None,dict(ready_after=60),None),('B no series',BRUN,None,dict(getcfg='basic'),None),('auto mode no series',('sollwert','20Hz','--jog','1s'),None,dict(getcfg='basic',modes=('basic',)),None),
('drive mismatch',('read','F002'),None,dict(series='x200'),'l200'),('drive mismatch run',RUN,None,dict(series='sj200'),'l200'),
('wrong 9600',('profibus','live'),None,dict(baud=9600),None),
('run 150%',('sollwert','150%','--jog','1s','--take-control'),None,{},None),('run 60Hz of 50',('sollwert','60Hz','--jog','1s','--take-control'),None,{},None),('run no take',('sollwert','20Hz','--jog','1s'),None,{},None),('run left',('sollwert','-20Hz','--jog','1s','--take-control'),None,{},None),('run left abs',('sollwert','-20Hz','--jog','1s','--take-control'),None,dict(hiw_signed=False),None),('run until',('sollwert','20Hz','--jog','1s','--take-control','--until','reached'),None,{},None),('pct',('sollwert','30%','--jog','1s','--take-control'),None,{},None),
('a204 second set',RUN,lambda s:s.gw.__setitem__(607,1),{},None),('p611 wrong',RUN,lambda s:s.o.update(a004=60.0),dict(a004=50.0),None),
]
if __name__=='__main__':
    k=int(sys.argv[1]); n=int(sys.argv[2]); sel=sys.argv[3:]
    for i,(nm,a,su,o,dr) in enumerate(C):
        if (sel and str(i) not in sel) or (not sel and i%n!=k): continue
        print('#',i,nm,o); S('e2-%d'%i,*a,opts=o,setup=su,after=0.2,drive=dr,msg=True)
