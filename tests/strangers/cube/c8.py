from bench import *; import subprocess
def w(d,*a,at=(),**k):
    r=Run(list(a),d,json_=False,at=at,**k); print('$',' '.join(a),k.get('addr',''),'-> rc',r.rc,'%.1fs'%r.t); print('   ',(r.out.strip()[-600:]+'\n'+r.err.strip()[-500:]).replace('\n','\n    ')); sys.stdout.flush(); return r
d=Drive(life=200,p412=1,m44_keypad=1,log='log/c8.log',addr=3)
w(d,'read','411',addr=1); w(d,'-b','9600','read','411',addr=3); w(d,'--parity','odd','read','411',addr=3); w(d,'--protocol','ascii','read','411',addr=3); w(d,'scan','-a','1-5',addr=None); w(d,'-b','9600','scan','-a','1-5',addr=None)
w(d,'sollwert','0','--until','reached',addr=3)
w(d,'monitor','--count','3','--interval','200ms','210',addr=3,at=[(0.5,lambda r:d.cmd('silent 1'))])
w(d,'monitor','--count','8','--interval','200ms','--format','csv','210','411',addr=3,at=[(1.2,lambda r:d.cmd('dead')),(3.5,lambda r:d.cmd('alive'))])
os.system('rm -f /tmp/nov22.rec'); w(d,'--trace','/tmp/nov22.rec','read','411','372@2','481',addr=3); w('tape:/tmp/nov22.rec','read','411','372@2','481',addr=3); w('tape:/tmp/nov22.rec','read','410',addr=3); w(None,'decode','trace','/tmp/nov22.rec')
w(d,'monitor','210','--format','ndjson',addr=3,at=[(1.5,lambda r:d.cmd('hangup'))],limit=20)
d.stop()
d=Drive(life=40,p412=1,m44_keypad=1,log='log/c8.log'); w(d,'monitor','210','--interval','200ms',at=[(1.5,INT)],limit=20); w(d,'monitor','210','--interval','200ms','--format','csv',at=[(1.5,TERM)],limit=20); w(d,'sniff','--for','1s',addr=None,at=[(0.3,lambda r:d.cmd('noise 0103020237f8f2'))]); w(d,'scan',addr=None,at=[(1.0,INT)]); w(d,'scan','--json',addr=None,at=[(1.0,INT)]); d.stop()
