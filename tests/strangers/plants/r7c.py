# same with a drive that refuses a wrong width by exception 2 (manual 6.6), and plan/apply
exec(open('r7.py').read().split("b=Bus(")[0].replace('r7','r7c'))
o=d.handle
def h(t):
    r=o(t)
    if len(r)==3 and r[1]&0x80 and d.p11==14: r=bytes([r[0],r[1],2])
    return r
d.handle=h
b=Bus([d],'/tmp/n23_r7c'); b.start()
run('dataset','save','s.toml',n=6); print([l.strip() for l in open('s.toml') if l.startswith(('"518','"519','"604'))])
print('\n'.join(x for i,x in enumerate(b.dump) if 'P.518' in x or (i and 'P.518' in b.dump[i-1])))
open('f.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"518@4" = "7,77"\n')
run('dataset','load','f.toml','--yes',n=12)
open('g.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"518" = "2"\n')
run('dataset','load','g.toml','--yes',n=12); run('write','518@4=3','--yes',n=9)
