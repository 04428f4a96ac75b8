from j import *
O='--family acu --set 418=0 --set 434=2 --set 638=5 '
for t in ('5s','10s'):
  for i in (1,2):
    d=Cube(O+'--running --left 20 '); d.dead=True; c=run([d],['--timeout',t,'-a','1','statemachine','quick-stop'],maxt=200,quiet=True)
    print('qs dead',t,'rc',c.rc,'%.1f'%c.dur,'hang',c.hang,[(round(a,1),b) for a,b in c.words],flush=True)
for i in (1,2):
    d=Cube(O); c=run([d],['--timeout','10s','-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],triggers=[(EN(.5),mute(True)),(EN(.8),INT),(EN(1.5),INT),(EN(2),INT)],maxt=100,quiet=True)
    print('run dead 3 INT 10s rc',c.rc,'%.1f'%c.dur,'hang',c.hang,[(round(a,1),b) for a,b in c.words][-8:],c.err[-300:],flush=True)
    d=Cube(O); c=run([d],['--timeout','10s','-a','1','sollwert','10Hz','--enable','--hold','--duration','2s','--yes'],triggers=[(EN(.5),mute(True)),(EN(.9),mute(False))],maxt=100,quiet=True)
    print('run, 0.4 s gap, 10s rc',c.rc,'%.1f'%c.dur,'hang',c.hang,c.end,[(round(a,1),b) for a,b in c.words][-8:],c.err[-300:],flush=True)
