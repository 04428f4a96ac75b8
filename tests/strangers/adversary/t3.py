from h import *
# stderr / stdout pipe that nobody reads
def full_pipe():
    r,w=os.pipe(); fcntl.fcntl(w,1031,4096)  # F_SETPIPE_SZ
    return r,w
def case(name,args,how,script=(),limit=20,fill=False):
    with act() as d:
        r,w=full_pipe()
        if fill:
            os.set_blocking(w,False)
            try:
                while True: os.write(w,b'x'*512)
            except BlockingIOError: pass
            os.set_blocking(w,True)
        kw={how:os.fdopen(w,'wb',0)}
        x=run(d,args,script,limit=limit,**kw); os.close(r); show(name,x)
case('-vv stderr unread, duration 3s',['-vv']+[a.replace('6s','3s') for a in RUN],'err')
case('-v stderr unread, duration 3s',['-v']+[a.replace('6s','3s') for a in RUN],'err')
case('-v stderr unread, TERM at 2',['-v']+RUN,'err',[(2,sig(signal.SIGTERM))])
case('stdout full pipe, 3s table',[a.replace('6s','3s') for a in RUN],'out',fill=True)
case('stdout full pipe, 3s json, TERM at 1',['--json']+[a.replace('6s','3s') for a in RUN],'out',[(1,sig(signal.SIGTERM))],fill=True)
