import socket,subprocess,time,os,threading
import os; B=os.environ.get('ANTRIEB','antrieb')
l=socket.socket(); l.bind(('127.0.0.1',0)); l.listen(5); p=l.getsockname()[1]
for pr in ('mbtcp','tcp'):
  for a in (['read','411'],['statemachine','quick-stop'],['identify'],['sollwert','10Hz','--enable','--hold','--duration','1s','--yes']):
    t=time.time(); r=subprocess.run([B,'--no-config','-p','%s://127.0.0.1:%d'%(pr,p),'-a','1']+a,capture_output=True,text=True,stdin=subprocess.DEVNULL); print(pr,a[:2],'rc',r.returncode,'%.1fs'%(time.time()-t),r.stderr.strip().split('\n')[0][:160],flush=True)
# full backlog: connect hangs
l2=socket.socket(); l2.bind(('127.0.0.1',0)); l2.listen(0); q=l2.getsockname()[1]; hold=[]
for i in range(3):
    s=socket.socket(); s.setblocking(False)
    try: s.connect(('127.0.0.1',q))
    except BlockingIOError: pass
    hold.append(s)
time.sleep(.3)
for a in (['statemachine','quick-stop'],['read','411']):
    t=time.time()
    try: r=subprocess.run([B,'--no-config','-p','tcp://127.0.0.1:%d'%q,'-a','1']+a,capture_output=True,text=True,stdin=subprocess.DEVNULL,timeout=60); print('connect hangs',a,'rc',r.returncode,'%.1fs'%(time.time()-t),r.stderr.strip()[:250])
    except subprocess.TimeoutExpired: print('connect hangs',a,'HANG 60 s')
# flood
def flood(c,rate):
    try:
        while True: c.sendall(os.urandom(64)); time.sleep(rate)
    except OSError: pass
l3=socket.socket(); l3.bind(('127.0.0.1',0)); l3.listen(9); z=l3.getsockname()[1]
def acc():
    while True:
        c,_=l3.accept(); threading.Thread(target=flood,args=(c,.002),daemon=True).start()
threading.Thread(target=acc,daemon=True).start()
for pr in ('mbtcp','tcp'):
  for a in (['statemachine','quick-stop'],['read','411'],['sollwert','10Hz','--enable','--hold','--duration','1s','--yes']):
    t=time.time()
    try: r=subprocess.run(['nice',B,'--no-config','-p','%s://127.0.0.1:%d'%(pr,z),'-a','1']+a,capture_output=True,text=True,stdin=subprocess.DEVNULL,timeout=90); print('flood',pr,a[:2],'rc',r.returncode,'%.1fs'%(time.time()-t),r.stderr.strip()[:200],flush=True)
    except subprocess.TimeoutExpired: print('flood',pr,a,'HANG 90 s',flush=True)
