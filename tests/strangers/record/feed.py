# feed.py BAUDNAME gap_ms n hex... : write telegrams to a pty, sniff on it
import os,sys,tty,termios,time,subprocess,signal,threading
gap=float(sys.argv[1])/1000; n=int(sys.argv[2]); hexes=sys.argv[3].split(','); extra=sys.argv[4:]
e,es=os.openpty(); tty.setraw(es); name=os.ttyname(es)
got=[]
def rd():
    while True:
        try: got.append(os.read(e,100))
        except OSError: return
threading.Thread(target=rd,daemon=True).start()
sn=subprocess.Popen([os.environ.get('ANTRIEB','antrieb'),'-p',name,'--parity','none','sniff']+extra)
time.sleep(0.7)
for i in range(n):
    os.write(e,bytes.fromhex(hexes[i%len(hexes)])); time.sleep(gap)
time.sleep(0.8); sn.send_signal(signal.SIGINT); print('rc',sn.wait(10)); print('sent',sum(map(len,got)))
