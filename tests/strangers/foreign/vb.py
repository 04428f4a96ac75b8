from mx import *
def bcc(b):
    x=0
    for c in b: x^=c
    return x
def pn(x): return int(x) if x[0].isdigit() else (ord(x[0])-55)*100+int(x[1:3])
class VACU(ACU):
    pend=b''
    def handle(s,q,t):
        if not s.power: return None
        if s.pend: q=s.pend+q; s.pend=b''
        i=q.rfind(b'\x04')
        if i<0: return None
        q=q[i+1:]
        if not q: return None
        if q[0]-64!=s.adr: 
            return None
        if len(q)==1: s.pend=b'\x04'+q; return None
        try:
            if q[1]==2:
                body=q[2:-1]
                if bcc(body)!=q[-1] or body[-1]!=3: return bytes([q[0],0x15])
                x=body[:-1].decode(); d=int(x[:2]); p=pn(x[2:5]); ln=int(x[5:7]); v=int(x[7:],16)
                if len(x[7:])!=ln: return bytes([q[0],0x15])
                s.lastmsg=t
                c,_=s.access(p,d,16 if ln==4 else 32,v,t)
                return bytes([q[0],0x15 if c else 6])
            if q[-1]!=5: return None
            x=q[1:-1].decode(); d=int(x[:2]); p=pn(x[2:5]); w=16 if p in s.L16 else 32
            s.lastmsg=t
            c,v=s.access(p,d,w,None,t)
            if c: return bytes([q[0],0x15])
            b=x+('04%04X'%(v&0xffff) if w==16 else '08%08X'%(v&0xffffffff))
            b=b.encode()+b'\x03'
            return bytes([q[0],2])+b+bytes([bcc(b)])
        except Exception as e: s.mark(t,'exc %r %r'%(e,q)); return None
    def comeback(s,t): super().comeback(t); s.pend=b''
