# my own ACTIVE Cube on a pty, from the CM-485 manual alone (chapters 6, 7, 8, 11)
import os, pty, tty, threading, time, struct, select, random, termios
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8):
            c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
# number: (width, four, default, min, max)
P={}
def p(n,w,four,d,lo,hi): P[n]=(w,four,d,lo,hi)
p(10,16,0,4,1,6);p(30,16,0,110,110,640);p(34,16,0,0,0,9999)
for n in (62,63,66,67,68,69,70,72,73,75,76,83,99,103,131,137): p(n,16,n in(68,69,66,67),{68:71,69:72}.get(n,7),0,999)
p(372,16,1,1390,60,60000);p(373,16,1,2,1,24);p(375,32,1,5000,1000,100000);p(376,16,1,8,1,10000)
p(381,16,1,1,1,7);p(382,16,1,0,-3600,3600);p(392,16,1,2,0,2);p(394,16,0,1,1,30);p(395,16,0,2,0,3);p(400,16,0,2,1,8)
for n in (405,406,407,408): p(n,16,0,80,0,100)
p(412,16,1,44,0,44);p(413,16,0,0,0,10000);p(414,16,0,0,0,4)
p(418,32,1,350,0,99999);p(419,32,1,5000,0,99999)
p(424,32,1,1000,1,999999);p(425,32,1,1000,1,999999);p(434,16,1,3,1,3);p(450,16,0,200,0,2500)
for n in (475,476,478): p(n,16,1,1,0,999)
for i,n in enumerate((480,481,482,483,485,486,487,488)): p(n,32,1,(500,1000,2500,5000)[i%4],-99900,99900)
p(518,32,1,0,0,30000);p(519,32,1,10000,0,30000);p(549,16,1,500,1,2000)
p(600,16,1,50,0,1000);p(601,16,1,10,-100,200);p(602,16,1,20,0,100);p(603,16,1,4000,600,5600);p(604,32,1,5000,0,59900)
p(632,16,1,100,0,2000);p(637,16,1,10,0,1000);p(638,16,1,10,0,2000)
p(900,16,0,-1,-1,63);p(903,16,0,6,3,8);p(904,16,0,3500,3500,50000);p(1375,16,0,0,0,2);p(1376,16,0,1,1,247)
ACT={11:16,210:32,211:16,213:16,228:32,229:32,241:32,249:16,250:16,260:16,270:16,282:32,283:32,411:16}
class Drive:
    def __init__(s,addr=1,reading='eeprom',rnd=None,cfg=None,single601=False):
        s.addr=addr; s.reading=reading; s.acu=True
        s.ee={};s.ram={};s.p11=0
        s.eew=0; s.ramw=0; s.log=[]   # accepted writes
        for n,(w,f,d,lo,hi) in P.items():
            for k in ((1,2,3,4) if f else (0,)): s.ee[n,k]=d; s.ram[n,k]=d
        s.running=False; s.off_until=0; s.hooks=[]; s.n=0; s.wn=0; s.dead=False
        s.links=None; s.eelog={}
    def four(s,n): return P[n][1]
    def status(s): return 0x0037 if s.running else 0x0033
    def actual(s,n):
        if n==411: return s.status()
        if n==11:
            v=s.p11; s.p11=0; return v
        if n==249: return 1
        if n==250: return 1
        return 1000 if (n in(210,241,283) and s.running) else 0
    def refuse(s,fc,cause,exc=4):
        s.p11=cause; return bytes([s.addr,fc|0x80,exc])
    def power(s):
        s.ram=dict(s.ee); s.running=False
    def read(s,fc,ds,n,width):
        if n in ACT:
            if ds not in(0,5): return s.refuse(fc,2)
            if ACT[n]!=width: return s.refuse(fc,14)
            return s.actual(n)
        if n in(484,524,410):
            if n!=410: return s.refuse(fc,3)
            if ds not in (0,5): return s.refuse(fc,2)
            if width!=16: return s.refuse(fc,14)
            return 0
        if n not in P: return s.refuse(fc,11)
        if ds>9: return s.refuse(fc,2)
        w,f,d,lo,hi=P[n]
        if w!=width: return s.refuse(fc,14)
        if ds>=5:
            if s.reading=='refused': return s.refuse(fc,2)
            m=s.ram; k=ds-5
        else:
            m=s.ram if s.reading=='in-force' else s.ee; k=ds
        if f:
            if k==0:
                v={m[n,i] for i in(1,2,3,4)}
                if len(v)>1: return s.refuse(fc,9)
                return m[n,1]
            return m[n,k]
        if k!=0: return s.refuse(fc,2)
        return m[n,0]
    def write(s,fc,ds,n,v,width):
        if n in ACT: return s.refuse(fc,4)
        if n in(410,484,524):
            return None
        if n not in P: return s.refuse(fc,11)
        if ds>9: return s.refuse(fc,2)
        w,f,d,lo,hi=P[n]
        if w!=width: return s.refuse(fc,14)
        if not lo<=v<=hi: return s.refuse(fc,1)
        if s.running and n in (30,372,373,375,376,400,395): return s.refuse(fc,8)
        k=ds%5
        if not f and k: return s.refuse(fc,2)
        ks=((1,2,3,4) if k==0 else (k,)) if f else (0,)
        mode=s.wmode(n,k,ds) if hasattr(s,'wmode') else None   # 'refuse','refuse-ram','keeps','clamp'
        if mode=='refuse': return s.refuse(fc,6)
        if mode=='clamp': v=v-1 if v>lo else v
        for i in ks:
            if ds<5 and mode not in('refuse-ram','keeps'):
                s.ee[n,i]=v; s.eew+=1; s.eelog[n,i]=s.eelog.get((n,i),0)+1
            elif ds<5: s.eew+=1; s.eelog[n,i]=s.eelog.get((n,i),0)+1
            else: s.ramw+=1
            if mode!='notinforce': s.ram[n,i]=v
        s.log.append((s.n,n,ds,v))
        if mode=='refuse-ram': return s.refuse(fc,6)
        if n==30 and ds<5:
            # configuration decides (manual 9.1.2.2: P.392 is 0 with torque control); 418 default
            for i in(1,2,3,4):
                pass
        return None
    def handle(s,t):
        # t is a whole telegram with right CRC for us; returns reply body without CRC or None
        fc=t[1]
        if fc in(3,6):
            a=t[2]<<8|t[3]; ds,n=a>>12,a&0xFFF; v=t[4]<<8|t[5]
            if fc==3:
                if v!=1: return bytes([s.addr,0x83,2])
                r=s.read(fc,ds,n,16)
                if isinstance(r,bytes): return r
                return bytes([s.addr,3,2])+struct.pack('>H',r&0xFFFF)
            sv=v
            if n in P and P[n][3]<0 and v>=0x8000: sv=v-0x10000
            r=s.write(fc,ds,n,sv,16)
            return r if r else bytes(t[:6])
        if fc==8:
            sub=t[2]<<8|t[3]
            if sub==0 or sub==10: return bytes(t[:6])
            if 11<=sub<=18: return bytes(t[:4])+b'\0\1'
            return bytes([s.addr,0x88,1])
        if fc==100:
            a=t[2]<<8|t[3]; ds,n=a>>12,a&0xFFF
            r=s.read(fc,ds,n,32)
            if isinstance(r,bytes): return r
            return bytes([s.addr,100])+struct.pack('>I',r&0xFFFFFFFF)
        if fc==101:
            a=t[2]<<8|t[3]; ds,n=a>>12,a&0xFFF
            v=struct.unpack('>i',bytes(t[4:8]))[0]
            r=s.write(fc,ds,n,v,32)
            return r if r else bytes(t[:8])
        return bytes([s.addr,fc|0x80,1])
LEN={3:8,6:8,8:8,100:6,101:10}
def show(t,reply=False):
    fc=t[1]
    if fc&0x80: return 'EXC %d'%t[2]
    if fc in(6,101) or (not reply and fc in (3,100)):
        a=t[2]<<8|t[3]; v=''
        if fc==6: v='= %d'%(t[4]<<8|t[5])
        if fc==101: v='= %d'%struct.unpack('>i',bytes(t[4:8]))[0]
        return '%s P.%d@%d %s'%('write' if fc in(6,101) else 'read',a&0xFFF,a>>12,v)
    if fc==3: return '%d'%(t[3]<<8|t[4])
    if fc==100: return '%d'%struct.unpack('>i',bytes(t[2:6]))[0]
    return bytes(t).hex()
class Bus(threading.Thread):
    """hook(bus,drive,telegram,iswrite) may return: None | ('drop',) before execution | ('lost',) after | ('garble',) | ('exc',code) instead
       | ('late',seconds) | ('trunc',) | ('cut',)"""
    def __init__(s,drives,link,hook=None,delay=0.003):
        super().__init__(daemon=True)
        s.m,s.s=pty.openpty(); tty.setraw(s.m); tty.setraw(s.s)
        s.name_=os.ttyname(s.s); s.link=link
        try: os.unlink(link)
        except FileNotFoundError: pass
        os.symlink(s.name_,link)
        s.d={d.addr:d for d in drives}; s.hook=hook; s.delay=delay; s.stop=False; s.n=0; s.cut=False; s.tlog=[]
        s.hung=False; s.bad=0; s.later=[]; s.dump=[]; s.t0=time.time()
    def hangup(s):
        s.hung=True
    def run(s):
        buf=b''
        last=0
        while not s.stop and not s.hung:
            r,_,_=select.select([s.m],[],[],0.05)
            now=time.time()
            if not r:
                if buf: s.bad+=1
                buf=b''; continue
            try: x=os.read(s.m,256)
            except OSError: break
            buf+=x
            while len(buf)>=2:
                L=LEN.get(buf[1])
                if L is None:
                    # unknown: wait the gap
                    time.sleep(0.004)
                    r,_,_=select.select([s.m],[],[],0)
                    if r: buf+=os.read(s.m,256); continue
                    t=buf; buf=b''
                else:
                    if len(buf)<L: break
                    t=buf[:L]; buf=buf[L:]
                if crc(t[:-2])!=t[-2:]: s.bad+=1; buf=b''; continue
                s.one(t)
        try: os.close(s.m)
        except OSError: pass
        try: os.close(s.s)
        except OSError: pass
    def one(s,t):
        d=s.d.get(t[0]); s.n+=1
        s.dump.append('%4d %8.3f > %s'%(d.n+1 if d else -1,time.time()-s.t0,show(t)))
        act=None
        if d is None: return
        d.n+=1
        w=t[1] in(6,101)
        if w: d.wn+=1
        if s.hook: act=s.hook(s,d,t,w)
        if s.cut:
            s.dump.append('              (line cut)'); return
        if time.time()<d.off_until:
            s.dump.append('              (drive off)'); return
        if act and act[0]=='drop': return
        if act and act[0]=='exc': rep=bytes([d.addr,t[1]|0x80,act[1]])
        else: rep=d.handle(t)
        s.dump.append('              < %s %s'%(show(rep+b'xx',True),act or ''))
        if act and act[0]=='lost': return
        rep+=crc(rep)
        if act and act[0]=='garble':
            i=random.randrange(len(rep)); rep=rep[:i]+bytes([rep[i]^(1<<random.randrange(8))])+rep[i+1:]
        if act and act[0]=='trunc': rep=rep[:-3]
        if act and act[0]=='power': # obeyed, then power fails before the reply
            d.power(); d.off_until=time.time()+act[1]; return
        time.sleep(s.delay)
        if act and act[0]=='late': time.sleep(act[1])
        try: os.write(s.m,rep)
        except OSError: pass
        if act and act[0]=='double':
            time.sleep(act[1])
            try: os.write(s.m,rep)
            except OSError: pass
