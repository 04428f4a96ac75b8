from judge import *
import subprocess
def sh(name,pre,args,cfg=None,at=(),limit=40,after=4,out=subprocess.PIPE):
    d=Drive(life=limit+30,**dict(dict(p412=1,m44_keypad=1,log='/tmp/cube-b2.log'),**(cfg or {})))
    t0=time.monotonic(); cmd=pre+'; exec %s -p %s -a 1 %s'%(BIN,d.tty,args)
    p=subprocess.Popen(['bash','-c',cmd],stdin=subprocess.DEVNULL,stdout=out,stderr=subprocess.PIPE,cwd='/tmp/adv22',env=ENV,start_new_session=True)
    import threading
    def tk():
        for x,f in at:
            time.sleep(max(0,t0+x-time.monotonic())); f(p,d)
    threading.Thread(target=tk,daemon=True).start()
    hung=False
    try: o,e=p.communicate(timeout=limit)
    except subprocess.TimeoutExpired: hung=True; p.kill(); o,e=p.communicate()
    x=d.dump(); time.sleep(after if turning(x) else 0.2); y=d.dump(); pr=[]
    if hung: pr.append('HANG')
    if p.returncode<0 or p.returncode==70 or b'panick' in e: pr.append('KILLED/CRASH')
    if turning(x): pr.append('TURNS %.1f %s'%(x['shaft'],x['state']))
    if turning(y): pr.append('STILL %.1f'%y['shaft'])
    print('== %-28s rc=%s t=%.1f maxf=%s end=%s | %s | %s'%(name,p.returncode,time.monotonic()-t0,x['maxf'],x['state'],'; '.join(pr) or '-',e.decode(errors='replace').strip()[-330:].replace('\n',' / '))); sys.stdout.flush(); d.stop()
    return p,o
if __name__=='__main__':
    R='--yes sollwert 10Hz --enable --hold --duration 3s'
    os.system('rm -f /tmp/adv22/*.rec; mkfifo /tmp/adv22/tff 2>/dev/null')
    sh('ulimit -f 4 trace','ulimit -f 4',R+' --trace a1.rec'); sh('ulimit -f 8 trace','ulimit -f 8',R+' --trace a2.rec')
    sh('trace /dev/full','true',R+' --trace /dev/full --force'); sh('trace fifo','true',R+' --trace tff --force',limit=20); sh('trace dir','true',R+' --trace dir --force'); sh('trace exists','touch e.rec',R+' --trace e.rec')
    sh('stdout full json','true',R+' --json >/dev/full'); sh('stdout full ndjson','true',R+' --format ndjson >/dev/full'); sh('stdout closed','true',R+' --json >&-'); sh('stderr closed','true',R+' 2>&-'); sh('stderr full','true',R+' 2>/dev/full'); sh('all closed','true',R+' <&- >&- 2>&-')
    sh('ndjson pipe head','true',R+' --format ndjson | head -2 >/dev/null; exit ${PIPESTATUS[0]}'.replace('exec ','') )
    for n in (3,4,5,6,8): sh('ulimit -n %d'%n,'ulimit -n %d'%n,R)
    sh('ulimit -v 60M','ulimit -v 60000',R); sh('ulimit -t 1','ulimit -t 1',R); sh('ulimit -u 1','ulimit -u 1',R)
    sh('slow reader ndjson','true',R.replace('3s','6s')+' --format ndjson | (sleep 12; cat >/dev/null)')
