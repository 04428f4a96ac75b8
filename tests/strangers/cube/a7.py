from ptyrun import *; from bench import *; import subprocess,sys
def one(label,opts,keys,n=12):
    d=Drive(life=60,p412=1,m44_keypad=1,log='log/ctrlz.log')
    m,sl=os.openpty(); fcntl.ioctl(sl,termios.TIOCSWINSZ,struct.pack('HHHH',24,80,0,0))
    def pre(): os.setsid(); fcntl.ioctl(0,termios.TIOCSCTTY,0)
    p=subprocess.Popen(['bash','--norc','-i'],stdin=sl,stdout=sl,stderr=sl,env=ENV,preexec_fn=pre)
    t0=time.monotonic(); buf=b''; keys=[(0.5,f'{BIN} -p {d.tty} -a 1 sollwert 10Hz --enable --hold --yes {opts}\r'.encode())]+keys; i=0; st=[]
    while time.monotonic()-t0<n:
        while i<len(keys) and time.monotonic()-t0>=keys[i][0]: os.write(m,keys[i][1]); i+=1
        if select.select([m],[],[],0.1)[0]: buf+=os.read(m,65536)
        if not st or time.monotonic()-t0-st[-1][0]>1: x=d.dump(); st.append((time.monotonic()-t0,x['state'],x['shaft'],x['p413']))
    print(label); print([ '%.0fs %s %.1f %s'%s for s in st]); import re
    print(re.sub(r'\x1b\[[0-9;?]*[A-Za-z]','',buf.decode(errors='replace'))[-900:].replace('\r\n',' / '))
    os.write(m,b'kill -KILL %1\r'); time.sleep(0.5); p.kill(); p.wait(); d.stop(); os.close(m); os.close(sl)
one('ctrl-z','',[(4,b'\x1a'),(6,b'jobs\r'),(9,b'fg\r'),(11,b'\x03')],15)
one('ctrl-z, never back','',[(4,b'\x1a'),(6,b'jobs\r')],12)
one('ctrl-z wd','--watchdog 2s',[(4,b'\x1a'),(6,b'jobs\r'),(9,b'fg\r')],16)
one('bg from start: &','&',[(5,b'jobs\r'),(6,b'kill -INT %1\r')],14)
one('ctrl-z view','--view',[(4,b'\x1a'),(6,b'q')],12)
