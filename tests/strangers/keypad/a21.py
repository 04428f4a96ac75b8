from k import *
U='\x1b[A'
with act('--internal -10 --set 434=3') as d:
    t=T(d,['-a','1','sollwert','5Hz','--enable','--hold','--yes','--view','--step','5Hz','--max','20Hz','--duration','6s']); t.enabled(); time.sleep(1.2); print('before',d.look()[1])
    for i in range(3): t.key(U); time.sleep(.4)
    time.sleep(.5); print('after 3 up',d.look()[1]); t.key('q'); t.wait(8); b=t.buf; print('alt at',b.find(b'\x1b[?1049h'),'question at',b.find(b'MOTION'),'raw seq near', b[max(0,b.find(b'internal setpoint')-200):b.find(b'MOTION')+60]); t.kill()
    i=subprocess.run([K,'-p',d.path,'--no-config']+['-a','1','sollwert','5Hz','--enable','--hold','--dry-run'],capture_output=True,text=True,env=env()); print(i.stdout[-300:],i.stderr[-500:])
