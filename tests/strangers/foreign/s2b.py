from s2 import *
G={'a3-mid-dead':[('a',1,0),('a',2,'dead'),('a',3,0)],'l3-first-dead':[('l',1,'dead'),('l',2,0),('l',3,0)],'mix-l-a-dead':[('l',1,0),('a',2,0),('l',3,'dead'),('a',4,0)],'l2-last-dead':[('l',1,0),('l',2,'dead')],'a2-slow3':[('a',1,.3),('a',2,0)],'l2-clean':[('l',1,0),('l',2,0)],'a3-clean':[('a',1,0),('a',2,0),('a',3,0)],'mix4-clean':[('l',1,0),('a',2,0),('l',3,0),('a',4,0)]}
V={'disable':['statemachine','disable'],'zero':['sollwert','0'],'qs':['statemachine','quick-stop'],'dv':['statemachine','disable-voltage']}
def prep(d):
    runs(d)
    if isinstance(d,ACU): d.ram.update({(418,i):0 for i in range(1,5)})
with ThreadPoolExecutor(2) as ex:
    fs=[ex.submit(grp,'%s-%s'%(g,v),a,sp,[],None,prep) for g,sp in G.items() for v,a in V.items()]
    for f in fs:
        try: f.result()
        except Exception as e: print('ERR',repr(e))
