from t9 import *
for ram in('ab','ram'):
    c=[0]
    for f in os.listdir('w'):
        if 'undo' in f: os.remove('w/'+f)
    def pw(s,n,ds,raw):
        c[0]+=1
        if c[0]==9: s.b.proc.send_signal(signal.SIGKILL);time.sleep(.02)
    b=Bench('t15-'+ram,nodes=[{'ram':ram,'pre_write':pw}]);bf=dict(b.nodes[0].ee)
    r=b.run('dataset','load','l5.toml','--yes',show=False);time.sleep(.1)
    n0=len(b.L)
    r=b.run('dataset','undo','l5.undo.toml','--yes',show=False)
    print(ram,r[0],re.findall(r'^result +(.*)$',r[1],re.M),'same' if bf==b.nodes[0].ee else 'DIFFERS');print('\n'.join(l[:140] for l in r[1].split('\n') if 'unknown' in l or '  9' in l or 'ram' in l)[:900]);print([l[:300] for l in r[2].split('\n') if l.startswith(('error','warning','hint'))])
    b.close()
# systembus-like: set-less only
c=[0]
def pw(s,n,ds,raw):
    c[0]+=1
    if c[0]==4: s.b.proc.send_signal(signal.SIGKILL);time.sleep(.02)
b=Bench('t15-ap',nodes=[{'nid':0,'pre_write':pw},{'nid':1,'rx':'0-2','ee':{(936,0):2}}]);bf=[dict(x.ee) for x in b.nodes]
r=b.run('systembus','apply','p.toml','--yes',node=None,show=False,timeout=60);time.sleep(.1)
u=[f for f in os.listdir('w') if f.startswith('p-')]
r=b.run('dataset','undo',u[0],'--yes',node='master',show=False);print(u,r[0],re.findall(r'^result +(.*)$',r[1],re.M),'same' if bf==[x.ee for x in b.nodes] else 'DIFFERS');print(r[1][:1500]);print(r[2][-900:])
print([l[9:] for l in b.L if '640 ' in l or '5C0' in l or 'W node' in l or 'RUN' in l][-24:])
b.close()
