from bench import *
def w(d,*a):
    r=Run(['--yes']+list(a),d,json_=False); print('$',' '.join(a),'-> rc',r.rc); print('   ',(r.out.strip()+'\n'+r.err.strip()).replace('\n','\n    ')[:900])
for rr in ('value','eeprom','refused'):
    print('#### ram_read',rr)
    d=Drive(life=60,p412=1,m44_keypad=1,log='log/a13.log',ram_read=rr)
    w(d,'write','480@2ram=12,5Hz'); w(d,'write','480@2=12,5Hz'); print(d.dump()['eew'])
    w(d,'write','481@2ram=12,5Hz'); w(d,'write','481@2=10Hz'); print(d.dump()['eew']); w(d,'read','481@2','481@2ram')
    w(d,'write','413@0ram=5'); w(d,'write','413=5'); print(d.dump())
    w(d,'dataset','copy','2','3','480','481'); w(d,'dataset','diff','2','3','480','481')
    d.stop()
