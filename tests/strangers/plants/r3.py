# "back, as before" although the EEPROM keeps the new value: a drive that shows what is in force, and whose RAM does not (or no longer) hold it
import sys,subprocess,json,os
from drive import *
A=os.environ['ANTRIEB']
os.makedirs(os.environ['WD']+'/r3',exist_ok=True); os.chdir(os.environ['WD']+'/r3')
for how in ('notinforce','plc'):
  for reading in ('in-force','eeprom','refused'):
    for f in os.listdir('.'): os.unlink(f)
    open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"601" = 12\n"480@2" = "7.5"\n')
    d=Drive(1,reading); 
    if how=='notinforce': d.wmode=lambda n,k,ds:'notinforce' if n==480 and ds<5 else None
    def hook(b,d,t,w):
        # a PLC writes fixed frequency 1 of set 2 cyclically into the RAM (over another bus): 5.00 Hz, as before
        if how=='plc': d.ram[480,2]=500
    b=Bus([d],'/tmp/n23_r3',hook); b.start()
    def run(*c):
        r=subprocess.run([A,'-p','/tmp/n23_r3','-b','115200','-a','1','--no-config',*c],capture_output=True,text=True,stdin=subprocess.DEVNULL)
        print('$ antrieb',*c,'-> exit',r.returncode); print('   ',[l for l in r.stdout.split('\n') if 'result ' in l or ' 480 ' in l]); print('   ','\n    '.join(l for l in r.stderr.split('\n') if l.startswith(('err','hint','warning: P')))); return r
    print('==',how,reading)
    run('dataset','load','f.toml','--yes')
    print('    EEPROM 480@2',d.ee[480,2],'RAM',d.ram[480,2],' (before: 500, 500)')
    if os.path.exists('f.undo.toml'): run('dataset','undo','f.undo.toml','--yes')
    d.power(); print('    after power off/on: 480@2 =',d.ram[480,2])
    b.stop=True; b.join()
