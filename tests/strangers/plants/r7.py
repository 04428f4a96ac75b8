# save of a 32-bit parameter whose width and number of data sets no source tells, with different data sets
import sys,subprocess,json,os
from drive import *
exec(open('r5.py').read().split("print('=== RAM")[0].split('from drive import *')[1].replace('r5','r7'))
d=Drive(1); 
for n in (518,519,604,601,418,419,424,425,560): 
    if (n,4) in d.ee: d.ee[n,4]=d.ram[n,4]=777
b=Bus([d],'/tmp/n23_r7'); b.start()
run('dataset','save','s.toml',n=20)
print([l.strip() for l in open('s.toml') if l.startswith(('"518','"519','"604','"601','"418','"419','"424','"425'))])
print([l.strip() for l in open('s.toml') if l.startswith(('refused','complete','unanswered'))])
print('\n'.join(x for i,x in enumerate(b.dump) if 'P.518' in x or (i and 'P.518' in b.dump[i-1])  or (i>2 and 'P.518' in b.dump[i-3] and 'P.11' in b.dump[i-1]) or (i>1 and 'P.518' in b.dump[i-2]) ))
run('read','518@1','518@4','518'); run('dataset','show','518')
run('dataset','check','s.toml',n=9)
