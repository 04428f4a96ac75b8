from h import *
def case(name,args,script=(),limit=25,size=16384):
    with act() as d:
        r,w=os.pipe(); fcntl.fcntl(w,1031,size)
        x=run(d,args,script,limit=limit,err=os.fdopen(w,'wb',0)); os.close(r); show(name,x)
        t=[k for k in d.log if k[1]=='<']; print('   last telegram to drive %.1f s after start; duration asked in args'%t[-1][0], t[-1][2].hex(' '))
case('-v, pipe 16K unread, duration 15s',['-v']+[a.replace('6s','15s') for a in RUN])
case('-v, pipe 16K unread, SIGTERM at 12 s',['-v']+[a.replace('6s','60s') for a in RUN],[(12,sig(signal.SIGTERM))])
case('-v, pipe 16K unread, SIGINT x3 from 12 s',['-v']+[a.replace('6s','60s') for a in RUN],[(12,sig(signal.SIGINT)),(13,sig(signal.SIGINT)),(14,sig(signal.SIGINT))])
case('-v, pipe 64K (default) unread, duration 60s, watchdog 2s',['-v']+[a.replace('6s','60s') for a in RUN]+['--watchdog','2s'],limit=75,size=65536)
