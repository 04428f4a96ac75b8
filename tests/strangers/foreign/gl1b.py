import gl1,sys
from multiprocessing import Pool
J=[(i,f,k,n,q,.8) for i,(f,k,n,q) in enumerate([('rtu','qs',2,22),('ascii','qs',2,31),('lx','disable',3,39),('rtu','disable',2,30),('lx','qs',2,20),('vabus','qs',2,30),('ascii','disable',2,24)]*int(sys.argv[1]))]
if __name__=='__main__':
    with Pool(2) as p:
        for x in p.imap(gl1.one,J): print(x,flush=True)
