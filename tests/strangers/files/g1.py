from mat import *
def sset(n,i,v,**k): return lambda d: d.set(n,i,v,**k)
def row(r): return [(v['param'],v['data_set'],v.get('store'),v['old_raw'],v['raw'],v['result'],v.get('note')) for v in rowsof(r.j)]
def fin(k): return lambda d,n,b: ('exc',4,6) if b[1] in(6,101) and b[2:4]==k else None
open(W+'/m480.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480"="3 Hz"\n"549"="6.00 %"\n')
T2=[(480,0,300),(549,0,600)]
for ram in('cells','ramval','refused','refused_all'):
    print('######',ram)
    # equal in EE, RAM differs, whole then refusal at 549? order 549 first then 480; refuse 480@4
    for nm,prep in (('ee equal ram differs set3',lambda d:(d.set(480,0,300),d.set(549,0,600),d.set(480,3,777,ee=False))),('ee differs ram equal',lambda d:(d.set(480,0,300,ee=False),d.set(549,0,600,ee=False))),('all equal',lambda d:(d.set(480,0,300),d.set(549,0,600))),('one of four equal',lambda d:d.set(480,2,300)),('ram other than ee',lambda d:(d.set(480,0,888,ee=False),d.set(549,0,777,ee=False)))):
        r,p,d=one(nm,None,ram=ram,file='m480.toml',T=T2,prep=prep,doundo=False); print('   ',[w[1:4] for w in d.wlog],row(r) if nm!='one of four equal' else '')
        if 'ram other' in nm or 'differs' in nm: print('    ERRTXT', [l for l in r.err.splitlines() if 'RAM' in l or 'ram' in l or 'warn' in l][:4])
        r,p,d=one(nm+' +refuse 480@4',lambda d,n,b:('exc',4,6) if b[1]==101 and b[2:4]==bytes.fromhex('41e0') else None,ram=ram,file='m480.toml',T=T2,prep=prep); print('   ',[w[1:4] for w in d.wlog])
