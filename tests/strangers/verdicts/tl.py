from j import *
# --timeout 60s with a dead line in the run, and stop verbs with it
O='--family acu --set 418=0 --set 434=2 --set 638=5 '
d=Cube(O); c=run([d],['--timeout','60s','-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],triggers=[(EN(.5),mute(True))],maxt=100,label='timeout 60s dead')
d=Cube(O+'--running --left 20 '); d.dead=True; c=run([d],['--timeout','60s','-a','1','statemachine','quick-stop'],maxt=100,label='qs timeout 60s dead')
d=Cube(O); c=run([d],['--timeout','60s','-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],triggers=[(EN(.5),mute(True)),(EN(.8),INT),(EN(1.5),INT),(EN(2),INT)],maxt=100,label='timeout 60s dead, 3 INT')
