from bench import *
import re
t=open('w/a5.toml').read()
s=t.replace('"480" = "5.00 Hz"','"480" = "7.00 Hz"').replace('"481" = "0.00 Hz"','"481" = "3.00 Hz"')
for n in (482,483,485,486,487,488): s=re.sub(rf'"{n}" = "[-0-9.]+ Hz"',f'"{n}" = "{n-480}.50 Hz"',s)
open('w/l5.toml','w').write(s)
def st(b): return {k[0]:v for k,v in b.nodes[0].ee.items() if k[1]==1 and 480<=k[0]<=488}
if __name__=='__main__':
    b=Bench('t5')
    b.run('dataset','load','l5.toml','--yes')
    print(st(b),b.nodes[0].writes)
    b.run('dataset','check','l5.toml')
    os.system('ls w')
    b.run('dataset','undo',*[x for x in os.listdir('w') if 'undo' in x][:1],'--yes')
    print(st(b))
    # refusal mid-load with odd code
    for code in (1,5,12,15,20,21,77,255,8):
        for f in os.listdir('w'):
            if 'undo' in f: os.remove('w/'+f)
        b=Bench(f't5-{code}',nodes=[{'refuse':lambda n,ds,raw,s,c=code: c if n==485 else None}])
        r=b.run('dataset','load','l5.toml','--yes',show=code in(1,77,8))
        print(code,r[0],r[3],r[2][-400:] if code not in (1,77,8) else '',st(b)); 
        print([x for x in os.listdir('w') if 'undo' in x])
        b.close()
