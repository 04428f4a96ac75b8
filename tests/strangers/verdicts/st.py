from j import *
RUN='--family acu --running --left 20 --set 418=0 --set 434=2 --set 638=10 '
H=['-a','1','sollwert','10Hz','--enable','--hold','--duration','1s','--yes']
def stuck(d,when):
    """the load holds the frequency: in `when` states the output does not fall"""
    o=d.d.advance
    def adv(now):
        v=(d.d.output,d.d.shaft); o(now)
        if d.d.state in when or (d.d.stopping in when): d.d.output,d.d.shaft=v; 
        if d.d.state in when and d.d.hold_until: d.d.hold_until=None
    d.d.advance=adv; return d
def go(n,d,a,rep=2,**k):
    for i in range(rep):
        D=d(); c=run([D],a,quiet=True,maxt=120,**k)
        print('##',n,'|',' '.join(a),'rc',c.rc,'%.1fs'%c.dur,'HANG' if c.hang else '','end',c.end,'later',c.later,'states',[(h[1][0][0],h[1][0][1]) for h in c.hist][::60][:12]); print('   words',' '.join('%.2f %s'%w for w in c.words)[-300:]); print('   out',c.out.strip().replace('\n',' | ')[:500]); print('   err',c.err.strip().replace('\n',' | ')[-450:],flush=True)
go('quick stop does not get slower',lambda:stuck(Cube(RUN),('quick stop','quick')),['-a','1','statemachine','quick-stop'])
go('disable does not get slower',lambda:stuck(Cube(RUN),('ramp','brake')),['-a','1','statemachine','disable'])
go('held run, ramp and quick stop do not get slower',lambda:stuck(Cube('--family acu --set 418=0 --set 434=2 --set 638=10 '),('ramp','brake','quick','quick stop')),H)
go('held run, ramp does not get slower',lambda:stuck(Cube('--family acu --set 418=0 --set 434=2 --set 638=10 '),('ramp','brake')),H,rep=1)
go('group',lambda:stuck(Cube(RUN),('quick stop','quick')),['-a','1,1','statemachine','quick-stop'],rep=1)
