import os,sys,tempfile
import drv,random,subprocess,os,signal,time,pty,fcntl
os.chdir(tempfile.mkdtemp())
open('x.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"372" = 1450\n"480" = "8 Hz"\n"400" = 4\n')
def go(what,at=2,extra=[]):
    for f in os.listdir('.'):
        if f.startswith('x.undo'): os.unlink(f)
    d=drv.Drive('acu',2,random.Random(1)); b=dict(d.ee); s=drv.Server('rtu',[d]); n={'w':0}
    m,sl=pty.openpty(); x=[m]
    def hook(sv,dd,isw,msg):
        if isw:
            n['w']+=1
            if n['w']==at:
                os.close(x[0])
    s.end=hook
    cmd=[drv.B,'--no-config','-p',s.port,'-a','2']+extra+['dataset','load','x.toml','--yes']
    kw=dict(stdin=sl,stdout=sl,stderr=sl,start_new_session=True)
    if what=='ctty': kw['preexec_fn']=lambda:fcntl.ioctl(0,0x540E,0)
    if what=='errfile': kw['stderr']=open('err.txt','w')
    if what=='outfile': kw['stdout']=open('out.txt','w')
    if what=='full': kw.update(stdin=subprocess.DEVNULL,stdout=open('/dev/full','w'),stderr=open('/dev/full','w')); s.end=None
    p=subprocess.Popen(cmd,**kw); os.close(sl); s.proc=p
    try: p.wait(40)
    except subprocess.TimeoutExpired: p.kill(); print('HANG')
    df=sorted({c[0] for c in d.ee if d.ee[c]!=b[c]})
    print(what,extra,'rc',p.returncode,'ee differs',df,'writes',len(d.writes),[f for f in os.listdir('.') if 'undo' in f])
    if what=='errfile': print(open('err.txt').read()[-800:])
    s.close()
for w in ('ctty','ctty','noctty','errfile','outfile','full'): go(w)
go('ctty',2,['--json']); go('ctty',2,['-q']); go('ctty',5)
