from bench import *
def w(d,*a,addr=1,**k):
    r=Run(['--yes']+list(a),d,json_=False,addr=addr,**k); print('$',' '.join(a),'-> rc',r.rc,'%.1fs'%r.t); print('   ',(r.out.strip()+'\n'+r.err.strip()).replace('\n','\n    ')[:1500]); sys.stdout.flush()
d=Drive(life=150,p412=1,m44_keypad=1,log='log/a14.log')
w(d,'line','show'); w(d,'line','set','--address','5'); w(d,'identify',addr=5); w(d,'line','set','--baud','57600','--parity','odd',addr=5)
w(d,'--baud','57600','--parity','odd','identify',addr=5); w(d,'--baud','57600','--parity','odd','protocol','set','ascii',addr=5)
w(d,'scan','--baud','auto','--parity','auto','--protocol','auto','--until-first',addr=None)
w(d,'--baud','57600','--parity','odd','--protocol','ascii','read','411','372@all',addr=5)
w(d,'--baud','57600','--parity','odd','--protocol','ascii','line','set','--address','300',addr=5)
print(d.dump()); d.stop()
d=Drive(life=100,p412=1,m44_keypad=1,log='log/a14b.log'); w(d,'scan',addr=None); w(d,'scan','--json',addr=None); w(d,'diag','--check'); w(d,'diag','line'); w(d,'diag','--link-test','30'); d.cmd('set warn 129'); d.cmd('fault 0507'); w(d,'diag','--check'); w(d,'--lang','de','diag'); w(d,'statemachine'); d.stop()
