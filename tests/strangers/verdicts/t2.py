from t1 import *
H=['-a','1','sollwert','10Hz','--enable','--hold','--duration','2s']
import nov
def sh(n,line,tr,o=O,maxt=30,rep=2,env=None,d=None):
    """tool started by a shell line in a terminal; PORT is replaced"""
    for i in range(rep):
        c=nov.R(); dr=d() if d else Cube(o); 
        m,sl=pty.openpty(); tty.setraw(m); tty.setraw(sl); name=os.ttyname(sl)
        tm,ts=pty.openpty(); fcntl.ioctl(ts,termios.TIOCSWINSZ,struct.pack('HHHH',24,100,0,0))
        def pre(): os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
        p=subprocess.Popen(['bash','--norc','-c',line.replace('ANT',BIN+' --no-config -p '+name)],stdin=ts,stdout=ts,stderr=ts,preexec_fn=pre,env=dict(os.environ,TERM='xterm',LC_ALL='C.UTF-8')); os.close(ts)
        t0=time.monotonic(); buf=b''; pend=[]; T_=b''; log=[]; todo=list(tr); hist=[]; alive=True
        while p.poll() is None and time.monotonic()-t0<maxt:
            now=time.monotonic(); dr.advance(now)
            for x in list(todo):
                ok=(dr.enabled is not None and now>=dr.enabled+x[1]) if x[0]=='en' else now>=t0+x[1] if x[0]=='t' else (x[0] in T_ and ((x.__class__ is tuple) and True))
                if ok: todo.remove(x); log.append((round(now-t0,2),str(x[2])[:40])); (os.write(tm,x[2]) if isinstance(x[2],bytes) else x[2](p,dr))
            while pend and pend[0][0]<=now: os.write(m,pend.pop(0)[1])
            if not hist or now-hist[-1][0]>.2: hist.append((now,round(dr.speed(),1)))
            rr,_,_=select.select([m,tm],[],[],.005)
            if m in rr:
                buf+=os.read(m,4096)
                while buf:
                    k=flen(buf)
                    if k is None or (k and len(buf)<k): break
                    if k==0: buf=b''; break
                    f,buf=buf[:k],buf[k:]; w=tell(f)
                    if w: log.append((round(now-t0,2),w))
                    if f[0]!=dr.addr: continue
                    q=dr.rtu(f,now)
                    if q: pend.append((now+.015,q))
            if tm in rr:
                try: T_+=os.read(tm,65536)
                except OSError: pass
        hang=p.poll() is None; dr.advance(time.monotonic()); e=(dr.state(),round(dr.speed(),1))
        if hang: os.killpg(p.pid,signal.SIGKILL)
        p.wait(); print('##',n,'|',line,'| rc',p.returncode,'STILL THERE' if hang else '','%.1fs'%(time.monotonic()-t0),'end',e,'speeds',[h[1] for h in hist][:60]); print('   log',log[:8],'..',log[-5:]); print('   tty',T_.decode('utf8','replace').replace('\r\n',' | ')[-500:],flush=True)
        for fd in (m,sl,tm): os.close(fd)
if __name__=='__main__':
    R='ANT -a 1 sollwert 10Hz --enable --hold --duration 2s'
    sh('question not seen: stderr to a file','%s 2>/tmp/j10e; cat /tmp/j10e'%R,[('t',1.5,b'y\n')])
    sh('stderr gone','%s 2>&-'%R,[('t',1.5,b'y\n')],rep=1)
    sh('yes | tool','yes | %s'%R,[],rep=1)
    sh('stdin a file with y','echo y >/tmp/j10y; %s </tmp/j10y'%R,[],rep=1)
    sh('stdout to file, asks','%s >/dev/null'%R,[('t',1.5,b'y\n')],rep=1)
    sh('nohup, terminal hang-up','trap "" HUP; %s --yes'%R.replace('2s','5s'),[('en',.8,lambda p,d:os.killpg(p.pid,signal.SIGHUP))])
    sh('INT ignored by parent, kill -INT, TERM','trap "" INT; %s --yes'%R.replace('2s','5s'),[('en',.8,b'\x03'),('en',1.6,lambda p,d:os.killpg(p.pid,signal.SIGTERM))],rep=1)
    sh('Ctrl-Z, bash -i','%s --yes'%R.replace('2s','3s'),[('en',.5,b'\x1a')],rep=1)
    sh('Ctrl-Backslash','%s --yes'%R.replace('2s','3s'),[('en',.5,b'\x1c')],rep=1)
    sh('background without --yes','set -m; %s & sleep 3; kill %%1; wait'%R,[],rep=1)
