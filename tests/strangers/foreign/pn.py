# one port missing / wrong protocol line among two: capitals?
import sys
from vb import *
import h4s
L=True
def go(tag,portb,protob='rtu'):
    d=LXM(1); h4s.runsl(d); l1=Line([d])
    f=__import__('tempfile').mktemp(suffix='.toml')
    open(f,'w').write('[ports.left]\npath="%s"\nprotocol="rtu"\nbaud=19200\nparity="even"\n[ports.right]\npath="%s"\nprotocol="%s"\nbaud=19200\nparity="even"\n[drives.fan]\nport="left"\naddress=1\ndrive="lxm05"\n[drives.pump]\nport="right"\naddress=1\ndrive="%s"\n'%(l1.path,portb,protob,'acu' if protob!='rtu' else 'lxm05'))
    t0=time.time(); p=subprocess.run([BIN,'--config',f,'-a','all','statemachine','disable','--yes'],capture_output=True,text=True,timeout=60,stdin=subprocess.DEVNULL)
    print(tag,'rc',p.returncode,'took %.2f'%(time.time()-t0),'n',d.n,d.st,'cap','STILL TURN' in p.stdout+p.stderr,p.stdout[:150],p.stderr[:600],flush=True)
    l1.close()
for pr in ('dp','sdo','sdo1'): go(pr,'/dev/ttyS0' if pr=='dp' else 'can0',pr)
