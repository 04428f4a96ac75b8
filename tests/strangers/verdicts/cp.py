from j import *
O='--family acu --set 418=0 --set 434=2 --set 638=5 '
def go(n,d,a,how,tr=(),limit=60,json_=True):
    """own runner: stdout a pipe closed at once ('closed'), or closed mid; via nov with out=... not possible, so a thread line"""
    import threading
    m,sl=pty.openpty(); tty.setraw(m); tty.setraw(sl); name=os.ttyname(sl)
    r,w=os.pipe()
    os.close(r) if how=='closed' else None
    p=subprocess.Popen([BIN,'--no-config','-p',name]+a,stdin=subprocess.DEVNULL,stdout=w,stderr=subprocess.PIPE); os.close(w)
    t0=time.monotonic(); buf=b''; pend=[]
    err=[b'']; th=threading.Thread(target=lambda: err.__setitem__(0,p.stderr.read()),daemon=True); th.start()
    tr=list(tr); st={'mute':False}
    while p.poll() is None and time.monotonic()-t0<limit:
        now=time.monotonic(); d.advance(now)
        for x in list(tr):
            if d.enabled is not None and now>=d.enabled+x[0]: tr.remove(x); x[1](st,p,r)
        while pend and pend[0][0]<=now:
            b=pend.pop(0)[1]
            os.write(m,b)
        rr,_,_=select.select([m],[],[],.005)
        if rr:
            buf+=os.read(m,4096)
            while buf:
                k=flen(buf)
                if k is None or (k and len(buf)<k): break
                if k==0: buf=b''; break
                f,buf=buf[:k],buf[k:]
                if st['mute'] or d.dead or f[0]!=d.addr: continue
                q=d.rtu(f,now)
                if q: pend.append((now+.015,q))
    hang=p.poll() is None
    if hang: p.kill()
    p.wait(); d.advance(time.monotonic()); th.join(2)
    print('##',n,a,how,'rc',p.returncode,'HANG' if hang else '','%.1fs'%(time.monotonic()-t0),d.state(),round(d.speed(),1),'| err',err[0].decode().strip().replace('\n',' | ')[-350:],flush=True)
    os.close(m); os.close(sl)
    if how!='closed':
        try: os.close(r)
        except OSError: pass
RUN='--running --left 20 '
def dead(d): d.dead=True; return d
for i in (1,2):
  for v in (['statemachine','quick-stop'],['statemachine','quick-stop','--json'],['sollwert','0'],['statemachine','disable'],['-q','statemachine','quick-stop']):
    a=['-a','1']+v if v[0]!='-q' else ['-q','-a','1']+v[1:]
    go('dead drive, stdout closed',dead(Cube(O+RUN)),a,'closed')
  go('P.412=0, stdout closed',Cube('--family acu --set 418=0 --set 434=2 --set 412=0 --running --internal 20'),['-a','1','statemachine','quick-stop'],'closed')
  go('held, ndjson, reader goes at .5, and the line with it',Cube(O),['-a','1','sollwert','10Hz','--enable','--hold','--duration','4s','--yes','--format','ndjson'],'mid',tr=[(.5,lambda st,p,r:(st.__setitem__('mute',True),os.close(r)))])
  go('held, json, reader gone from the start, line dead at .5',Cube(O),['-a','1','sollwert','10Hz','--enable','--hold','--duration','1s','--yes','--json'],'closed',tr=[(.5,lambda st,p,r:st.__setitem__('mute',True))])
