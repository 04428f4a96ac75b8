#!/usr/bin/env python3
# counterparts on a pty, written from the manuals alone
import os, pty, tty, time, threading, subprocess, select, struct, sys, signal, heapq, random, termios
BIN=os.environ.get('ANTRIEB','target/debug/antrieb')
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
def lrc(b): return (-sum(b))&255
def s32(v): v&=0xffffffff; return v-(1<<32) if v>>31 else v
class Base:
    def __init__(s,adr=3): s.adr=adr; s.n=0.0; s.hist=[]; s.events=[]; s.power=True; s.wr=[]
class LXM(Base):
    addrs={1284:0,1544:0,1546:0,1554:6000,1556:600,1558:750,5638:19200,5640:1,5642:2,5644:0,5646:0,6914:0,6916:0,6918:0,6920:0,6930:0,6936:18,6938:0,6940:0,6942:60,6944:0,6946:0,6948:0,8200:0,8456:0,9734:1,9736:1,10248:60,10250:6,10504:60,10506:180,15362:0,15364:0,15366:0,15368:0,7700:0}
    ro={6916,6920,7700,15362,15364,15366,15368}
    rng={1554:(1,13200),1556:(30,3000000),1558:(750,3000000),5640:(1,247),5644:(0,10000),6936:(1,35),6942:(1,13200),9736:(-2**31,2**31-1),6938:(-13200,13200),8456:(-30000,30000),8200:(-30000,30000),6944:(0,2),6946:(0,2),6948:(0,2),6930:(0,7)}
    def __init__(s,adr=3,**o):
        super().__init__(adr); s.o=dict(mode_turn='refuse',c7='coast',guard='quick',guide=1000,ref_keep=True,qs_auto=True,bit9=True,absolute=True,exc=4); s.o.update(o)
        s.p=dict(s.addrs); s.p[5640]=adr; s.st='SOD'; s.mode=0; s.pos=0.0; s.tgt=None; s.last=time.time(); s.reached=False; s.ref=False; s.syn=0; s.boot=0; s.lastmsg=time.time(); s.cnt=[0]*8; s.fb=0; s.moving=False
    STB={'NR':0,'SOD':0x40,'RTS':0x21,'SO':0x23,'OE':0x27,'QS':0x07,'FR':0x0F,'F':0x08}
    def status(s):
        w=s.STB[s.st]|0x10|(0x200 if s.o['bit9'] else 0)
        if s.reached: w|=0x400
        if s.ref: w|=0x1000
        if s.st in('SOD','F'): w|=0x20 if s.st=='SOD' and 0 else 0
        return w
    def demand(s):
        if s.st!='OE': return 0.0
        m=s.mode
        lim=s.p[1554]
        v=0
        if m==3: v=s32(s.p[6938])
        elif m==-4: v=s32(s.p[8456]) if s.p[6946]==2 else (s.o.get('analog',0) if s.p[6946]==1 else 0)
        elif m==-3: v=s32(s.p[8200])*3 if s.p[6944]==2 else (s.o.get('analog',0) if s.p[6944]==1 else 0)
        elif m==-2: v=s.o['guide']*s32(s.p[9736])/max(1,s32(s.p[9734])) if s.p[6948] in(1,2) else 0
        elif m==-1:
            j=s.p[6930]; v=(s.p[10506] if j&4 else s.p[10504])*(1 if j&1 else -1 if j&2 else 0)
        elif m in(1,6) and s.tgt is not None:
            d=s.tgt-s.pos; vm=s.p[6942] if m==1 else s.p[10248]
            if abs(d)<30 : s.pos=s.tgt; s.tgt=None; s.reached=True; s.n=0; s.ref=s.ref or m==6; return 0
            vs=(2*s.p[1558]/60*abs(d)/16384)**.5*60   # n for braking
            v=min(vm,max(vs,2))*(1 if d>0 else -1)
        return max(-lim,min(lim,v))
    def tick(s,t):
        dt=t-s.last; s.last=t
        if not s.power:
            s.n*=max(0,1-dt*3)
            if abs(s.n)<3: s.n=0
            s.pos+=s.n/60*16384*dt; s.hist.append((t,s.n)); return
        for e in list(s.events):
            if e[0](s,t): s.events.remove(e); e[1](s,t)
        if s.p[5644] and s.st=='OE' and t-s.lastmsg>s.p[5644]/1000:
            s.mark(t,'guard'); s.st='QS' if s.o['guard']=='quick' else 'FR'
        d=s.demand(); 
        if s.st in('QS','FR'):
            a=s.p[1558]; d=0
            s.tgt=None
        elif s.st!='OE':
            a=0; s.n*=max(0,1-dt*2); s.tgt=None
            if abs(s.n)<3: s.n=0
        a=(s.p[1558] if abs(d)<abs(s.n) or d*s.n<0 else s.p[1556])
        if s.st in('OE','QS','FR'):
            if s.mode==-3 and s.st=='OE': a=2000
            st=a*dt
            s.n=d if abs(d-s.n)<=st else s.n+(st if d>s.n else -st)
        if s.st=='FR' and s.n==0: s.st='F'
        if s.st=='QS' and s.n==0 and s.o['qs_auto']: s.st='SOD'
        if s.st=='OE' and s.mode in(3,-4): s.reached=abs(s.n-d)<1
        s.pos+=s.n/60*16384*dt
        s.hist.append((t,s.n))
    marks=None
    def mark(s,t,what):
        if s.marks is None: s.marks=[]
        s.marks.append((t,what))
    def trip(s,t,num=0x2300,cls=3):
        s.st='F' if cls>=3 else 'FR'; s.p[15362]=num; s.p[15364]=cls; s.mark(t,'trip')
    def reboot(s,t,off=0.8):
        s.power=False; s.boot=t+off; s.mark(t,'power off')
    def comeback(s,t):
        keep={k:s.p[k] for k in(5638,5640,5642,5646)}
        s.p=dict(s.addrs); s.p.update(keep); s.st='SOD'; s.mode=0; s.tgt=None; s.power=True; s.ref=False; s.mark(t,'power on'); s.lastmsg=t
    def rd(s,a):
        if a==6916: return s.status()
        if a==6920: return s.mode&0xffffffff
        if a==7700: return int(s.pos)&0xffffffff
        return s.p[a]&0xffffffff
    def control(s,w,t):
        c=w&0xff
        if c&0x80 and not s.p[6914]&0x80:
            if s.st=='F': s.st='SOD'
        if s.st in('F','FR'): return 0
        c&=0xf
        if not c&2: s.st='SOD'; return 0
        if not c&4:
            if s.st in('OE',): s.st='QS'
            elif s.st in('RTS','SO'): s.st='SOD'
            return 0
        if c&7==6:
            if s.st in('SOD','SO','OE'): s.st='RTS'
        elif c&0xf==7:
            if s.st=='RTS': s.st='SO'
            elif s.st=='OE':
                if s.n and s.o['c7']=='refuse': return 4
                s.st='SO'
        elif c&0xf==0xf:
            if s.st=='RTS': s.st='SO'; 
            if s.st=='SO': s.st='OE'; s.t_en=t; s.reached=False
            if s.st=='OE' and w&0x10 and not s.p[6914]&0x10:
                if s.mode==1:
                    x=s32(s.p[6940]); s.tgt=x if (s.o['absolute'] == bool(w&0x40)) else s.pos+x; s.reached=False
                elif s.mode==6: s.tgt=s.pos-10*16384; s.reached=False
        return 0
    def wrt(s,a,v,t):
        if a not in s.p: return 2
        if a in s.ro: return 4
        sv=s32(v)
        if a in s.rng and not s.rng[a][0]<=sv<=s.rng[a][1]: return 3
        if a==6914:
            r=s.control(v,t)
            if r: return r
        if a==6918:
            if sv not in(1,3,6,-1,-2,-3,-4): return 3
            if s.st!='OE': return s.o['exc']
            if sv!=s.mode:
                if (abs(s.n)>0 or s.tgt is not None) and s.o['mode_turn']=='refuse': return s.o['exc']
                s.mode=sv; s.reached=False
                if not s.o['ref_keep']: s.p[6944]=s.p[6946]=s.p[6948]=s.p[6930]=0
        s.p[a]=v; s.wr.append((t,a,sv)); return 0
    def handle(s,q,t):
        """q: frame with CRC; returns reply or None"""
        if not s.power: return None
        if len(q)<4 or crc(q[:-2])!=q[-2:]: return None
        if q[0] not in(s.adr,0): return None
        s.lastmsg=t; s.cnt[0]=(s.cnt[0]+1)&0xffff
        f=q[1]; r=None
        def ex(c,fb=None): 
            s.syn=0x1100+c; return bytes([s.adr,f|0x80])+(b'\x0e' if f==43 else b'')+bytes([c])
        if f==3:
            if len(q)!=8: return None
            a,n=struct.unpack('>HH',q[2:6])
            if n%2 or n<2 or n>60: r=ex(3)
            elif any(a+i not in s.p for i in range(0,n,2)): r=ex(2)
            else: r=bytes([s.adr,3,2*n])+b''.join(struct.pack('>I',s.rd(a+i)) for i in range(0,n,2))
        elif f==16:
            a,n,b=struct.unpack('>HHB',q[2:7])
            if n%2 or b!=2*n or len(q)!=9+b: r=ex(3)
            else:
                c=0
                for i in range(0,n,2):
                    c=s.wrt(a+i,struct.unpack('>I',q[7+2*i:11+2*i])[0],t)
                    if c: break
                r=ex(c) if c else q[:6]
        elif f==23:
            ra,rn,wa,wn,b=struct.unpack('>HHHHB',q[2:11]); c=0
            for i in range(0,wn,2):
                c=s.wrt(wa+i,struct.unpack('>I',q[11+2*i:15+2*i])[0],t)
                if c: break
            r=ex(c) if c else bytes([s.adr,23,2*rn])+b''.join(struct.pack('>I',s.rd(ra+i)) for i in range(0,rn,2))
        elif f==8:
            sf,d=struct.unpack('>HH',q[2:6])
            if sf==0: r=q[:-2]
            elif sf==2: r=q[:4]+struct.pack('>H',s.syn)
            elif sf==10: s.cnt=[0]*8; s.syn=0; r=q[:-2]
            elif sf in(11,12,13,16,17,18): r=q[:4]+struct.pack('>H',s.cnt[0] if sf==11 else 0)
            else: r=ex(s.o.get('fc8exc',1))
        elif f==43:
            if q[2]!=14 or q[3]!=1: r=ex(3)
            else: r=bytes([s.adr,43,14,1,2,0,0,3])+b''.join(bytes([i,len(x)])+x for i,x in((0,b'Telemecanique'),(1,b'LXM05AD10F1'),(3,b'V01.102')))
        else: r=ex(1)
        if q[0]==0: return None
        return r+crc(r) if len(r)<6 or r!=q else r
class ACU(Base):
    L16={410:0,411:0,412:44,413:0,414:1,249:1,250:0,260:0,270:0,392:2,394:1,395:2,10:4,1375:0,1376:1,30:110,11:0,34:0,211:0,637:10,638:10,549:500,434:3,475:1,476:1,218:0,373:2,372:1450,376:40,371:0,632:100,68:71,69:72,103:0,381:1,213:0,418:0}
    L32={210:0,217:0,228:0,282:0,283:0,241:0,229:0,484:0,524:0,418:350,419:5000,424:500,425:500,480:500,481:1000,482:2500,483:5000,375:5000,420:500,421:500,422:500,423:500,219:0}
    L16.pop(418)
    DS={392,412,434,424,425,637,638,480,481,482,483,372,375,376,418,419,475,476,373,420,421,422,423,632,371,381,68,69}
    RO={411,249,250,260,270,211,218,213,210,217,228,282,283,241,229,219}
    def __init__(s,adr=1,**o):
        super().__init__(adr); s.o=dict(act=False,level=True,fmin=0,internal=0,unknown=4,wo484=True,ramw_read='force',s2=True,enable=True,edge=False,dsin=1); s.o.update(o)
        s.ee={}; s.ram={}
        for k,v in list(s.L16.items())+list(s.L32.items()):
            for d in(range(1,5) if k in s.DS else (0,)): s.ee[k,d]=v
        if s.o['act']: s.ee[30,0]=110
        for k,v in s.o.get('set',{}).items():
            for d in(range(1,5) if k in s.DS else (0,)): s.ee[k,d]=v
        s.ram=dict(s.ee); s.st='SOD'; s.cw=0; s.last=s.lastmsg=time.time(); s.err11=0; s.hold=None; s.tf=0; s.br=False; s.sgn=1; s.marks=[]; s.ctr=[0]*9; s.boot=0; s.fault=0
    def mark(s,t,w): s.marks.append((t,w))
    def g(s,p): return s.ram[p,s.ds() if p in s.DS else 0]
    def ds(s): return s.ram[414,0] or s.o['dsin']
    def start(s): return s.o['enable'] and s.o['s2']
    STB={'SOD':0x40,'RTS':0x21,'SO':0x23,'OE':0x27,'QS':0x07,'FR':0x0F,'F':0x08}
    def shown(s):
        if s.g(412)!=1: 
            return 0x08 if s.st=='F' else 0x27 if s.turnc() else 0x23
        return s.STB[s.st]
    def turnc(s): # contacts
        return s.g(412)!=1 and s.start() and s.o.get('contact_start',False)
    def status(s):
        w=s.shown()
        if not s.o['act']: w|=0x10
        if s.g(412)==1 and s.start(): w|=0x200
        if s.shown()==0x27 and abs(s.n-s.dem())<0.3: w|=0x400
        return w
    def dem(s):
        m=s.g(434); x=s.g(484) ; i=s.o['internal']*100
        v=i if m==1 else s32(x) if m==2 else i+s32(x)
        v/=100
        if v: s.sgn=1 if v>0 else -1
        lo,hi=s.g(418)/100,s.g(419)/100
        a=min(hi,max(lo,abs(v)))
        return a*s.sgn
    def trip(s,t,code=0x0501): s.st='F'; s.fault=code; s.tf=t; s.mark(t,'trip')
    def reboot(s,t,off=0.8): s.power=False; s.boot=t+off; s.mark(t,'power off')
    def comeback(s,t): s.ram=dict(s.ee); s.ram[484,0]=0; s.cw=0; s.st='SOD'; s.power=True; s.mark(t,'power on'); s.lastmsg=t; s.sgn=1; s.fault=0
    def ctl(s,w,t,new=True):
        old=s.cw; s.cw=w
        if s.g(412)!=1: return
        if w&0x80 and not old&0x80 and s.st=='F' and t-s.tf>15: s.st='SOD'; s.fault=0
        if s.st in('F','FR'): return
        c=w&0xf
        if not c&2:
            s.st='SOD'; s.br=False; return
        if not c&4:
            if s.st=='OE': s.st='QS'; s.hold=None
            elif s.st!='QS': s.st='SOD'
            return
        if s.st=='QS': return
        if c&7==6:
            if s.st in('SOD','SO'): s.st='RTS'
            elif s.st=='OE': s.st='RTS'; s.br=False
        elif c==7:
            if s.st=='RTS': s.st='SO'
            elif s.st=='OE':
                if s.g(392)==0: s.st='SO'
                else: s.br=True; s.hold=None
        elif c==0xf:
            if s.st=='RTS': s.st='SO'
            if s.st in('SOD','SO') and s.start(): s.st='OE'; s.t_en=t
            if s.st=='OE': s.br=False
    def tick(s,t):
        dt=t-s.last; s.last=t
        if not s.power:
            s.n*=max(0,1-dt*2); 
            if abs(s.n)<.1: s.n=0
            s.hist.append((t,s.n)); return
        for e in list(s.events):
            if e[0](s,t): s.events.remove(e); e[1](s,t)
        if s.g(413) and t-s.lastmsg>s.g(413) and s.st!='F': s.trip(t,0x2010)
        if s.g(412)==1:
            if s.st=='OE' and not s.start(): s.st='SO'; s.br=False
            if s.o['level'] and s.st in('SO','SOD') and s.cw&0xf==0xf and s.start() : s.ctl(s.cw,t,False)
        act=s.shown()
        if act==0x27 or s.st=='QS':
            brk=s.br or s.st=='QS'
            d=0 if brk else s.dem()
            a=(s.g(424) if s.st=='QS' else s.g(421) if abs(d)<abs(s.n) or d*s.n<0 else s.g(420))/100
            st=a*dt; s.n=d if abs(d-s.n)<=st else s.n+(st if d>s.n else -st)
            if brk:
                if abs(s.n)<=s.g(637)/1000*s.g(419)/100:
                    if s.hold is None: s.hold=t
                    if s.n==0 and t-s.hold>=s.g(638)/10:
                        s.st='SOD' if s.st=='QS' else 'SO'; s.br=False
        else:
            s.n*=max(0,1-dt*1.5)
            if abs(s.n)<.1: s.n=0
        s.hist.append((t,s.n))
    def access(s,p,d,w,val,t):
        """returns (code, value)"""
        L=s.L16 if w==16 else s.L32; O=s.L32 if w==16 else s.L16
        if p not in L:
            if p in O: s.err11=14; return 4,0
            s.err11=11; return s.o['unknown'],0
        ram=d>=5; b=d-5 if ram else d
        if b and p not in s.DS: s.err11=2; return 4,0
        if val is None:
            if p in(484,524) and s.o['wo484']: s.err11=3; return 4,0
            if p==11: v=s.err11; s.err11=0; return 0,v
            if p==411: return 0,s.status()
            if p==249: return 0,s.ds()
            if p==250: return 0,(1 if s.o['enable'] else 0)|(2 if s.o['enable'] and s.o['s2'] else 0)
            if p==260: return 0,s.fault
            if p in(210,217,241): return 0,int(s.n*100)&0xffffffff
            if p==211: return 0,(30 if s.shown()==0x27 else 0)
            if p==218: return 0,int(s.n*30)&0xffff
            if p==228: return 0,int(s.o['internal']*100)&0xffffffff
            if p==282: return 0,s.ram[484,0]
            if p==283: return 0,int(s.dem()*100)&0xffffffff if s.shown()==0x27 else 0
            if p==410: return 0,s.cw
            m=s.ram if ram or s.o['ramw_read']=='force' else s.ee
            if p in s.DS and b==0:
                vs={m[p,i] for i in range(1,5)}
                if len(vs)>1: s.err11=9; return 4,0
                return 0,vs.pop()&0xffffffff
            return 0,m[p,b]
        if p in s.RO: s.err11=4; return 4,0
        if p in(30,395,373,372) and s.shown()==0x27: s.err11=8; return 4,0
        if p==412 and val>44 or p==434 and not 1<=val<=3 or p==414 and val>4 or p==413 and val>10000 or p==392 and val>2: s.err11=1; return 4,0
        s.wr.append((t,p,d,s32(val) if w==32 else val))
        if p==410: s.ctl(val,t); return 0,val
        for i in(range(1,5) if p in s.DS and b==0 else (b,)):
            s.ram[p,i]=val
            if not ram and p not in(484,524): s.ee[p,i]=val
        if p==34 and val==123: s.reboot(t,1)
        if p==412: s.ctl(s.cw,t)
        return 0,val
    def pdu(s,q,t):
        f=q[1]
        def ex(c): return bytes([s.adr,f|0x80,c])
        if f in(3,6,100,101):
            need={3:6,6:6,100:4,101:8}[f]
            if len(q)!=need: return ex(3)
            a=struct.unpack('>H',q[2:4])[0]; d,p=a>>12,a&0xfff
            if f==3 and q[4:6]!=b'\0\1': return ex(2)
            val=None if f in(3,100) else int.from_bytes(q[4:],'big')
            if d>9: s.err11=2; return ex(4)
            c,v=s.access(p,d,16 if f in(3,6) else 32,val,t)
            if c: return ex(c)
            if f==3: return bytes([s.adr,3,2])+struct.pack('>H',v&0xffff)
            if f==100: return bytes([s.adr,100])+struct.pack('>I',v&0xffffffff)
            return q
        if f==8:
            sf,d=struct.unpack('>HH',q[2:6])
            if d: return ex(3)
            if sf==10: return q
            if 11<=sf<=18: return q[:4]+struct.pack('>H',s.ctr[0] if sf in(11,14) else 0)
            return ex(1)
        return ex(1)
    ascii=False
    def handle(s,q,t):
        if not s.power: return None
        if s.ascii:
            try:
                if q[:1]!=b':' or q[-2:]!=b'\r\n': return None
                b=bytes.fromhex(q[1:-2].decode())
            except Exception: return None
            if lrc(b[:-1])!=b[-1]: return None
            b=b[:-1]
        else:
            if len(q)<4 or crc(q[:-2])!=q[-2:]: return None
            b=q[:-2]
        if b[0] not in(0,s.adr): return None
        s.lastmsg=t; s.ctr[0]=(s.ctr[0]+1)&0xffff
        r=s.pdu(b,t)
        if b[0]==0: return None
        return (b':'+(r+bytes([lrc(r)])).hex().upper().encode()+b'\r\n') if s.ascii else r+crc(r)
class Line:
    """fate(i,t,req,reply,drive) -> list of (extra delay, bytes)"""
    def __init__(s,drives,fate=None,baud=19200,turn=0.004,name='lx'):
        s.m,sl=pty.openpty(); tty.setraw(sl); tty.setraw(s.m); s.sl=sl; s.path=os.ttyname(sl); s.drives=drives; s.fate=fate; s.baud=baud; s.turn=turn
        s.q=[]; s.stop=False; s.log=[]; s.buf=b''; s.tb=0; s.i=0; s.seq=0; s.ascii=any(getattr(d,'ascii',False) for d in drives)
        s.th=threading.Thread(target=s.run,daemon=True); s.th.start()
    def run(s):
        last=0
        while not s.stop:
            t=time.time()
            r,_,_=select.select([s.m],[],[],0.001)
            t=time.time()
            if r:
                try: d=os.read(s.m,4096)
                except OSError: d=b''
                s.buf+=d; s.tb=t
            done=False
            if s.buf and (s.buf.endswith(b'\r\n') if s.ascii else t-s.tb>0.0012):
                q,s.buf=s.buf,b''
                heapq.heappush(s.q,(s.tb+len(q)*11/s.baud+.0015,s.seq,'in',q)); s.seq+=1
            while s.q and s.q[0][0]<=t:
                when,_,k,b=heapq.heappop(s.q)
                if k=='in':
                    s.log.append((t,'>',b))
                    s.i+=1
                    if s.cut_in(t,b): s.log.append((t,'x',b'request lost')); continue
                    for dr in s.drives:
                        rep=dr.handle(b,t)
                        if rep is None: continue
                        base=max(0.0,s.turn-.0015)+ (len(rep)*11/s.baud)+.002
                        outs=[(0,rep)] if not s.fate else s.fate(s.i,t,b,rep,dr)
                        if not outs: s.log.append((t,'x',rep))
                        for dl,o in outs:
                            heapq.heappush(s.q,(t+base+dl,s.seq,'out',o)); s.seq+=1
                else:
                    os.write(s.m,b); s.log.append((t,'<',b))
            if t-last>0.002:
                for dr in s.drives:
                    if not dr.power and dr.boot<=t: dr.comeback(t)
                    dr.tick(t)
                last=t
    lose_req=None
    def cut_in(s,t,b): return bool(s.lose_req and s.lose_req(t,b))
    def close(s): s.stop=True; s.th.join(); os.close(s.m); os.close(s.sl)
def ev_turn(thr): return lambda d,t: abs(d.n)>=thr
def ev_after(cond,sec):
    st={}
    def f(d,t):
        if 't' not in st and cond(d,t): st['t']=t
        return 't' in st and t-st['t']>=sec
    return f
def run(line,args,drive=None,timeout=120,sig=None,extra=('--yes',),env=None,settle=0.0,verbose=True):
    cmd=[BIN,'-p',line.path,'--no-config']+(['-v'] if verbose else [])+args+list(extra)
    t0=time.time()
    p=subprocess.Popen(cmd,stdout=subprocess.PIPE,stderr=subprocess.PIPE,stdin=subprocess.DEVNULL,text=True,env=dict(os.environ,**(env or {})))
    sent=[]
    if sig:
        def killer():
            for cond,sg in sig:
                while p.poll() is None and not cond(drive,time.time()): time.sleep(.005)
                if p.poll() is None: p.send_signal(sg); sent.append(time.time())
        threading.Thread(target=killer,daemon=True).start()
    try: out,err=p.communicate(timeout=timeout); rc=p.returncode
    except subprocess.TimeoutExpired: p.kill(); out,err=p.communicate(); rc='HANG'
    t1=time.time(); nend=drive.n if drive else 0
    time.sleep(settle)
    r=dict(rc=rc,out=out,err=err,t0=t0,t1=t1,sent=sent,nend=nend,took=t1-t0)
    if drive:
        h=drive.hist; on=[t for t,n in h if t>=t0 and abs(n)>1e-6]
        r['first']=on[0] if on else None; r['last']=on[-1] if on else None
        r['max']=max((abs(n) for t,n in h if t>=t0),default=0)
        r['min']=min((n for t,n in h if t>=t0),default=0)
    return r
