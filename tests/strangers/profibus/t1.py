from sc import *
def a204(s): s.gw[607]=1; s.par[16]=1000; s.par[15]=500; s.o['a004']=100.0
s,r=S('t1-a204',*RUN,setup=a204,msg=True); print('   max',[(hex(a),hex(b)) for t,a,b in s.stws])
def a204b(s): s.gw[607]=1; s.par[16]=1000; s.par[15]=500
s,r=S('t1-a204b',*RUN,setup=a204b,msg=True); print('   max',[(hex(a),hex(b)) for t,a,b in s.stws])
s,r=S('t1-a204p',*[x if x!='20Hz' else '40%' for x in RUN],setup=a204,msg=True); print('   ',[(hex(a),hex(b)) for t,a,b in s.stws])
# multi address / no address
s=Slave('t1-m'); s.start()
B=[BIN,'-p',s.path,'--baud','19200','--protocol','dp','--no-config','--yes']
for a in (['-a','3,5','statemachine','disable'],['-a','3,5','read','F002'],['write','F002=5s'],['read','F002'],['sollwert','20Hz','--jog','1s','--take-control'],['statemachine','disable'],['-a','126','read','F002'],['-a','127','read','F002'],['-a','0','statemachine','disable'],['-a','all','statemachine','disable'],['-a','3','--drive','act','read','411'],['-a','3','read','F002','--retries','0'],['-a','3','--parity','none','read','F002']):
    r=run(s,quiet=True,raw=B+a+['--json'],timeout=120); e=((r.j or {}).get('error') or {}); print(' '.join(a),'rc',r.rc,'%.1f'%r.t,e.get('code'),e.get('message'),'|',str(e.get('hint'))[:100])
    print('      W',[w['message'][:100] for w in (r.j or {}).get('warnings',[])][:2])
print(s.sins[:3]); s.close()
s=Slave('t1-n'); s.start(); 
for a in (RUN,('read','F002'),('write','F002=5s'),('statemachine','disable'),('statemachine','reset'),('sollwert','0Hz'),('diag',),('monitor','--duration','1s')):
    r=run(s,*a,yes=False,quiet=True); print('no tty no --yes',a[:2],r.rc,r.err.strip().splitlines()[-1:][0][:160],s.nreq)
s.close()
