from mat import *
KIND=sys.argv[1].split(','); K=range(int(sys.argv[2]),int(sys.argv[3])+1); ARGS=sys.argv[4].split() if len(sys.argv)>4 else []
RAMR=os.environ.get('RAMR','cells')
mem=('ram',) if '--ram' in ARGS else ('ee','ram')
ARGS+=['--timeout','150ms']
def at(k,act): return lambda d,n,b: act if n==k else None
def sig(k,*sigs):
    def h(d,n,b):
        if n==k:
            for i,s in enumerate(sigs):
                if i: time.sleep(0.05)
                try: os.kill(CUR[0].pid,s)
                except OSError: pass
            time.sleep(0.03)
    return h
def sig2(k,gap,s):
    def h(d,n,b):
        if n in(k,k+gap):
            try: os.kill(CUR[0].pid,s)
            except OSError: pass
            time.sleep(0.03)
    return h
def wr(k,act):
    st={'c':0}
    def h(d,n,b):
        if b[1] in(6,101):
            st['c']+=1
            if st['c']==k: return act
    return h
def wrp(k,act):  # persist for that parameter
    st={'c':0,'a':None}
    def h(d,n,b):
        if b[1] in(6,101):
            st['c']+=1
            if st['c']==k: st['a']=b[2:4]
            if b[2:4]==st['a']: return act
    return h
def rdfail(k,act):  # persistent refusing reading from telegram k on of that param
    st={'a':None}
    def h(d,n,b):
        if n==k: st['a']=b[2:4]
        if n>=k and b[1] in(3,100) and b[2:4]==st['a']: return act
    return h
H=dict(drop=lambda k:at(k,'drop'),lost=lambda k:at(k,'lost'),exc=lambda k:at(k,('exc',4,6)),late=lambda k:at(k,('late',0.22)),late2=lambda k:at(k,('late',0.5)),garble=lambda k:at(k,'garble'),
 power=lambda k:at(k,('power',0.4)),powera=lambda k:at(k,('powerafter',0.4)),powerl=lambda k:at(k,('powerafter',3.0)),kill=lambda k:sig(k,signal.SIGKILL),int=lambda k:sig(k,signal.SIGINT),intint=lambda k:sig(k,signal.SIGINT,signal.SIGINT),
 int2=lambda k:sig2(k,3,signal.SIGINT),term=lambda k:sig(k,signal.SIGTERM),termint=lambda k:sig2(k,2,signal.SIGTERM),hupsig=lambda k:sig(k,signal.SIGHUP),dead=lambda k:at(k,'dead'),deada=lambda k:at(k,'deadafter'),hup=lambda k:at(k,'hup'),
 wref=lambda k:wr(k,('exc',4,6)),wrefp=lambda k:wrp(k,('exc',4,6)),wrange=lambda k:wrp(k,('exc',4,1)),wrun=lambda k:wrp(k,('exc',4,8)),rdref=lambda k:rdfail(k,('exc',4,5)),stop=lambda k:sig(k,signal.SIGTSTP))
tot=bad=0
for kind in KIND:
    for k in K:
        r,p,d=one('%s %d'%(kind,k),H[kind](k),ram=RAMR,args=ARGS,quiet=True,mem=mem,eeonly=kind in('hup',))
        tot+=1; bad+=bool(p)
print(KIND,ARGS,RAMR,'total',tot,'bad',bad,STAT)
