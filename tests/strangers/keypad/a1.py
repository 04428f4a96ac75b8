from k import *
# 1 basics: view, see what it looks like
with act() as d:
    t=T(d,VIEW+['--duration','8s']); t.enabled(); time.sleep(2)
    t.key('\x1b[A'); time.sleep(.5); t.key('\x1b[A'); time.sleep(.5); t.key('\x1b[B');time.sleep(.5)
    print(d.look(), d.drive.writes[-6:]); open('a1.raw','wb').write(t.buf)
    t.key(' '); time.sleep(1.5); print('after space',d.look(),t.term()); n=len(t.buf)
    t.key('\x1b[A'); time.sleep(.5); t.key(' '); time.sleep(1); print('after arrows',d.look()); open('a2.raw','wb').write(t.buf)
    t.key('q'); t.wait(20); report('basic',t,d)
    print(writes484(d)); t.kill()
