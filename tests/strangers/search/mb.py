import os,sys,json,time,select,tty
# small modbus slave, own; holding registers in dict, answers FC3/4/6/16
R={}; INP={}
def crc(b):
    c=0xFFFF
    for x in b:
        c^=x
        for _ in range(8): c=(c>>1)^0xA001 if c&1 else c>>1
    return bytes([c&255,c>>8])
R.update({100:215,101:65411,102:0xB2D0,103:0x5E00,104:1234,105:3,106:0xFFFF,107:0xFF38,200:5000,300:7,301:65535,1:215,2:1234,3:0xB2D0,4:0x5E00,9:0xFFFF,10:0xFFFE,11:4000,20:65535,21:12,22:1500,48:1,40101:77})
INP.update({10:999})
m,s=os.openpty(); tty.setraw(s); print(os.ttyname(s),flush=True)
L=open('l.mb','w',buffering=1); buf=b''; t0=time.monotonic(); last=0
while time.monotonic()-t0<float(sys.argv[1]):
    r,_,_=select.select([m],[],[],0.004 if buf else 0.05)
    if r: 
        try: buf+=os.read(m,4096)
        except OSError: time.sleep(.05)
        continue
    if not buf: continue
    f,buf=buf,b''; L.write('RX '+f.hex()+'\n')
    if len(f)<4 or crc(f[:-2])!=f[-2:] or f[0]!=5: continue
    fc=f[1]; h=lambda i:f[i]<<8|f[i+1]; a=h(2)
    def ex(c): return bytes([5,fc|0x80,c])
    if fc in(3,4):
        T=R if fc==3 else INP; n=h(4)
        if any(a+i not in T for i in range(n)): w=ex(2)
        else: w=bytes([5,fc,2*n])+b''.join(T[a+i].to_bytes(2,'big') for i in range(n))
    elif fc==6:
        if a in R: R[a]=h(4); w=f[:-2]
        else: w=ex(2)
    elif fc==16:
        n=h(4)
        if all(a+i in R for i in range(n)):
            for i in range(n): R[a+i]=h(7+2*i)
            w=f[:6]
        else: w=ex(2)
    else: w=ex(1)
    w+=crc(w); L.write('TX '+w.hex()+'\n'); time.sleep(.01); os.write(m,w)
