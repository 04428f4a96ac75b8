# somebody changes ONE data set of a value that load wrote as set 0 (four sets, no source says so): undo cannot take the other three back, --force neither
import sys,subprocess,json,os
from drive import *
exec(open('r5.py').read().split("print('=== RAM")[0].split('from drive import *')[1].replace('r5','r6'))
for reading in ('eeprom','refused'):
    print('=====',reading)
    for f in os.listdir('.'): os.unlink(f)
    open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"518" = "1,5"\n')
    d=Drive(1,reading); b=Bus([d],'/tmp/n23_r6'); b.start()
    run('dataset','load','f.toml','--yes',n=8)
    d.ee[518,4]=d.ram[518,4]=777
    run('dataset','undo','f.undo.toml','--yes'); print([d.ee[518,i] for i in(1,2,3,4)])
    run('dataset','undo','f.undo.toml','--yes','--force'); print([d.ee[518,i] for i in(1,2,3,4)])
    run('dataset','check','f.undo.toml')
    run('dataset','load','f.toml','--yes',n=30); print([d.ee[518,i] for i in(1,2,3,4)])
    b.stop=True; b.join()
