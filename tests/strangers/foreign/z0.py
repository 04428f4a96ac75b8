# z0.py COUNT WORKERS : `sollwert 0` to a running LXM05/ACU, another master enables/gives a speed once behind it; is exit 0 said while the shaft turns?
import sys
from h4b import *
def one(seed):
    R=random.Random(seed); L=R.random()<.5; d=LXM(3) if L else ACU(1,set={418:0}); (runsl if L else runsa)(d)
    w=R.uniform(.05,.9); S={}
    ev=ev_after(lambda d,t:len(d.wr)>0,w)
    def en(dd,t):
        S['en']=t
        if L: d.p[6938]=500; d.control(15,t)
        else: d.ram[484,0]=3000
        d.mark(t,'SP')
    d.events=[(ev,en)]
    ln=Line([d])
    try: r=run2(ln,['-a',str(d.adr),'sollwert','0'],d)
    finally: ln.close()
    gap=r['t1']-S['en'] if 'en' in S else None
    fl='FALSE0' if gap and gap>.1 and abs(r['nend'])>1e-6 and r['rc']==0 else ''
    return '%d %s w %.2f rc %s took %.2f gap %s n %.1f %s :: %s'%(seed,'lx' if L else 'ac',w,r['rc'],r['took'],gap and '%.2f'%gap,r['nend'],fl,' | '.join(x for x in r['out'].splitlines() if x[:4] in('setp','runn','note')))
if __name__=='__main__':
    with Pool(int(sys.argv[2])) as p:
        for x in p.imap_unordered(one,range(100,100+int(sys.argv[1]))): print(x,flush=True)
