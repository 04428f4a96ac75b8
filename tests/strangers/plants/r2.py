# one exception N (transient) to one read of the second reading
import sys,subprocess,json,os
from drive import *
A=os.environ['ANTRIEB']
os.makedirs(os.environ['WD']+'/r2',exist_ok=True); os.chdir(os.environ['WD']+'/r2')
for f in os.listdir('.'): os.unlink(f)
open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"372@2" = 1450\n')
for exc in (6,5,4,2,1,3):
  for which in (0x2174,0x7174):
   for nth in (1,2,3,4):
    d=Drive(1); st={'c':0}
    def hook(b,d,t,w):
        a=t[2]<<8|t[3]
        if t[1]==3 and a==which:
            st['c']+=1
            if st['c']==nth: return ('exc',exc)
    b=Bus([d],'/tmp/n23_r2',hook); b.start()
    r=subprocess.run([A,'-p','/tmp/n23_r2','-b','115200','-a','1','--no-config','dataset','load','f.toml','--yes'],capture_output=True,text=True,stdin=subprocess.DEVNULL)
    b.stop=True; b.join()
    e=[l for l in r.stderr.split('\n') if l.startswith(('error','hint','warning: P'))]
    print('exc',exc,'at read',nth,'of','EEPROM 372@2' if which==0x2174 else 'RAM 372@7','-> exit',r.returncode,'| ee',d.ee[372,2],'ram',d.ram[372,2],'|',' / '.join(e)[:330])
    if 'f.undo.toml' in os.listdir('.'): os.unlink('f.undo.toml')
