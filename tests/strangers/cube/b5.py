import socket,threading,time,os,random,struct
from b1 import t
END=time.monotonic()+280
def serve(f):
    s=socket.socket(); s.setsockopt(socket.SOL_SOCKET,socket.SO_REUSEADDR,1); s.bind(('127.0.0.1',0)); s.listen(8); s.settimeout(1)
    def loop():
        while time.monotonic()<END:
            try: c,_=s.accept()
            except OSError: continue
            c.settimeout(0.5)
            def h(c=c):
                try: f(c)
                except Exception: pass
                try: c.close()
                except OSError: pass
            threading.Thread(target=h,daemon=True).start()
    threading.Thread(target=loop,daemon=True).start(); return s.getsockname()[1]
def silent(c):
    e=time.monotonic()+60
    while time.monotonic()<e:
        try:
            if not c.recv(999): return
        except socket.timeout: pass
def flood(b,gap):
    def f(c):
        e=time.monotonic()+60
        while time.monotonic()<e: c.sendall(b() if callable(b) else b); time.sleep(gap)
    return f
def closer(c): pass
def rst(c): c.setsockopt(socket.SOL_SOCKET,socket.SO_LINGER,struct.pack('ii',1,0))
def mb(fn):
    def f(c):
        e=time.monotonic()+60
        while time.monotonic()<e:
            try: r=c.recv(999)
            except socket.timeout: continue
            if not r: return
            x=fn(r)
            if x: c.sendall(x)
    return f
rnd=lambda n:(lambda:bytes(random.randrange(256) for _ in range(n)))
H=lambda r,pdu,tid=None,ln=None,proto=0: (r[:2] if tid is None else tid)+struct.pack('>HH',proto,len(pdu)+1 if ln is None else ln)+r[6:7]+pdu
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
S={'tcp silent':('tcp',silent),'tcp zeros':('tcp',flood(b'\0'*4096,0.01)),'tcp random':('tcp',flood(rnd(50),0.01)),'tcp drip':('tcp',flood(b'U',0.02)),'tcp close':('tcp',closer),'tcp rst':('tcp',rst),
 'tcp valid flood':('tcp',flood(lambda:(lambda b:b+crc(b))(bytes([1,3,2,2,0x37])),0.01)),
 'tcp exc busy':('tcp',mb(lambda r:(lambda b:b+crc(b))(bytes([r[0],r[1]|0x80,6])))),'tcp exc 0':('tcp',mb(lambda r:(lambda b:b+crc(b))(bytes([r[0],r[1]|0x80,0])))),'tcp echo':('tcp',mb(lambda r:r)),'tcp other slave':('tcp',mb(lambda r:(lambda b:b+crc(b))(bytes([r[0]+1,r[1],2,0,0])))),
 'tcp all ones':('tcp',mb(lambda r:(lambda b:b+crc(b))(bytes([r[0],3,2,255,255]) if r[1]==3 else bytes([r[0],r[1],255,255,255,255]) if r[1]==100 else r[:-2]))),
 'mb wrong tid':('mbtcp',mb(lambda r:H(r,b'\x03\x02\x02\x37',b'\xff\xff'))),'mb len65535':('mbtcp',mb(lambda r:H(r,b'\x03\x02\x02\x37',ln=65535))),'mb len0':('mbtcp',mb(lambda r:H(r,b'\x03\x02\x02\x37',ln=0))),'mb proto':('mbtcp',mb(lambda r:H(r,b'\x03\x02\x02\x37',proto=7))),'mb half':('mbtcp',mb(lambda r:r[:5])),'mb flood tid':('mbtcp',flood(b'\xff\xff\0\0\0\x05\x01\x03\x02\x00\x00',0.005)),'mb gw exc':('mbtcp',mb(lambda r:H(r,bytes([r[7]|0x80,0x0B])))),
 'rfc loop':('rfc2217',flood(b'\xff\xfb\x2c\xff\xfd\x2c\xff\xfb\x01',0.01)),'rfc sb endless':('rfc2217',flood(b'\xff\xfa\x2c'+b'\x01'*500,0.01)),'rfc silent':('rfc2217',silent),'rfc refuse':('rfc2217',mb(lambda r:b'\xff\xfe\x2c\xff\xfc\x2c'))}
V=[('read','-a 1 read 411'),('disable','-a 1 statemachine disable'),('write','-a 1 --yes write 480@1=7Hz')]
if __name__=='__main__':
    import sys
    for n,(sch,f) in list(S.items())[(int(sys.argv[1]) if len(sys.argv)>1 else 0):]:
        p=serve(f)
        for vn,v in V:
            if time.monotonic()>END-30: print('out of time at',n); sys.exit()
            t(n+' '+vn,'$B -p %s://127.0.0.1:%d %s'%(sch,p,v),limit=75,show=200)
