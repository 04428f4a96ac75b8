from mat import *
exec(open('g2.py').read().split("H='antrieb")[0].split('from mat import *')[1])
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
def f(n,t): open(W+'/'+n,'w').write(H+t)
clean()
d=Drive(); b0=d.snap()
L=lambda *a: run(['dataset',*a,'--timeout','150ms'],d)
f('y.toml','"419"="60.00 Hz"\n"372"="1450"\n')
def cl():
    for x in glob.glob(W+'/y.undo*'): os.remove(x)
for nm,n in (('419',419),('372',372)):
  for i in (1,3):
    cl(); d.P=table(); r=L('load','y.toml','--yes'); 
    # undo file merges? show
    d.set(n,i,4321); d.clr(); r=L('undo','y.undo.toml','--yes'); print(nm,i,d.P[n]['ee'],[w[1:4] for w in d.wlog],s(r)); print(r.err[:900])
print(open(W+'/y.undo.toml').read())
# drive whose sets differ before
cl(); d.P=table(); d.set(419,3,4321); b=d.snap(); d.clr(); r=L('load','y.toml','--yes'); print('load unequal',[w[1:4] for w in d.wlog],s(r)); r=L('undo','y.undo.toml','--yes'); print(d.snap()==b,s(r))
cl(); d.P=table(); d.set(419,3,6000); b=d.snap(); d.clr(); r=L('load','y.toml','--yes'); print('load one equal',[w[1:] for w in d.wlog],s(r)); r=L('undo','y.undo.toml','--yes'); print(d.snap()==b,s(r))
# 419@0 read equal but RAM sets differ
cl(); d.P=table(); d.set(419,3,4321,ee=False); b=d.snap(); d.clr(); r=L('load','y.toml','--yes'); print('ram unequal',[w[1:] for w in d.wlog],s(r),[l for l in r.err.splitlines() if 'RAM' in l]); 
cl(); d.P=table(); d.set(419,3,4321,ee=False); b=d.snap(); d.clr(); d.hook=lambda d,n,b:('exc',4,6) if b[1]==6 and b[2:4]==bytes.fromhex('4174') else None; r=L('load','y.toml','--yes'); print('ram unequal refuse 372@4',[w[1:] for w in d.wlog],d.snap()==b,{n:(x,b[n]) for n,x in d.snap().items() if x!=b[n]},s(r)); d.hook=None
# 419@0 target equal in EE, ram unequal
cl(); d.P=table(); d.set(419,0,6000); d.set(419,3,4321,ee=False); b=d.snap(); d.clr(); r=L('load','y.toml','--yes'); print('ee equal ram unequal',[w[1:] for w in d.wlog],d.P[419],s(r))
d.stop()
