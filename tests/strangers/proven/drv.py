# Drives of my own: CM-485 manual 6.4, 6.6, 6.7, 7 (RTU, ASCII), facts/protocols.md A (VABus), lxm05-modbus 5.2 (LXM05), MBAP for a gateway
import os,pty,tty,json,random,select,socket,struct,subprocess,threading,time,termios
B=os.path.abspath(os.environ['ANTRIEB'])
WD=os.environ.get('WD','/tmp/proven'); os.makedirs(WD,exist_ok=True)
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return struct.pack('<H',c)
def catalogue(fam):
    p=f'{WD}/cat-{fam}.json'
    if not os.path.exists(p):
        open(p,'w').write(subprocess.run([B,'--no-config','--drive',fam,'params','--json'],capture_output=True,text=True).stdout)
    return json.load(open(p))['data']['params']
def seedvalues(fam):
    p=f'{WD}/seed-{fam}.json'
    if not os.path.exists(p):
        a={'act':'1','acu':'2','lxm05':'3'}[fam]; port='sim'
        if fam=='lxm05': open(f'{WD}/lx.toml','w').write('[[drive]]\nmodel="lxm05"\naddress=3\n'); port=f'sim:{WD}/lx.toml'
        o=f'{WD}/seed-{fam}.toml'
        r=subprocess.run([B,'--no-config','-p',port,'-a',a,'--json','dataset','save',o],capture_output=True,text=True)
        open(p,'w').write(r.stdout)
    return json.load(open(p))['data']['saved'][0]['values']
W32={'long','ulong','ilong','int32','uint32','dint'}
class Drive:
    def __init__(s,fam,addr,rnd,ramread=True,setread='eeprom',unknown='4'):
        s.fam,s.addr,s.rnd=fam,addr,rnd; s.ramread,s.setread,s.unknown=ramread,setread,unknown
        s.ee={};s.ram={};s.w={};s.four=set();s.ro={}
        s.p11=0;s.locked=False;s.silent_until=0;s.dead=False;s.tel=0;s.writes=[];s.wtel=0;s.plan=None;s.log=[]
        s.status=0x33 if fam=='acu' else 0x23
        s.refuse={} ; s.nodename=None
        if fam=='lxm05':
            for v in seedvalues(fam): s.ee[v['param']]=v['raw']&0xFFFFFFFF
            for a in (5644,6914,6918,6920,6930,6936,6938,6940,6942,6944,6946,6948,7700,8200,8456,15362,15364,15366,15368): s.ro[a]=0
            s.ro[6916]=592; s.ee[5640]=addr
        else:
            cat={p['param']:p for p in catalogue(fam)}
            for v in seedvalues(fam):
                n=v['param'];d=v['data_set']; s.w[n]=32 if v['data_type'] in W32 else 16
                m=(1<<s.w[n])-1
                if d==0 and not (cat.get(n,{}).get('data_sets') ): s.ee[n,0]=v['raw']&m
                elif d==0:
                    s.four.add(n)
                    for k in range(1,5): s.ee[n,k]=v['raw']&m
                else: s.four.add(n); s.ee[n,d]=v['raw']&m
            s.ro={411:(16,s.status),210:(32,0),211:(16,0),213:(32,0),249:(16,1),250:(16,3),260:(16,0),269:(16,0),270:(16,0),410:(16,0),241:(32,0),228:(32,0),229:(32,0),230:(32,0)}
            if fam=='act': s.ro[484]=(32,0)
            if (1376,0) in s.ee: s.ee[1376,0]=addr
            if (394,0) in s.ee: s.ee[394,0]=addr
        s.ram=dict(s.ee)
    # -- parameter access: returns ('ok',value,width) or ('err',p11,exc)
    def err(s,c,e=4): s.p11=c; return ('err',c,e)
    def rd(s,n,d,w):
        if n==11:
            c=s.p11;s.p11=0;s.locked=False
            return ('ok',c,16) if w in(16,None) else s.err(14)
        if n in s.ro:
            ww,v=s.ro[n]
            if w not in(ww,None): return s.err(14)
            if d not in (0,5): return s.err(2)
            return ('ok',v,ww)
        if n not in s.w: return s.err(11,int(s.unknown))
        if w not in(s.w[n],None): return s.err(14)
        if d>=5 and not s.ramread: return s.err(2)
        mem=s.ram if d>=5 or s.setread=='ram' else s.ee
        k=d%5
        if n in s.four:
            if k==0:
                vs={mem[n,i] for i in range(1,5)}
                if len(vs)>1: return s.err(9)
                return ('ok',vs.pop(),s.w[n])
            return ('ok',mem[n,k],s.w[n])
        if k: return s.err(2)
        return ('ok',mem[n,0],s.w[n])
    def wr(s,n,d,w,v):
        if n in s.ro: return s.err(4)
        if n not in s.w: return s.err(11,int(s.unknown))
        if w!=s.w[n]: return s.err(14)
        k=d%5
        if n in s.four: ks=range(1,5) if k==0 else [k]
        elif k: return s.err(2)
        else: ks=[0]
        if (n in s.refuse) and (s.refuse[n][0] is None or s.refuse[n][0]>0):
            if s.refuse[n][0] is not None: s.refuse[n][0]-=1
            if s.refuse[n][1]=='eepromram':   # RAM takes it, EEPROM not
                for i in ks: s.ram[n,i]=v
                return s.err(6)
            return s.err(s.refuse[n][1])
        for i in ks:
            s.ram[n,i]=v
            if d<5: s.ee[n,i]=v
        s.writes.append((n,d,v))
        return ('ok',v,w)
    def power(s): s.ram=dict(s.ee); s.p11=0;s.locked=False
    # -- PDU of Modbus
    def pdu(s,p):
        f=p[0]
        if s.fam=='lxm05': return s.lxpdu(p)
        def out(r,good):
            return good if r[0]=='ok' else bytes([f|0x80,r[2]])
        if f==3 and len(p)==5:
            a,q=struct.unpack('>HH',p[1:5])
            if q!=1: return bytes([0x83,2])
            r=s.rd(a&0xFFF,a>>12,16); return out(r,b'\x03\x02'+struct.pack('>H',r[1]&0xFFFF))
        if f==6 and len(p)==5:
            a,v=struct.unpack('>HH',p[1:5]); return out(s.wr(a&0xFFF,a>>12,16,v),p)
        if f==100 and len(p)==3:
            a,=struct.unpack('>H',p[1:3]); r=s.rd(a&0xFFF,a>>12,32); return out(r,b'\x64'+struct.pack('>I',r[1]&0xFFFFFFFF))
        if f==101 and len(p)==7:
            a,v=struct.unpack('>HI',p[1:7]); return out(s.wr(a&0xFFF,a>>12,32,v),p)
        if f==8 and len(p)==5: return p
        return bytes([f|0x80,1])
    def lxpdu(s,p):
        f=p[0]
        if f==43: 
            o=b''
            for i,t in((0,b'Schneider Electric'),(1,b'LXM05AD10M2'),(3,b'V02.001')): o+=bytes([i,len(t)])+t
            return b'\x2b\x0e\x01\x02\x00\x00\x03'+o
        if f==3:
            a,q=struct.unpack('>HH',p[1:5])
            if q%2: return bytes([0x83,3])
            o=b''
            for i in range(q//2):
                v=s.ee.get(a+2*i,s.ro.get(a+2*i))
                if v is None: return bytes([0x83,2])
                o+=struct.pack('>I',v)
            return bytes([3,len(o)])+o
        if f==16:
            a,q=struct.unpack('>HH',p[1:5]); d=p[6:]
            if q%2 or len(d)!=2*q: return bytes([0x90,3])
            for i in range(q//2):
                x=a+2*i
                if x not in s.ee: return bytes([0x90,2])
                if x in s.refuse and (s.refuse[x][0] is None or s.refuse[x][0]>0):
                    if s.refuse[x][0] is not None: s.refuse[x][0]-=1
                    return bytes([0x90,4])
                s.ee[x]=struct.unpack('>I',d[4*i:4*i+4])[0]; s.ram[x]=s.ee[x]
                s.writes.append((x,0,s.ee[x]))
            return p[:5]
        if f==8: return p
        return bytes([f|0x80,1])
    # -- VABus frame (without EOT): returns reply bytes or None
    def vab_num(s,t):
        c=t[0]
        if c.isdigit(): return int(t)
        return (ord(c)-65+10)*100+int(t[1:])
    def vabus(s,fr):
        a=fr[0:1]
        def rep(n,ds,raw,w):
            t=b'0'+bytes([48+ds%5])+raw+(b'04%04X'%(raw_v&0xFFFF) if w==16 else b'08%08X'%(raw_v&0xFFFFFFFF))+b'\x03'
            bcc=0
            for x in t:bcc^=x
            return a+b'\x02'+t+bytes([bcc])
        if fr[-1:]==b'\x05' and len(fr)==7 :
            ds=fr[2]-48;n=s.vab_num(fr[3:6].decode()); r=s.rd(n,ds,None)
            if r[0]!='ok': s.locked=True; return a+b'\x15'
            raw_v=r[1]; return rep(n,ds,fr[3:6],r[2])
        if fr[1:2]==b'\x02':
            t=fr[2:-1];bcc=0
            for x in t:bcc^=x
            if bcc!=fr[-1]: s.p11=12; s.locked=True; return a+b'\x15'
            if s.locked: return a+b'\x15'
            ds=t[1]-48;n=s.vab_num(t[2:5].decode());ln=int(t[5:7]);v=int(t[7:7+ln],16)
            r=s.wr(n,ds,16 if ln==4 else 32,v)
            if r[0]!='ok': s.locked=True; return a+b'\x15'
            return a+b'\x06'
        return None
    def is_write(s,kind,m):
        if kind=='vabus': return m[1:2]==b'\x02'
        return m[0] in (6,101,16)
class Server:
    """serves drives on one pty (rtu, ascii, vabus) or a TCP gateway (mbtcp)"""
    def __init__(s,kind,drives,link=None,delay=0.0015):
        s.kind,s.drives,s.delay=kind,{d.addr:d for d in drives},delay; s.stop=False; s.end=None; s.proc=None; s.cut=False; s.cnt=0
        if kind=='mbtcp':
            s.ls=socket.socket(); s.ls.setsockopt(socket.SOL_SOCKET,socket.SO_REUSEADDR,1); s.ls.bind(('127.0.0.1',0)); s.ls.listen(5); s.port=f'mbtcp://127.0.0.1:{s.ls.getsockname()[1]}'; s.cs=None
        else:
            s.m,s.s=pty.openpty(); tty.setraw(s.m);tty.setraw(s.s); s.port=os.ttyname(s.s)
            if link:
                if os.path.islink(link): os.unlink(link)
                os.symlink(s.port,link); s.port=link
        s.th=threading.Thread(target=s.run,daemon=True); s.th.start()
    def close(s):
        s.stop=True; s.th.join(2)
        try:
            if s.kind=='mbtcp': s.ls.close(); s.cs and s.cs.close()
            else: os.close(s.m); os.close(s.s)
        except OSError: pass
    def handle(s,addr,kind,msg,enc):
        """returns reply bytes or None"""
        d=s.drives.get(addr)
        if d is None: return None
        s.cnt+=1
        now=time.time()
        if d.dead or s.cut or now<d.silent_until:
            return None
        d.tel+=1
        isw=d.is_write(kind,msg)
        act=None
        if isw: d.wtel+=1
        if s.end: act=s.end(s,d,isw,msg)
        if act=='drop': return None
        r=d.vabus(msg) if kind=='vabus' else d.pdu(msg)
        if act=='late-drop': return None       # obeyed, but no reply
        if isinstance(act,tuple) and act[0]=='bytes': r=act[1]
        if callable(act): act()
        if d.dead or s.cut or time.time()<d.silent_until: return None
        return None if r is None else enc(r)
    def run(s):
        buf=b''
        while not s.stop:
            try:
                if s.kind=='mbtcp':
                    rl=[s.ls]+([s.cs] if s.cs else [])
                    r,_,_=select.select(rl,[],[],0.05)
                    if s.ls in r:
                        if s.cs: s.cs.close()
                        s.cs,_=s.ls.accept(); buf=b''; s.cs.setsockopt(socket.IPPROTO_TCP,socket.TCP_NODELAY,1)
                        if s.cut: s.cs.close(); s.cs=None
                        continue
                    if s.cs and s.cs in r:
                        x=s.cs.recv(600)
                        if not x: s.cs.close(); s.cs=None; continue
                        buf+=x
                        while len(buf)>=7:
                            ti,pi,ln,un=struct.unpack('>HHHB',buf[:7])
                            if len(buf)<6+ln: break
                            p=buf[7:6+ln]; buf=buf[6+ln:]
                            time.sleep(s.delay)
                            q=s.handle(un,'mb',p,lambda r:struct.pack('>HHHB',ti,0,len(r)+1,un)+r)
                            if q: s.cs.sendall(q)
                            elif s.cut and s.cs: s.cs.close(); s.cs=None; break
                            elif un not in s.drives: s.cs.sendall(struct.pack('>HHHB',ti,0,3,un)+bytes([p[0]|0x80,11]))
                    continue
                r,_,_=select.select([s.m],[],[],0.02 if s.kind!='rtu' else 0.0025 if buf else 0.05)
                if r:
                    x=os.read(s.m,512); buf+=x
                    if s.kind=='rtu':
                        # complete by length (time on a loaded machine tells nothing)
                        if not s.rtu_complete(buf): continue
                if s.kind=='rtu':
                    if buf and s.rtu_complete(buf):
                        b,buf=buf,b''; time.sleep(s.delay)
                        q=s.handle(b[0],'mb',b[1:-2],lambda r:(lambda t:t+crc(t))(b[:1]+r))
                        if q: os.write(s.m,q)
                    elif buf and not r:
                        s.age=getattr(s,'age',0)+1
                        if s.age>40: buf=b'';s.age=0
                elif s.kind=='ascii':
                    while b'\n' in buf:
                        l,buf=buf.split(b'\n',1); l=l.strip()
                        i=l.rfind(b':')
                        if i<0: continue
                        try: raw=bytes.fromhex(l[i+1:].decode())
                        except ValueError: continue
                        if sum(raw)&0xFF: continue
                        time.sleep(s.delay)
                        def enc(r,a=raw[:1]):
                            t=a+r; t+=bytes([(-sum(t))&0xFF]); return b':'+t.hex().upper().encode()+b'\r\n'
                        q=s.handle(raw[0],'mb',raw[1:-1],enc)
                        if q: os.write(s.m,q)
                else:
                    while True:
                        i=buf.find(b'\x04')
                        if i<0: buf=b''; break
                        while buf[i+1:i+2]==b'\x04': i+=1
                        f=buf[i+1:]
                        n=None
                        if len(f)>=2:
                            if f[1]==2:
                                e=f.find(b'\x03',2)
                                if e>0 and len(f)>e+1: n=e+2
                            elif len(f)>=7: n=7
                        if n is None: break
                        fr=f[:n]; buf=f[n:]; time.sleep(s.delay)
                        try: q=s.handle(fr[0]-0x40,'vabus',fr,lambda r:r)
                        except (ValueError,IndexError): q=None
                        if q: os.write(s.m,q)
            except OSError as e:
                if s.stop: return
                time.sleep(0.02)
    def rtu_complete(s,b):
        for n in (8,6,5,10,7,12):   # known lengths first
            if len(b)==n and crc(b[:-2])==b[-2:]: return True
        return len(b)>4 and crc(b[:-2])==b[-2:]
