# my own LXM05 on a pty: codes 3, 16, 23, 8, 43/14; 32 bits a parameter in two registers, high word first; strict
import sys,os,random,subprocess,json,time,shutil,threading,struct

import drive
from drive import Bus,crc
A=os.environ['ANTRIEB']
RW={1284:0,1544:2**31-1,1546:-2**31,1554:13200,1556:600,1558:600,5638:19200,5640:1,5642:2,5644:0,5646:0,9734:1,9736:1,10248:60,10250:6,10504:60,10506:180,6914:0,6918:0,6930:0,6936:17,6938:0,6940:0,6942:60,6944:0,6946:0,6948:0,8200:0,8456:0}
RO={6916:0x250,6920:0,7700:12345,15362:0,15364:0,15366:0,15368:0}
SET=[1544,1546,1554,1556,1558,9734,9736,10248,10250,10504,10506]
class Lxm:
    def __init__(s,addr=1):
        s.addr=addr; s.v=dict(RW); s.n=0; s.wn=0; s.off_until=0; s.running=False; s.w=0; s.clamp=None; s.saved=dict(RW)
    def exc(s,fc,c): return bytes([s.addr,fc|0x80,c])
    def rd(s,a,c):
        if a%2 or c%2 or c<2: return None
        out=b''
        for x in range(a,a+c,2):
            if x in s.v: v=s.v[x]
            elif x in RO: v=(0x237 if s.running else RO[x]) if x==6916 else RO[x]
            else: return None
            out+=struct.pack('>I',v&0xFFFFFFFF)
        return out
    def handle(s,t):
        fc=t[1]
        if fc==43:
            objs=[(0,b'Schneider Electric'),(1,b'LXM05AD10M2'),(2,b'V1.102')]
            b=bytes([s.addr,43,14,t[3],2,0,0,len(objs)])
            for i,o in objs: b+=bytes([i,len(o)])+o
            return b
        if fc==8: return bytes(t[:6])
        a=t[2]<<8|t[3]; c=t[4]<<8|t[5]
        if fc==3:
            r=s.rd(a,c)
            return s.exc(3,2) if r is None else bytes([s.addr,3,len(r)])+r
        if fc==16:
            if t[6]!=2*c or c%2 or a%2: return s.exc(16,3)
            vals=struct.unpack('>%di'%(c//2),bytes(t[7:7+2*c]))
            for i,v in enumerate(vals):
                x=a+2*i
                if x not in s.v: return s.exc(16,2)
                if x in(1554,1556,1558,10248,10250,10504,10506) and not 0<=v<=13200000: return s.exc(16,3)
            for i,v in enumerate(vals):
                x=a+2*i
                if s.clamp==x: v=v-1
                s.v[x]=v; s.w+=1
            return bytes(t[:6])
        if fc==23:
            wa=t[6]<<8|t[7]; wc=t[8]<<8|t[9]
            if t[10]!=2*wc or wc%2 or wa%2: return s.exc(23,3)
            vals=struct.unpack('>%di'%(wc//2),bytes(t[11:11+2*wc]))
            for i,v in enumerate(vals):
                if wa+2*i not in s.v: return s.exc(23,2)
            for i,v in enumerate(vals):
                x=wa+2*i; s.v[x]=v-1 if s.clamp==x else v; s.w+=1
            r=s.rd(a,c)
            return s.exc(23,2) if r is None else bytes([s.addr,23,len(r)])+r
        return s.exc(fc,1)
def dynlen(b):
    if b[1] in(3,8): return 8
    if b[1]==16: return 9+b[6] if len(b)>6 else 99
    if b[1]==23: return 13+b[10] if len(b)>10 else 99
    if b[1]==43: return 7
    return None
class L2(dict):
    pass
class LBus(Bus):
    def run(s):
        import select
        buf=b''
        while not s.stop and not s.hung:
            r,_,_=select.select([s.m],[],[],0.03)
            if not r: buf=b''; continue
            try: buf+=os.read(s.m,256)
            except OSError: break
            while len(buf)>=2:
                L=dynlen(buf)
                if L is None: buf=b''; break
                if len(buf)<L: break
                t=buf[:L]; buf=buf[L:]
                if crc(t[:-2])!=t[-2:]: buf=b''; continue
                s.one(t)
        for f in(s.m,s.s):
            try: os.close(f)
            except OSError: pass
    def one(s,t):
        d=s.d.get(t[0]); s.n+=1
        if d is None: return
        d.n+=1; w=t[1] in(16,23)
        if w: d.wn+=1
        act=s.hook(s,d,t,w) if s.hook else None
        if s.cut or time.time()<d.off_until: return
        if act and act[0]=='drop': return
        rep=bytes([d.addr,t[1]|0x80,act[1]]) if act and act[0]=='exc' else d.handle(t)
        if act and act[0]=='lost': return
        rep+=crc(rep)
        if act and act[0]=='garble': i=random.randrange(len(rep)); rep=rep[:i]+bytes([rep[i]^(1<<random.randrange(8))])+rep[i+1:]
        if act and act[0]=='trunc': rep=rep[:-3]
        time.sleep(s.delay)
        if act and act[0]=='late': time.sleep(act[1])
        try: os.write(s.m,rep)
        except OSError: pass
        if act and act[0]=='double': time.sleep(act[1]); os.write(s.m,rep)
KINDS=['none','kill9','int','term','hup','cut','cutfor','exc','excafter','garble','lostw','drop','trunc','other','starts','clamp','late','double','int2']
def run(seed,kind=None):
    R=random.Random(seed); random.seed(seed); kind=kind or R.choice(KINDS)
    dirn=os.environ['WD']+'/lruns/%s'%seed; shutil.rmtree(dirn,ignore_errors=True); os.makedirs(dirn)
    d=Lxm(); ns=R.sample(SET,R.randint(1,8)); want={}
    for n in SET:
        if R.random()<.5: d.v[n]=R.randint(1,3000)
    for n in ns:
        want[n]=R.randint(1,3000)
    open(dirn+'/f.toml','w').write('antrieb = 1\n[drive]\nfamily = "lxm05"\n[values]\n'+''.join('"%d" = %d\n'%x for x in want.items()))
    v0=dict(d.v); st={'a':True,'f':False,'n':0,'w':0}; proc=[None]; touched={}; at=R.randint(1,8+5*len(ns)); wn=R.randint(1,len(ns)); bw=R.random()<.5; ex=R.choice((1,2,3,4,6)); dur=R.choice((.5,2,5))
    if kind=='clamp': d.clamp=R.choice(ns)
    def hook(b,d,t,w):
        if not st['a']: return
        st['n']+=1; st['w']+=w
        trig=not st['f'] and ((w and st['w']==wn) if bw else st['n']==at)
        if kind in('kill9','int','term','hup','int2') and trig:
            st['f']=True; proc[0].send_signal({'kill9':9,'int':2,'int2':2,'term':15,'hup':1}[kind]); time.sleep(.01)
            if kind=='int2': threading.Timer(.05,lambda:proc[0].send_signal(2)).start()
        if kind=='cut' and trig: st['f']=True; b.cut=True
        if kind=='cutfor' and trig: st['f']=True; d.off_until=time.time()+dur
        if kind=='exc' and w and st['w']==wn: return ('exc',ex)
        if kind=='excafter' and w and st['w']==wn: d.handle(t); return ('exc',ex)
        if kind=='garble' and R.random()<.2: return ('garble',)
        if kind=='trunc' and R.random()<.15: return ('trunc',)
        if kind=='lostw' and w and R.random()<.5: return ('lost',)
        if kind=='drop' and R.random()<.15: return R.choice((('drop',),('lost',)))
        if kind=='late' and R.random()<.1: return ('late',R.choice((.05,.16,.3)))
        if kind=='double' and R.random()<.2: return ('double',R.choice((0,.002,.01,.05)))
        if kind=='other' and trig:
            st['f']=True; n=R.choice(ns); d.v[n]=R.randint(4000,5000); touched[n]=(d.v[n],st['n'])
        if kind=='starts' and trig: st['f']=True; d.running=True
    link='/tmp/n23l_%s'%seed; b=LBus([d],link,hook); b.start(); bad=[]
    base=[A,'-p',link,'-b','38400','-a','1','--timeout','150ms','--json','--no-config','dataset']
    def go(*c):
        p=proc[0]=subprocess.Popen(base+list(c),cwd=dirn,stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL)
        try: o,e=p.communicate(timeout=200)
        except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); bad.append('HANG')
        try: J=json.loads(o)
        except Exception: J=None
        return p.returncode,J,o,e
    rc,J,o,e=go('load','f.toml','--yes'); open(dirn+'/out.json','w').write(o); open(dirn+'/err.txt','w').write(e)
    data=(J or {}).get('data') or {}; en=data.get('ended')
    nm=lambda J,n: any(v['param']==n and v['result'] in('unrestored','stored','refused') for v in ((J or {}).get('data')or{}).get('values',[])) or str(n) in json.dumps((J or {}).get('warnings'))+json.dumps((J or {}).get('error'))
    if J is None and kind!='kill9': bad.append('no JSON '+o[:50])
    for n in d.v:
        if J is None: break
        x=d.v[n]
        if n in touched: 
            if x!=touched[n][0] and rc!=0: bad.append('other lost %d %s %s'%(n,en,touched))
            continue
        if rc==0 and x!=want.get(n,v0[n]): bad.append('0 but %d=%d'%(n,x))
        if en in('back','untouched') and x!=v0[n]: bad.append('%s but %d=%d was %d'%(en,n,x,v0[n]))
        if en=='torn' and x!=v0[n] and not nm(J,n): bad.append('torn unnamed %d'%n)
    if (rc==0)!=(en=='done') and J: bad.append('rc %s ended %s'%(rc,en))
    st['a']=False; b.cut=False; d.off_until=0; d.running=False; d.clamp=None; rc2=None
    if os.path.exists(dirn+'/f.undo.toml'):
        rc2,J2,o2,e2=go('undo','f.undo.toml','--yes'); open(dirn+'/out2.json','w').write(o2)
        for n in d.v:
            if d.v[n]!=v0[n]:
                if rc2==0 and not(n in touched and touched[n][1]<8+len(ns)): bad.append('undo 0 but %d=%d was %d'%(n,d.v[n],v0[n]))
                elif not nm(J2,n) and n not in touched: bad.append('undo unnamed %d'%n)
    elif d.v!=v0 and not touched: bad.append('changed, no undo file')
    b.stop=True; b.join(); os.unlink(link)
    return dict(seed=seed,kind=kind,rc=rc,ended=en,rc2=rc2,n=len(ns),touched=touched,code=((J or {}).get('error')or{}).get('code'),bad=bad)
if __name__=='__main__':
    a,bb=int(sys.argv[1]),int(sys.argv[2]); end=float(os.environ.get('UNTIL','1e18')); f=open(os.environ['WD']+'/lxm.%d.ndjson'%a,'a')
    for s in range(a,bb):
        if time.time()>end: break
        try: r=run(s)
        except Exception as e:
            import traceback; r=dict(seed=s,bad=['HARNESS '+traceback.format_exc()])
        f.write(json.dumps(r)+'\n'); f.flush()
        if r['bad'] or s<a+3: print(json.dumps(r),flush=True)
