# save with a catalogue of one's own, Ctrl-C; resume without that catalogue: never complete, but exit 0
import sys,subprocess,json,os
from drive import *
A=os.environ['ANTRIEB']
os.makedirs(os.environ['WD']+'/r4',exist_ok=True); os.chdir(os.environ['WD']+'/r4')
for f in os.listdir('.'): os.unlink(f)
d=Drive(1); st={}
def hook(b,d,t,w):
    if st.get('at')==d.n: st['p'].send_signal(2)
b=Bus([d],'/tmp/n23_r4',hook); b.start()
def run(*c):
    p=st['p']=subprocess.Popen([A,'-p','/tmp/n23_r4','-b','115200','-a','1','--no-config',*c],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,stdin=subprocess.DEVNULL); o,e=p.communicate()
    print('$ antrieb',*c,'-> exit',p.returncode); print('\n'.join(l for l in (o+e).split('\n') if l.startswith(('file','complete','values','error','hint')) or 'not asked' in l)); print(sorted(os.listdir('.')))
open('cat.toml','w').write('schema = 1\nfamily = "active"\ndrives = []\nparams = [ { id = 508, slug = "own-508", en = "Own 508", de = "Eigen 508", decimals = 0, type = "uint", access = "rw", min = 0, max = 10 } ]\n')
st['at']=40; run('--catalogue','cat.toml','dataset','save','s.toml'); st['at']=None
run('dataset','save','s.toml','--resume'); run('dataset','save','s.toml','--resume'); run('dataset','check','s.toml.part'); run('--catalogue','cat.toml','dataset','save','s.toml','--resume')
