import sgl,sys
from multiprocessing import Pool
jobs=[(900+i,f,'zero',k,999,dt) for i,(f,k,dt) in enumerate([(f,k,dt) for f in('vabus','ascii','rtu','lx') for k in(2,3,4,5) for dt in(.02,.2)])]
if __name__=='__main__':
    with Pool(4) as p:
        for x in p.imap_unordered(sgl.one,jobs): print(x,flush=True)
