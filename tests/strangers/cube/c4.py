from bench import *
d=Drive(life=60,p412=1,m44_keypad=1,log='log/c4.log',ram_read='eeprom')
def w(*a,**k):
    r=Run(list(a),d,json_=False,**k); print('$',' '.join(a),'-> rc',r.rc); print('   ',(r.out.strip()+'\n'+r.err.strip()).replace('\n','\n    ')[:1500])
w('--yes','write','413@ram=5'); w('read','413','413@ram','412@1','412@1ram','434@0ram'); w('read','413','413@ram','--format','csv'); w('read','413','413@ram','--format','ndjson')
w('--lang','de','sollwert','10Hz','--enable','--hold','--duration','1s','--yes'); w('--lang','de','statemachine'); w('--lang','de','statemachine','quick-stop'); w('--lang','de','diag'); w('--lang','de','--yes','statemachine','reset'); w('--lang','de','identify'); w('--lang','de','sollwert','--fnord'); w('--lang','de','sollwert','10Hz','--duration','1s'); w('--lang','de','sollwert','10Hz','5'); w('--lang','de','-h')
w('read','411',env={'LANG':'de_DE.UTF-8'}); w('read','411',env={'LC_ALL':'de_AT','LANG':'en_US'}); w('read','411',env={'LANG':'de'}); w('read','411',env={'LC_MESSAGES':'de_DE.UTF-8'}); w('read','411',env={'LANGUAGE':'de'}); w('read','411',env={'LC_ALL':'','LANG':'de_CH.UTF-8'})
d.stop()
