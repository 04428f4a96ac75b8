from mat import *
hit=0
fr=lambda h: (lambda b:b+crc(b))(bytes.fromhex(h))
def go(tag,k,pay,verb,gap=0.0):
    global hit
    clean(); d=Drive(ram='cells',delay=0.008); b=d.snap()
    r=run(['dataset','load','m.toml','--yes'],d); L=d.snap()
    if verb=='load': clean(); d.P=table()
    d.clr()
    def h(d,n,bb):
        if n==k: os.write(d.m,fr(pay)); time.sleep(gap)
    d.hook=h
    tr=W+'/trx'; 
    if os.path.exists(tr): os.remove(tr)
    r2=run(['dataset','undo','m.undo.toml','--yes','--trace',tr] if verb=='undo' else ['dataset','load','m.toml','--yes','--trace',tr],d); pl=r2.j['data']['eeprom_writes'] if r2.j and r2.j.get('data') else None
    tot=sum(d.cnt().values()); eq=[w[:4] for w in d.wlog if w[4]]
    ok=(d.snap()==b) if verb=='undo' else (d.snap()==L)
    print(tag,verb,k,'rc',r2.rc,'n',d.n,'plan',pl,'written',tot,'eq',eq,'ok',ok,((r2.j or {}).get('data')or{}).get('ended'),(r2.j['error'] or {}).get('message') if r2.j else r2.err[-100:]); sys.stdout.flush()
    if eq and not hit: hit=1; os.rename(tr,'dup9.txt')
    d.stop()
for verb,k,g in (('undo',15,0),('load',18,0),('undo',5,0),('undo',15,0),('load',5,0),('undo',16,0)): go('counting drive, stale gap %s'%g,k,'0164fffffb1e',verb,g)