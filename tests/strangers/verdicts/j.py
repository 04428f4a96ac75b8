"""judge10's own bench on top of promised/nov.py. Each run takes a lock file so that one thing runs at a time."""
import sys,os,tempfile
S=os.path.dirname(os.path.dirname(os.path.abspath(__file__))); sys.dont_write_bytecode=True
sys.path.insert(0,S+'/promised'); os.environ.setdefault('ANTRIEB','antrieb')
from nov import *
import nov
LK=open(os.path.join(tempfile.gettempdir(),'antrieb-verdicts.lock'),'w')
_run=nov.run
def run(*a,**k):
    os.environ.get("LK") and fcntl.flock(LK,fcntl.LOCK_EX)
    try: return _run(*a,**k)
    finally: fcntl.flock(LK,fcntl.LOCK_UN); time.sleep(.05)
def setx(f):
    def setx(c): c.drives[0].d.advance(time.monotonic()); f(c.drives[0].d)
    return setx
def mute(on):
    def mute(c): c.mute=on; c.nohear=on
    return mute
def N(k,t=0):
    st={}
    def f(c,n):
        if c.n>=k and 't' not in st: st['t']=n
        return 't' in st and n>=st['t']+t
    return f
def key(t):
    def key(c):
        if c.tm is not None: os.write(c.tm,t)
    return key
Y=b'y/N]'
L=lambda x:(lambda c,f,r,now,d:[(x,r)])
def judge(c,d,stopverb=False,clean=False):
    bad=[]; lx=d.kind=='lxm'
    try: doc=json.loads(c.out)
    except Exception: doc=None; bad.append('NOJSON')
    text=c.out+c.err; est,esp=c.end[0]; lst,lsp=c.later[0]; unit=5 if lx else .2
    turning=abs(esp)>unit; powered=est in('enabled','quick stop')
    data=(doc or {}).get('data') or {}
    if 'drives' in data: data=data['drives'][0].get('motion') or {}
    may='MAY STILL TURN' in text or 'keeps running' in text.lower() or 'still turns' in text or 'turns on' in text or 'coasts' in text
    if c.hang: bad.append('HANG')
    if c.rc not in(0,1,2,3,4,5,6,7,8,9,130): bad.append('RC%s'%c.rc)
    if doc and (doc['ok']!=(c.rc==0)): bad.append('OK!=RC')
    if turning and powered and data.get('running') is False: bad.append('FALSE running no at %.1f in %s'%(esp,est))
    if turning and data.get('standing') is True: bad.append('FALSE standing at %.1f in %s'%(esp,est))
    if turning and not may and c.words: bad.append('TURNS %.1f in %s untold'%(esp,est))
    if est=='enabled' and abs(lsp)>unit: bad.append('LEFT TURNING %.1f %s'%(lsp,'told' if may else 'UNTOLD'))
    if est=='enabled' and data.get('running') is False: bad.append('FALSE running no, enabled')
    if lst=='enabled' and est!='enabled': bad.append('STARTED AGAIN')
    if not turning and est not in('enabled',) and data.get('running') is True: bad.append('FALSE running yes in '+est)
    if not turning and 'MAY STILL TURN' in text and clean: bad.append('ALARM in '+est)
    df={k:x for k,x in d.diff().items() if k not in('DCOMcontrol','DCOMopmode')}
    ng='NOT given back' in text or any(not x.get('restored',True) for x in data.get('changed',[]) if isinstance(x,dict))
    if df and not ng: bad.append('NOT BACK untold %s'%df)
    if df and ng and clean: bad.append('NOT BACK told %s'%df)
    if d.wear(): bad.append('EEPROM %s'%d.wear())
    if c.rc==0 and d.enabled is None and not stopverb: bad.append('rc0 never enabled')
    return bad,doc
def line(tag,c,bad,extra=''):
    e=[l for l in c.err.split('\n') if l.startswith(('error','note','hint'))]
    print('%s %s rc %s %.1fs end %s later %s %s %s | %s'%('BAD' if bad else 'ok ',tag,c.rc,c.dur,c.end[0],c.later[0],bad or '',extra,' / '.join(x[:130] for x in e[:2])),flush=True)
