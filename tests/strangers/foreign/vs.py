from cln import *
import sys,re,tempfile
to=float(sys.argv[1]); pr=sys.argv[2]; args=sys.argv[3:] or ['dataset','save',tempfile.mktemp(suffix='.toml')]
d=(VACU if pr=='vabus' else ACU)(1); d.ascii=pr=='ascii'
ln=Line([d])
r=run(ln,['-a','1','--protocol',pr]+args,d,timeout=to); ln.close()
L=ln.log; q=[x for x in L if x[1]=='>']
E=r['err']
first=re.search(r'\n\s+([\d.]+) ms > .*fence',E)
print(pr,args[:2],'rc',r['rc'],'took %.1f'%r['took'],'tel',len(q),'naks',E.count('(NAK)'),'fences',E.count('fence:'),'notanswer',E.count('not the answer'),'first fence',first and first[1])
open('out/vs-%s-%d.txt'%(pr,int(time.time()*10)),'w').write(E)
