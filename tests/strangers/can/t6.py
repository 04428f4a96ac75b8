from bench import *
from t5 import st
def tail(e,n=2): return ' | '.join([l for l in e.strip().split('\n') if l.startswith(('error','warning','note'))][-n:])[:420]
cnt={}
def every(k,f,writes=False):
    c=[0]
    def h(b,n,req,tx,rep):
        c[0]+=1
        return f(b,n,req,tx,rep) if c[0]%k==0 else [(0,tx,rep)]
    return h
H={
 'late600_1of7':every(7,lambda b,n,q,t,r:[(.6,t,r)]),
 'late1600_1of20':every(20,lambda b,n,q,t,r:[(1.6,t,r)]),
 'lost10':every(10,lambda b,n,q,t,r:[]),
 'double':every(1,lambda b,n,q,t,r:[(0,t,r),(.0005,t,r)]),
 'triple_late':every(3,lambda b,n,q,t,r:[(0,t,r),(.02,t,r),(.3,t,r)]),
 'wrongindex_first':every(2,lambda b,n,q,t,r:[(0,t,r[:1]+bytes([(r[1]+1)&255])+r[2:]),(.001,t,r)]),
 'wrongsub_first':every(2,lambda b,n,q,t,r:[(0,t,r[:3]+bytes([r[3]^1])+b'\x11\x22\0\0'),(.001,t,r)]),
 'abort_other_first':every(2,lambda b,n,q,t,r:[(0,t,b'\x80'+bytes([(r[1]+1)&255])+r[2:4]+b'\x0b\0\0\0'),(.001,t,r)]),
 'othernode':every(2,lambda b,n,q,t,r:[(0,t+1,r[:4]+b'\x77\x77\0\0'),(.001,t,r)]),
 'cmd43':every(1,lambda b,n,q,t,r:[(0,t,(b'\x43' if r[0]==0x42 else r[:1])+r[1:])]),
 'cmd4b':every(1,lambda b,n,q,t,r:[(0,t,(b'\x4b' if r[0]==0x42 else r[:1])+r[1:])]),
 'cmd41_1of5':every(5,lambda b,n,q,t,r:[(0,t,(b'\x41' if r[0]==0x42 else b'\x41')+r[1:])]),
 'toggle50_1of5':every(5,lambda b,n,q,t,r:[(0,t,(b'\x52' if r[0]==0x42 else b'\x70')+r[1:])]),
 'cmdswap_1of5':every(5,lambda b,n,q,t,r:[(0,t,(b'\x60' if r[0]==0x42 else b'\x42')+r[1:])]),
 'short6_1of5':every(5,lambda b,n,q,t,r:[(0,t,r[:6])]),
 'short4_1of5':every(5,lambda b,n,q,t,r:[(0,t,r[:4])]),
 'abort0_1of9':every(9,lambda b,n,q,t,r:[(0,t,b'\x80'+r[1:4]+bytes(4))]),
 'abortcia_1of9':every(9,lambda b,n,q,t,r:[(0,t,b'\x80'+r[1:4]+b'\0\0\x02\x06')]),
 'abort_wrongidx0':every(9,lambda b,n,q,t,r:[(0,t,b'\x80\0\0\0'+b'\x04\0\x04\x05')]),
 'garble':every(6,lambda b,n,q,t,r:[(0,t,bytes(x^0x10 for x in r))]),
 'ack60data':every(1,lambda b,n,q,t,r:[(0,t,r[:4]+b'\1\2\3\4' if r[0]==0x60 else r)]),
}
if __name__=='__main__':
    which=sys.argv[1:] or list(H)
    for k in which:
        for f in os.listdir('w'):
            if 'undo' in f: os.remove('w/'+f)
        b=Bench('t6-'+k,reply=H[k])
        r=b.run('read','411','480@all','382@1','900',show=False)
        vals=re.findall(r'^ *(\d+) +(\d) .*?(\S+) +(?:Hz|°|Switch|$)',r[1],re.M)
        print(f'## {k}: read rc{r[0]} {r[3]:.1f}s', [l.strip()[:70] for l in r[1].split('\n')[1:8]] if r[0] or k in('wrongsub_first','othernode') else 'ok' if r[1].count('5.00')==4 and '0x0040' in r[1] else r[1], tail(r[2],1) if r[0] else '')
        r=b.run('write','480@1=6Hz','--yes',show=False)
        print('   write rc',r[0],f'{r[3]:.1f}s',r[1].strip().split('\n')[-1][-60:],'| drive',b.nodes[0].ee[480,1],b.nodes[0].ee[480,2],tail(r[2],1)if r[0] else '')
        b.nodes[0].ee[480,1]=500
        r=b.run('dataset','load','l5.toml','--yes',show=False,timeout=120)
        res=re.findall(r'^result +(.*)$',r[1],re.M)
        print('   load rc',r[0],f'{r[3]:.1f}s',res,'| drive',st(b),tail(r[2],1) if r[0] else '', 'SINS',set(b.sins) if b.sins else '',[x for x in os.listdir('w') if 'undo' in x])
        b.close()
    print(time.strftime('%X'))
