# cln1.py [rtu|ascii|vabus|lx] : cln.py one at a time
# clean runs: values (cpy clean), and verbs
import sys
from mx import *
from vb import *
import h4s
def T(name,mk,a,prep=None,exp=0,sig=None,n=1,pr=None):
    d=mk(); 
    if prep: prep(d)
    if pr=='ascii': d.ascii=True
    ln=Line([d])
    a=(['--protocol',pr] if pr and pr!='rtu' else [])+a
    try: r=run(ln,['-a',str(d.adr)]+a,d,settle=.3,sig=sig)
    finally: ln.close()
    nq=sum(1 for x in ln.log if x[1]=='>')
    fl=''
    if r['rc']!=exp: fl+=' RC!'
    if abs(d.n)>1e-6: fl+=' TURNS'
    if 'warn' in r['err']: fl+=' WARN '+[x for x in r['err'].splitlines() if 'warn' in x][0][:100]
    return '%-44s rc %s took %.2f tel %d n %.1f max %.1f %s gaps %s%s'%(name,r['rc'],r['took'],nq,d.n,r['max'],d.st,[round(r['last']-s,2) for s in r['sent']] if r['last'] else '',fl),r,d
import tempfile
def jobs():
    J=[]
    for pr in sys.argv[1:] or('rtu','ascii','vabus','lx'):
        for act in ((False,) if pr!='lx' else (False,)):
            mk=(lambda: LXM(3)) if pr=='lx' else (lambda pr=pr,act=act:(VACU if pr=='vabus' else ACU)(1,act=act,set={418:0}))
            p=None if pr=='lx' else pr; nm=pr+('-act' if act else '')
            sp=['300rpm'] if pr=='lx' else ['5Hz','--take-control']
            prep=h4s.runsl if pr=='lx' else h4s.runsa
            def R(n,a,**k): J.append((nm+' '+n,mk,a,dict(k,pr=p)))
            R('identify',['identify'])
            R('save',['dataset','save',tempfile.mktemp(suffix='.toml')])
            R('run-ramp',['sollwert']+sp+['--enable','--hold','--duration','600ms'])
            R('run-qs',['sollwert']+sp+['--enable','--hold','--duration','600ms','--on-exit','quick-stop'])
            R('qs',['statemachine','quick-stop'],prep=prep)
            R('disable',['statemachine','disable'],prep=prep)
            R('dv',['statemachine','disable-voltage'],prep=prep)
            R('zero',['sollwert','0'],prep=prep)
            for s in (0.0,.3,1.0): R('int@%.1f'%s,['sollwert']+sp+['--enable','--hold','--duration','5s'],exp=130,sig=[(ev_after(lambda d,t: abs(d.n)>.5,s),signal.SIGINT)])
            R('int-during-stop',['sollwert']+sp+['--enable','--hold','--duration','800ms'],exp=130,sig=[(ev_after(lambda d,t: abs(d.n)>.5,.95),signal.SIGINT)])
            R('int x2',['sollwert']+sp+['--enable','--hold','--duration','5s'],exp=130,sig=[(ev_after(lambda d,t: abs(d.n)>.5,.5),signal.SIGINT),(ev_after(lambda d,t: abs(d.n)>.5,.1),signal.SIGINT)])
            R('term',['sollwert']+sp+['--enable','--hold','--duration','5s'],exp=130,sig=[(ev_after(lambda d,t: abs(d.n)>.5,.6),signal.SIGTERM)])
    return J
def do(j):
    try:
        l,r,d=T(j[0],j[1],j[2],**j[3]); open('out/cln-'+j[0].replace(' ','_')+'.txt','w').write(l+'\n'+r['out']+r['err']); return l
    except Exception as e:
        import traceback; return 'ERR %s %s'%(j[0],traceback.format_exc()[-200:])
if __name__=='__main__':
    with ThreadPoolExecutor(1) as ex:
        for x in ex.map(do,jobs()): print(x,flush=True)
