src=open('g10.py').read(); exec(src[:src.index("for nm,k in (('y'")])
def ttyd(d,delay,fn,args=['dataset','load','m.toml']):
    m,sl=pty.openpty(); p=subprocess.Popen([BIN,'-p',d.tty,'-a','1','-b','115200',*args],cwd=W,env=ENV,stdin=sl,stdout=sl,stderr=sl,start_new_session=True,preexec_fn=lambda:__import__('fcntl').ioctl(0,0x540E,0)); os.close(sl); CUR[0]=p
    out=b''; sent=False
    while True:
        r,_,_=select.select([m],[],[],0.5)
        if r:
            try: x=os.read(m,4096)
            except OSError: break
            out+=x
        elif not sent and b'[y/N]' in out: sent=True; fn(); time.sleep(delay); os.write(m,b'y\n')
    rc=p.wait(20); os.close(m); return rc,out.decode(errors='replace')
clean(); d=Drive(); rc,o=ttyd(d,1,lambda: d.set(480,2,777)); print('changed at the question rc',rc,d.P[480]['ee'],o.split('[y/N]')[1][:700].replace('\r\n',' / ')); print([l for l in open(W+'/m.undo.toml') if '480' in l]); d.stop()
clean(); d=Drive(); d.hook=lambda d,n,b:('exc',4,6) if b[1]==6 and b[2:4]==bytes.fromhex('419c') and b[5]==2 else None
rc,o=ttyd(d,1,lambda: d.set(480,2,777)); print('changed at the question + refused 412: rc',rc,d.P[480]['ee'],o.split('[y/N]')[1][:900].replace('\r\n',' / ')); d.stop()
clean(); d=Drive(); rc,o=ttyd(d,1,lambda: d.set(480,2,-1250)); print('made equal at the question rc',rc,d.cnt().get((480,1)),[w for w in d.wlog if w[4]]); d.stop()
# another drive put in place while question
clean(); d=Drive(); rc,o=ttyd(d,1,lambda: setattr(d,'run',True)); print('started at question rc',rc,d.nw,o[-250:].replace('\r\n',' / ')); d.stop()
# sim bench
for fam,a in (('acu','1'),('x','2')):
    r=run(['dataset','save','sim%s.toml'%a,'--force'],'sim',baud=None,addr=a); print('sim save',a,r.rc,r.err[-200:], (r.j or {}).get('data') and [(x['drive'],len(x['values'])) for x in r.j['data']['saved']])
