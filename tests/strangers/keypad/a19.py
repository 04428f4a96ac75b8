from k import *
U=b'\x1b[A'
for i in range(2):
    with act() as d:
        t=T(d,VIEW+['--duration','8s']); t.enabled(); time.sleep(1.2); m=time.monotonic(); t.key(U*200+b' '); time.sleep(2); t.key('q'); t.wait(9)
        print('one write of 200 arrows and a space:',[(round(x-m,2),n,v) for x,n,s,v in d.drive.writes if x>m-.2],'max',maxout(d)[0]); t.kill()
