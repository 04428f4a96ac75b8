"""Modbus over TCP: raw tcp:// and mbtcp:// against an ACU, with a hostile server"""
from j import *
import socket,threading
class Srv:
    def __init__(s,d,mode,hook=None):
        s.d=d; s.mode=mode; s.hook=hook; s.l=socket.socket(); s.l.setsockopt(socket.SOL_SOCKET,socket.SO_REUSEADDR,1); s.l.bind(('127.0.0.1',0)); s.l.listen(5); s.port=s.l.getsockname()[1]
        s.stop=False; s.n=0; s.words=[]; s.t0=time.monotonic(); s.conns=0; s.mutef=lambda:False; s.kill=None; s.refuse=False; s.cur=None; s.lock=threading.Lock(); s.hist=[]
        threading.Thread(target=s.acc,daemon=True).start(); threading.Thread(target=s.tick,daemon=True).start()
    def tick(s):
        while not s.stop:
            with s.lock: s.d.advance(time.monotonic()); s.hist.append((round(time.monotonic()-s.t0,2),s.d.state(),round(s.d.speed(),1)))
            time.sleep(.02)
    def acc(s):
        while not s.stop:
            try: c,_=s.l.accept()
            except OSError: return
            s.conns+=1; s.cur=c; threading.Thread(target=s.serve,args=(c,),daemon=True).start()
    def serve(s,c):
        buf=b''
        while not s.stop:
            try: x=c.recv(4096)
            except OSError: return
            if not x: return
            buf+=x
            while True:
                if s.mode=='mb':
                    if len(buf)<6: break
                    ln=struct.unpack('>H',buf[4:6])[0]
                    if len(buf)<6+ln: break
                    tid=buf[:2]; pdu=buf[6:6+ln]; buf=buf[6+ln:]; f=crc(pdu)
                else:
                    n=flen(buf)
                    if n is None or (n and len(buf)<n): break
                    if n==0: buf=b''; break
                    f,buf=buf[:n],buf[n:]; tid=None
                s.n+=1; w=tell(f); now=time.monotonic()
                if w: s.words.append((round(now-s.t0,2),w))
                with s.lock: s.d.advance(now); r=s.d.rtu(f,now) if f[0]==s.d.addr else None
                if r is None: continue
                outs=[(.005,r)] if not s.hook else s.hook(s,f,r,tid)
                for dl,b in outs:
                    m=b if s.mode!='mb' or not isinstance(b,bytes) else tid+b'\0\0'+struct.pack('>H',len(b)-2)+b[:-2]
                    if isinstance(b,tuple): m=b[0]
                    def go(m=m):
                        try: c.sendall(m)
                        except OSError: pass
                    threading.Timer(dl,go).start()
def go(name,mode,args,opt='--family acu --set 418=0 --set 434=2 --set 638=5 ',hook=None,at=(),rep=2,limit=90,addr=1):
    for i in range(rep):
        d=Cube(opt,addr); S=Srv(d,mode,hook)
        p=subprocess.Popen(['nice',BIN,'--no-config','-p',('mbtcp' if mode=='mb' else 'tcp')+'://127.0.0.1:%d'%S.port,'-a',str(addr)]+args,stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE)
        S.p=p; t0=time.monotonic(); todo=list(at)
        o=[b'',b'']; th=threading.Thread(target=lambda: o.__setitem__(slice(0,2),p.communicate()),daemon=True); th.start()
        hang=False
        while p.poll() is None:
            now=time.monotonic()
            for t in list(todo):
                if d.enabled is not None and now>=d.enabled+t[0]: todo.remove(t); t[1](S)
            if now-t0>limit: hang=True; p.kill(); break
            time.sleep(.01)
        with S.lock: d.advance(time.monotonic()); end=(d.state(),round(d.speed(),1))
        dur=time.monotonic()-t0; th.join(3); time.sleep(.5)
        with S.lock: d.advance(time.monotonic()); later=(d.state(),round(d.speed(),1))
        S.stop=True; S.l.close()
        print('##',name,mode,' '.join(args),'\n  rc',p.returncode,'%.1fs'%dur,'HANG' if hang else '','end',end,'later',later,'conns',S.conns,'n',S.n,'speeds',[h[2] for h in S.hist][::25],'diff',d.diff()); print('  words',S.words[:14]); print('  out',o[0].decode().strip().replace('\n',' | ')[:500]); print('  err',o[1].decode().strip().replace('\n',' | ')[-500:],flush=True)
def fin(S): S.cur.close() if False else S.cur.shutdown(socket.SHUT_RDWR)
def rst(S): S.cur.setsockopt(socket.SOL_SOCKET,socket.SO_LINGER,struct.pack('ii',1,0)); S.cur.close()
def shutw(S): S.cur.shutdown(socket.SHUT_WR)
def down(S): S.l.close(); rst(S)
H=['sollwert','10Hz','--enable','--hold','--duration','3s','--yes']
if __name__=='__main__':
    A=sys.argv[1:]
    C={
 'plain':lambda m:go('plain',m,H,rep=1),
 'fin':lambda m:go('FIN at 0.8',m,H,at=[(.8,fin)]),
 'rst':lambda m:go('RST at 0.8',m,H,at=[(.8,rst)]),
 'down':lambda m:go('server gone at 0.8',m,H,at=[(.8,down)]),
 'half':lambda m:go('half closed at 0.8',m,H,at=[(.8,shutw)]),
 'qsfin':lambda m:go('qs, FIN at the first telegram',m,['statemachine','quick-stop'],opt='--family acu --set 418=0 --set 434=2 --running --left 20 ',hook=lambda s,f,r,t:(s.n==1 and (fin(s) or [])) or [(.005,r)]),
 'dbl':lambda m:go('doubled',m,H,hook=lambda s,f,r,t:[(.005,r),(.1,r)],rep=1),
 'late':lambda m:go('late .8',m,H,hook=lambda s,f,r,t:[(.8,r)],rep=1),
 'tid':lambda m:go('wrong tid every 3rd',m,H,hook=lambda s,f,r,t:[(.005,(struct.pack('>H',99)+b'\0\0'+struct.pack('>H',len(r)-2)+r[:-2],))] if s.n%3==0 else [(.005,r)],rep=1),
 'one':lambda m:go('byte by byte 30ms',m,H,hook=lambda s,f,r,t:[(.03*i,(bytes([x]),)) for i,x in enumerate(t+b'\0\0'+struct.pack('>H',len(r)-2)+r[:-2] if t else r)],rep=1),
 'len':lambda m:go('length says 65535',m,H,hook=lambda s,f,r,t:[(.005,((t or b'')+b'\0\0\xff\xff'+r[:-2],))] if s.n>20 else [(.005,r)],rep=1),
 'stale':lambda m:go('previous reply under the current tid',m,['read','372@2','376@2','480@2','481@2','482@2','411','412'],hook=lambda s,f,r,t:[(.005,getattr(s,'pv',r))] if not s.__dict__.__setitem__('pv2',getattr(s,'pv',None)) and not s.__dict__.__setitem__('pv',r) and s.n==9 and s.pv2 else [(.005,r)],rep=1),
}
    for n in A[1:] or C: C[n](A[0])
