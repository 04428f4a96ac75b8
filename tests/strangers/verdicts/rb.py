from j import *
for k in (34,37,40,43):
  for i in (1,2):
    d=Lx(1,left='RAMPacc=300,PVn_target=900,DCOMopmode=3'); d.advance(time.monotonic())
    c=run([d],['--drive','lxm05','-a','1','sollwert','300rpm','--enable','--hold','--duration','1500ms','--yes','--watchdog','2s','--json'],triggers=[(N(k),setx(lambda x:x.power_cycle()))],quiet=True,verbose_line=False)
    j=json.loads(c.out); D=j['data']
    print('k',k,'rc',c.rc,'%.2f'%c.dur,[(round(a,2),b) for a,b in c.words],'events',d.d.events,'speeds',[h[1][0][1] for h in c.hist][::8]); print('   ',json.dumps({x:D.get(x) for x in ('state','from','stop','running','standing','notes','changed','setpoint')})[:900],j['error'],c.err[-200:],flush=True)
