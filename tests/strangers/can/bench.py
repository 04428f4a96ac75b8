#!/usr/bin/env python3
"""The other drive: EM-RES-03 nodes on a CAN bus behind an SLCAN adapter on a pty. From the manual, ch. 5."""
import os,sys,json,time,threading,tty,select,subprocess,random,heapq,signal,re
# ANTRIEB is the program, WD a folder for logs and files.
BIN=os.path.abspath(os.environ.get('ANTRIEB','target/debug/antrieb'))
WD=os.environ.get('WD','/tmp/other-can'); os.makedirs(WD+'/w',exist_ok=True); os.chdir(WD)
CAT={p['param']:p for p in json.loads(subprocess.check_output([BIN,'--no-config','--drive','acu','params','--json']))['data']['params']}
RATE={50000:3,100000:4,125000:5,250000:6,500000:7,1000000:8}
SCODE={2:3,3:4,4:5,5:6,6:7,8:8}
class Node:
    def __init__(s,b,nid=5,rate=7,**o):
        s.b=b;s.o=dict(sdo2=1,node_effect='now',rate_effect='now',sdo2_effect='now',neg='zero',highword='ignore',ds0='9',ram='ram',strict=False,
             rx='0-1',p9xx='rw',boot=True,after_change='keep');s.o.update(o)
        s.nid=nid;s.rate=rate;s.state=1;s.alive=True;s.running=False;s.f=0.0;s.tf=time.time();s.turn=False
        s.ee={};s.ram={};s.writes=0;s.can=1
        for n,p in CAT.items():
            if p['data_type']=='string':continue
            dec=p['decimals'] or 0
            v=p['default'] if p['default'] is not None else (p['min'] if p['min'] is not None else 0)
            v=round(v*10**dec)
            for ds in range(1,5) if p['data_sets']==4 else [0]: s.ee[n,ds]=v
        s.ee.update({(900,0):nid,(903,0):rate,(923,0):s.o['sdo2'],(978,0):1,(979,0):1,(411,0):0x40,(249,0):1,(270,0):0,(260,0):0,(250,0):0,(30,0):110,(412,1):44})
        for n in(930,932,934): s.ee[n,0]=1
        s.ee[919,0]=0;s.ee[1376,0]=s.nid;s.ee[241,0]=0
        s.ee.update(o.get('ee',{}))
    def typ(s,n):
        p=CAT[n];return p['data_type'] or 'uint'
    def motor(s):
        now=time.time();dt=now-s.tf;s.tf=now
        tgt=s.ee.get((480,1),0)/100 if s.running else 0
        step=5*dt
        s.f+=max(-step,min(step,tgt-s.f))
        t=abs(s.f)>.01
        if t!=s.turn: s.turn=t; s.b.log(f'SHAFT node {s.nid} {"TURNS" if t else "stands"} f={s.f:.2f}')
    def get(s,n,ds):
        s.motor()
        if n==978: return s.state,None
        if n==979: return s.can,None
        if n in(210,241): return round(s.f*100),None
        if n not in CAT: return None,11
        p=CAT[n]
        if p['data_type']=='string': return None,21
        if p['access']=='w': return None,3
        if p['data_sets']==4:
            if ds==0:
                v={s.ee[n,d] for d in range(1,5)}
                if s.o['ds0']=='9' and len(v)>1: return None,9
                if s.o['ds0']=='2': return None,2
                return s.ee[n,1],None
            if 1<=ds<=4: return s.ee[n,ds],None
            if 5<=ds<=9 and s.o['ram']=='ram': return s.ram.get((n,max(1,ds-5)),s.ee[n,max(1,ds-5)]),None
            return None,2
        if ds in(0,) : return s.ee[n,0],None
        if 1<=ds<=4 and s.o.get('setless')=='taken': return s.ee[n,0],None
        return None,2
    def put(s,n,ds,raw,ctl):
        if n not in CAT: return 11
        p=CAT[n];t=s.typ(n)
        if p['access']=='r': s.b.sin(f'write of read-only P.{n}');return 4
        hi=raw>>16
        if t in('int','uint','word') :
            if ctl==0x23: s.b.note(f'long control byte for word P.{n}') if p['data_type'] else None
            if hi and not(t=='int' and hi==0xffff):
                s.b.sin(f'word P.{n} written with bytes 6,7 = {hi:04x}')
            if hi and s.o['highword']=='abort': return 1
            v=raw&0xffff
            if t=='int' and v>0x7fff: v-=0x10000
            if s.o['strict'] and ctl!=0x2b: return 10
        else:
            v=raw-(1<<32) if raw>>31 else raw
            if s.o['strict'] and ctl!=0x23: return 10
        dec=10**(p['decimals'] or 0)
        if p['min'] is not None and v<round(p['min']*dec) or p['max'] is not None and v>round(p['max']*dec):
            s.b.sin(f'P.{n} out of range {v}');return 1
        if s.running and n<900 and n not in(410,480): return 8
        if p['data_sets']==4:
            if ds==0: keys=[(n,d) for d in range(1,5)]
            elif 1<=ds<=4: keys=[(n,ds)]
            elif 5<=ds<=9 and s.o['ram']=='ram':
                s.ram[n,max(1,ds-5)]=v; s.b.log(f'W node {s.nid} P.{n}@{ds} RAM = {v}');return 0
            else: return 2
        else:
            if ds: return 2
            keys=[(n,0)]
        if n in(936,937,938) and v==2 and s.o['rx']=='0-1': return 1
        old=[s.ee[k] for k in keys]
        if old==[v]*len(keys): s.b.note(f'write without change P.{n}@{ds}={v}')
        for k in keys: s.ee[k]=v
        s.writes+=1
        s.b.log(f'W node {s.nid} P.{n}@{ds} {old} -> {v}')
        return 0
    def later(s,n,v):
        if n==900 and s.o['node_effect']=='now': s.nid=v;s.b.log(f'node now {v}');s.o.get('boot_on_change') and s.bootup()
        if n==903 and s.o['rate_effect']=='now': s.rate=v;s.b.log(f'rate now {v}')
        if n==923 and s.o['sdo2_effect']=='now': s.o['sdo2']=v
    def reset(s):
        s.nid=s.ee[900,0] if s.o['node_effect']!='poweron' else s.nid
        s.rate=s.ee[903,0] if s.o['rate_effect']!='poweron' else s.rate
        if s.o['sdo2_effect']!='poweron': s.o['sdo2']=s.ee[923,0]
        s.state=1
        s.b.at(.05,s.bootup)
    def bootup(s):
        if s.alive: s.b.bus(1792+s.nid,bytes(1),s.rate,src=s)
    def rx(s,cid,d,rate):
        if not s.alive or rate!=s.rate or s.nid<0: return
        if cid==0 and len(d)==2 and s.nid>0:
            if d[1] in(0,s.nid):
                old=s.state
                if d[0]==1: s.state=2
                elif d[0]==2: s.state=3
                elif d[0]==128: s.state=1
                elif d[0] in(129,130): s.reset()
                s.b.log(f'NMT {d[0]} node {s.nid}: {old}->{s.state}')
                if s.o.get('release'): s.motor(); s.running=s.state==2 or (s.running and s.o.get('keep',True))
            return
        r1=s.ee.get((921,0),0) or 1536+s.nid; t1=s.ee.get((922,0),0) or 1408+s.nid
        if s.nid==0: r1=None
        if cid==r1: ch=1;tx=t1
        elif cid==1600+s.nid and s.o['sdo2']: ch=2;tx=1472+s.nid
        else: return
        if s.state==3: return
        if len(d)!=8: s.b.sin(f'SDO of {len(d)} bytes');return
        c=d[0];n=d[1]|d[2]<<8;ds=d[3];raw=int.from_bytes(d[4:],'little')
        if c==0x40:
            if raw: s.b.sin('upload request with data')
            v,ab=s.get(n,ds)
            s.b.reads+=1
            if ab: rep=bytes([0x80])+d[1:4]+bytes([ab,0,0,0])
            else:
                v&=0xffffffff
                if s.typ(n) in('int','uint','word') if n in CAT else False:
                    if not(s.typ(n)=='int' and s.o['neg']=='sign'): v&=0xffff
                rep=bytes([0x42])+d[1:4]+v.to_bytes(4,'little')
            post=None
        elif c in(0x22,0x23,0x2b,0x2f):
            if s.o.get('pre_write') and s.o['pre_write'](s,n,ds,raw): return
            ab=s.o['refuse'](n,ds,raw,s) if s.o.get('refuse') else None
            if ab is None: ab=s.put(n,ds,raw,c)
            rep=bytes([0x80 if ab else 0x60])+d[1:4]+bytes([ab or 0,0,0,0])
            post=None if ab else (n,s.ee.get((n,ds),0))
        elif c==0x80: s.b.log('client abort');return
        else:
            s.b.sin(f'SDO command {c:02x}');rep=bytes([0x80])+d[1:4]+bytes([15,0,0,0]);post=None
        outs=[(0.0,tx,rep)]
        h=s.b.o.get('reply')
        if h: outs=h(s.b,s,d,tx,rep) 
        for dt,i,r in outs: s.b.at(dt,lambda i=i,r=r,rt=s.rate: s.b.bus(i,r,rt,src=s))
        if post: s.b.at(.001,lambda: s.later(*post))
class Bench:
    def __init__(s,name='x',nodes=None,**o):
        s.o=dict(ack='cr',c_closed='bell',listen=True,txack='cr',frame=.0003,version='V1013\r');s.o.update(o)
        s.m,s.sl=os.openpty();tty.setraw(s.sl);tty.setraw(s.m);s.path=os.ttyname(s.sl)
        s.t0=time.time();s.L=[];s.sins=[];s.notes={};s.open=False;s.listen=False;s.srate=None;s.q=[];s.seq=0;s.buf=b'';s.reads=0
        s.txn=0;s.lock=threading.RLock();s.proc=None;s.dead=False;s.err=False;s.txids={}
        s.logf=open(f'{WD}/w/{name}.log','w')
        s.nodes=[Node(s,**n) for n in (nodes if nodes is not None else [{}])]
        s.stop=False;s.th=threading.Thread(target=s.loop,daemon=True);s.th.start()
    def log(s,t):
        l=f'{time.time()-s.t0:8.3f} {t}';s.L.append(l);s.logf.write(l+'\n')
    def sin(s,t): s.sins.append(t);s.log('SIN '+t)
    def note(s,t): s.notes[t]=s.notes.get(t,0)+1;s.log('note '+t)
    def at(s,dt,f):
        with s.lock: s.seq+=1;heapq.heappush(s.q,(time.time()+dt,s.seq,f))
    def w(s,b):
        if s.dead: return
        try: os.write(s.m,b)
        except OSError as e: s.log(f'write {e}')
    def out(s,cid,d,rtr=False):
        if s.open and not s.o.get('deaf'): s.w(b't%03X%d'%(cid,len(d))+d.hex().upper().encode()+(b'%04X'%(int((time.time()-s.t0)*1000)%60000) if s.o.get('stamp') else b'')+b'\r')
    def bus(s,cid,d,rate,src=None):
        s.log(f'bus {cid:03X} {d.hex()} @{rate} from {src.nid if isinstance(src,Node) else src}')
        for n in s.nodes:
            if n is not src: n.rx(cid,d,rate)
        if src!='tool':
            if rate==s.srate: s.out(cid,d)
            elif s.open:
                s.err=True
                if not s.listen: s.log('error frames by adapter at wrong rate')
    def ack(s): 
        if s.o['ack']=='cr': s.w(b'\r')
    def bell(s): s.w(b'\a') if s.o['ack']!='none' else None
    def line(s,l):
        c=l[:1]
        if not c: return
        h=s.o.get('cmd')
        if h and h(s,l): return
        if c not in b'tTrR': s.log(f'> {l!r}')
        if c==b'C':
            if s.open: s.open=False;s.ack()
            elif s.o['c_closed']=='bell': s.bell()
            elif s.o['c_closed']=='late': s.at(.25,s.bell)
            else: s.ack()
        elif c==b'S':
            if s.open: s.sin('S while open');s.bell();return
            k=int(l[1:]);
            if k in s.o.get('norate',()): s.bell();return
            s.srate=SCODE.get(k);s.ack()
        elif c in b'OL':
            if s.open: s.sin('O while open');s.bell();return
            if s.srate is None: s.sin('O without S');s.bell();return
            if c==b'L' and not s.o['listen']: s.bell();return
            s.open=True;s.listen=c==b'L';s.err=False;s.ack()
        elif c==b'V': s.w(s.o['version'].encode())
        elif c==b'N': s.w(b'NA123\r')
        elif c==b'F':
            if not s.open: s.bell()
            else: s.w(b'F%02X\r'%(s.o.get('F',0)|(0x84 if s.err else 0)))
        elif c in b'ZXMmWQU': s.ack()
        elif c==b't':
            if not s.open or s.listen: s.sin('t while '+('listen only' if s.open else 'closed'));s.bell();return
            cid=int(l[1:4],16);n=int(l[4:5]);d=bytes.fromhex(l[5:].decode())
            if len(d)!=n: s.sin(f'dlc {l!r}');s.bell();return
            s.txn+=1;s.txids[cid]=s.txids.get(cid,0)+1
            f=s.o.get('tx')
            if f and f(s,cid,d): return
            if not(0x640<=cid<=0x67f or 0x601<=cid<=0x63f or (cid==0 and s.o.get('nmt'))): s.sin(f'frame {cid:03X} {d.hex()}')
            if s.o['txack']=='cr': s.ack()
            elif s.o['txack']=='z': s.w(b'z\r')
            heard=[x for x in s.nodes if x.alive and x.rate==s.srate and x.nid>=0]
            if not heard and not s.o.get('others'): s.err=True;s.log('nobody acks');return
            s.at(s.o['frame'],lambda: s.bus(cid,d,s.srate,'tool'))
        elif c in b'TrR': s.sin(f'{l!r}');s.bell()
        else: s.sin(f'unknown command {l!r}');s.bell()
    def loop(s):
        while not s.stop:
            now=time.time()
            while True:
                with s.lock:
                    if not s.q or s.q[0][0]>time.time(): break
                    f=heapq.heappop(s.q)[2]
                try: f()
                except Exception as e: s.log(f'EXC {e!r}')
            to=min(.05,max(0,s.q[0][0]-time.time())) if s.q else .05
            if s.dead: time.sleep(.01);continue
            r,_,_=select.select([s.m],[],[],to)
            if r:
                try: d=os.read(s.m,4096)
                except OSError: time.sleep(.01);continue
                s.buf+=d
                while b'\r' in s.buf:
                    l,s.buf=s.buf.split(b'\r',1)
                    try: s.line(l)
                    except Exception as e: s.sin(f'bad line {l!r} {e!r}');s.bell()
            for n in s.nodes: n.motor()
    def unplug(s):
        s.log('UNPLUG');s.dead=True;os.close(s.m)
        try: os.close(s.sl)
        except OSError: pass
    def every(s,dt,f):
        def g():
            if s.stop: return
            f();s.at(dt,g)
        s.at(dt,g)
    def run(s,*args,timeout=90,node='5',baud='500000',pre=(),env=None,show=True,port=None):
        cmd=[BIN,'-p',port or 'slcan:'+s.path,'-b',baud,*(['-a',node] if node else []),'--no-config','--lang','en','--no-progress',*pre,*args]
        s.log('RUN '+' '.join(cmd[1:]))
        t=time.time();n0=len(s.sins)
        s.proc=p=subprocess.Popen(cmd,stdout=subprocess.PIPE,stderr=subprocess.PIPE,stdin=subprocess.DEVNULL,cwd=WD+'/w')
        try: o,e=p.communicate(timeout=timeout);rc=p.returncode
        except subprocess.TimeoutExpired: p.kill();o,e=p.communicate();rc='HANG'
        dt=time.time()-t
        s.log(f'END {rc} {dt:.2f}')
        if show:
            print(f'$ {" ".join(args)}   [rc {rc}, {dt:.1f} s, tx {s.txn}, open {s.open}]');print(o.decode().rstrip());print('  !'+e.decode().rstrip().replace('\n','\n  !'))
            if s.sins[n0:]: print('  SINS',sorted(set(s.sins[n0:])))
            print()
        return rc,o.decode(),e.decode(),dt
    def close(s):
        s.stop=True;s.th.join(1);s.logf.close()
        for f in(s.m,s.sl):
            try: os.close(f)
            except OSError: pass
