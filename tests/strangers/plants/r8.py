import sys,subprocess,json,os
from drive import *
exec(open('r5.py').read().split("print('=== RAM")[0].split('from drive import *')[1].replace('r5','r8'))
open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480@2" = "5"\n"481@1" = "10"\n')
d=Drive(1); d.ram[480,2]=4444
b=Bus([d],'/tmp/n23_r8'); b.start()
run('dataset','check','f.toml'); run('dataset','load','f.toml','--yes',n=9); print('eew',d.eew,'ramw',d.ramw,d.ram[480,2]); run('dataset','load','f.toml','--yes',n=9)
# drive that starts to run behind the question / runs before
d.running=True; open('g.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480@2" = "6"\n'); run('dataset','load','g.toml','--yes',n=9); print('eew',d.eew); run('dataset','load','g.toml','--yes','--force',n=9); print('eew',d.eew)
run('dataset','undo','f.undo.toml','--yes',n=6)
