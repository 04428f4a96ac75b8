from bench import *
d=Drive(life=40,m44_keypad=1)
r=Run(['--yes','sollwert','10Hz','--enable','--hold','--duration','2s','--take-control','--watchdog','2s','-v'],d); print(brief(r)); print(r.out[:6000]); print(r.err[:9000])
print(r.atend); d.stop()
