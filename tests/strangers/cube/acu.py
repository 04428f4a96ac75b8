#!/usr/bin/env python3
"""A strict ACTIVE Cube behind CM-485, written from the manual. Serves a pty; ends by itself.
usage: acu.py CONFIG-JSON ; commands on stdin, one a line; JSON lines on stdout; log file of all telegrams."""
import os, sys, json, time, select, tty, termios, random, fcntl, struct
C=dict(life=60, addr=1, ascii=0, baud=19200, parity='even', delay=0.010, delay_rnd=0.0, slow_after=None, slow=0.7,
  p412=44, sto=True, s2=True, s3=False, mains=True, conf=110, p392=2, fmin=350, fmax=5000, accel=10.0, decel=10.0,
  estop=20.0, coast=4.0, thr=10, hold=0.5, intset=0, p434=3, p413=0, p413ee=None,
  cw='level',            # level|edge
  ram_read='value',      # value|refused|eeprom(set 0-4 read gives eeprom copy)
  unknown=2,             # exception for unknown parameter
  p412_run='ok',         # ok|refused : writes to P412 while running
  p413_run='ok',
  coast_shows=0,         # 1: P.210/241 show the coasting shaft
  reset_remote=False, bit4='mains',  # mains | table (0 in switched-on)
  p410_read=True, contacts_edge=False, frozen=False, ee_busy=0.0, pieces=None, both='stop',
  qs_end='auto', faultlock=15.0, warn=0, p241=True, p250=True, p217=True, reset_to='sod', echo=False, refuse=[], dead_after_writes=None,
  lie410=False, params={})
C.update(json.loads(sys.argv[1]) if len(sys.argv)>1 else {})
LOG=open(C.get('log','/dev/null'),'w',buffering=1)
T0=time.monotonic()
def now(): return time.monotonic()-T0
def log(*a): LOG.write('%9.3f '%now()+' '.join(str(x) for x in a)+'\n')
def out(o): sys.stdout.write(json.dumps(o)+'\n'); sys.stdout.flush()
random.seed(C.get('seed',1))
# ---------- parameters: number -> [type, per-data-set, access, min, max, values(4 or 1)]
P={}
def par(n,t,ds=False,acc='rw',lo=None,hi=None,v=0,run=True):
    P[n]=dict(t=t,ds=ds,acc=acc,lo=lo,hi=hi,ee=[v]*4 if ds else [v],ram=[v]*4 if ds else [v],run=run)
U,S,L,I='u16','i16','i32','u32'
par(10,U,lo=1,hi=6,v=4); par(11,U,acc='r'); par(30,U,v=C['conf'],run=False); par(34,U,lo=0,hi=9999,run=False)
par(68,U,v=71); par(69,U,v=72); par(103,U,v=7)
for n in(210,241,217,219,228,229,282,283): par(n,L,acc='r')
for n in(211,213,218,220): par(n,S,acc='r')
for n in(249,250,254,260,269,270,411): par(n,U,acc='r')
par(269,U,acc='r')
par(372,U,True,lo=0,hi=60000,v=1390,run=False); par(373,U,True,lo=1,hi=24,v=2,run=False); par(375,L,True,lo=1000,hi=100000,v=5000,run=False); par(376,U,True,lo=1,hi=10000,v=40,run=False)
par(392,U,True,lo=0,hi=2,v=C['p392']); par(394,U,lo=1,hi=30,v=1); par(395,U,lo=0,hi=3,v=3 if C['ascii'] else 2)
par(400,U,lo=1,hi=8,v=2)
par(410,U); par(412,U,True,lo=0,hi=44,v=C['p412']); par(413,U,lo=0,hi=10000,v=C['p413']); par(414,U,lo=0,hi=4,v=0)
par(418,L,True,lo=0,hi=99999,v=C['fmin']); par(419,L,True,lo=0,hi=99999,v=C['fmax'])
for n,x in((420,'accel'),(421,'decel'),(422,'accel'),(423,'decel'),(424,'estop'),(425,'estop')): par(n,L,True,lo=1,hi=999999,v=int(C[x]*100))
par(434,U,True,lo=1,hi=3,v=C['p434']); par(475,U,True,v=1); par(476,U,True,v=1)
for i,n in enumerate((480,481,482,483,485,486,487,488)): par(n,L,True,lo=-99900,hi=99900,v=500*(i+1))
par(484,L,acc='w',lo=-99999,hi=99999); par(524,L,acc='w',lo=-30000,hi=30000); par(518,L,True,lo=0,hi=30000); par(519,L,True,lo=0,hi=30000,v=10000)
par(549,U,lo=1,hi=2000,v=500); par(632,U,True,lo=0,hi=2000,v=20); par(637,U,True,lo=0,hi=1000,v=C['thr']); par(638,U,True,lo=0,hi=2000,v=int(C['hold']*10))
par(600,U,True,lo=0,hi=1000,v=50); par(601,S,True,lo=-100,hi=200,v=10); par(602,U,True,lo=0,hi=100,v=20); par(603,U,True,lo=600,hi=5600,v=4000); par(604,L,True,lo=0,hi=59900,v=5000)
par(1375,U,lo=0,hi=2,v={'even':0,'odd':1,'none':2}[C['parity']]); par(1376,U,lo=1,hi=247,v=C['addr'])
if C['p413ee'] is not None: P[413]['ee']=[C['p413ee']]
if not C['p241']: P.pop(241)
if not C['p250']: P.pop(250)
if not C['p217']: P.pop(217); P.pop(218)
for k,v in C['params'].items():
    n=int(k)
    if isinstance(v,list): P[n]['ram']=list(v); P[n]['ee']=list(v)
    else: P[n]['ram']=[v]*len(P[n]['ram']); P[n]['ee']=[v]*len(P[n]['ee'])
EEW={}   # eeprom writes counted
VIOL=[]
class Drive: pass
D=Drive()
D.state='SOD'; D.cw=0; D.cwprev=0; D.lastsign=1; D.f=0.0; D.shaft=0.0; D.stopping=None; D.below=None; D.fault=0; D.fault_t=None; D.lastok=now()
D.sst=0; D.warn=C['warn']; D.t=now(); D.dead_until=0; D.sto=C['sto']; D.s2=C['s2']; D.s3=C['s3']; D.mains=C['mains']; D.writes=0; D.maxf=0.0
D.starts=0; D.cnt=[0]*9; D.dc_end=0; D.newcw=False; D.torque_limit=False; D.stuck=False; D.stall=False; D.lastfault=0
def aset():
    v=P[414]['ram'][0]; return v if v else 1
def g(n):
    p=P[n]; return p['ram'][aset()-1] if p['ds'] else p['ram'][0]
def setstate(s,why=''):
    if s!=D.state: log('STATE',D.state,'->',s,why,'f=%.2f shaft=%.2f'%(D.f,D.shaft)); D.state=s; 
def mode():
    m=g(412); return m
def conts():
    "enable, right, left"
    if mode()==2:
        return D.sto and D.cw&1, bool(D.cw&2), bool(D.cw&4)
    return D.sto,D.s2,D.s3
def mainsok(): return D.mains
def release():
    e,r,l=conts(); return bool(e and (r or l))
def internal():
    i=C['intset']/100.; lo=g(418)/100.; hi=g(419)/100.
    if abs(i)<lo: i=-lo if i<0 else lo
    return max(-hi,min(hi,i))
def target():
    i=internal(); ln=P[484]['ram'][0]/100.
    if ln: D.lastsign=1 if ln>0 else -1
    m=g(434); s={1:i,2:ln,3:i+ln}[m]
    lo=g(418)/100.; hi=g(419)/100.
    if mode()!=1:
        e,r,l=conts()
        if l and not r: s=-s
    if m==2 and abs(s)<lo: s=(D.lastsign if s==0 else (1 if s>0 else -1))*lo
    return max(-hi,min(hi,s))
def trip(code):
    D.fault=code; D.lastfault=code; D.fault_t=now(); setstate('FAULT','F%04X'%code); D.f=0; D.stopping=None
def word():
    s={'SOD':0x40,'RTSO':0x21,'SO':0x23,'OE':0x27,'QSA':0x07,'FRA':0x0F,'FAULT':0x08}[D.state]
    if D.mains:
        if not(C['bit4']=='table' and mode()!=1 and D.state=='SO'): s|=0x10
    if D.warn: s|=0x80
    if mode()==1 and release(): s|=0x200
    if mode()==2 and D.sto: s|=0x200
    if D.state=='OE' and abs(D.f-(0 if D.stopping else target()))<0.05*max(1,abs(target()))*0.2: s|=0x400
    if D.warn&0x89: s|=0x8000
    if D.stall: s|=0x800
    return s
def command():
    "state machine in mode 1; one transition per call"
    c=D.cw&0x0F; w=D.cw
    if D.state in('FAULT','FRA'): return False
    dv=not(w&2); qs=(w&6)==2; sd=(w&7)==6; so=(w&7)==7; eo=(w&15)==15
    s=D.state
    if D.stopping=='dc': return False
    if s=='SOD':
        if sd: setstate('RTSO','2'); return True
        if eo and C['conf']%100!=40 and D.mains and release(): setstate('OE',"4'"); D.stopping=None; D.starts+=1; return True
    elif s=='RTSO':
        if dv or qs: setstate('SOD','7'); return True
        if so and D.mains: setstate('SO','3'); return True
    elif s=='SO':
        if sd: setstate('RTSO','6'); return True
        if dv or qs: setstate('SOD','10'); return True
        if eo and release() and D.mains: setstate('OE','4'); D.stopping=None; D.starts+=1; return True
    elif s=='OE':
        if sd: D.stopping=None; setstate('RTSO','8'); return True
        if dv: D.stopping=None; setstate('SOD','9'); return True
        if qs: D.stopping=None; D.below=None; setstate('QSA','11'); return True
        if so and not w&8:
            if D.stopping: return False
            m=g(392)
            if m==0: setstate('SO','5 coast')
            elif m==1: D.stopping='dc'; D.dc_end=now()+g(632)/10.; log('DC brake')
            else: D.stopping='ramp'; D.below=None; log('RAMP stop')
            return True
        if eo and D.stopping=='ramp': D.stopping=None; log('ramp reversed'); return True
    elif s=='QSA':
        if dv: setstate('SOD','12'); return True
    return False
def toward(f,t,up,down,dt):
    if f==t: return t
    r=(up if abs(t)>abs(f) and t*f>=0 else down)*dt
    return min(t,f+r) if t>f else max(t,f-r)
def tick():
    t=now(); dt=t-D.t; D.t=t
    if dt<=0: return
    # watchdog
    wd=P[413]['ram'][0]
    if wd and t-D.lastok>wd and D.state!='FAULT': log('WATCHDOG'); trip(0x2010)
    m=mode()
    if D.state=='FRA': setstate('FAULT','14')
    if m==1:
        if not D.mains and D.state in('OE','QSA','SO'): setstate('SOD','mains off')
        if D.state in('OE','QSA') and not release():
            setstate('SO','enable lost'); D.stopping=None; D.newcw=False
        if C['cw']=='level':
            for _ in range(4):
                if not command(): break
        elif D.newcw:
            D.newcw=False; command()
    else:
        if D.state!='FAULT':
            go=release() and D.mains
            if m==44 and C.get('m44_keypad'): go=False
            if C['contacts_edge'] and not D.edge_seen and D.state!='OE': go=False
            e,r,l=conts()
            if r and l and C['both']=='stop': go=False
            if go and D.state!='OE': setstate('OE','contacts'); D.stopping=None; D.starts+=1
            if not go:
                if D.state=='OE':
                    if not e or not D.mains: setstate('SO','enable off')
                    elif D.stopping!='ramp': D.stopping='ramp'; D.below=None
                elif D.state!='SO': setstate('SO','contacts')
            elif D.state=='OE': D.stopping=None
    thr=g(637)/1000.*g(419)/100.
    if D.state=='OE':
        tg=0 if D.stopping else target()
        if D.stopping=='dc':
            D.f=toward(D.f,0,1,C['decel'],dt)
            if t>=D.dc_end: D.stopping=None; D.f=0; setstate('SO','dc end'); D.newcw=False
        elif not D.stuck: D.f=toward(D.f,tg,g(420)/100.,g(421)/100.,dt)
        if D.stopping=='ramp':
            if abs(D.f)<=thr:
                if D.below is None: D.below=t
                if t-D.below>=g(638)/10.: D.stopping=None; D.f=0; setstate('SO','5 ramp done')
            else: D.below=None
        D.shaft=D.f
    elif D.state=='QSA':
        D.f=toward(D.f,0,1,g(424)/100.,dt); D.shaft=D.f
        if abs(D.f)<=thr:
            if D.below is None: D.below=t
            if t-D.below>=g(638)/10. and C['qs_end']=='auto': D.f=0; setstate('SOD','12 standstill')
        else: D.below=None
    else:
        D.shaft=toward(D.shaft,0,1,C['coast'],dt)
        D.f=D.shaft if C['coast_shows'] else 0.0
        D.below=None
    D.maxf=max(D.maxf,abs(D.shaft))
D.edge_seen=False
def getval(n,si):
    if n==11: v=D.sst; D.sst=0; return v
    if n==210: return round(D.f*100)
    if n==241: return round(D.f*100)
    if n==217: return round((D.shaft if C.get('encoder') else 0)*100)
    if n==218: return round((D.shaft if C.get('encoder') else 0)*30)
    if n==211: return 32 if D.state=='OE' else 0
    if n==213: return round(abs(D.f)*0.1)
    if n==228: return round(internal()*100)
    if n==229: return 0
    if n==282: return P[484]['ram'][0]
    if n==283: return round((0 if D.stopping or D.state!='OE' else target())*100)
    if n==249: return aset()
    if n==250:
        e,r,l=conts() if mode()==2 else (D.sto,D.s2,D.s3)
        return (1 if e else 0)|(2 if r else 0)|(4 if l else 0)
    if n==260: return D.fault
    if n==270: return D.warn
    if n==411: return word()
    if n==410: return D.cw
    return None
class Exc(Exception):
    def __init__(s,c,sst=None): s.c=c; s.sst=sst
def acc(addr,size,write):
    n=addr&0xFFF; ds=addr>>12
    if ds>9 or n>1599 or n not in P: raise Exc(C['unknown'] if n<1600 else 4,11)
    p=P[n]
    if (p['t'] in(L,I))!=(size==32): raise Exc(2,14)
    if ds%5 and not p['ds']: raise Exc(4,2)
    if n in(410,484,524) and ds!=0: raise Exc(4,2)
    if ds>=5 and not write and C['ram_read']=='refused': raise Exc(4,2)
    return n,p,ds
def running(): return D.state in('OE','QSA')
def rd(addr,size):
    n,p,ds=acc(addr,size,False)
    if p['acc']=='w' or (n==410 and not C['p410_read']): raise Exc(4,3)
    v=getval(n,0)
    if v is None:
        a=p['ram'] if (ds>=5 or C['ram_read']!='eeprom') else p['ee']
        k=ds%5
        if p['ds'] and k==0:
            if len(set(a))>1: raise Exc(4,9)
            v=a[0]
        else: v=a[k-1] if p['ds'] else a[0]
    return v&(0xFFFFFFFF if size==32 else 0xFFFF)
def wr(addr,v,size):
    n,p,ds=acc(addr,size,True)
    if p['acc']=='r': raise Exc(4,4)
    if n in C['refuse'] : raise Exc(4,15)
    if size==32 and v>=1<<31: v-=1<<32
    if p['t']==S and v>=1<<15: v-=1<<16
    if p['lo'] is not None and v<p['lo'] or p['hi'] is not None and v>p['hi']: raise Exc(4,1)
    if running():
        if not p['run']: raise Exc(4,8)
        if n==412 and C['p412_run']=='refused': raise Exc(4,8)
        if n==413 and C['p413_run']=='refused': raise Exc(4,8)
    D.writes+=1
    if n==410:
        old=D.cw; D.cw=v; D.newcw=True; log('CW 0x%04X'%v)
        if not old&0x80 and v&0x80 and D.state=='FAULT':
            if now()-D.fault_t>=C['faultlock'] and (not C['reset_remote'] or word()&0x200):
                D.fault=0; setstate('SOD','15 reset')
            else: log('reset ignored (lock)')
        return
    if n==11: return
    k=ds%5
    idx=range(len(p['ram'])) if (not p['ds'] or k==0) else [k-1]
    for i in idx: p['ram'][i]=v
    if ds<5 and n not in(484,524):
        for i in idx: p['ee'][i]=v
        EEW[n]=EEW.get(n,0)+1
    log('WRITE P.%d@%d=%d'%(n,ds,v))
    if n==1376: C['addr']=v
    if n==34 and v==123: D.reboot=True
    if n==395: C['newproto']=v
D.reboot=False
def pdu(b,bc):
    fc=b[0]; h=lambda i:b[i]<<8|b[i+1]
    try:
        if fc==3:
            if len(b)!=5: raise Exc(3,13)
            if h(3)!=1: raise Exc(2)
            v=rd(h(1),16); return bytes([3,2,v>>8,v&255])
        if fc==6:
            if len(b)!=5: raise Exc(3,13)
            wr(h(1),h(3),16); return b
        if fc==100:
            if len(b)!=3: raise Exc(3,13)
            v=rd(h(1),32); return bytes([100])+v.to_bytes(4,'big')
        if fc==101:
            if len(b)!=7: raise Exc(3,13)
            wr(h(1),int.from_bytes(b[3:7],'big'),32); return b
        if fc==8:
            if len(b)!=5: raise Exc(3,13)
            sub=h(1)
            if sub==10:
                if h(3): raise Exc(3)
                D.cnt=[0]*9; return b
            if 11<=sub<=18:
                if h(3): raise Exc(3)
                v=D.cnt[sub-10]; return b[:3]+bytes([v>>8,v&255])
            raise Exc(1)
        raise Exc(1)
    except Exc as e:
        if e.sst is not None: D.sst=e.sst
        D.cnt[3]+=1
        return bytes([fc|0x80,e.c])
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
# ---------- line
m,s=os.openpty(); tty.setraw(s); name=os.ttyname(s)
if C.get('close_slave'): os.close(s)
out({'pty':name,'pid':os.getpid()})
fl=fcntl.fcntl(0,fcntl.F_GETFL); fcntl.fcntl(0,fcntl.F_SETFL,fl|os.O_NONBLOCK)
B={2400:termios.B2400,4800:termios.B4800,9600:termios.B9600,19200:termios.B19200,57600:termios.B57600,115200:termios.B115200}
cin=b''; buf=b''; lastbyte=0; lastrep=-1; pend=None; dead=False; noise=0; silent_until=0; garble=0; drop=0; lastreq=-9; waiting=None; deadw=False
def settings_ok():
    x=fcntl.ioctl(m,0x802C542A,bytes(44)); iflag,of,cf,lf=struct.unpack('4I',x[:16]); isp,osp=struct.unpack('2I',x[36:44])
    if osp!=C['baud']: return False
    par='none' if not iflag&termios.INPCK else ('odd' if cf&termios.PARODD else 'even')
    return par==C['parity'] or C.get('anyparity')
def chartime(): return 11.0/C['baud'] if not C['ascii'] else 10.0/C['baud']
def emit(b):
    try:
        if C['pieces']:
            for i in range(0,len(b),C['pieces']): os.write(m,b[i:i+C['pieces']]); time.sleep(0.004)
        else: os.write(m,b)
    except OSError as e: log('emit',e)
def handle(fr):
    global pend,lastreq,garble,drop,dead
    t=now()
    if lastrep>0 and 0<t-lastrep<0.002: VIOL.append('spoke %.2f ms after reply'%((t-lastrep)*1e3)); 
    if not settings_ok(): log('DEAF settings',fr.hex()); return
    if C['ascii']:
        try:
            x=bytes.fromhex(fr[1:-2].decode()); assert fr[:1]==b':' and sum(x)&255==0; body=x[:-1]
        except Exception: log('BAD',fr); D.cnt[2]+=1; return
    else:
        if len(fr)<4 or crc(fr[:-2])!=fr[-2:]: log('BAD CRC',fr.hex()); D.cnt[2]+=1; return
        body=fr[:-2]
    D.cnt[1]+=1
    if body[0] not in(0,C['addr']): log('other',fr.hex()); return
    D.cnt[4]+=1
    if pend: VIOL.append('spoke while a reply was due: '+body.hex()); log('COLLISION'); pend=None
    if body[0]==0: D.cnt[5]+=1
    if C['dead_after_writes'] is not None and D.writes>=C['dead_after_writes']: dead=True
    if dead or t<D.dead_until: log('DEAD',body.hex()); return
    tick()
    r=pdu(body[1:],body[0]==0)
    if not r[0]&0x80: D.lastok=now()
    tick()
    log('RX',body.hex(),'TX',r.hex())
    if body[0]==0: return
    full=bytes([body[0]])+r
    if C['ascii']: w=b':'+(full+bytes([-sum(full)&255])).hex().upper().encode()+b'\r\n'
    else: w=full+crc(full)
    d=len(fr)*chartime()+C['delay']+random.random()*C['delay_rnd']+len(w)*chartime()
    if C['slow_after'] is not None and D.writes>=C['slow_after']: d=C['slow']+len(w)*chartime()
    if drop>0: drop-=1; log('DROPPED'); return
    if garble>0: garble-=1; w=w[:2]+bytes([w[2]^0x10])+w[3:]
    if C['echo']: emit(fr)
    pend=(t+d,w)
    if 'newproto' in C:
        v=C.pop('newproto')
        if v in(2,3): C['ascii']=int(v==3)
        else: globals().update(dead=True)
    if D.reboot:
        C['baud']=[0,2400,4800,9600,19200,57600,115200][P[10]['ee'][0]]; C['parity']=['even','odd','none'][P[1375]['ee'][0]]
        for q in P.values(): q['ram']=list(q['ee'])
    if D.reboot: D.reboot=False; D.dead_until=now()+3; D.state='SOD'; D.cw=0; P[484]['ram']=[0]
end=C['life']
def dump(): 
    return dict(t=round(now(),3),state=D.state,word='0x%04X'%word(),cw='0x%04X'%D.cw,f=round(D.f,2),shaft=round(D.shaft,2),maxf=round(D.maxf,2),starts=D.starts,fault='%04X'%D.fault,lastfault='%04X'%D.lastfault,
      line=P[484]['ram'][0],p412=P[412]['ram'],p412ee=P[412]['ee'],p413=P[413]['ram'],p413ee=P[413]['ee'],p434=P[434]['ram'],eew=EEW,viol=VIOL,writes=D.writes,stopping=D.stopping)
babble_until=0; nextb=0
while True:
    t=now()
    if t>end: log('END life'); break
    tick()
    if pend and t>=pend[0]:
        emit(pend[1]); pend=None; lastrep=now()
    if t<babble_until and t>=nextb: 
        emit(bytes(random.randrange(256) for _ in range(6))); nextb=t+C.get('babble_gap',0.02)
    to=0.02 if D.state in('OE','QSA') or abs(D.shaft)>0 else 0.1
    if pend: to=max(0,min(to,pend[0]-t))
    if buf and not C['ascii']: to=min(to,0.003)
    if t<babble_until: to=min(to,max(0,nextb-t))
    try: r,_,_=select.select([m,0] if end and not C.get('noin') else [m],[],[],to)
    except OSError: break
    if 0 in r:
        try: x=os.read(0,4096)
        except BlockingIOError: x=None
        if x==b'': C['noin']=1
        elif x:
            cin+=x
            while b'\n' in cin:
                l,cin=cin.split(b'\n',1); a=l.decode().split()
                if not a: continue
                if a[0]!='dump': log('CMD',l.decode())
                if a[0]=='dump': tick(); out(dump())
                elif a[0]=='set': setattr(D,a[1],json.loads(a[2]))
                elif a[0]=='c': C[a[1]]=json.loads(a[2])
                elif a[0]=='p': P[int(a[1])]['ram']=[int(a[2])]*len(P[int(a[1])]['ram'])
                elif a[0]=='fault': trip(int(a[1],16))
                elif a[0]=='dead': dead=True
                elif a[0]=='alive': dead=False
                elif a[0]=='silent': D.dead_until=now()+float(a[1])
                elif a[0]=='babble': babble_until=now()+float(a[1])
                elif a[0]=='garble': garble=int(a[1])
                elif a[0]=='drop': drop=int(a[1])
                elif a[0]=='noise': emit(bytes.fromhex(a[1]))
                elif a[0]=='hangup': 
                    try: os.close(s)
                    except OSError: pass
                    os.close(m); sys.exit(0)
                elif a[0]=='quit': sys.exit(0)
    if m in r:
        try: x=os.read(m,4096)
        except OSError: time.sleep(0.05); x=b''
        if x: buf+=x; lastbyte=now()
        if C['ascii']:
            while b'\n' in buf:
                l,buf=buf.split(b'\n',1)
                if b':' in l: handle(l[l.rindex(b':'):]+b'\n')
    elif buf and not C['ascii'] and now()-lastbyte>=0.0025:
        fr,buf=buf,b''; handle(fr)
