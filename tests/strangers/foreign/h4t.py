import h4s,random,sys
from multiprocessing import Pool
jobs=[(f,kd,'zlate',k,l) for f in('lx','rtu','ascii','vabus') for kd in('disable','qs','zero','ramp','quick-stop','enable') for k in range(0,9) for l in(.3,.6,1.0,1.5)]
random.Random(int(sys.argv[2])).shuffle(jobs)
if __name__=='__main__':
    w=int(sys.argv[1]); s=sys.argv[2]; del sys.argv[2:]
    with Pool(w,maxtasksperchild=10) as p:
        for j,x in zip(jobs,p.imap(h4s.sw,jobs)): print(j,x,flush=True)
