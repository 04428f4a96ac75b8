import glob,re,sys
def shaft(fam,b):
    try:
        if fam=='lx': return b[1]==3 and int.from_bytes(b[2:4],'big') in(6916,7700,7696,7698,7690)
        if fam=='ascii': b=bytes.fromhex(b[1:-2].decode())
        if fam in('ascii','rtu'):
            return b[1] in(3,100) and (int.from_bytes(b[2:4],'big')&0xfff) in(411,210,217,241)
        return b[-1:]==b'\x05' and b[-4:-1] in(b'411',b'210',b'217',b'241')
    except Exception: return False
if __name__=="__main__":
    rows=[]
    for f in glob.glob('out/'+(sys.argv[1] if len(sys.argv)>1 else 'h4-*.txt')):
        s=open(f).read(); h=s.split('\n',1)[0]; m=re.match(r'(\d+) (\S+) +(\S+) +(\S+) +(\S+) +(\S+) +rc (\S+) +took (\S+) en (\S+) gap (\S+) n (\S+)',h)
        if not m: continue
        fam=m[2]; took=float(m[8]); log=[l.split(' ',2) for l in s.split('\nLOG\n')[1].split('\nHIST')[0].split('\n') if l]
        last=None
        for t,k,b in log:
            if k=='>' and shaft(fam,bytes.fromhex(b)) and float(t)<=took: last=float(t)
        if last is None: continue
        rows.append((took-last,h[:110]))
    rows.sort(reverse=True)
    for fam in('lx','rtu','ascii','vabus'):
        x=[r for r in rows if r[1].split()[1]==fam]
        print(fam,len(x),'blind>0.25 and rc 0:',sum(r[0]>.25 and ' rc 0' in r[1] for r in x))
    for r in rows[:int(sys.argv[2]) if len(sys.argv)>2 else 40]: print('%.2f'%r[0],r[1])
    