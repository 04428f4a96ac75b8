def tele(R,a=0,b=999,addr=None):
    for l in R.log:
        if a<=l[0]<=b and (addr is None or (l[2][:2] and l[2][:2]=='%02x'%addr)): print('    %.3f %s %s'%l)
