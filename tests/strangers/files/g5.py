from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
import resource,hashlib,shutil
d=Drive()
def ls(p=W): return sorted((f,os.lstat(p+'/'+f).st_size) for f in os.listdir(p) if f.startswith(('s','.s','t')) )
def S(*a,**k): 
    k.setdefault('limit',60); return run(['dataset','save',*a,'--timeout','150ms'],d,**k)
def sv(r): return 'rc=%s t=%.1f | %s | hint %s | err %s'%(r.rc,r.t,((r.j or {}).get('error') or {}).get('message','')[:250],((r.j or {}).get('error') or {}).get('hint'),[l[:150] for l in r.err.splitlines()[-3:]])
for f in os.listdir(W):
    if f.startswith(('s','t','.s')): p=W+'/'+f; (shutil.rmtree if os.path.isdir(p) and not os.path.islink(p) else os.remove)(p)
r=S('s1.toml'); ref=[l for l in open(W+'/s1.toml') if l.startswith('"')]; print('whole',sv(r),len(ref))
h=open(W+'/s1.toml').read(); r=S('s1.toml'); print('exists',sv(r),open(W+'/s1.toml').read()==h)
# symlink
os.symlink('s1.toml',W+'/sl.toml'); r=S('sl.toml'); print('symlink no force',sv(r)); r=S('sl.toml','--force'); print('symlink force',sv(r),os.path.islink(W+'/sl.toml'),ls())
os.symlink('nowhere/x.toml',W+'/sdang.toml'); r=S('sdang.toml'); print('dangling',sv(r),os.path.islink(W+'/sdang.toml'),ls())
os.mkfifo(W+'/sfifo'); r=S('sfifo',limit=20); print('fifo',sv(r),'HUNG' if r.hung else '',os.path.exists(W+'/sfifo')); r=S('sfifo','--force',limit=20); import stat; print('fifo force',sv(r),'HUNG' if r.hung else '',stat.S_ISFIFO(os.lstat(W+'/sfifo').st_mode))
d.clr(); r=S('/dev/null','--force'); print('/dev/null',sv(r),stat.S_ISCHR(os.stat('/dev/null').st_mode),d.n); r=S('/dev/full','--force'); print('/dev/full',sv(r), stat.S_ISCHR(os.stat('/dev/full').st_mode))
r=S('/proc/self/x'); print('proc',sv(r),d.n)
d.clr(); r=S('nodir/x.toml'); print('nodir',sv(r),'telegrams',d.n)
r=S('-',js=False); print('dash',sv(r),ls(),os.path.exists(W+'/-'))
r=S(''); print('empty name',sv(r))
r=S('s'*300); print('long',sv(r))
r=S('s\xff\n.toml'); print('newline name',sv(r),ls())
# ulimit -f
def lim(n): return lambda: (resource.setrlimit(resource.RLIMIT_FSIZE,(n,n)))
for n in(0,100,2000,4000): r=S('sul%d.toml'%n,pre=lim(n)); print('ulimit',n,sv(r),[x for x in ls() if 'sul' in x[0]])
# tmpfs
os.makedirs('/tmp/n22fs',exist_ok=True); m=subprocess.run(['mount','-t','tmpfs','-o','size=8k','tmpfs','/tmp/n22fs'],capture_output=True,text=True); print('mount',m.returncode,m.stderr.strip())
if m.returncode==0:
    r=S('/tmp/n22fs/a.toml'); print('fs1',sv(r),os.listdir('/tmp/n22fs'))
    open('/tmp/n22fs/fill','wb').write(b'x'*4096); r=S('/tmp/n22fs/b.toml'); print('fs2',sv(r),[(f,os.path.getsize('/tmp/n22fs/'+f)) for f in os.listdir('/tmp/n22fs')])
    open('/tmp/n22fs/m.toml','w').close(); shutil.copy(W+'/m.toml','/tmp/n22fs/m.toml') if False else None
    d.clr(); r=run(['dataset','load','m.toml','--yes','--undo-file','/tmp/n22fs/u.toml'],d); print('load, undo on full disk',d.nw,s(r),os.listdir('/tmp/n22fs'))
    subprocess.run(['umount','/tmp/n22fs'])
d.clr(); r=run(['dataset','load','m.toml','--yes','--undo-file','nodir/u.toml'],d); print('undo nodir',d.nw,s(r))
open(W+'/uex.toml','w').write('x'); r=run(['dataset','load','m.toml','--yes','--undo-file','uex.toml'],d); print('undo exists',d.nw,s(r)); r=run(['dataset','load','m.toml','--yes','--force','--undo-file','m.toml'],d); print('undo=source',d.nw,s(r),open(W+'/m.toml').read()==FILE)
r=run(['dataset','load','m.toml','--yes','--undo-file','/dev/null'],d); print('undo /dev/null',d.nw,s(r))
r=run(['dataset','load','m.toml','--yes'],d,pre=lim(100)); print('undo ulimit',d.nw,s(r),glob.glob(W+'/m.und*'))
for fm in('json','csv','ndjson'):
    r=S('sf.%s'%fm,'--format',fm); print(fm,r.rc,len(r.out),r.out[:300].replace('\n','|'),ls()[-3:])
d.stop()
