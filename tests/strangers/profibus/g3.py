from g1 import *
import sys
TOK=bytes.fromhex('dc0202')
def sd2(da,sa,fc,du,ds=None,ss=None):
    b=bytes([da|(0x80 if ds is not None else 0),sa|(0x80 if ss is not None else 0),fc])+(bytes([ds,ss]) if ds is not None else b'')+du
    return b'\x68'+bytes([len(b)]*2)+b'\x68'+b+bytes([sum(b)&255,0x16])
def master(s,period,start,dur,kind='tok'):
    "another master that talks from start (callable) for dur"
    def f():
        t0=time.monotonic()
        while not (start(s) if callable(start) else time.monotonic()-t0>=start) and not s.stopme: time.sleep(.005)
        t1=time.monotonic(); s.log('MASTER 2 starts'); fcb=0
        while time.monotonic()-t1<dur and not s.stopme:
            b={'tok':TOK,'fdl':b'\x10\x09\x02\x49\x54\x16','dx':sd2(9,2,0x5D if fcb else 0x7D,b'\0'*8),'gc':sd2(127,2,0x46,b'\0\0',58,62),'noise':bytes(random.randrange(256) for _ in range(9))}[kind]
            fcb^=1; s.raw(b)
            if not s.foreign: s.foreign=time.monotonic()+len(b)*11*s.bit
            time.sleep(period)
        pass
    threading.Thread(target=f,daemon=True).start()
C=[]
for kind in('tok','fdl','dx','gc','noise'):
    C.append(('before '+kind,RUN,lambda s,kind=kind:master(s,.1,0,60,kind),None))
C+=[('before slow tok 1.0s',('read','F002'),lambda s:master(s,1.0,0,60,'tok'),None),('before slow 1.2s live',('profibus','live'),lambda s:master(s,1.2,0,60,'dx'),None),
('live later',('profibus','live'),lambda s:master(s,.2,lambda s:s.nreq>=2,60,'dx'),None),('in read',('read','F002','F003','614','703'),lambda s:master(s,.05,lambda s:s.dx_count>=10,60,'dx'),None),('in run tok',RUN,lambda s:master(s,.05,lambda s:s.out>15,60,'tok'),None),('in run dx',RUN,lambda s:master(s,.05,lambda s:s.out>15,60,'dx'),None),('in run fdl 1',RUN,lambda s:master(s,.3,lambda s:s.out>15,.2,'fdl'),None),('in run noise',RUN,lambda s:master(s,.05,lambda s:s.out>15,1,'noise'),None),
('before sollwert 0',('sollwert','0Hz'),lambda s:master(s,.1,0,60,'tok'),None),('before disable',('statemachine','disable'),lambda s:master(s,.1,0,60,'dx'),None),('before monitor',('monitor','--duration','2s'),lambda s:master(s,.1,0,60,'dx'),None),('before diag',('diag',),lambda s:master(s,.1,0,60,'dx'),None)]
if __name__=='__main__':
    k=int(sys.argv[1]); n=int(sys.argv[2]); sel=sys.argv[3:]
    for i,(nm,a,su,dr) in enumerate(C):
        if (sel and str(i) not in sel) or (not sel and i%n!=k): continue
        print('#',i,nm); S('g3-%d'%i,*a,setup=su,after=.3,drive=dr,msg=True,json_='monitor' not in a); 
