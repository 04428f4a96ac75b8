from mat import *
from t6 import plant,two,P,chk,R,summ,go
A=HERE+'/adv'; os.makedirs(A,exist_ok=True)
def ls(p): return {f:(os.path.islink(p+'/'+f) and '->'+os.readlink(p+'/'+f)) or os.path.getsize(p+'/'+f) for f in sorted(os.listdir(p))}
def short(r): return 'rc=%s t=%.1f :: %s'%(r.rc,r.t,r.e.strip()[-420:].replace('\n',' | '))
def fresh():
    shutil.rmtree(A,ignore_errors=True); os.makedirs(A); shutil.copy(W+'/m.toml',A+'/m.toml'); d=Drv(); return d,d.snap()
def rep(tag,d,b,r): print('###',tag,short(r),'nw',d.nw,'wrmax',max(d.wr.values(),default=0),'diffs',len(diffs(b,d.snap())),ls(A),flush=True); d.stop=True
L=['dataset','load',A+'/m.toml','--yes']
# ulimit -f
for k in(0,1,2):
    d,b=fresh(); r=run(d,*L,json_=False,pre=['bash','-c','ulimit -f %d; exec "$0" "$@"'%k]); rep('load ulimit -f %d'%k,d,b,r)
d,b=fresh(); r=run(d,'--trace',A+'/t.trace',*L,json_=False,pre=['bash','-c','ulimit -f 4; exec "$0" "$@"']); rep('load --trace ulimit -f 4 (KiB)',d,b,r)
d,b=fresh(); r=run(d,'dataset','save',A+'/s.toml',json_=False,pre=['bash','-c','ulimit -f 1; exec "$0" "$@"']); rep('save ulimit -f 1',d,b,r)
# tmpfs
T=HERE+'/tmpfs'; os.makedirs(T,exist_ok=True)
if subprocess.call(['mount','-t','tmpfs','-o','size=16k','tmpfs',T])==0:
    try:
        for fill in(12288,8192):
            for f in os.listdir(T): os.remove(T+'/'+f)
            shutil.copy(W+'/m.toml',T+'/m.toml'); open(T+'/fill','wb').write(b'x'*(fill if fill<12288 else 12288))
            d=Drv(); b=d.snap(); r=run(d,'dataset','load',T+'/m.toml','--yes',json_=False); print('### tmpfs fill %d load'%fill,short(r),'nw',d.nw,ls(T))
            r=run(d,'dataset','save',T+'/s.toml',json_=False); print('### tmpfs save',short(r),ls(T))
            d=Drv(); d.reset(); r=run(d,'--trace',T+'/t','dataset','load',W+'/m.toml','--yes',json_=False); print('### tmpfs trace load',short(r),'nw',d.nw,ls(T)); clean()
    finally: subprocess.call(['umount',T])
# read-only directory: as nobody
d,b=fresh(); os.chmod(A,0o755); os.chmod(A+'/m.toml',0o644)
os.system('chmod o+rw '+d.tty)
r=run(d,*L,json_=False,pre=['setpriv','--reuid=65534','--regid=65534','--clear-groups']); rep('readonly dir as nobody',d,b,r)
d,b=fresh(); os.system('chmod o+rw '+d.tty); r=run(d,'dataset','save',A+'/s.toml',json_=False,pre=['setpriv','--reuid=65534','--regid=65534','--clear-groups']); rep('save readonly dir as nobody',d,b,r)
# symlinks
d,b=fresh(); os.symlink(A+'/victim',A+'/m.undo.toml'); r=run(d,*L,json_=False); rep('undo dangling symlink',d,b,r)
d,b=fresh(); open(A+'/victim','w').write('keep'); os.symlink(A+'/victim',A+'/m.undo.toml'); r=run(d,*L,json_=False); rep('undo symlink to file',d,b,r)
d,b=fresh(); open(A+'/victim','w').write('keep'); os.symlink(A+'/victim',A+'/u.toml'); r=run(d,*L,'--undo-file',A+'/u.toml',json_=False); rep('--undo-file is a symlink',d,b,r)
d,b=fresh(); open(A+'/victim','w').write('keep'); os.symlink(A+'/victim',A+'/s.toml'); r=run(d,'dataset','save',A+'/s.toml','--force',json_=False); rep('save --force onto a symlink',d,b,r)
d,b=fresh(); r=run(d,*L,'--undo-file',A+'/m.toml',json_=False); rep('--undo-file = the file itself',d,b,r)
d,b=fresh(); r=run(d,*L,'--undo-file',A+'/m.toml','--force',json_=False); rep('--undo-file = the file itself --force',d,b,r)
d,b=fresh(); os.mkfifo(A+'/f'); r=run(d,'dataset','load',A+'/f','--yes',json_=False,timeout=8); rep('load a FIFO',d,b,r)
d,b=fresh(); r=run(d,'dataset','load',A,'--yes',json_=False,timeout=8); rep('load a directory',d,b,r)
d,b=fresh(); r=run(d,'dataset','load','/dev/zero','--yes',json_=False,timeout=8); rep('load /dev/zero',d,b,r)
# hostile undo file
d,b=fresh(); r=run(d,*L); u=open(A+'/m.undo.toml').read()
for tag,x in(('truncated half',u[:len(u)//2]),('truncated in undo.values',u[:-60]),('no [undo]',u.split('# What was')[0]),('undo.values with less keys',u.replace('"549" = "7.00 %"  # control-deviation\n','')),('memory=both',u.replace('"eeprom"','"both"')),('memory ram',u.replace('"eeprom"','"ram"')),('extra value 481',u.replace('[values]\n','[values]\n"481" = "9.99 Hz"\n')),('1376',u.replace('[values]\n','[values]\n"1376" = "9"\n').replace('[undo.values]\n','[undo.values]\n"1376" = "1"\n'))):
    open(A+'/x.undo.toml','w').write(x); d2=Drv(); [d2.set(n,i+1 if len(d2.ee[n])>1 else 0,v) for (n,i),v in TG.items()]; b2=d2.snap(); r=run(d2,'dataset','undo',A+'/x.undo.toml','--yes',json_=False); print('### undo file',tag,short(r),'nw',d2.nw,'diffs',len(diffs(b2,d2.snap())),d2.ee[1376],d2.ee[481],flush=True); d2.stop=True
