from bench import *
import random
wrong=0; tot=0; unk=0
TRUE={480:500,481:1000,482:1500,483:2000,485:2500,486:3000,487:3500,488:4000,372:1390,373:2,376:40,10:4,1376:1,413:0,549:500,600:50,603:4000}
def trial(name,cfg,extra=(),n=3,limit=150):
    global wrong,tot,unk
    for k in range(n):
        d=Drive(life=limit+20,p412=1,m44_keypad=1,log='log/b6.log',seed=k,**cfg)
        ps=list(TRUE); random.Random(k).shuffle(ps); ps=ps[:9]
        r=Run(list(extra)+['read']+[str(x) for x in ps],d,limit=limit); g=b=u=0
        for row in ((r.j or {}).get('data') or {}).get('values',[]) if isinstance((r.j or {}).get('data'),dict) else ((r.j or {}).get('data') or []):
            if row.get('error') or row.get('raw') is None: u+=1
            elif row['raw']==TRUE[row['param']]: g+=1
            else: b+=1; print('   WRONG',row['param'],row['raw'],TRUE[row['param']])
        wrong+=b; tot+=g; unk+=u
        print('%-30s #%d rc=%s t=%.1f good=%d wrong=%d unknown=%d%s'%(name,k,r.rc,r.t,g,b,u,' HUNG' if r.hung else '')); sys.stdout.flush(); d.stop()
os.environ['ACU']='acu2.py'
trial('dup 30ms',dict(dup=0.03)); trial('dup rnd 500ms',dict(dup=0.5,dup_rnd=1)); trial('dup every 2 100ms',dict(dup=0.1,dup_every=2))
trial('late every 2 +600',dict(late_every=2,late_by=0.6)); trial('late every 3 +550',dict(late_every=3,late_by=0.55)); trial('late every 2 +1s',dict(late_every=2,late_by=1.0)); trial('late every 2 +2.5s',dict(late_every=2,late_by=2.5)); trial('late rnd retries0',dict(late_every=2,late_by=0.52),['--retries','0']); trial('late short timeout',dict(delay=0.06,delay_rnd=0.1),['--timeout','100ms'])
print('good',tot,'wrong',wrong,'unknown',unk)
