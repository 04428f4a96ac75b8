import sys,subprocess,json,os
from drive import *
A=os.environ['ANTRIEB']
os.makedirs(os.environ['WD']+'/r5',exist_ok=True); os.chdir(os.environ['WD']+'/r5')
for f in os.listdir('.'): os.unlink(f)
def run(*c,n=40):
    r=subprocess.run([A,'-p','/tmp/n23_r5','-b','115200','-a','1','--no-config',*c],capture_output=True,text=True,stdin=subprocess.DEVNULL)
    print('$ antrieb',*c,'-> exit',r.returncode); print('\n'.join((r.stdout+'--\n'+r.stderr).split('\n')[:n])); return r
print('=== RAM not shown, RAM differs already')
open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480@2" = "5"\n"481@1" = "7"\n')
d=Drive(1,'refused'); d.ram[480,2]=4444; b=Bus([d],'/tmp/n23_r5'); b.start()
run('dataset','load','f.toml','--yes'); print('RAM 480@2',d.ram[480,2]); run('dataset','check','f.toml'); run('dataset','load','f.toml','--ram','--yes')
b.stop=True; b.join()
print('=== 601 exists four times (nobody says so), the sets differ')
d=Drive(1); d.ee[601,2]=d.ram[601,2]=77; b=Bus([d],'/tmp/n23_r5'); b.start()
open('g.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"601" = 12\n')
run('dataset','load','g.toml','--yes'); print([d.ee[601,i] for i in(1,2,3,4)]); run('dataset','save','g.s.toml',n=20); print([l for l in open('g.s.toml') if '601' in l]) if os.path.exists('g.s.toml') else None
open('h.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"601@2" = 13\n'); run('dataset','load','h.toml','--yes'); print([d.ee[601,i] for i in(1,2,3,4)])
run('dataset','check','g.toml')
b.stop=True
