from bench import *; from ptyrun import Pty
import sys
def turning(x): return x is not None and abs(x['shaft'])>0.05
def view(name,args,keys,limit=40,cfg=None,show=0):
    d=Drive(life=limit+30,**dict(dict(p412=1,m44_keypad=1,log='/tmp/cube-'+name.replace(' ','_')+'.log'),**(cfg or {})))
    p=Pty(['-p',d.tty,'-a','1']+args); p.d=d
    p.go(keys,limit); e=d.dump(); time.sleep(1.5); l=d.dump()
    pr=[]
    if p.hung: pr.append('HANG')
    if p.rc==70 or b'panick' in p.buf: pr.append('CRASH')
    if turning(e): pr.append('TURNS at exit %.2f %s'%(e['shaft'],e['state']))
    if turning(l): pr.append('STILL %.2f'%l['shaft'])
    if e['state']=='OE': pr.append('ENABLED')
    if not p.closed and p.after!=p.before: pr.append('TERMIOS not restored')
    if not p.closed and p.buf.count(b'\x1b[?1049h')!=p.buf.count(b'\x1b[?1049l'): pr.append('alt screen left')
    if not p.closed and p.buf.count(b'\x1b[?25l')>0 and p.buf.rfind(b'\x1b[?25l')>p.buf.rfind(b'\x1b[?25h'): pr.append('cursor hidden')
    for k in('p412','p413','p434'):
        if e[k]!=[1]*4 and k=='p412' or k=='p413' and e[k]!=[0]: pr.append(k+str(e[k]))
    print('== %-26s rc=%s t=%.1f maxf=%s starts=%s end=%s line=%s | %s'%(name,p.rc,p.t,e['maxf'],e['starts'],e['state'],e['line'],'; '.join(pr) or '-'))
    i=p.buf.rfind(b'\x1b[?1049l'); t=p.buf[i+8:] if i>=0 else p.buf[-900:]
    import re
    print('    last:',re.sub(r'\x1b\[[0-9;?]*[A-Za-z]','',t.decode(errors='replace')).strip()[-700:].replace('\r\n',' / '))
    if show: print(p.text[-show:])
    sys.stdout.flush(); d.stop(); p.end(); return p
def D(c): return lambda s:s.d.cmd(c)
S=lambda sg:(lambda s:s.p.send_signal(sg))
V=['sollwert','10Hz','--enable','--hold','--view']
if __name__=='__main__':
    y=(1.5,b'y\r')
    view('view q',V,[y,(5,b'q')])
    view('view space q',V,[y,(4,b' '),(7,b'q')])
    view('view esc',V,[y,(5,b'\x1b')])
    view('view ctrlc',V,[y,(5,b'\x03')])
    view('view ctrlc2',V,[y,(5,b'\x03'),(5.3,b'\x03')])
    view('view duration',V+['--duration','2s'],[y,(9,b'q')])
    view('view hangup',V,[y,(5,lambda s:s.hangup())])
    view('view term',V,[y,(5,S(15))])
    view('view hup',V,[y,(5,S(1))])
    view('view stop cont',V,[y,(4,S(20)),(6,S(18)),(8,b'q')])
    view('view dead',V,[y,(4,D('dead')),(6,b'q')],limit=60)
    view('view dead space',V,[y,(4,D('dead')),(6,b' '),(40,b'q')],limit=80)
    view('view fault',V,[y,(4,D('fault 0500')),(8,b'q')])
    view('view up down',['sollwert','5Hz','--enable','--hold','--view','--step','1Hz','--min','0Hz','--max','8Hz','--source','line'],[y]+[(3+.2*i,b'\x1b[A') for i in range(6)]+[(6+.2*i,b'\x1b[B') for i in range(3)]+[(9,b'q')],cfg=dict(fmin=0))
    view('view d',V,[y,(4,b'd'),(6,b'd'),(7,b'q')])
    view('view junk',V,[y]+[(3+i*.05,bytes([33+i%90])) for i in range(80)if 33+i%90 not in(100,113)]+[(9,b'q')])
    view('view n',V,[(1.5,b'n\r')])
    view('view eof',V,[(1.5,b'\x04')])
    view('view ctrlc at question',V,[(1.5,b'\x03')])
    view('deadman tap',['sollwert','10Hz','--enable','--hold','--dead-man'],[y,(3,b'\r'),(9,b'q')])
    view('deadman hold',['sollwert','10Hz','--enable','--hold','--dead-man'],[y]+[(3+i*.05,b'\r') for i in range(60)]+[(10,b'q')])
    view('deadman arrows',['sollwert','10Hz','--enable','--hold','--dead-man'],[y]+[(3+i*.05,b'\x1b[A') for i in range(60)]+[(10,b'q')])
