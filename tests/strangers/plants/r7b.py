# save --discover: unknown numbers (ramps 420-423, 32 bit, four sets), sets differ; 16-bit ones beside them (466)
import sys,subprocess,json,os
import drive
from drive import *
for n in (420,421,422,423): p(n,32,1,500,0,999999)
p(466,16,1,5,0,100); p(467,32,1,70000,0,999999)
exec(open('r5.py').read().split("print('=== RAM")[0].split('from drive import *')[1].replace('r5','r7b'))
d=Drive(1)
for n in (420,421,466,467): d.ee[n,3]=d.ram[n,3]=900 if n!=466 else 9
b=Bus([d],'/tmp/n23_r7b',delay=0.001); b.start()
run('--timeout','100ms','dataset','save','--discover','s.toml',n=6)
print([l.strip() for l in open('s.toml') if l.startswith(('"42','"46','42'))])
print([l.strip()[-600:] for l in open('s.toml') if l.startswith(('refused','complete','unanswered'))])
for n in (420,422,466):
    print('\n'.join(x for i,x in enumerate(b.dump) if 'P.%d@'%n in x or (i and 'P.%d@'%n in b.dump[i-1])  or (i>2 and 'P.%d@'%n in b.dump[i-3] and 'P.11' in b.dump[i-1]) ))
run('--timeout','100ms','dataset','check','s.toml',n=6)
