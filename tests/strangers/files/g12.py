src=open('g11.py').read(); exec(src[:src.index("clean(); d=Drive(); rc,o=ttyd(d,1,lambda: d.set(480,2,777)); print('changed at")])
for i in range(2):
    clean(); d=Drive(); d.hook=lambda d,n,b:('exc',4,6) if b[1]==6 and b[2:4]==bytes.fromhex('419c') and b[5]==2 else None
    rc,o=ttyd(d,1,lambda: d.set(480,2,777)); print('question+777+refused: rc',rc,d.P[480]['ee'],o[-500:].replace('\r\n',' / ')); d.stop()
# sim: LXM05, ACT: save, load with refuse etc. only: save -> load of edited -> undo -> check
def B(*a,**k): return run(list(a),'sim',baud=None,**k)
for a in ('1','2'):
    r=B('dataset','save','sim%s.toml'%a,'--force',addr=a); print(a,r.rc)
    r=B('dataset','check','sim%s.toml'%a,addr=a); print(' check',r.rc,((r.j or {}).get('error') or {}).get('message'))
    r=B('dataset','load','sim%s.toml'%a,'--yes',addr=a); da=(r.j or {}).get('data') or {}; from collections import Counter; print(' load same',r.rc,da.get('ended'),Counter(v['result'] for v in da.get('values',[])),(r.j or {}).get('error'),da.get('undo_file'))
    for x in glob.glob(W+'/sim%s.undo*'%a): print('  left',x); os.remove(x)
    other='2' if a=='1' else '1'
    r=B('dataset','load','sim%s.toml'%a,'--yes',addr=other); print(' load into other',r.rc,((r.j or {}).get('error') or {}).get('message'))
    r=B('dataset','diff','factory','drive',addr=a); print(' diff factory',r.rc,((r.j or {}).get('error') or {}).get('message'))
r=B('dataset','save','d-{address}.toml','--force',addr='1,2'); print('both',r.rc,os.path.exists(W+'/d-1.toml'),os.path.exists(W+'/d-2.toml')); 
r=B('dataset','save','one.toml','--force',addr='1,2'); print('both into one',r.rc,((r.j or {}).get('error') or {}).get('message'))
r=B('dataset','check','d-{address}.toml',addr='1,2'); print('check both',r.rc)
r=B('dataset','save','e-{address}.toml','--force',addr='1,9'); print('one missing',r.rc,glob.glob(W+'/e-*'),((r.j or {}).get('error') or {}).get('message'),(r.j or {}).get('ok'))
r=B('dataset','save','dir1/',addr='1'); print('dir/',r.rc,((r.j or {}).get('error') or {}).get('message')); os.makedirs(W+'/dir2',exist_ok=True); r=B('dataset','save','dir2','--force',addr='1,2'); print('dir2',r.rc,os.listdir(W+'/dir2'))
r=B('dataset','save','{address}','--force',addr='2'); r2=B('dataset','save','../evil-{address}.toml','--force',addr='2'); print(r.rc,r2.rc)
