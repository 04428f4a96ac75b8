from t9 import *
c=[0]
for f in os.listdir('w'):
    if 'undo' in f: os.remove('w/'+f)
def pw(s,n,ds,raw):
    c[0]+=1
    if c[0]==9: s.b.proc.send_signal(signal.SIGKILL);time.sleep(.02)
b=Bench('t16',nodes=[{'ram':'ab','pre_write':pw}]);bf=dict(b.nodes[0].ee)
b.run('dataset','load','l5.toml','--yes',show=False);time.sleep(.1)
for i in(1,2):
    r=b.run('dataset','undo','l5.undo.toml','--yes',show=False);print(i,r[0],re.findall(r'^result +(.*)$',r[1],re.M),'same' if bf==b.nodes[0].ee else 'DIFFERS')
r=b.run('dataset','load','l5.toml','--yes',show=False);print('load over it',r[0],re.findall(r'^result +(.*)$',r[1],re.M))
b.close()
for s in (1,2):
    b=Bench('t16s',nodes=[{'nid':1},{'nid':17}],reply=lambda b,n,q,t,r:[(0,t,r[:4])] if n.nid==17 else [(0,t,r)])
    r=b.run('scan',node=None,show=False);print('scan short',r[0],r[1].strip().split('\n')[1:],r[2][-300:]);
    r=b.run('read','411',node='17',show=False);print('read short',r[0],r[2][-300:]);b.close()
for sig in('INT','TERM'):
    b=Bench('t16i');b.at(.6,lambda:b.proc.send_signal(getattr(signal,'SIG'+sig)));r=b.run('read','411',show=False);time.sleep(.5);print(sig,r[0],f'{r[3]:.2f}','open',b.open,[l[9:] for l in b.L if '> ' in l]);b.close()
b=Bench('t16v');b.run('write','921=1700','--yes');b.close()
