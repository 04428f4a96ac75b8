from h import *
import socket,tty
class Proxy:
    def __init__(s,path,rfc=False):
        s.fd=os.open(path,os.O_RDWR|os.O_NOCTTY); tty.setraw(s.fd)
        s.l=socket.socket(); s.l.setsockopt(socket.SOL_SOCKET,socket.SO_REUSEADDR,1); s.l.bind(('127.0.0.1',0)); s.l.listen(5); s.port=s.l.getsockname()[1]
        s.mode='ok'; s.stop=False; s.c=None; s.delay=0; s.q=[]
        threading.Thread(target=s.loop,daemon=True).start()
    def loop(s):
        while not s.stop:
            r=[s.l]
            if s.c and s.mode!='freeze': r.append(s.c)
            if s.mode!='freeze': r.append(s.fd)
            x,_,_=select.select(r,[],[],0.005)
            if s.mode=='rst' and s.c:
                s.c.setsockopt(socket.SOL_SOCKET,socket.SO_LINGER,struct.pack('ii',1,0)); s.c.close(); s.c=None; s.mode='refuse'; s.l.close(); continue
            if s.mode=='fin' and s.c: s.c.shutdown(socket.SHUT_RDWR); s.c.close(); s.c=None; s.mode='ok2'; continue
            if s.mode=='halffin' and s.c: s.c.shutdown(socket.SHUT_WR); s.mode='half'; continue
            if s.mode=='flood' and s.c:
                try: s.c.send(os.urandom(2000))
                except OSError: pass
            if s.mode=='refuse': time.sleep(0.01); continue
            try:
                if s.l in x: s.c,_=s.l.accept()
            except OSError: pass
            if s.c in x:
                try: d=s.c.recv(4096)
                except OSError: d=b''
                if d: os.write(s.fd,d)
                else: s.c.close(); s.c=None
            if s.fd in x:
                d=os.read(s.fd,4096)
                if s.c and s.mode!='half' and s.mode!='flood':
                    try: s.c.sendall(d)
                    except OSError: pass
def t(mode,args,resume=None):
    with act('--any-setting') as d:
        p=Proxy(d.path)
        class D: pass
        real=d.path; d.path=f'tcp://127.0.0.1:{p.port}'
        sc=[(0.8,lambda _:setattr(p,'mode',mode))]
        if resume: sc.append((0.8+resume,lambda _:setattr(p,'mode','ok')))
        r=run(d,args,sc,limit=70,after=1.5); p.stop=True
        show(f'tcp {mode} resume {resume}',r); print('    ',r['err'][-520:].replace('\n',' / '))
A4=[a.replace('6s','4s') for a in RUN]
for m,res in (('ok',None),('freeze',None),('freeze',1.0),('freeze',8.0),('rst',None),('fin',None),('halffin',None),('flood',None),('flood',1.5)): t(m,A4,res)
