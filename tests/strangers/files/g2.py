from mat import *
def s(r,n=300):
    e=(r.j or {}).get('error') or {}; da=(r.j or {}).get('data') or {}
    return 'rc=%s t=%.1f ended=%s rows=%s left=%s | %s %s | hint %s | warn %s'%(r.rc,r.t,da.get('ended'),[(v['param'],v['data_set'],v['result']) for v in rowsof(r.j)][:9],[(x['param'],x['why']) for x in da.get('left_out',[])],e.get('code'),(e.get('message') or '')[:250],(e.get('hint') or '')[:150],[w['message'][:150] for w in (r.j or {}).get('warnings',[])])
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
def f(n,t): open(W+'/'+n,'w').write(H+t)
clean()
d=Drive(); b0=d.snap()
L=lambda *a: run(['dataset','load',*a,'--timeout','150ms'],d)
print('--- dry-run'); 
for a in (['m.toml','--dry-run'],['m.toml','--dry-run','--ram']):
    d.clr(); r=L(*a); print(d.n,s(r)); 
f('bad.toml','"412"="99"\n'); d.clr(); r=L('bad.toml','--dry-run'); print('bad dry',d.n,s(r)); 
f('mm.toml','"375"="5000 Hz"\n'); r=L('mm.toml','--dry-run'); print('big dry',d.n,s(r))
print('files after dry', sorted(os.listdir(W))[:20])
print('--- running')
d.run=True; d.clr(); r=L('m.toml','--yes'); print(d.n,d.nw,s(r)); d.clr(); r=L('m.toml','--yes','--ram'); print(d.nw,s(r)); r=L('m.toml','--yes','--force'); print(d.nw,s(r)); d.run=False
# starts between plan and write
for k in (3,5,14,15,16,18,20):
    one('starts at %d'%k,lambda d,n,b:(setattr(d,'run',True) if n==k else None))
print('--- layers')
f('base.toml','"372"="1450"\n"480"="1 Hz"\n"480@2"="2 Hz"\n'); f('pump.toml','"480"="4 Hz"\n'); f('pump2.toml','"480@3"="5 Hz"\n')
d.P=table(); d.clr(); r=L('base.toml','pump.toml','pump2.toml','--yes'); print([w[1:4] for w in d.wlog],d.P[480]['ee'],d.P[372]['ee'])
r=L('base.toml','base.toml','--yes','--only','480'); print(d.P[480]['ee'],s(r)); 
print('--- scopes')
f('sc.toml','"372"="1450"\n"480"="1 Hz"\n"549"="7 %"\n"413"="9 s"\n"1376"="7"\n"1375"="odd"\n"395"="3"\n"10"="6"\n"484"="3 Hz"\n"30"="410"\n')
for a in (['--sets','1,3'],['--sets','0'],['--sets','9'],['--sets','5'],['--only','motor'],['--only','480-483'],['--only','nonsense'],['--except','motor,480'],['--only','480','--except','480'],['--only','bus'],['--only','413'],['--only','all,bus'],['--only','1376'],['--only','484'],['--only','480','--sets','2'],['--ram','--only','480,372'],['--ram','--only','549'],['--ram','--only','30'],['--only','480','--sets','1','--ram']):
    for x in glob.glob(W+'/sc.undo*'): os.remove(x)
    d.P=table(); d.clr(); b=d.snap(); r=L('sc.toml','--yes',*a); print(a,[w[1:4] for w in d.wlog],s(r)); 
    q=d.snap(); 
    if '--ram' in a: print('   EE touched', [n for n in q if q[n][0]!=b[n][0]], 'ram', {n:q[n][1] for n in q if q[n][1]!=b[n][1]})
    if os.path.exists(W+'/sc.undo.toml') :
        ee=d.cnt(); d.clr(); u=run(['dataset','undo','sc.undo.toml','--yes'],d); q=d.snap(); print('   undo rc',u.rc,'same',q==b,[w[1:4] for w in d.wlog][:6],'' if u.rc==0 else s(u))
    if d.dead: d.dead=False
    d.addr=1
d.stop()
