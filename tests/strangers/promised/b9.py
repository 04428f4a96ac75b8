"""what is promised (effective) against what the shaft does"""
from nov import *
import re
def one(seed):
    r=random.Random(seed)
    o='--family %s --set 434=%d --set 418=%d --set 419=%d --internal %g --left %g --set 420=4000 --set 421=4000 --set 422=4000 --set 423=4000 --read-back %s '%(r.choice(['act','acu']),r.choice([1,2,3]),r.choice([0,350,600]),r.choice([5000,800,1200]),r.choice([0,5,-5,12,-12]),r.choice([0,0,7,-7]),r.choice(['eeprom','force']))
    if r.random()<.3: o+='--set 434@2=%d --set 418@2=%d --set 419@2=%d --contact-set 2 '%(r.choice([1,2,3]),r.choice([0,350]),r.choice([5000,900]))
    sp=r.choice(['10Hz','-10Hz','1Hz','-1Hz','5Hz','-5Hz','3,5Hz','0.00Hz'])
    a=['-a','1','sollwert','--enable','--hold','--duration','500ms','--until','reached','--yes','--json']
    if r.random()<.5: a+=['--source',r.choice(['line','sum'])]
    a+=['--',sp]
    d=Cube(o); c=run([d],a,quiet=True,maxt=40)
    try: j=json.loads(c.out)
    except Exception: print('NOJSON',seed,c.rc,c.err[-300:]); return
    sp_=(j['data'] or {}).get('setpoint') or {}
    en=[h[1][0][1] for h in c.hist if h[1][0][0]=='enabled']
    # steady speed: the most frequent one while enabled
    st=max(set(en),key=en.count) if en else None
    ext=(min(en),max(en)) if en else None
    told=re.findall(r'runs at (-?[0-9.]+) Hz|\(makes (-?[0-9.]+) Hz\)',c.err)
    eff=sp_.get('effective')
    bad=''
    if en and eff is not None and sp_.get('reached') and abs((sp_.get('actual') or 0)-eff)>.6: bad+=' EFF!=ACT'
    if en and eff is not None and max(abs(ext[0]),abs(ext[1]))>abs(eff)+1.0: bad+=' PEAK'
    if en and eff is not None and eff>0 and ext[0]<-.3 or en and eff is not None and eff<0 and ext[1]>.3: bad+=' REVERSED'
    if en and eff is None: bad+=' noeff'
    print('%s seed %d rc %s asked %s eff %s reached %s actual %s shaft %s | told %s | %s %s'%('BAD'+bad if bad else 'ok',seed,c.rc,sp,eff,sp_.get('reached'),sp_.get('actual'),ext,told,o,' '.join(a[3:])),flush=True)
    if c.rc not in(0,) : print('      err:',(j['error'] or {}).get('message'))
for s in range(int(sys.argv[1]),int(sys.argv[2])): one(s)
