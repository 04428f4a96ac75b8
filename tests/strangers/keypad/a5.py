from k import *
want=sys.argv[1:]
def on(n): return not want or any(w in n for w in want)
from a4 import stopt,hold
# hangup with stderr/stdout into files to see what is said
def hang(name,args,eo='file',how='hang',pre=1.0,opts=''):
    if not on(name): return
    with act(opts) as d:
        t=T.__new__(T); t.d=d; t.buf=b''; t.ev=[]; t.stop=False; t.reading=True
        m,sl=pty.openpty(); t.m=m; t.sl=sl; fcntl.ioctl(sl,termios.TIOCSWINSZ,struct.pack('HHHH',24,80,0,0)); t.before=termios.tcgetattr(sl)
        ef=open('/tmp/adv3.err','w+b'); of=open('/tmp/adv3.out','w+b')
        e=env(); e['TERM']='xterm-256color'
        def pr(): os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
        t.t0=time.monotonic()
        t.p=subprocess.Popen(h.cmd(d,args),stdin=sl,stdout=of if 'o' in eo else sl,stderr=ef if 'e' in eo else sl,env=e,preexec_fn=pr)
        t.th=threading.Thread(target=t._rd,daemon=True); t.th.start()
        if '--dead-man' in args: time.sleep(1.2); hold(t,'\r',1.5)
        else: t.enabled(); time.sleep(pre)
        mark=time.monotonic(); look=d.look()
        if how=='hang': t.hang()
        else: how(t)
        t.wait(20)
        print(f'## {name}: exit {t.p.poll()} before={look} end={d.look()} words {stopt(d,mark)}')
        ef.seek(0); of.seek(0); print('   ERR',ef.read().decode()[-600:].strip(),'\n   OUT',of.read().decode()[-600:].strip(),flush=True)
        if t.p.poll() is None: t.p.kill()
E1=VIEW+['--duration','8s']
hang('hang view, stderr file',E1,'e')
hang('hang view, both terminal',E1,'')
hang('hang view again, both terminal',E1,'')
hang('hang view, stdout file json',E1+['--json'],'o')
hang('hang plain held',RUN+['--duration','8s'],'')
hang('hang plain held2, err file',RUN+['--duration','8s'],'e')
hang('hang plain -v',RUN+['--duration','8s','-v'],'')
hang('hang dead-man',RUN+['--dead-man','--duration','8s'],'')
hang('hang slow ramp view',E1,'',opts='--set 421=200 --set 425=400')
# stdin variants
def st(name,args,stdin):
    if not on(name): return
    with act() as d:
        m,sl=pty.openpty(); fcntl.ioctl(sl,termios.TIOCSWINSZ,struct.pack('HHHH',24,80,0,0)); b4=termios.tcgetattr(sl)
        t0=time.monotonic(); out=[]
        pr=None
        if stdin=='closed':
            si=None; pr=lambda: os.close(0)
        elif stdin=='pipe': si=subprocess.PIPE
        elif stdin=='bg': si=sl
        else: si=open(stdin)
        def pre():
            os.setsid()
            fcntl.ioctl(sl if False else 1,termios.TIOCSCTTY,0)
            if pr: pr()
        p=subprocess.Popen(h.cmd(d,args),stdin=si,stdout=sl,stderr=sl,env={**env(),'TERM':'xterm'},preexec_fn=pre)
        th=threading.Thread(target=lambda:[out.append(x) for x in iter(lambda:os.read(m,9999),b'')],daemon=True); th.start()
        if stdin=="pipe":
            try: time.sleep(2); p.stdin.write(b"\x1b[A\x1b[A"); p.stdin.flush(); time.sleep(.5); p.stdin.write(b"q"); p.stdin.close()
            except OSError as x: print(x)
        try: p.wait(15)
        except Exception: print('HANG')
        print(f'## stdin {name}: exit {p.poll()} {time.monotonic()-t0:.1f}s end={d.look()} termios same {termios.tcgetattr(sl)==b4} max {maxout(d)}')
        print('   ',re.sub(rb'\x1b\[[0-9;?]*[a-zA-Z]',b'',b''.join(out)).decode()[-500:].strip().replace('\r\n','\n    '),flush=True)
        if p.poll() is None: p.kill()
for n,s in (('pipe','pipe'),('null','/dev/null'),('closed','closed')):
    st(n+' view',E1,s)
    st(n+' dead-man',RUN+['--dead-man','--duration','4s'],s)
