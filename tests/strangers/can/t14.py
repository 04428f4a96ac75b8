from t12 import go2
from t9 import *
from t6 import H
b=go2('u',['read','417','--json'],nodes=[{'ee':{(417,0):65000}}],out=60);b.close()
b=go2('w',['write','417=5','--yes'],out=5);b.close()
b=go2('w2',['write','417=-5','--type','int','--yes'],out=5);print(b.nodes[0].ee[417,0],[l for l in b.L if '645 2' in l]);b.close()
nn=[{'nid':i} for i in(1,2,17,62,63)]
for k in('lost10','late600_1of7','double','othernode','short4_1of5','abort0_1of9'):
    H[k] 
    b=Bench('t14-'+k,nodes=nn,reply=H[k]);r=b.run('scan',node=None,show=False,timeout=60);print(k,r[0],f'{r[3]:.1f}',re.findall(r'^ *(\d+)  (\w+)',r[1],re.M),[l[:200] for l in r[2].split('\n') if l.startswith(('error','warning: asked'))]);b.close()
for sig,at in(('INT',.5),('TERM',2.0),('INT',2.0)):
    b=Bench('t14-s%s%s'%(sig,at),nodes=nn);b.at(at,lambda:b.proc.send_signal(getattr(signal,'SIG'+sig)));r=b.run('scan','--thorough',node=None,show=False,timeout=60);time.sleep(.1);print('scan',sig,at,r[0],f'{r[3]:.2f}',re.findall(r'^ *(\d+)  (\w+)',r[1],re.M),'open',b.open,[l[:160] for l in r[2].split('\n') if l.startswith('error')]);b.close()
# signal in apply, 2 drives
for sig in('INT','KILL'):
  for at in(4,10):
    c=[0]
    for f in os.listdir('w'):
        if 'undo' in f: os.remove('w/'+f)
    def pw(s,n,ds,raw):
        c[0]+=1
        if c[0]==at: s.b.proc.send_signal(getattr(signal,'SIG'+sig));time.sleep(.02)
    b=Bench('t14-ap%s%d'%(sig,at),nodes=[{'nid':0,'pre_write':pw},{'nid':1,'rx':'0-2','ee':{(936,0):2},'pre_write':pw}]);bf=[dict(x.ee) for x in b.nodes]
    r=b.run('systembus','apply','p.toml','--yes',node=None,show=False,timeout=60);time.sleep(.1)
    print('apply',sig,at,r[0],re.findall(r'^result +(.*)$',r[1],re.M),'same' if bf==[x.ee for x in b.nodes] else 'DIFFERS','open',b.open,[l[:260] for l in r[2].split('\n') if l.startswith('error')])
    if sig=='KILL':
        u=sorted(f for f in os.listdir('w') if 'undo' in f)
        for f in u:
            r=b.run('dataset','undo',f,'--yes',node='master' if 'drive-1' in f else '1',show=False);print('  undo',f,r[0],[l[:200] for l in r[2].split('\n') if l.startswith('error')])
        print('  ','same' if bf==[x.ee for x in b.nodes] else 'DIFFERS')
    b.close()
