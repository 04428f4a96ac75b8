from bench import *
for c in (0x41,0x40,0x4f,0x47,0x50,0x52,0x60,0x00,0xc2,0xa0,0x20,0x30):
    b=Bench('t7-%02x'%c,reply=lambda b,n,q,t,r,c=c:[(0,t,bytes([c])+r[1:])] if r[1:4]==b'\xe0\x01\x02' and r[0]==0x42 else [(0,t,r)])
    r=b.run('read','480@2','--timeout','150ms','--json',show=False)
    try: j=json.loads(r[1]);v=j['data'] and [(x.get('raw'),x.get('value'),x.get('error') and str(x['error'])[:140]) for x in j['data']['values']]; e=j['error'] and j['error']['code']
    except Exception as x: v=r[1][:300];e=x
    print('%02x'%c,'rc',r[0],v,e,[l[9:60] for l in b.L if 'bus' in l][-3:]);b.close()
# a drive that lies on write
from t5 import st
def lie(kind):
    def f(s,n,ds,raw,ctl):
        if n in(485,480):
            if kind=='ignore': s.b.at(0,lambda: s.b.bus(1472+s.nid,bytes([0x60,n&255,n>>8,ds])+bytes(4),s.rate,src=s)); return True
            if kind=='clamp':
                s.ee[n,ds]=raw-1; s.b.at(0,lambda: s.b.bus(1472+s.nid,bytes([0x60,n&255,n>>8,ds])+bytes(4),s.rate,src=s)); return True
            if kind=='silent_store': s.ee[n,ds]=raw; return True
            if kind=='silent_drop': return True
            if kind=='abort_store': s.ee[n,ds]=raw; s.b.at(0,lambda: s.b.bus(1472+s.nid,bytes([0x80,n&255,n>>8,ds,6,0,0,0]),s.rate,src=s)); return True
    return lambda s,n,ds,raw: f(s,n,ds,raw,0)
for k in('ignore','clamp','silent_store','silent_drop','abort_store'):
    b=Bench('t7-'+k,nodes=[{'pre_write':lie(k)}])
    r=b.run('write','480@1=6Hz','--yes','--timeout','200ms',show=False)
    print('##',k,'rc',r[0],f'{r[3]:.1f}',r[1].strip()[-90:],'| drive',b.nodes[0].ee[480,1],'|',r[2].strip().split('\n')[-2:][0][:300]);
    b.nodes[0].ee[480,1]=500
    r=b.run('dataset','load','l5.toml','--yes','--timeout','200ms',show=False,timeout=60)
    print('  load rc',r[0],f'{r[3]:.1f}',re.findall(r'^result +(.*)$',r[1],re.M),st(b),[l[:330] for l in r[2].split('\n') if l.startswith('error')])
    b.close()
