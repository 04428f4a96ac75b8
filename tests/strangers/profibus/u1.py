from sc import *
s=Slave('u1-live'); s.start()
r=run(s,raw=[BIN,'-p',s.path,'--baud','19200','--no-config','profibus','live'],quiet=True); print('0 asked:',s.heard.count((0,9)),'125:',s.heard.count((125,9)),'126:',s.heard.count((126,9)),s.sins[:2]); s.close()
def a204b(s): s.gw[607]=1; s.par[16]=1000; s.par[15]=500
S('u1-a204b',*RUN,setup=a204b,msg=True)
s=Slave('u1-tr'); s.start()
try: os.unlink(WD+'/t.trace')
except OSError: pass
s.hook=lambda s,q,b: None if random.random()<.05 else [(0,b)]
r=run(s,*RUN,'--trace',WD+'/t.trace',quiet=True); print(r.rc); s.close()
r=run(s:=Slave('u1-d'),quiet=True,raw=[BIN,'--no-config','--protocol','dp','decode','trace',WD+'/t.trace','--cfg','ppo1']); L=r.out.splitlines(); print(r.rc,len(L),r.err[-300:]); print('\n'.join(x[:150] for x in L[:14])); print('\n'.join(x[:150] for x in L[-12:])); print('bad lines',[x[:120] for x in L if 'no valid' in x][:5])
r=run(s,quiet=True,raw=[BIN,'--no-config','--protocol','dp','-p','tape:'+WD+'/t.trace','sniff','--cfg','ppo1']); print(r.rc,r.err[-200:]); print('\n'.join(x[:150] for x in r.out.splitlines()[-12:]))
