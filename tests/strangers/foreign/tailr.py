# tailr.py FILE [SECONDS] : tail of a LOG of n1/x7 output, RTU, one line per telegram
import sys
L=open(sys.argv[1]).read().split('LOG',1)[1].splitlines()[1:]
sec=float(sys.argv[2]) if len(sys.argv)>2 else 2
end=float(L[-1].split()[0])
for l in L:
    p=l.split()
    if float(p[0])>=end-sec: print(p[0],p[1],p[2][:40] if len(p)>2 else '')
