# mld.py FAM KIND : two ports (plant file), drive on port 2 dead / port 2 absent: others stop, told in time, and drive A enabled DT behind standing
import sys
s=open('ml.py').read()
import re
src=s.replace("l1,l2=Line([ds[0]]),Line([ds[1]])","class Dd(Base):\n    st='?'\n    def tick(s,t): pass\n    def handle(s,q,t): return None\nds[1]=Dd(1)\nl1,l2=Line([ds[0]]),Line([ds[1]])")
src=src.replace("out/ml-","out/mld-").replace("print(fam","print('dead',fam")
exec(compile(src,'mld','exec'))
