from bench import *
d=Drive(life=10,m44_keypad=1)
r=Run(['identify'],d)
print(d.log()[:400]); d.stop()
