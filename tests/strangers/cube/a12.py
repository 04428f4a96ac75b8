from bench import *
d=Drive(life=280,p412=1,m44_keypad=1,log='log/a12.log',params={'480':[100,200,300,400]})
def w(*a,y=True,**k):
    r=Run((['--yes'] if y else [])+list(a),d,json_=False,**k); print('$',' '.join(a),'-> rc',r.rc,'%.1fs'%r.t); print('   ',(r.out.strip()+'\n'+r.err.strip()).replace('\n','\n    ')[:1300]); 
    v=r.atend['viol']; 
    if v: print('VIOL',v[:2])
w('write','376@4=1.5kW'); w('write','480@2ram=12,5Hz'); w('read','480@2','480@2ram','480@all','480'); w('write','480=5Hz'); w('read','480'); w('write','480=5Hz')
w('write','375@2=9Hz'); w('write','375@2=9Hz','--force'); w('write','372=-5'); w('write','372@1=1,5'); w('write','372@1=70000'); w('write','411=3'); w('write','411=3','--force')
w('write','482@1=-3,25 Hz'); w('write','482@1=1.000,5Hz'); w('write','482@1=10.005Hz'); w('write','482@1=10A'); w('write','482@9=10Hz'); w('write','249@2=1'); w('read','1234'); w('read','1234','--type','int'); w('read','600','601','602','603','604')
w('write','601@1=-50'); w('read','601@1'); w('write','484=10Hz'); w('write','410=0x0006'); w('read','410'); w('read','484')
w('dataset','diff'); w('dataset','copy','1','2'); w('dataset','active'); w('dataset','select','3'); w('dataset','active'); w('dataset','select','0'); w('dataset','show','480')
print(d.dump()); d.stop()
