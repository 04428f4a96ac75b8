# gl1.py : groups of 2-3, nobody enables; ONE reply lost or late (>timeout) at the k-th telegram behind the first stop word; exit must be 0
import sys
from vb import *
import h4s
from multiprocessing import Pool
def one(j):
    seed,fam,kind,n,k,mode=j
    L=fam=='lx'; ds=[]
    for a in range(1,n+1):
        d={'lx':LXM,'rtu':ACU,'ascii':ACU,'vabus':VACU}[fam](a)
        if fam=='ascii': d.ascii=True
        (h4s.runsl if L else h4s.runsa)(d); ds.append(d)
    S={'k':0}
    def fate(i,t,q,r,d):
        if any(x.wr for x in ds):
            S['k']+=1
            if S['k']==k: return [] if mode=='lost' else [(mode,r)]
        return [(0,r)]
    a=([] if fam in('lx','rtu') else ['--protocol',fam])+{'disable':['statemachine','disable'],'qs':['statemachine','quick-stop'],'zero':['sollwert','0']}[kind]
    ln=Line(ds,fate)
    try: r=h4s.run2(ln,['-a',','.join(str(x.adr) for x in ds)]+a,ds[0])
    finally: ln.close()
    open('out/gl1-%d.txt'%seed,'w').write(r['out']+r['err'])
    return 'gl1 %d %s %s n%d k%d %s rc %s took %.2f n %s %s %s'%(seed,fam,kind,n,k,mode,r['rc'],r['took'],[round(x.n,1) for x in ds],'CAPS' if 'STILL TURN' in r['out']+r['err'] else '', 'RC!' if r['rc'] else '')
if __name__=='__main__':
    R=random.Random(int(sys.argv[3])); J=[(i,R.choice(['lx','rtu','ascii','vabus']),R.choice(['disable','qs','zero']),R.choice([2,2,3]),R.randrange(1,40),R.choice(['lost','lost',.8,.3])) for i in range(int(sys.argv[1]))]
    with Pool(int(sys.argv[2]),maxtasksperchild=5) as p:
        for x in p.imap_unordered(one,J): print(x,flush=True)
