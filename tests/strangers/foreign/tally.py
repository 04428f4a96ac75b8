import re,collections,glob
n=collections.Counter();w=collections.Counter();v=collections.Counter();ok=collections.Counter();rc=collections.Counter();st=collections.Counter(); cp=collections.Counter()
for f in ['cpya.log','cpyb.log','cpye.log','cpyl.log','cpyd.log']:
    try: L=open('out/'+f)
    except Exception: continue
    for l in L:
        m=re.match(r'(\d+) (\S+) +(\S+) +(\S+) +(\S+) .*cop (\d+) tel (\d+) rc (\S+) took (\S+) ok (\d+) err (\d+) (\[.*?\]) stale (\d+) ?(.*)',l)
        if not m: continue
        k=(m[5]); n[k]+=1; ok[k]+=int(m[10]); rc[k,m[8]]+=1; st[k]+=int(m[13]); cp[k]+=int(m[6])
        if 'WRONG' in l: w[k]+=1; v[k]+=l.split('WRONG')[1].count('(')
for k in n: print(k,'runs',n[k],'copies',cp[k],'values',ok[k],'wrong runs',w[k],'wrong values',v[k],'stale',st[k],{r:c for (q,r),c in rc.items() if q==k})
