from s2 import *
G={'a2-slow3':[('a',1,.3),('a',2,0)],'a1-slow3':[('a',1,.3)],'l2-slow3':[('l',1,.3),('l',2,0)],'a2-slow2':[('a',1,.2),('a',2,0)]}
V={'disable':['statemachine','disable'],'qs':['statemachine','quick-stop']}
def prep(d):
    runs(d)
    if isinstance(d,ACU): d.ram.update({(418,i):0 for i in range(1,5)})
with ThreadPoolExecutor(2) as ex:
    fs=[ex.submit(grp,'%s-%s'%(g,v),a,sp,[],None,prep) for g,sp in G.items() for v,a in V.items()]
    for f in fs:
        try: f.result()
        except Exception as e: print('ERR',repr(e))
