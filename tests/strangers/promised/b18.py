from nov import *
import subprocess
O='--set 418=0 --set 638=10 '
H=['-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','3s','--yes']
def second(args,store):
    def second(c):
        store.append(subprocess.Popen([BIN,'--no-config','-p',c.name]+args,stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE))
    return second
S=[]
c=run([Cube(O)],H,triggers=[(EN(1),second(['-a','1','statemachine','quick-stop'],S)),(EN(1.2),second(['-a','1','sollwert','0'],S)),(EN(1.3),second(['-a','1','read','411'],S))],label='second start',maxt=30)
for p in S: o,e=p.communicate(timeout=20); print('second rc',p.returncode,o.decode()[-200:],e.decode()[-400:])
# quick-stop --take-control
def g(n,o,a,**k): return run([Cube(o)],a,label=n,maxt=40,**k)
R0=O+'--set 412=0 --internal 20 --running'
g('qs --take-control, no --yes, no terminal',R0,['-a','1','statemachine','quick-stop','--take-control'])
g('qs --take-control --yes',R0,['-a','1','statemachine','quick-stop','--take-control','--yes','--json'])
g('disable --take-control --yes',R0,['-a','1','statemachine','disable','--take-control','--yes'])
g('dv --take-control --yes',R0,['-a','1','statemachine','disable-voltage','--take-control','--yes'])
g('zero --take-control --yes',R0,['-a','1','sollwert','0','--take-control','--yes'])
