from mat import *
from t3 import ask
from t6 import plant,two,P
def term_undo(tag,at,ans=b'y\n',pre=None):
    d=Drv(); r=load(d); b=d.snap(); d.reset()
    r=ask(d,['dataset','undo',W+'/m.undo.toml'],ans,lambda:at(d)); print('### undo on terminal:',tag,'rc',r.rc,'480',d.ee[480],d.ram[480],'419',d.ee[419],'wr',d.wr,'runw',d.runw); print('   ',r.o[-500:].replace('\n','\n    ')); sys.stdout.flush(); d.stop=True
term_undo('480@2 set to 7.77 while asked',lambda d:d.set(480,2,777))
term_undo('419@3 set to 43.21 while asked',lambda d:d.set(419,3,4321))
term_undo('480@2 set to the old value while asked',lambda d:d.set(480,2,500))
term_undo('drive starts while asked',lambda d:setattr(d,'run',True))
# save faults
for kind in('int','term','kill','change','other'):
    d=Drv(); st={}
    def h(k,f,d=d,kind=kind):
        if k==60:
            if kind in('int','term','kill'): d.proc.send_signal({'int':2,'term':15,'kill':9}[kind])
            else: d.proc.send_signal(2)
    d.hook=h; s=W+'/s.toml'
    for f in os.listdir(W):
        if f.startswith(('s.toml','.s.')): os.remove(W+'/'+f)
    r=run(d,'dataset','save',s,json_=False); ls=[f for f in os.listdir(W) if 's.toml' in f]; print('### save',kind,'rc',r.rc,ls,r.e[-250:].replace('\n',' | '))
    d.hook=None
    if kind=='change': d.set(372,2,1111)
    if kind=='other': d.stop=True; d=Drv(addr=5)
    r=run(d,'dataset','save','--resume',s,json_=False); print('    resume rc',r.rc,[f for f in os.listdir(W) if 's.toml' in f],(r.o[:200]+r.e[-250:]).replace('\n',' | '))
    if r.rc==0:
        r=run(d,'dataset','check',s,json_=False); print('    check',r.rc,(r.o[-250:]).replace('\n',' | '),r.e[-200:])
    d.stop=True
# german: look for English words
import itertools
EN=re.compile(r"\b(the|is|are|was|were|not|drive|drives|value|values|expected|file|files|written|nothing|may|with|which|it|of|an?d|reads|refused|address|no|reply|unknown|invalid|missing|found|cannot|error|hint|warning|note|take|back|interrupted|string|type|field|key)\b",re.I)
def de(tag,d,*a,**k):
    r=run(d,'--lang','de',*a,json_=False,**k); t=r.o+r.e
    bad=[l for l in t.splitlines() if len(EN.findall(re.sub(r'/\S+|`[^`]*`','',l)))>=2]
    print('DE %-28s rc=%s %s'%(tag,r.rc,bad[:3] if bad else 'ok')); sys.stdout.flush(); return r
d=Drv(); clean(); de('load',d,'dataset','load',W+'/m.toml','--yes'); d.set(480,2,777); r=de('undo changed',d,'dataset','undo',W+'/m.undo.toml','--yes'); print(r.e[-500:])
d=Drv(); d.eefail=lambda p,ds:p==412; clean(); r=de('load refused',d,'dataset','load',W+'/m.toml','--yes'); print(r.e[-400:])
d=Drv(); d.eefail=lambda p,ds:d.nw>3; clean(); r=de('load torn',d,'dataset','load',W+'/m.toml','--yes'); print(r.e[-700:])
d=Drv(); d.ramkeep=lambda p,ds:p==480; clean(); r=de('load stored only',d,'dataset','load',W+'/m.toml','--yes'); print(r.o[:300],r.e[-500:])
d=Drv(); de('save',d,'dataset','save',W+'/q.toml'); de('save again',d,'dataset','save',W+'/q.toml'); d.set(480,2,777); de('check',d,'dataset','check',W+'/q.toml'); de('diff',d,'dataset','diff',W+'/q.toml','drive'); de('diff factory',d,'dataset','diff','factory','drive')
d.run=True; de('running',d,'dataset','load',W+'/m.toml','--yes'); de('undo wrong file',d,'dataset','undo',W+'/m.toml','--yes'); de('nofile',d,'dataset','load',W+'/nix.toml','--yes'); de('slip verb',d,'dataset','laod',W+'/m.toml'); de('slip opt',d,'dataset','load',W+'/m.toml','--ja'); de('sets 7',d,'dataset','load',W+'/m.toml','--sets','7','--yes'); de('only slip',d,'dataset','load',W+'/m.toml','--only','moter','--yes'); de('no yes',d,'dataset','load',W+'/m.toml')
for n,x in(('toml bad','antrieb = 1\n[drive\n'),('unknown key','antrieb = 1\n[drive]\nfamily="act"\nfoo=1\n'),('wrong type','antrieb = "1"\n'),('bool','antrieb = 1\n[drive]\nfamily="act"\n[values]\n"372"=true\n'),('dup','antrieb = 1\n[drive]\nfamily="act"\n[values]\n"372"="1"\n"372"="2"\n'),('range','antrieb = 1\n[drive]\nfamily="act"\n[values]\n"372"="99999"\n'),('fam','antrieb = 1\n[drive]\nfamily="xyz"\n')):
    open(W+'/e.toml','w').write(x); de('file '+n,d,'dataset','load',W+'/e.toml','--yes')
d.off=True; de('silent',d,'dataset','load',W+'/m.toml','--yes')
a,b=two(); plant(a); b.run=True
def dp(tag,*x): r=run(a,'--lang','de',*x,cwd=P,port=False,json_=False); t=r.o+r.e; bad=[l for l in t.splitlines() if len(EN.findall(re.sub(r'/\S+|`[^`]*`','',l)))>=2]; print('DE plant %-20s rc=%s %s'%(tag,r.rc,bad[:3] or 'ok'))
dp('plan','plan'); dp('apply','apply','--yes'); dp('check','check'); dp('init','init'); 
open(P+'/antrieb.toml','a').write('[drives.x]\nadresse=1\n'); dp('bad key','plan')
