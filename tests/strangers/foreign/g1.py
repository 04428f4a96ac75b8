# g1.py : two drives, clean line, `-a 1,2 sollwert 0`; drive 1 stands early and gets a setpoint from somebody while drive 2 still slows down
from vb import *
import h4s
for i,(fam,dt) in enumerate([('rtu',.5),('lx',.3),('vabus',.5),('ascii',.5),('rtu',1.5)]):
    ds=[{'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](a) for a in(1,2)]
    for d in ds:
        if fam=='ascii': d.ascii=True
        (h4s.runsl if fam=='lx' else h4s.runsa)(d)
    if fam=='lx': ds[1].n=1500; ds[1].p[6938]=1500
    else: ds[1].n=30; ds[1].ram[484,0]=3000
    S={}
    def ev(d,t):
        if d.n or not d.wr: return False
        S.setdefault('z',t); return t-S['z']>=dt
    def en(d,t):
        S['en']=t
        if fam=='lx': d.p[6938]=500
        else: d.ram[484,0]=3000
    ds[0].events=[(ev,en)]
    ln=Line(ds)
    r=h4s.run2(ln,([] if fam in('rtu','lx') else ['--protocol',fam])+['-a','1,2','sollwert','0'],ds[0]); ln.close()
    print(fam,dt,'rc',r['rc'],'gap',round(r['t1']-S['en'],2) if 'en' in S else None,'n',[round(d.n,1) for d in ds],flush=True)
