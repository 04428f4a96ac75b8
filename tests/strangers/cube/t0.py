from bench import *
d=Drive(life=40,m44_keypad=1)
for a in (['identify'],['read','372@2','481','@actual'],['diag'],['statemachine'],['sollwert']):
    r=Run(a,d,json_=False); print(a,r.rc,'%.2f'%r.t); print(r.out[:1500]); print(r.err[:600])
print(d.dump()); d.stop()
