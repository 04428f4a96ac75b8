from k import *
import a2
a2.want=sys.argv[1:]
case=a2.case
SLOW="--set 421=200 --set 423=200 --set 425=400"
S=signal
def sg(*l):
    def f(t,d):
        for x in l:
            if isinstance(x,float): time.sleep(x)
            elif isinstance(x,(bytes,str)): t.key(x)
            else: t.sig(x)
    return f
if __name__=="__main__": case('paste start never ended, then space x3 then q then C-c', ['\x1b[200~',1,' ',1,' ',' ',.5,'q',2,'\x03'],dur='20s')
if __name__=="__main__": case('paste start split then 1 s arrows then space', ['\x1b[20',.02,'0~\x1b[A\x1b[A',1,' ',2,'q'],dur='20s')
if __name__=="__main__": case('esc [ then space (truncated sequence)', ['\x1b[',.01,' ',2,'q'],dur='15s')
if __name__=="__main__": case('esc [ 1 ; then space q', ['\x1b[1;',' ',1,' ',1,'q'],dur='15s')
if __name__=="__main__": case('OSC start never ended then space', ['\x1b]52;c;',.3,' ',1,' ',1,'q',1,'\x03'],dur='15s')
if __name__=="__main__": case('DCS start then space', ['\x1bP1$r',.3,' ',1,' ',1,'q',1,'\x03'],dur='15s')
if __name__=="__main__": case('ESC O then space', ['\x1bO',' ',1,'q'],dur='15s')
if __name__=="__main__": case('utf8 lead byte then space', [b'\xe2',' ',1,'q'],dur='15s')
if __name__=="__main__": case('utf8 4 lead then space q', [b'\xf0',' ',.5,'q',1,' '],dur='15s')
if __name__=="__main__": case('mouse x10 bytes: esc[M + " q"', ['\x1b[M',' ','q',' ',1,'q'],dur='15s')
if __name__=="__main__": case('NUL bytes and 0x80-ff', [bytes(range(128,256)),.5,b'\0\0',.5,'q'])
if __name__=="__main__": case('slow ramp space, space, space', [' ',1,' ',1,' ',1,'q'],opts=SLOW,dur='9s')
if __name__=="__main__": case('slow ramp space, arrows up, q', [' ',1,'\x1b[A',.2,'\x1b[A',1,'q'],opts=SLOW,dur='9s')
if __name__=="__main__": case('slow ramp q q q', ['q',1,'q',1,'q'],opts=SLOW,dur='9s')
if __name__=="__main__": case('slow ramp C-c x3', ['\x03',1,'\x03',1,'\x03'],opts=SLOW,dur='9s')
if __name__=="__main__": case('TERM TERM', sg(S.SIGTERM,S.SIGTERM),opts=SLOW)
if __name__=="__main__": case('INT 0.5 INT 0.5 INT', sg(S.SIGINT,.5,S.SIGINT,.5,S.SIGINT),opts=SLOW)
if __name__=="__main__": case('HUP only', sg(S.SIGHUP))
if __name__=="__main__": case('QUIT key', ['\x1c'])
if __name__=="__main__": case('SIGQUIT x2', sg(S.SIGQUIT,.3,S.SIGQUIT))
if __name__=="__main__": case('C-z key', ['\x1a',2,'q'])
if __name__=="__main__": case('TSTP TTOU TTIN', sg(S.SIGTSTP,.5,S.SIGTTOU,.5,S.SIGTTIN,.5,'q'))
if __name__=="__main__": case('STOP 2 s CONT', sg(S.SIGSTOP,2.,S.SIGCONT,1.,'q'))
if __name__=="__main__": case('C-s 3 s then q', ['\x13',3,'q'])
if __name__=="__main__": case('USR1', sg(S.SIGUSR1)); __name__=="__main__" and case('ALRM',sg(S.SIGALRM)); __name__=="__main__" and case('PIPE',sg(S.SIGPIPE,1.,'q'))
