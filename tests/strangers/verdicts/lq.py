from j import *
for nm,kw,a in (('quick stop does not slow',dict(turning=600.,quick_stop_ramp=0.),['-a','1','statemachine','quick-stop']),
  ('disable, coasting 0 friction',dict(turning=600.,friction=0.),['-a','1','statemachine','disable']),
  ('control 7 refused',dict(turning=600.,control7='refused'),['-a','1','statemachine','disable']),
  ('no slow, sollwert 0',dict(turning=600.,left='RAMPdecel=30'),['-a','1','sollwert','0']),
  ('quick slow 20/s',dict(turning=600.,quick_stop_ramp=60.),['-a','1','statemachine','quick-stop'])):
    for i in (1,2):
        d=Lx(1,**kw); c=run([d],a,quiet=True,maxt=120)
        print('##',nm,'rc',c.rc,'%.1fs'%c.dur,'HANG' if c.hang else '','end',c.end,[(round(x,1),y) for x,y in c.words][:12],'| out',c.out.strip().replace('\n',' | ')[:300],'| err',c.err.strip().replace('\n',' | ')[:400],flush=True)
# J10-6 again
for i in (1,2):
    d=Lx(1)
    def en(c): x=c.drives[0].d; x.advance(time.monotonic()); x.state='enabled'; x.mode=3; x.value.update(PVn_target=2000,DCOMopmode=3,DCOMcontrol=15); x.acting.update(PVn_target=2000)
    c=run([d],['-a','1','sollwert','300rpm','--enable','--hold','--duration','1s'],triggers=[(ASK(.3,Y),en),(ASK(2,Y),key(b'y\n'))],term='in',quiet=True,maxt=40)
    print('## q6 rc',c.rc,c.end,'speeds',[h[1][0][1] for h in c.hist][::10],'out',c.out.replace('\n',' | ')[:300],'tty',c.ttys.replace('\r\n',' | ')[-200:],flush=True)
    d=Cube('--family acu --set 418=0 --set 434=2 --set 638=10 ')
    def en2(c): x=c.drives[0].d; x.advance(time.monotonic()); x.line_setpoint=4000; x._command(15,time.monotonic())
    c=run([d],['-a','1','sollwert','10Hz','--enable','--hold','--duration','1s'],triggers=[(ASK(.3,Y),en2),(ASK(1.5,Y),key(b'y\n'))],term='in',quiet=True,maxt=40)
    print('## q6 acu rc',c.rc,c.end,'speeds',[h[1][0][1] for h in c.hist][::10],'out',c.out.replace('\n',' | ')[:300],'tty',c.ttys.replace('\r\n',' | ')[-200:],flush=True)
