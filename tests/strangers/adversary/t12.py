# drives that lie: replies altered by function
from h import *
from collections import Counter
def crc(b): return ad.with_crc(b)
class Liar(ad.DriveServer):
    rule=None
    def _send(self,data,begin,duration,mine):
        if mine and self.rule:
            x=self.rule(self,data)
            if x is None: return
            data=x
        super()._send(data,begin,duration,mine)
def exc(code,fc,when=None):
    def f(s,d):
        if d[1]==fc and (when is None or when(s,d)): return crc(bytes([d[0],fc|0x80,code]))
        return d
    return f
en=lambda s,d: s.drive.first_enabled is not None
def status(mut):
    def f(s,d):
        # a reply 03 02 xx xx to P.411 (last request)
        req=[k for k in s.log if k[1]=='<'][-1][2]
        if d[1]==3 and req[2:4]==b'\x01\x9b': return crc(d[:3]+mut(s,int.from_bytes(d[3:5],'big')).to_bytes(2,'big'))
        return d
    return f
def value(par,mut):
    def f(s,d):
        req=[k for k in s.log if k[1]=='<'][-1][2]
        if d[1]==req[1] and d[1] in(3,100) and int.from_bytes(req[2:4],'big')==par:
            n=d[2] if d[1]==3 else 4
            if d[1]==3: v=mut(s,int.from_bytes(d[3:3+n],'big',signed=True)); return crc(d[:3]+v.to_bytes(n,'big',signed=True))
            v=mut(s,int.from_bytes(d[4:8],'big',signed=True)); return crc(d[:4]+v.to_bytes(4,'big',signed=True)) if len(d)==10 else crc(d[:2]+v.to_bytes(4,'big',signed=True))
        return d
    return f
def echo_other(fc,off,mut):
    def f(s,d):
        if d[1]==fc and en(s,d): b=bytearray(d[:-2]); b[off]=mut(b[off]); return crc(bytes(b))
        return d
    return f
def flap(s,v):
    s.k=getattr(s,'k',0)+1; return v if s.k%2 or s.drive.first_enabled is None else 0x0240
def rnd(s,v): return v ^ (1<<(time.monotonic_ns()//1000%16)) if s.drive.first_enabled else v
R={
 'exception 0 to every write FC6 once enabled':exc(0,6,en),
 'exception 255 to FC6':exc(255,6,en),
 'exception 5 (acknowledge) to FC6':exc(5,6,en),
 'exception 6 (busy) to FC101 enabled':exc(6,101,en),
 'exception 2 to every read 411 enabled':exc(2,3,en),
 'exception 4 to FC100 enabled':exc(4,100,en),
 'status flaps enabled/inhibit':status(flap),
 'status random bit':status(rnd),
 'status always 0xFFFF':status(lambda s,v:0xFFFF),
 'status always 0':status(lambda s,v:0),
 'status stays enabled':status(lambda s,v:0x0627 if s.drive.first_enabled else v),
 'status stays switched on':status(lambda s,v:0x0623 if s.drive.first_enabled else v),
 'P.210 never 0 (0.01)':value(210,lambda s,v:v or 1),
 'P.210 never 0 (wavering +-3)':value(210,lambda s,v:v+(time.monotonic_ns()//1000000%7-3)),
 'P.210 always 0':value(210,lambda s,v:0),
 'P.210 negative big':value(210,lambda s,v:-v),
 'echo of FC6 with another value':echo_other(6,5,lambda b:b^1),
 'echo of FC6 with another register':echo_other(6,3,lambda b:b^1),
 'echo of FC101 with another value':echo_other(101,7,lambda b:b^1),
 'byte count one too many':lambda s,d: crc(d[:2]+bytes([d[2]+1])+d[3:-2]+b'\0') if d[1]==3 and en(s,d) else d,
}
for n,rule in R.items():
    if len(sys.argv)>1 and sys.argv[1] not in n: continue
    d=act('',Liar); d.rule=rule
    with d:
        r=run(d,[a.replace('6s','2s') for a in RUN]+['--json'],limit=60,after=1)
        try: x=json.loads(r['out']); D=x['data'] or {}; e=x['error']; st=D.get('stop') or {}
        except Exception as ex: print('NO DOC',r['out'][:300]); D={};e=None;st={}
        print(f"{n}: exit {r['code']} {r['s']}s hang={r['hang']} end={r['end']} later={r['later']} running={D.get('running')} standing={D.get('standing')} ack={st.get('acknowledged')} P484={d.drive.ram.get(484) if hasattr(d.drive,'ram') else ''} | {(e or {}).get('message','')[:170]}",flush=True)
        print('     given back?', [(c['name'],c['restored']) for c in D.get('changed',[])], 'sp', d.report()['writes'][-4:])
