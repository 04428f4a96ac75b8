from mat import *
from t6 import plant,two,P,chk,R,summ,go
from t3 import ask
import fcntl,termios
def sh(r): return 'rc=%s t=%.1f :: %s'%(r.rc,r.t,(r.o[-150:]+r.e.strip()[-450:]).replace('\n',' | '))
def X(tag,d,*a,**k): r=run(d,*a,cwd=P,port=False,json_=False,timeout=30,**k); print('###',tag,sh(r),flush=True); return r
def toml(s): open(P+'/antrieb.toml','w').write(s)
if __name__=='__main__':
    # trace under ulimit, stderr
    d=Drv(); clean(); r=run(d,'--trace',W+'/t.trace','dataset','load',W+'/m.toml','--yes',json_=False,pre=['bash','-c','ulimit -f 4; exec "$0" "$@"']); print('TRACE',r.rc,[l for l in (r.e+r.o).splitlines() if 'trace' in l or 'record' in l], os.path.getsize(W+'/t.trace')); os.remove(W+'/t.trace')
    clean(); d=Drv(); r=run(d,'--trace',W+'/t.trace','dataset','load',W+'/m.toml','--yes',json_=False); print('TRACE full',os.path.getsize(W+'/t.trace')); os.remove(W+'/t.trace')
    # undo with 1376
    u=open(W+'/m.undo.toml').read()
    for n,v in(('1376','9'),('395','0')):
        open(W+'/x.undo.toml','w').write(u.replace('[values]\n','[values]\n"%s" = "%s"\n'%(n,v)).replace('[undo.values]\n','[undo.values]\n"%s" = "%s"\n'%(n,'1' if n=='1376' else '2')))
        r=run(d,'dataset','undo',W+'/x.undo.toml','--yes',json_=False); print('UNDO',n,r.rc,r.e,r.o[-900:]); d.set(1376,0,1); d.set(395,0,2)
    a,b=two(); plant(a); base=open(P+'/antrieb.toml').read(); link=P+'/line'; os.symlink(a.tty,link)
    toml(base.replace('[drives.pump]\nport = "left"\naddress = 2','[drives.pump]\nport = "%s"\naddress = 1'%link)); X('two drives at one address by a symlinked device',a,'plan')
    toml(base+'[ports.right]\npath = "%s"\nbaud = 9600\n'%link); X('one line under two port names, two settings',a,'plan')
    toml(base.replace('[drives.pump]\nport = "left"','[drives.pump]\nport = "right"')+'[ports.right]\npath = "%s"\nbaud = 9600\n'%link); X('one line under two names, drives on each',a,'plan')
    toml(base.replace('[drives.pump]\nport = "left"','[drives.pump]\nport = "right"')+'[ports.right]\npath = "%s"\n'%link); X('one line under two names, same settings',a,'apply','--yes')
    for n in('"../../evil"','"a/b"','"a b"','"{address}"','"ä"','all','"@x"','"1"','"1,2"','""','"fan.undo"'):
        plant(a); os.path.exists(link) or os.symlink(a.tty,link); toml(base.replace('[drives.pump]','[drives.%s]'%n).replace('[groups]\nall2 = ["fan", "pump"]\n','')); r=X('drive name '+n,a,'apply','--yes'); print('    ',sorted(os.listdir(P)),sorted(f for f in os.listdir(HERE) if 'evil' in f)); a.set(480,2,500); b.set(480,2,500)
    plant(a); toml(base.replace('["m.toml"]','["../../../etc/passwd"]',1)); X('file ../../etc/passwd',a,'plan')
    toml(base.replace('["m.toml"]','["antrieb.toml"]',1)); X('file antrieb.toml',a,'plan')
    toml(base.replace('["m.toml"]','["m.toml","m.toml"]',1)); X('file twice',a,'plan')
    toml(base.replace('["m.toml"]','"m.toml"',1)); X('files a string',a,'plan')
    toml(base.replace('drive = "act"','drive = "acu"',1)); X('family acu at act',a,'plan'); X('family acu at act, apply',a,'apply','--yes')
    toml(base.replace('address = 2','address = 7')); a.set(480,2,500); X('one silent',a,'plan'); r=X('one silent apply atomic',a,'apply','--yes','--atomic'); print(a.nw)
    toml(base.replace('address = 2','adresse = 2')); X('slip adresse',a,'plan')
    toml(base); X('-a typo',a,'-a','pmup','plan'); X('-a typo de',a,'--lang','de','-a','pmup','plan'); X('group',a,'-a','@all2','plan'); X('--only typo',a,'plan','--only','motr')
    os.remove(P+'/antrieb.toml'); X('no antrieb.toml',a,'plan'); X('no antrieb.toml de',a,'--lang','de','apply')
    toml(base); fd=os.open(a.tty,os.O_RDWR|os.O_NOCTTY); fcntl.flock(fd,fcntl.LOCK_EX|fcntl.LOCK_NB); X('line held by another (flock)',a,'apply','--yes'); fcntl.flock(fd,fcntl.LOCK_UN); os.close(fd)
    # question stands, b changed; then apply
    a,b=two(); plant(a)
    r=ask(a,['--lang','de','apply'],b'j\n',lambda:b.set(480,2,1234),cwd=P,port=False); print('### apply de on terminal, pump 480@2 changed while asked: rc',r.rc,b.ee[480],a.ee[480]); print(re.sub(r'.*\x1b\[2K','',r.o)[-2600:])
    a,b=two(); plant(a); r=ask(a,['apply','--atomic'],b'y\n',lambda:b.set(480,2,1234),cwd=P,port=False); print('### apply atomic on terminal: rc',r.rc,b.ee[480],a.ee[480],a.wr); print(r.o[-700:])
