# gcl.py FAM KIND LATE|lost N : drives 1..N, drive 1 stands early; in the closing round the reply to the look at drive 2 is LATE s late (once) or lost (once); drive 1 is enabled 0.06 s behind that question
import sys
from vb import *
import h4s
from grp2 import look
def one(fam,kind,late,n):
    L=fam=='lx'; ds=[]
    for a in range(1,n+1):
        d={'lx':LXM,'rtu':ACU,'ascii':ACU}[fam](a)
        if fam=='ascii': d.ascii=True
        (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    for d in ds[1:]:
        if L: d.n=1500; d.p[6938]=1500; d.p[1558]=max(750,d.p[1558])
        else: d.n=30; d.ram[484,0]=3000
    S={'c':0}
    def fate(i,t,q,r,d):
        if d is ds[0]:
            if 'l1' in S and t-S['l1']>.35 and all(x.wr and x.n==0 for x in ds): S.setdefault('cl',t)
            S['l1']=t
        elif d is ds[1] and 'cl' in S and 'a0' not in S and look(fam,q,2):
            S['a0']=t; return [] if late=='lost' else [(float(late),r)]
        return [(0,r)]
    def ev(d,t): return 'a0' in S and t-S['a0']>=.06
    def go(d,t):
        S['a']=t
        if L: d.mode=3; d.p[6918]=3; d.control(6,t); d.control(15,t); d.p[6938]=500
        else:
            for i in range(1,5): d.ram[412,i]=1; d.ram[434,i]=3
            d.ctl(0,t); d.ctl(6,t); d.ctl(15,t); d.ram[484,0]=3000
    ds[0].events=[(ev,go)]
    a=[] if fam!='ascii' else ['--protocol',fam]
    a+={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
    ln=Line(ds,fate)
    try: r=h4s.run2(ln,['-a',','.join(str(x.adr) for x in ds)]+a,ds[0])
    finally: ln.close()
    t1=r['t1']; lk=[[t for t,k,b in ln.log if k=='>' and t<t1 and look(fam,b,x.adr)] for x in ds]
    ga='a' in S and round(t1-S['a'],2)
    n1=[n for t,n in ds[0].hist if t<=t1][-1]
    l='gcl %s %s %s n%d rc %s took %.2f gapA %s blind %s n %.1f %s cap %s'%(fam,kind,late,n,r['rc'],r['took'],ga,['%.2f'%(t1-x[-1]) for x in lk],n1,ds[0].st,'STILL TURN' in r['out']+r['err'])
    if abs(n1)>1e-6 and r['rc']==0 and ga and ga>.2: l+=' **FALSE0**'
    open('out/gcl-%s-%s-%s-%d.txt'%(fam,kind,late,n),'w').write(l+'\n'+r['out']+r['err']+'\nLOG\n'+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log))
    print(l,flush=True)
if __name__=='__main__':
    for x in sys.argv[1:]:
        f,k,l,n=x.split(','); one(f,k,l,int(n))
