#!/usr/bin/env python3
"""A stranger's SJ2-PB with an inverter behind it, on a pty. Strict. stdlib only."""
import os, sys, pty, tty, time, select, threading, csv, re, json, termios
H=os.path.dirname(os.path.abspath(__file__)); WD=os.environ.get('WD','/tmp/stranger-profibus'); os.makedirs(WD+'/logs',exist_ok=True)
CSV=os.environ.get('INDEX',H+'/index.csv')
CFGS={'basic':b'\xF3','ppo1':b'\xF3\xF1','ppo2':b'\xF3\xF5','ppo3':b'\xF1','ppo4':b'\xF5','ppo5':b'\xF3\xF9'}
LENS={'basic':8,'ppo1':12,'ppo2':20,'ppo3':4,'ppo4':12,'ppo5':28}
SERIES={'l200':0x20,'sj200':0x10,'x200':0x40}
DEF=dict(addr=3, baud=19200, series='l200', ident=0x0BE7, modes=('basic','ppo1','ppo2','ppo3','ppo4','ppo5'),
  getcfg='ppo1', pd_userprm=b'', prefix=b'', userprm_strict=True, wrong_series='cfg',
  tsdr_bits=15, ready_after=0.0, wdfeed='dx',
  a004=50.0, a004_scale=10, a003=50.0, a002=1, a001=1, p703=2, p620=0, p928=0, p927=1,
  contact=False, contact_rev=False, analog=20.0, f001=15.0, f002=2.0, f003=2.0,
  lost_by=('wd',), b10='ramp', zsw_b10='0', b6_on='1', first_edge=True, off2='ramp', off3='coast', b3='ramp', b4='ramp',
  zsw_local='commanded', start='direct', b928='edge', hsw_over='hold', neg='reverse', hiw_signed=True,
  ack_b10=True, restart='edge', b9='both', rest8=True, both='stop', basic_lost='conn', local_terminal_stop=True,
  trip_cause_stands=False, errword='low', pkw_ms=15, pkw_inv_ms=60, pkw_wait='old', pkw_repeat='once', neg_pwe='0000',
  p927_reply=(8,0), missing=0, arr_ak1=4, limit_err=2, running_err=17, p964_from=1, ind_low='echo', ak1_long=2,
  p611_rest='hsw', p614_lag=0.0, p928_lost='keep', lock120='wait', trip_diag='block', dh_on_trip=True, p616='copy',
  a00x_when='later', coast_s=3.0, basic_ramp0='ignore', b091=0, p608=0, basic_over='hold', p600_basic=True, hiw_from='output', dx_keep=False)
def parse_range(r):
    m=re.findall(r'=\s*(-?\d+)\s*-\s*(\d+)',r.replace('–','-'))
    if len(m)==1: return int(m[0][0]),int(m[0][1])
class Slave(threading.Thread):
    def __init__(s, name='x', **o):
        super().__init__(daemon=True); s.o=dict(DEF); 
        for k in o: assert k in DEF,k
        s.o.update(o); s.name_=name
        s.m,s.sl=pty.openpty(); tty.setraw(s.m); tty.setraw(s.sl); s.path=os.ttyname(s.sl); os.set_blocking(s.m,False)
        s.link=WD+'/pty-'+name
        try: os.unlink(s.link)
        except OSError: pass
        os.symlink(s.path,s.link)
        s.f=open(WD+'/logs/'+name+'.log','w'); s.t0=time.monotonic()
        s.sins=[]; s.lines=[]; s.stopme=False; s.hook=None; s.lock=threading.RLock()
        s.late_t=0; s.nlate=0; s.mute=False; s.heard=[]; s.nreq=0; s.foreign=False; s.evq=[]
        s.power=True; s.silent_drop=0
        # dp
        s.bit=1/s.o['baud']; s.rx=b''; s.rx_first=0; s.rx_last=0; s.tx=[]; s.last_wire=-9; s.free_at=-9
        s.reset_dp(); s.fcb={}  # sa-> (fcb, bytes, reply)
        s.dx_count=0; s.dx_times=[]; s.stws=[]; s.outs_log=[]
        s.minidle=9e9
        # inverter
        s.par={}; s.tab={}
        for r in csv.DictReader(open(CSV)):
            i=int(r['index'])
            if i>=300: continue
            avail=(r[s.o['series']].strip().lower()=='yes')
            if not avail: continue
            L=int(r['length_bytes']); rng=parse_range(r['range_as_printed_de'])
            s.tab[i]=(L,'W' in r['access'],rng,r['param'])
            s.par[i]=rng[0] if rng else 0
        sc=s.o['a004_scale']
        for k,v in {13:s.o['a003']*sc,14:s.o['a003']*sc,15:s.o['a004']*sc,16:s.o['a004']*sc,17:s.o['f001']*sc,88:s.o['a001'],89:s.o['a002'],34:100,131:s.o['b091'],251:7,215:255,221:255,227:255,160:4,161:4,213:3}.items():
            if k in s.par: s.par[k]=int(round(v))
        s.par[7]=s.enc_t(s.o['f002']); s.par[9]=s.enc_t(s.o['f003']); s.par[8]=s.par[7]; s.par[10]=s.par[9]
        for k in (51,53,52,54): s.par[k]=s.enc_t(5)
        s.gw={601:0,603:0,605:0,606:0,607:0,608:s.o['p608'],609:0,610:0,616:0,620:s.o['p620'],621:0,623:0,703:s.o['p703'],704:0,918:s.o['addr'],922:0,927:s.o['p927'],928:s.o['p928'],965:0x0302,971:0,800:0x0102,801:0x0203,702:3}
        s.arr={915:[0]*8,916:[0]*8,964:[1234,0x20,0x0203,2009,1705]}
        s.e2={915:[0]*8,916:[0]*8}
        s.trip={300:0,301:0,302:0,303:0,304:0,305:0}; s.fault=None; s.fault_t=0; s.trip_at=None
        s.pkw_writes={}; s.writes=[]
        s.pkw=None; s.pkw_last=None; s.pkw_out=bytes(8); s.pkw_due=None; s.pkw_seen0=True
        # motor
        s.out=0.0; s.shaft=0.0; s.sp=0.0; s.running=0; s.run_by=None; s.live=True; s.tl=time.monotonic(); s.turning=False
        s.stw=0; s.hsw=0; s.last_valid=(0,0); s.edge_ok=False; s.prev_stw=0; s.lostact=None; s.seen_any=False; s.frs=False
        s.basic=[0]*4; s.basic_prev=0; s.basic_acc=10.; s.basic_dec=10.; s.basic_sp=0.
        s.jogging=False; s.last_hiw=0; s.turn_log=[]; s.trips=0; s.mode_b=None; s.eep=False; s.eep_t=0
        s.forced_local=False; s.stuck=False; s.no_start=False; s.bus_run=False
    def enc_t(s,x): 
        return (-int(round(x*100)))&0xFFFF if x<100 else int(round(x*10))
    def dec_t(s,r):
        if r>=0x8000: return (65536-r)/100
        return r/10 if r>=1000 else 0.01
    def reset_dp(s):
        s.state='wait_prm'; s.owner=None; s.wd=None; s.wd_t=0; s.prmf=False; s.cfgf=False; s.mode=None; s.dh=False; s.born=time.monotonic(); s.wd_on=False
        s.userprm=b''
    def log(s,msg):
        t=time.monotonic()-s.t0; s.lines.append((t,msg)); s.f.write('%9.4f %s\n'%(t,msg)); s.f.flush()
    def sin(s,msg):
        t=time.monotonic()-s.t0
        if time.monotonic()-s.late_t<0.3 and msg.split()[0] in('T_SYN:','collision:','two','incomplete','garbage'): s.log('(late peer) '+msg); return
        s.sins.append((t,msg)); s.log('*** SIN '+msg)
    # ---------- line
    def run(s):
        try:
            while not s.stopme:
                now=time.monotonic(); to=0.02
                if s.tx: to=max(0,min(to,s.tx[0][0]-now))
                t1=now; r,_,_=select.select([s.m],[],[],to)
                now=time.monotonic()
                if now-t1-to>0.004: s.late_t=now; s.nlate+=1
                with s.lock:
                    if s.tx and now-s.tx[0][0]>0.004: s.late_t=now; s.nlate+=1
                    while s.tx and s.tx[0][0]<=now:
                        t,b=s.tx.pop(0)
                        while s.tx and s.tx[0][0]<=now: b+=s.tx.pop(0)[1]
                        s.last_wire=time.monotonic()
                        try: os.write(s.m,b)
                        except BlockingIOError: s.log('pty full, bytes lost')
                    if r:
                        try: b=os.read(s.m,4096)
                        except (BlockingIOError,OSError): b=b''
                        if b: s.bytes_in(b,now)
                    if s.rx and now-s.rx_last>0.03:
                        s.sin('incomplete or gapped telegram: '+s.rx.hex()); s.rx=b''
                    s.tick(now)
        except Exception:
            import traceback; s.log('PEER CRASH '+traceback.format_exc()); raise
    def bytes_in(s,b,now):
        if not s.rx:
            idle=now-max(s.last_wire,s.free_at)
            if s.tx: 
                s.sin('collision: bytes while a reply is being sent: '+b.hex())
            elif idle+(0.0025 if s.free_at>s.last_wire else 0)<33*s.bit and s.last_wire>0:
                s.sin('T_SYN: %.2f ms idle, %.2f needed: %s'%(idle*1e3,33*s.bit*1e3,b.hex()))
            if idle<s.minidle: s.minidle=idle
            s.rx_first=now
        elif now-s.rx_last>0.004: s.log('note: gap %.1f ms within a telegram'%((now-s.rx_last)*1e3))
        s.rx+=b; s.rx_last=now
        while s.rx:
            n=s.parse(s.rx)
            if n==0: return
            if n<0: s.sin('garbage '+s.rx.hex()); s.rx=b''; return
            t,s.rx=s.rx[:n],s.rx[n:]
            if s.rx: s.sin('two telegrams without T_SYN between: %s | %s'%(t.hex(),s.rx.hex()))
            s.free_at=max(s.rx_first+n*11*s.bit,now)
            if s.foreign and s.foreign<now-0.005: s.sin('sent although another master was heard %.1f ms ago: %s'%((now-s.foreign)*1e3,t.hex()))
            s.nreq+=1
            s.telegram(t,now)
    def parse(s,b):
        d=b[0]
        if d==0x10: n=6
        elif d==0x68:
            if len(b)<4: return 0
            if b[1]!=b[2] or b[3]!=0x68 or not 4<=b[1]<=249: return -1
            n=b[1]+6
        elif d==0xA2: n=14
        elif d==0xDC: return 3 if len(b)>=3 else 0
        elif d==0xE5: return 1
        else: return -1
        if len(b)<n: return 0
        body=b[1:n-2] if d!=0x68 else b[4:n-2]
        if b[n-1]!=0x16 or sum(body)&255!=b[n-2]: return -1
        return n
    def reply(s,b,req,extra=0.0):
        if b is None: return
        if s.mute or not s.power: return
        seq=[(0.0,b)]
        if s.hook:
            seq=s.hook(s,req,b)
            if seq is None: return
        t=s.free_at+s.o['tsdr_bits']*s.bit+extra
        for d,bb in seq:
            t+=d
            for x in bb:
                t+=11*s.bit; s.tx.append((t,bytes([x])))
    def raw(s,b,at=None):
        "bytes of another station"
        with s.lock:
            t=at or time.monotonic()
            for x in b:
                t+=11*s.bit; s.tx.append((t,bytes([x])))
    def sd1(s,da,sa,fc): b=bytes([da,sa,fc]); return b'\x10'+b+bytes([sum(b)&255,0x16])
    def sd2(s,da,sa,fc,du,dsap=None,ssap=None):
        b=bytes([da|(0x80 if dsap is not None else 0),sa|(0x80 if ssap is not None else 0),fc])+(bytes([dsap,ssap]) if dsap is not None else b'')+du
        return b'\x68'+bytes([len(b)]*2)+b'\x68'+b+bytes([sum(b)&255,0x16])
    def telegram(s,t,now):
        d=t[0]
        if d==0xDC: s.sin('token passed: '+t.hex()); return
        if d==0xE5: s.sin('SC from a master'); return
        body=t[1:-2] if d!=0x68 else t[4:-2]
        da,sa,fc=body[0],body[1],body[2]; du=body[3:]
        dsap=ssap=None
        if da&0x80: dsap=du[0]; du=du[1:]
        if sa&0x80: ssap=du[0]; du=du[1:]
        da&=127; sa&=127
        if not fc&0x40: s.sin('a request with FC bit 6 = 0: '+t.hex()); return
        fcb,fcv,fn=bool(fc&0x20),bool(fc&0x10),fc&15
        if fn in (4,6) or da==127:
            if da!=127: s.sin('SDN to one: '+t.hex())
            if fcb or fcv: s.sin('FCB/FCV in an SDN: '+t.hex())
            if dsap==58:
                if ssap!=62 or len(du)!=2: s.sin('Global_Control malformed '+t.hex())
                s.log('Global_Control %02X group %02X'%(du[0],du[1])); s.seen_gc=True
                if du[0]&0x02 and s.owner==sa and s.power and not s.mute: s.clear()
            else: s.sin('unknown broadcast '+t.hex())
            return
        if da!=s.o['addr']:
            s.heard.append((da,fn))
            if fn!=9 : s.log('asked station %d: %s'%(da,t.hex()))
            return
        if not s.power or s.mute: return
        if fn==9:
            if fc!=0x49: s.sin('FDL status with FC %02X'%fc)
            s.reply(s.sd1(sa,da,0x00),t); return
        if fn not in (0xC,0xD): s.sin('function %X'%fn); return
        last=s.fcb.get(sa)
        if fcv:
            if last is None: s.sin('FCV=1 before FCB was set up (FCB=1,FCV=0): '+t.hex())
            elif last[0]==fcb:
                if last[1]!=t: s.sin('same FCB, other bytes: %s then %s'%(last[1].hex(),t.hex()))
                s.log('repeat '+(t.hex() if dsap is not None else 'DX'))
                if s.state=='dx' and sa==s.owner and dsap is None: s.wd_t=now
                s.reply(last[2],t); return
        else:
            if not fcb: s.sin('FCB=0, FCV=0 in an SRD: '+t.hex())
            if last and last[1]==t and now-last[3]<0.1:
                s.log('repeat (first) '+t.hex()); s.reply(last[2],t); return
        if s.wd_on and s.o['wdfeed']=='any' and sa==s.owner: s.wd_t=now
        r=s.serve(t,sa,dsap,ssap,du,now)
        s.fcb={sa:(fcb,t,r,now)}
        s.reply(r,t)
    def serve(s,t,sa,dsap,ssap,du,now):
        me=s.o['addr']
        if dsap is None: return s.data_exchange(t,sa,du,now)
        if ssap!=62: s.sin('SSAP %s'%ssap)
        if dsap==60:
            if du: s.sin('Slave_Diag with data')
            s.dh=False; d=s.diag(now)
            s.log('Slave_Diag -> '+d.hex()); return s.sd2(sa,me,0x08,d,62,60)
        if dsap==59:
            c=CFGS[s.mode or s.o['getcfg']]
            s.log('Get_Cfg -> '+c.hex()); return s.sd2(sa,me,0x08,c,62,59)
        if dsap==61: 
            s.set_prm(du,sa,now); return b'\xE5'
        if dsap==62:
            if s.state!='wait_cfg' and s.state!='dx':
                s.log('note Chk_Cfg in '+s.state); return s.sd1(sa,me,0x03)
            if sa!=s.owner: return s.sd1(sa,me,0x03)
            for k in CFGS:
                if CFGS[k]==du: break
            else: k=None
            ok=k in s.o['modes']
            if ok: ok=s.prm_fits(k)=='ok' 
            if ok and s.state=='wait_cfg':
                if k in('ppo4',): s.sin('PPO4 while commissioning')
                s.state='dx'; s.mode=k; s.cfgf=False; s.wd_t=now; s.log('Chk_Cfg %s -> DATA_EXCHANGE'%k); s.enter_dx()
            elif not ok: s.cfgf=True; s.leave('cfg'); s.log('Chk_Cfg %s refused'%du.hex())
            return b'\xE5'
        s.sin('SAP %d'%dsap); return s.sd1(sa,me,0x03)
    def prm_fits(s,k):
        u=s.userprm
        if k!='basic': 
            if s.o['pd_userprm'] is None: return 'ok'
            return 'ok' if u==s.o['pd_userprm'] else 'bad'
        want=s.o['prefix']+{'l200':b'\xC7\xFF\xFF','sj200':b'\x47\xFF\xFF','x200':b'\x8F\xFF'}[s.o['series']]
        return 'ok' if u==want else 'bad'
    def set_prm(s,du,sa,now):
        s.log('Set_Prm '+du.hex())
        if len(du)<7: s.sin('Set_Prm short'); return
        st,w1,w2,tsdr=du[0],du[1],du[2],du[3]; ident=du[4]<<8|du[5]
        if s.owner not in (None,sa): s.log('other owner'); return
        if st&0x40:
            if st&0x80: s.sin('Lock and Unlock both')
            s.log('UNLOCK'); s.leave('unlock'); s.prmf=False; return
        if not st&0x80:
            s.sin('Set_Prm without Lock'); return
        if tsdr<11: s.sin('min Tsdr %d'%tsdr)
        if ident!=s.o['ident']: s.sin('Set_Prm with wrong ident %04X'%ident); s.prmf=True; s.leave('prm'); return
        if now-s.born<s.o['ready_after']: s.log('not ready yet'); s.notready=True; return
        if st&8 and (w1==0 or w2==0): s.sin('WD_On with factor 0')
        if not st&8: s.sin('Set_Prm without WD_On (watchdog off)')
        if du[6]: s.log('note: group %02X'%du[6])
        s.userprm=du[7:]
        fits=[k for k in s.o['modes'] if s.prm_fits(k)=='ok']
        if not fits and s.o['wrong_series']=='prm': s.prmf=True; s.leave('prm'); s.log('user prm refused'); return
        s.prmf=False; s.owner=sa; s.wd=w1*w2*0.01 if st&8 else None; s.wd_on=bool(st&8); s.wd_t=now
        if s.state!='dx': s.state='wait_cfg'
        s.log('parameterised by %d, wd %s s'%(sa,s.wd))
    def diag(s,now):
        a=0
        if s.state!='dx': a|=2
        if s.cfgf: a|=4
        if s.prmf: a|=0x40
        ext=b''
        if s.fault is not None and s.o['trip_diag']=='block' and s.state=='dx': a|=8; ext=bytes([0x04,0x01,s.fault[0],0x00])
        b=4|(1 if s.state=='wait_prm' else 0)|(8 if s.wd_on else 0)
        return bytes([a,b,0,s.owner if s.owner is not None else 255,s.o['ident']>>8,s.o['ident']&255])+ext
    def leave(s,why):
        was=s.state
        if was=='dx':
            s.log('LEFT data exchange: %s (out=%.2f shaft=%.2f stw=%04X)'%(why,s.out,s.shaft,s.stw))
            if why in('unlock',) and abs(s.out)>0.005 and s.bus_run: s.sin('Unlock while the output turns under the bus: %.2f Hz'%s.out)
            if why in s.o['lost_by'] or why=='wd': s.conn_lost(why)
            else: s.unlocked=True
        s.state='wait_prm'; s.owner=None; s.wd=None; s.wd_on=False; s.dh=False
        s.modelast=s.mode or getattr(s,'modelast',None); s.mode=None
    def enter_dx(s):
        s.lostact=None; s.pkw_last=None; s.pkw_out=bytes(8); s.pkw_due=None; s.prev_stw=s.stw if s.o['first_edge'] is False else 0
        s.fresh=True; s.basic_prev=0; s.mode_b=(s.mode=='basic'); s.bus_run=s.bus_run if s.o['dx_keep'] else False
        if s.forced_local and s.o['p703']!=4: s.forced_local=False
        s.edge_ok=False; s.basic_fresh=True
    def conn_lost(s,why):
        if s.mode=='basic':
            keep={'conn':bool(s.basic[0]&0x4000),'p620':s.gw[620]==1,'either':bool(s.basic[0]&0x4000) or s.gw[620]==1}[s.o['basic_lost']]
            if not s.basic[0]&0x10: s.lostact='local'
            else: s.lostact='keep' if keep else 'ramp'
        else:
            v=s.gw[703]; s.lostact={0:'keep',1:'coast',2:'ramp',3:'dc',4:'local'}[v]
            if v==4 or s.o['p928_lost']=='0': s.gw[928]=0
        s.log('CONNECTION LOST (%s): %s'%(why,s.lostact))
    def clear(s):
        s.log('CLEAR (out %.2f, shaft %.2f)'%(s.out,s.shaft))
        if abs(s.out)>0.005 and s.bus_run: s.sin('Clear while the output turns under the bus: %.2f Hz'%s.out)
        if s.state!='dx': return
        if 'clear' in s.o['lost_by']: s.conn_lost('clear')
        if s.mode=='basic': s.basic=[0]*4
        else: s.stw=0; s.hsw=0
    def data_exchange(s,t,sa,du,now):
        me=s.o['addr']
        if s.state!='dx' or sa!=s.owner:
            s.log('Data_Exchange in %s -> RS'%s.state); return s.sd1(sa,me,0x03)
        if len(du)!=LENS[s.mode]:
            s.sin('Data_Exchange of %d bytes for %s'%(len(du),s.mode)); s.leave('len'); return s.sd1(sa,me,0x03)
        s.wd_t=now; s.dx_count+=1; s.dx_times.append(now)
        s.step(now)
        if s.mode=='basic': inp=s.basic_io(du,now)
        else: inp=s.pd_io(du,now)
        return s.sd2(sa,me,0x0A if s.dh else 0x08,inp)
    # ---------- words
    def pd_io(s,du,now):
        m=s.mode; pkw=b''
        if m in('ppo1','ppo2','ppo5'): pkw,du=du[:8],du[8:]
        stw=du[0]<<8|du[1]; hsw=du[2]<<8|du[3]
        ext=[du[i]<<8|du[i+1] for i in range(4,len(du),2)]
        if (stw,hsw)!=(s.stw,s.hsw) or s.fresh:
            s.log('STW %04X HSW %04X (out %.2f)'%(stw,hsw,s.out)); s.stws.append((now-s.t0,stw,hsw))
        s.judge_stw(stw,hsw)
        s.prev_stw=s.stw if not s.fresh else (0 if s.o['first_edge'] else stw); s.stw=stw; s.hsw=hsw
        s.words(now); s.fresh=False
        for i,v in enumerate(ext):
            p=s.arr[915][i]
            if p and v!=s.ext_last.get(i) and 'x': 
                s.ext_last[i]=v; s.log('PZD%d: P.%d=%d'%(i+3,p,v)); s.do_write(p,v,'pzd')
        out=b''
        if pkw or m in('ppo1','ppo2','ppo5'): out+=s.do_pkw(pkw,now)
        z=s.zsw(); h=s.hiw()
        out+=bytes([z>>8,z&255,h>>8,h&255])
        for i in range(len(ext)):
            p=s.arr[916][i] or s.arr[915][i]; v=s.value(p) if p else 0
            v=(v or 0)&0xFFFF; out+=bytes([v>>8,v&255])
        return out
    ext_last={}
    def judge_stw(s,stw,hsw):
        if stw==s.stw and hsw==s.hsw: return
        turning=abs(s.out)>0.005
        if stw&0xC000: s.sin('STW bits 14/15: %04X'%stw)
        sg=hsw-65536 if hsw&0x8000 else hsw
        if abs(sg)>0x4000: s.sin('HSW above 4000h: %04X'%hsw)
        if not stw&0x400 and turning and s.bus_run: s.sin('bit 10 dropped while the motor turns under the bus: %04X at %.2f Hz'%(stw,s.out))
        if stw==0 and turning and s.bus_run: s.sin('zero outputs while the motor turns')
        if stw&1 and stw&0x80: s.sin('start bit and acknowledge together %04X'%stw)
        if stw&0x80 and not s.stw&0x80:
            if not stw&0x400: s.sin('acknowledge without bit 10')
            if s.stw&1: s.sin('acknowledge without dropping bit 0 first')
        if stw&1 and not s.stw&1:
            if s.fault is not None: s.sin('start word while tripped')
            if s.stw&0x407!=0x406: s.sin('start %04X without 0406 before (%04X)'%(stw,s.stw))
            if s.gw[928]!=1: s.sin('start word with P.928=%d'%s.gw[928])
    def words(s,now):
        stw,prev=s.stw,s.prev_stw
        if stw&~0x400: s.seen_any=True
        if stw&0x80 and not prev&0x80 and (stw&0x400 or not s.o['ack_b10']): s.reset_fault('STW')
        if stw&0x400: s.last_valid=(stw,s.hsw)
        if not stw&0x400:
            if s.o['b10']!='freeze': s.bus_run=False
            return
        if s.gw[928]!=1: s.bus_run=False; return
        if stw&0x1000: s.bus_run=False; return
        if stw&6==6 and not stw&1: s.edge_ok=True
        go=stw&0xF==0xF and stw&0x40
        if not go: s.bus_run=False
        elif not s.bus_run and s.fault is None and not s.no_start:
            rise=not prev&1
            if s.o['start']=='edge':
                if rise and s.edge_ok: s.bus_run=True
            else:
                if rise or s.o['b928']=='level' or getattr(s,'armed',False): s.bus_run=True
            if s.bus_run: s.log('BUS RUN')
        s.armed=False
    def local_cmd(s):
        "(dir, setpoint)"
        a2=s.par[89]; d=0
        if a2==1: d=1 if s.o['contact'] else 0; d=-1 if s.o['contact_rev'] else d
        a1=s.par[88]; sp={0:8.0,1:s.o['analog'],2:s.o['f001']}.get(a1,0.0)
        return d,sp
    def command(s,now):
        "-> (dir, setpoint Hz, stop kind, acc, dec, hold)"
        acc,dec=s.dec_t(s.par[7]),s.dec_t(s.par[9])
        A=s.o['a004']
        if s.gw[605] and s.gw[928]==1 and s.state=='dx': return (1,1.0,'ramp',acc,dec,False,'p605')
        if s.mode_b is None and s.state!='dx' : d,sp=s.local_cmd(); return (d,sp,'ramp',acc,dec,False,'local')
        if s.mode_b:
            if s.state!='dx' and s.lostact in('ramp','coast','dc'): return (0,0,s.lostact,acc,s.basic_dec,False,'lost')
            if s.state!='dx' and s.lostact is None: # unlocked
                pass
            w=s.basic[0]
            if s.lostact=='local': w=0
            acc,dec=s.basic_acc,s.basic_dec
            if w&0x10:
                r=w&3; d={0:0,1:1,2:-1,3:0 if s.o['both']=='stop' else s.running}[r]
                if s.fault is not None: d=0
                if not s.bus_run: d=0
                src='bus'
            else: d,_=s.local_cmd(); src='local'
            if w&0x40: sp=s.basic_sp
            else:
                sp=8.0 if w&0x20 else s.o['analog']
            return (d,sp,'coast' if s.par.get(131) else 'ramp',acc,dec,False,src)
        # profidrive
        if s.state!='dx':
            if s.lostact in('ramp','coast','dc'):
                if s.gw[928]!=1: d,sp=s.local_cmd(); return (d,sp,'ramp',acc,dec,False,'local')
                return (0,0,s.lostact,acc,dec,False,'lost')
            if s.lostact=='local': d,sp=s.local_cmd(); return (d,sp,'ramp',acc,dec,False,'local')
        stw,hsw=s.stw,s.hsw
        if s.gw[928]!=1 or s.forced_local: d,sp=s.local_cmd(); return (d,sp,'ramp',acc,dec,False,'local')
        if not stw&0x400:
            m=s.o['b10']
            if m=='local': d,sp=s.local_cmd(); return (d,sp,'ramp',acc,dec,False,'local')
            if m=='freeze': stw,hsw=s.last_valid
            else: return (0,0,'ramp',acc,dec,False,'bus')
        sg=hsw-65536 if hsw&0x8000 else hsw
        if abs(sg)>0x4000: sg=0x4000 if s.o['hsw_over']=='hold' else 0
        sp=sg/0x4000*A; d=1
        if sp<0:
            if s.o['neg']=='reverse': d=-1; sp=-sp
            else: sp=0
        if stw&0x800: d=-d
        if stw&0x2000: sp=s.local_cmd()[1]
        kind='ramp'
        if not stw&4: kind={'coast':'coast','quick':'dc'}[s.o['off3']]
        elif not stw&2: kind={'ramp':'ramp','coast':'coast'}[s.o['off2']]
        elif not stw&8: kind={'ramp':'ramp','coast':'coast','only':'ramp'}[s.o['b3']]
        elif s.gw[608] or s.par.get(131): kind='coast'
        if stw&0x1000: d0,_=s.local_cmd(); return (d0,sp,kind,acc,dec,False,'local')
        if not s.bus_run: return (0,0,kind,acc,dec,False,'bus')
        if not stw&0x10: return (d,0,kind,acc,dec if s.o['b4']=='ramp' else 0.05,False,'bus')
        return (d,sp,kind,acc,dec,not stw&0x20,'bus')
    def step(s,now):
        dt=now-s.tl; s.tl=now
        if dt<=0: return
        A=s.o['a004']
        if not s.power or s.fault is not None:
            s.out=0.0; s.running=0; live=False
        else:
            d,sp,kind,acc,dec,hold,src=s.command(now)
            if src!=s.run_by: s.log('control: %s'%src); s.run_by=src
            if s.frs: s.out=0; live=False; s.running=0
            else:
                live=True
                tgt=d*min(sp,A)
                if d==0 and kind in('coast',) and s.out!=0: s.out=0.0; live=False; s.log('output off, coasts (shaft %.2f)'%s.shaft)
                if d==0 and kind=='coast': live=False
                if d==0 and kind=='dc': dec=0.4
                if not hold and not s.stuck:
                    up=abs(tgt)>abs(s.out) and tgt*s.out>=0
                    r=A/(acc if up else dec)*dt
                    if abs(tgt-s.out)<=r: s.out=tgt
                    else: s.out+=r if tgt>s.out else -r
                s.running=d; s.sp=tgt
                if s.out==0 and d==0: live=live and abs(s.shaft)<0.01
        if s.out!=0: s.shaft=s.out
        elif live: s.shaft=s.out
        else:
            k=A/s.o['coast_s']*dt
            s.shaft=0 if abs(s.shaft)<=k else s.shaft-(k if s.shaft>0 else -k)
        tn=abs(s.shaft)>0.005
        if tn!=s.turning:
            s.turning=tn; s.turn_log.append((now-s.t0,tn)); s.log('SHAFT TURNS (%s)'%s.run_by if tn else 'SHAFT STANDS')
    def frq(s): return s.out
    def hiw(s):
        f=s.frq(); 
        v=int(round(f/s.o['a004']*0x4000))
        if not s.o['hiw_signed']: v=abs(v)
        return v&0xFFFF
    def at_sp(s):
        d,sp=s.running,abs(s.sp)
        return abs(abs(s.out)-sp)<0.01 and d!=0
    def by_bus(s):
        stw=s.stw; p=s.gw[928]==1 and not s.forced_local and stw&0x400
        return bool(p and not stw&0x2000), bool(p and not stw&0x1000)
    def zsw(s):
        w=s.stw; z=0
        f=s.fault is not None
        if not w&0x400:
            if s.o['zsw_b10']=='0': z=0
            else:
                if w&~0x400: z|=0x33
            if f: z|=8
            if not s.seen_any and s.o['b6_on']=='1' and s.o['zsw_b10']!='0': z|=0x40
            return z
        b12=bool(w&0x1000); show=s.gw[928]==1 or s.o['zsw_local']=='commanded'
        if show:
            if (w&6==6) or b12: z|=1
            if (w&7==7 or b12) and not f: z|=2
            if w&0xF==0xF and not b12 and not f: z|=4
            if w&2 or b12: z|=0x10
            if w&4 or b12: z|=0x20
        if f: z|=8; z&=~1
        sp_,c_=s.by_bus()
        if s.o['b9']=='both' and sp_ and c_ or s.o['b9']=='any' and (sp_ or c_): z|=0x200
        if s.running: eq=s.at_sp()
        else: eq=s.o['rest8'] and s.out==0 and s.hsw==0
        if eq and not f: z|=0x500
        return z
    def basic_io(s,du,now):
        w=[du[i]<<8|du[i+1] for i in range(0,8,2)]
        if w!=s.basic or s.basic_fresh: s.log('BASIC %s (out %.2f)'%(' '.join('%04X'%x for x in w),s.out)); s.stws.append((now-s.t0,w[0],w[1]))
        c=w[0]; turning=abs(s.out)>0.005; p=s.basic_prev
        if c&0x3F0C: s.sin('Basic: unused bits %04X'%c)
        if c&0x8000: s.sin('EEp Wri'); 
        if c&0x4000: s.sin('Conn Sta')
        if c&3==3: s.sin('both run bits')
        if c&3 and not c&0x10: s.sin('run bit without Net Ctrl')
        if c&0x10 and not c&0x50==0x50: s.log('note Net Ctrl without Net Ref')
        if c&0x10 and (not 1<=w[2]<=30000 or not 1<=w[3]<=30000): s.sin('ramp words outside the range: %04X %04X'%(w[2],w[3]))
        if w[1]>40000: s.sin('setpoint above 400 Hz')
        if turning and s.bus_run and not c&0x10: s.sin('Net Ctrl dropped while the motor turns under the bus')
        if c&0x80 and not p&0x80 and c&3: s.sin('Reset with run bit')
        if c&3 and not p&3 and s.fault is not None: s.sin('start while tripped')
        if c&0x80 and not p&0x80 and (not s.basic_fresh or s.o['first_edge']): s.reset_fault('Basic')
        if c&3 and c&0x10:
            if not s.bus_run and s.fault is None and not s.no_start and (not p&3 or s.o['restart']=='standing'): s.bus_run=True; s.log('BUS RUN basic')
        else: s.bus_run=False
        if 1<=w[2]<=30000: s.basic_acc=w[2]/10
        if 1<=w[3]<=30000: s.basic_dec=w[3]/10
        f=w[1]/100
        if f<=s.o['a004']: s.basic_sp=f
        elif s.o['basic_over']=='hold': s.basic_sp=s.o['a004']
        s.basic=w; s.basic_prev=c; s.basic_fresh=False
        st=c&0x4000|c&0x70
        if s.fault is not None: st|=0x80|s.fault[0]<<8
        elif s.o['trip_cause_stands'] and s.trips: st|=s.lastcause<<8
        r=s.running if s.fault is None else 0
        if s.out>0.005 or (s.out==0 and r>0): st|=1
        if s.out<-0.005 or (s.out==0 and r<0): st|=2
        fr=int(round(abs(s.out)*100)); cur=160 if s.out else 0
        state=10 if s.fault is not None else (1 if s.out or r else (3 if s.turning else 0))
        return b''.join(bytes([x>>8,x&255]) for x in (st,fr,cur,state))
    def do_trip(s,cause=0x05,display=5):
        with s.lock:
            s.step(time.monotonic())
            s.log('TRIP cause %02X at %.2f Hz'%(cause,s.out)); s.fault=(cause,display); s.trips+=1; s.lastcause=cause; s.fault_t=time.monotonic(); s.bus_run=False
            s.tripdata={300:cause,301:int(abs(s.out)*100),302:160,303:3250,304:3600,305:7200}
            if 215 in s.par:
                s.par[215]=display; s.par[216]=s.tripdata[301]; s.par[217]=320; s.par[218]=3250
            if s.o['dh_on_trip'] and s.state=='dx': s.dh=True
            s.lockuntil=time.monotonic()+0.12
    lockuntil=0
    def reset_fault(s,by):
        s.log('RESET by %s (fault %s)'%(by,s.fault))
        if s.fault is None: s.log('note: reset edge without fault')
        s.fault=None if not getattr(s,'sticky',False) else s.fault
        if s.o['restart']=='standing': s.armed=True
        if s.fault is None and s.state=='dx' and s.o['dh_on_trip']: s.dh=True
    # ---------- PKW
    def is_inv(s,p): return p<300
    def value(s,p,sub=0):
        if p in s.tab:
            if p==239: return int(abs(s.out)*10)
            if p==245: return int(abs(s.sp)*10)
            if p==247: return 8 if s.fault is not None else (3 if s.running else 2)
            if p==246: return 0 if not s.out else (1 if s.out>0 else 2)
            return s.par[p]
        if p in s.trip: return s.trip[p]
        if p in (700,): return s.hsw
        if p==701: return s.hiw()
        if p==600: 
            if s.mode_b: return (1 if s.basic[0]&0x40 else 0)|(2 if s.basic[0]&0x10 else 0)
            a,b=s.by_bus(); return (1 if a else 0)|(2 if b else 0)
        if p==602: return 1
        if p==604: return 0 if s.fault is not None else (1 if s.out>0 else 2 if s.out<0 else 0)
        if p==611:
            if s.o['p611_rest']=='hsw' or s.running:
                if s.gw[928]==1 and s.stw&0x400:
                    sg=s.hsw-65536 if s.hsw&0x8000 else s.hsw
                    return int(round(abs(sg)/0x4000*s.o['a004']*100))
                return int(abs(s.local_cmd()[1])*100)
            return 0
        if p==612: return 0x100 if s.running else 0
        if p==613: return 0x21 if s.running else 1
        if p==614: return int(round(abs(s.out)*100))
        if p==615: return 16 if s.out else 0
        if p==622: return 10 if s.fault is not None else (1 if s.running or s.out else 0)
        if p==624: return SERIES[s.o['series']]
        if p==967: return s.stw
        if p==968: return s.zsw()
        return s.gw.get(p)
    RO={600,602,604,611,612,613,614,615,622,624,700,701,702,300,301,302,303,304,305,918,965,967,968,964,800,801}
    U16={611,612,613,614,615,700,701,301,302,303,922,965,967,968,971,800,801}
    def plen(s,p):
        if p in s.tab: return s.tab[p][0]
        if p in(304,305): return 4
        return 2 if p in s.U16 else 1
    def exists(s,p): return p in s.tab or p in s.arr or s.value(p) is not None
    def do_write(s,p,v,how):
        "-> None or error"
        if not s.exists(p): return s.o['missing']
        if p in s.RO or (p in s.tab and not s.tab[p][1]): return 1
        L=s.plen(p)
        if how=='pkw':
            s.writes.append((time.monotonic()-s.t0,p,v)); s.pkw_writes[p]=s.pkw_writes.get(p,0)+1
            s.log('WRITE P.%d = %d (0x%X)'%(p,v,v))
        if p in (605,606,608,623,601,603,250,248,928) and s.stw&1 and s.state=='dx': s.sin('write of P.%d while a start word stands'%p)
        if p in s.tab:
            rng=s.tab[p][2]; v&=0xFFFF if L==2 else 0xFF
            if p in (7,8,9,10,51,52,53,54):
                if not (1000<=v<=30000 or 0xD8F1<=v<=0xFFFF): return s.o['limit_err']
            elif rng and not rng[0]<=v<=rng[1]: return s.o['limit_err']
            if s.running and p in (13,15,88,89,99,160): return s.o['running_err']
            s.par[p]=v; return None
        lim={703:4,928:2,927:1,620:1,605:1,607:1,704:3,616:1,601:1,603:1,621:1}.get(p)
        if lim is not None and v>lim: return s.o['limit_err']
        old=s.gw.get(p); s.gw[p]=v
        if p==928:
            if v==1 and s.o['b928']=='level': s.armed=True
            s.log('P.928 := %d'%v)
        if p==603 and v==1 and old==0: s.reset_fault('P.603')
        if p==616 and v==1 and old==0:
            s.trip=dict(getattr(s,'tripdata',s.trip)) if s.o['p616']=='copy' else {k:0 for k in s.trip}
        return None
    def rej(s,p,e,ak=7):
        pwe=(e,0) if s.o['errword']=='high' else (0,e)
        return bytes([ak<<4|p>>8,p&255])+s.ind_now+b''.join(bytes([x>>8,x&255]) for x in pwe)
    def ans(s,ak,p,v):
        if ak in(1,4,6) and v&0x8000 and s.o['neg_pwe']=='FFFF' and p in (7,8,9,10,51,52,53,54): v|=0xFFFF0000
        return bytes([ak<<4|p>>8,p&255])+s.ind_now+(v&0xFFFFFFFF).to_bytes(4,'big')
    def do_pkw(s,q,now):
        if q!=s.pkw_last:
            ak=q[0]>>4; p=(q[0]<<8|q[1])&0x7FF
            if s.pkw_last is not None:
                oak=s.pkw_last[0]>>4
                if ak and oak: s.sin('PKW: AK %d P.%d right after AK %d without AK 0 between'%(ak,p,oak))
                if s.pkw_due and ak==0: s.log('note: request withdrawn before answer (P.%d)'%((s.pkw_last[0]<<8|s.pkw_last[1])&0x7FF))
            elif ak: s.log('note: first PKW is a request')
            if ak and not s.pkw_seen0: s.sin('PKW request P.%d while the answer channel was not empty'%p)
            if q[0]&8: s.sin('PKE bit 11 set')
            if ak in(4,5,8) or ak>9: s.sin('AK %d'%ak)
            s.pkw_last=q
            if ak==0:
                s.pkw_due=None
                if s.o['pkw_wait']=='slow0': s.zero_at=now+0.05
                else: s.pkw_out=bytes(8)
            else:
                s.log('PKW '+q.hex()); d=s.o['pkw_inv_ms'] if s.is_inv(p) else s.o['pkw_ms']
                if now<s.lockuntil and s.o['lock120']=='wait': d+=120
                s.pkw_due=now+d/1e3
                if s.o['pkw_wait']=='zero': s.pkw_out=bytes(8)
        elif q[0]>>4 and s.pkw_due is None and s.o['pkw_repeat']=='every':
            s.pkw_due=now
        za=getattr(s,'zero_at',None)
        if za and now>=za: s.pkw_out=bytes(8); s.zero_at=None
        if s.pkw_due and now>=s.pkw_due:
            s.pkw_due=None; s.pkw_out=s.pkw_exec(q,now) or s.pkw_out
            s.log('PKW -> '+s.pkw_out.hex())
        s.pkw_seen0=s.pkw_out[0]>>4==0
        return s.pkw_out
    deny=None  # {p:err}
    def pkw_exec(s,q,now):
        ak=q[0]>>4; p=(q[0]<<8|q[1])&0x7FF; sub=q[2]; v=int.from_bytes(q[4:8],'big')
        s.ind_now=bytes([q[2],q[3] if s.o['ind_low']=='echo' else 0])
        if q[3]: s.sin('IND low byte %02X'%q[3])
        if s.gw[927]==0 and p!=927: return s.rej(p,s.o['p927_reply'][1],s.o['p927_reply'][0])
        if s.deny and p in s.deny:
            e=s.deny[p]
            if e is None: return None
            if isinstance(e,tuple):  # (n times, err)
                if e[0]>0: s.deny[p]=(e[0]-1,e[1]); return s.rej(p,e[1])
            elif not (isinstance(e,str)): return s.rej(p,e)
            elif e=='w8' and ak in(2,3,7): return s.rej(p,0,8)
            elif e.startswith('w') and ak in(2,3,7): return s.rej(p,int(e[1:]))
        if now<s.lockuntil and s.o['lock120']=='refuse': return s.rej(p,101)
        if not s.exists(p):
            s.log('note: asked for missing P.%d'%p); return s.rej(p,s.o['missing'])
        L=s.plen(p)
        if ak==1:
            if sub: s.sin('IND in AK 1')
            if p in s.arr: return s.rej(p,s.o['arr_ak1'])
            return s.ans(s.o['ak1_long'] if L==4 else 1,p,s.value(p))
        if ak==2:
            if p in s.arr: return s.rej(p,4)
            if L==4: return s.rej(p,5)
            if v>0xFFFF and v<0xFFFF8000: s.sin('AK 2 with PWE %08X'%v)
            e=s.do_write(p,v&0xFFFF,'pkw')
            return s.rej(p,e) if e is not None else s.ans(1,p,v)
        if ak==3:
            s.sin('AK 3 (no 4-byte parameter is writable) P.%d'%p); return s.rej(p,5)
        if ak in(6,7):
            if p not in s.arr: s.sin('AK %d on P.%d, no array'%(ak,p)); return s.rej(p,4)
            n=sub-(s.o['p964_from'] if p==964 else 1)
            if not 0<=n<len(s.arr[p]): 
                s.log('note sub %d of %d refused'%(sub,p)); return s.rej(p,3)
            if ak==6: return s.ans(4,p,s.arr[p][n])
            if p==964: return s.rej(p,1)
            if v and (not s.exists(v) or v in s.arr): return s.rej(p,22)
            if v and s.plen(v)>2: return s.rej(p,5)
            s.arr[p][n]=v; s.writes.append((time.monotonic()-s.t0,(p,sub),v)); s.log('MAP %d.%d=%d'%(p,sub,v)); return s.ans(4,p,v)
        if ak==9:
            if p not in s.arr: return s.rej(p,4)
            return s.ans(6,p,len(s.arr[p]))
        return s.rej(p,5)
    # ---------- time
    def tick(s,now):
        s.step(now)
        if s.wd_on and s.wd and s.state in('dx','wait_cfg') and now-s.wd_t>s.wd:
            s.log('WATCHDOG after %.2f s'%s.wd); s.wd_exp=getattr(s,'wd_exp',0)+1; s.leave('wd')
        for e in list(s.evq):
            if e[0](s): s.evq.remove(e); s.log('event '+e[2]); e[1](s)
    def when(s,cond,act,name=''):
        with s.lock: s.evq.append((cond,act,name))
    def poweroff(s):
        s.power=False; s.log('POWER OFF (shaft %.2f)'%s.shaft); s.tx=[]
        s.reset_dp(); s.mode_b=None; s.fcb={}
    def poweron(s):
        s.power=True; s.reset_dp(); s.mode_b=None; s.stw=0; s.basic=[0]*4; s.seen_any=False; s.gw[928]=0; s.lostact=None; s.bus_run=False; s.log('POWER ON')
    def close(s):
        s.stopme=True; s.join(2); 
        try: os.close(s.m); os.close(s.sl)
        except OSError: pass
        s.f.close()
if __name__=='__main__':
    kw={}
    for a in sys.argv[1:]:
        k,v=a.split('=',1)
        try: v=eval(v,{})
        except Exception: pass
        kw[k]=v
    dur=kw.pop('duration',600)
    s=Slave(kw.pop('name','main'),**kw); s.start(); print(s.path,s.link,flush=True)
    t=time.time()
    while time.time()-t<dur and s.is_alive(): time.sleep(.2)
