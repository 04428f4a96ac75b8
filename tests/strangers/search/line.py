#!/usr/bin/env python3
"""A line (pty) with several drives, each with baud/ascii/addr; answers only at the right speed. JSON config:
{life, log, drives:[{addr,baud,ascii,delay,...}], noise:{gap,n}, chatter:{...}}  prints the pty's name"""
import os,sys,json,time,select,tty,termios,fcntl,struct,random
CFG=json.loads(sys.argv[1])
SRC=open(os.path.dirname(os.path.abspath(__file__)) + '/../cube/acu.py').read().split('# ---------- line')[0]
NS=[]
for d in CFG.get('drives',[]):
    sv=sys.argv; sys.argv=['acu.py',json.dumps(d)]
    ns={'__name__':'drive'}; exec(compile(SRC,'acu.py','exec'),ns); sys.argv=sv
    NS.append(ns)
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
m,s=os.openpty(); tty.setraw(s); name=os.ttyname(s)
print(name,flush=True)
LOG=open(CFG.get('log','/dev/null'),'w',buffering=1); T0=time.monotonic()
def log(*a): LOG.write('%9.3f '%(time.monotonic()-T0)+' '.join(map(str,a))+'\n')
def parity():
    c=line()[1]
    return 'none' if c&0x40 else 'odd' if c&0x200 else 'even'
def line():
    x=fcntl.ioctl(m,0x802C542A,bytes(44)); i,o,c,l=struct.unpack('4I',x[:16]); return struct.unpack('2I',x[36:44])[1], c
life=CFG.get('life',120); out=[]; buf=b''; last=0; nb=0; seen=None
nz=CFG.get('noise'); cnt={}
while time.monotonic()-T0<life:
    t=time.monotonic()
    out.sort()
    while out and out[0][0]<=t:
        w=out[0][1]; ok=line()[0]==out[0][2]
        if not ok: w=bytes(random.randrange(256) for _ in range(max(1,len(w)//2)))
        try: os.write(m,w)
        except OSError: pass
        log('TX' if ok else 'TX-AT-WRONG-SPEED',out[0][1].hex(),line()[0]); out.pop(0)
    to=0.05
    if out: to=min(to,max(0,out[0][0]-t))
    if buf: to=min(to,0.003)
    if nz:
        if t>=nb:
            os.write(m,bytes(random.randrange(256) for _ in range(nz.get('n',5)))); nb=t+nz['gap']
        to=min(to,max(0,nb-t))
    ms=CFG.get('master')
    if ms:
        if t>=globals().get('nm',0):
            f=bytes([7,3,0x01,0x9b,0,1]); f+=crc(f); g=bytes([7,3,2,0,0x40]); g+=crc(g)
            if line()[0]==ms['baud'] and parity()==ms.get('parity','even'):
                out.append((t,f,ms['baud'])); out.append((t+0.03,g,ms['baud']))
            else:
                out.append((t,f,-1)); out.append((t+0.03,g,-1))
            nm=t+ms['gap']
        to=min(to,max(0,nm-t))
        if out: to=min(to,max(0,min(o[0] for o in out)-t))
    r,_,_=select.select([m],[],[],to)
    if r:
        try: x=os.read(m,4096)
        except OSError: time.sleep(.02); continue
        b=line()
        if b[0]!=seen: log('LINE',b[0],hex(b[1])); seen=b[0]
        buf+=x; last=time.monotonic(); continue
    if buf and time.monotonic()-last>=0.0025:
        b=line()[0]; fr,buf=buf,b''
        log('RX',b,fr.hex()); cnt[b]=cnt.get(b,0)+1
        for ns in NS:
            C=ns['C']
            if C['baud']!=b or (CFG.get('strict',1) and parity()!=C['parity']): 
                if CFG.get('garbage') : out.append((t+0.02,bytes(random.randrange(256) for _ in range(6)),b))
                continue
            if C.get('vabus'):
                # nodes later
                from_v=vab(ns,fr) if 'vab' in globals() else None
                continue
            if C['ascii']:
                try:
                    k=fr[fr.rindex(b':'):]; y=bytes.fromhex(k[1:-2].decode()); assert sum(y)&255==0 and k.endswith(b'\r\n'); body=y[:-1]
                except Exception: continue
            else:
                if len(fr)<4 or crc(fr[:-2])!=fr[-2:]: continue
                body=fr[:-2]
            if body[0]!=C['addr']: continue
            ns['tick'](); r_=ns['pdu'](body[1:],False); ns['tick']()
            full=bytes([body[0]])+r_
            w=b':'+(full+bytes([-sum(full)&255])).hex().upper().encode()+b'\r\n' if C['ascii'] else full+crc(full)
            ch=11.0/b
            out.append((t+(len(fr)+len(w))*ch+C['delay']+random.random()*C['delay_rnd'],w,b))
log('COUNT',cnt)
