# finding: undo says done (0) although the EEPROM keeps the new value (drive that shows in 0-4 what is in force)
import sys,subprocess,json,os
from drive import *
A=os.environ['ANTRIEB']
os.makedirs(os.environ['WD']+'/r1',exist_ok=True); os.chdir(os.environ['WD']+'/r1')
for f in os.listdir('.'): os.unlink(f)
open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"601" = 42\n"372@2" = 1450\n')
d=Drive(1,sys.argv[1] if len(sys.argv)>1 else 'in-force'); st={}
def hook(b,d,t,w):
    a=t[2]<<8|t[3]
    if w and a==0x2174: st['back']=1; return ('exc',4)       # the write of 372@2 is refused: everything goes back
    if st.get('back') and not st.get('undo') and t[1]==3 and a==601: return ('lost',)   # the answers to "read P.601@0" are lost
b=Bus([d],'/tmp/n23_r1',hook); b.start()
def run(*c):
    r=subprocess.run([A,'-p','/tmp/n23_r1','-b','115200','-a','1','--no-config',*c],capture_output=True,text=True,stdin=subprocess.DEVNULL)
    print('$ antrieb',*c,'-> exit',r.returncode); print(r.stdout); print('\n'.join(r.stderr.split('\n')[-8:])); return r
run('dataset','load','f.toml','--yes')
print('EEPROM P.601',[d.ee[601,i] for i in(1,2,3,4)],'RAM',[d.ram[601,i] for i in (1,2,3,4)])
st['undo']=1
run('dataset','undo','f.undo.toml','--yes'); 
print('EEPROM P.601',[d.ee[601,i] for i in(1,2,3,4)],'RAM',[d.ram[601,i] for i in (1,2,3,4)])
d.power(); print('after power off and on: works with P.601 =',d.ram[601,1])
print('\n'.join(x for x in b.dump if '601' in x and 'write' in x))
