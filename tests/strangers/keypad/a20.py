from k import *
U='\x1b[A'
with act() as d:
    t=T(d,['-a','1','sollwert','--ramp','5Hz:20Hz:3s','--source','line','--enable','--hold','--yes','--view','--step','1Hz','--max','40Hz','--duration','9s']); t.enabled(); time.sleep(1)
    n=len(t.buf); 
    for i in range(5): t.key(U); time.sleep(.1)
    time.sleep(.5); 
    print('in ramp:',d.look()[1], re.sub(rb'\x1b\[[0-9;?]*[a-zA-Z]',b' ',t.buf[n:]).decode()[-500:]); time.sleep(3); print('after ramp',d.look()[1]); t.key(U); time.sleep(.7); print('arrow after the ramp',d.look()[1]); t.key('q'); t.wait(8); print([v for _,n,s,v in d.drive.writes if n==484]); t.kill()
with act('--internal -10 --set 434=3') as d:
    t=T(d,['-a','1','sollwert','5Hz','--enable','--hold','--yes','--view','--step','5Hz','--max','20Hz','--duration','6s']); t.enabled(); time.sleep(1.5); print('before',d.look()[1])
    for i in range(3): t.key(U); time.sleep(.4)
    time.sleep(.5); print('after 3 up',d.look()[1]); t.key('q'); t.wait(8); i=t.buf.find(b'\x1b[?1049h'); print(t.buf[:i].decode(),t.tail(500)); t.kill()
