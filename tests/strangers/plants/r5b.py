import sys,subprocess,json,os
from drive import *
exec(open('r5.py').read().split("print('=== RAM")[0].split('from drive import *')[1])
open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480@2" = "5"\n"481@1" = "7"\n')
d=Drive(1,'refused'); d.ram[480,2]=4444
b=Bus([d],'/tmp/n23_r5'); b.start()
def j(*c):
    r=subprocess.run([A,'-p','/tmp/n23_r5','-b','115200','-a','1','--no-config','--json',*c],capture_output=True,text=True,stdin=subprocess.DEVNULL); J=json.loads(r.stdout)
    print(c,r.returncode,'warnings',[ (w['code'],w['message'][:150]) for w in J['warnings']],'ended',J['data'].get('ended'))
j('dataset','check','f.toml'); j('dataset','load','f.toml','--yes'); j('dataset','load','f.toml','--yes'); j('dataset','undo','f.undo.toml','--yes');j('dataset','undo','f.undo.toml','--yes'); print('RAM 480@2',d.ram[480,2],'481@1',d.ram[481,1])
