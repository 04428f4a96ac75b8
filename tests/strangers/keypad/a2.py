from k import *
want=sys.argv[1:]
def case(name,keys,dur='6s',after=1.0,base=VIEW,size=(24,80),wait=25,opts="",shw=True):
    if want and not any(w in name for w in want): return
    with act(opts) as d:
        t=T(d,base+['--duration',dur],size=size); ok=t.enabled(); time.sleep(after)
        if callable(keys): keys(t,d)
        else:
            for k in keys:
                if isinstance(k,(int,float)): time.sleep(k)
                else: t.key(k)
        done=t.wait(wait)
        report(name+('' if done else ' HANG'),t,d,1.0,shw)
        print('   setpoints',[v for _,n,s,v in d.drive.writes if n==484][-12:], 'words',[v for _,n,s,v in d.drive.writes if n==410], d.drive.first_enabled and round(d.samples[-1][0]-d.drive.first_enabled,1))
        t.kill()
if __name__=='__main__':
    case('paste with arrows and letters', ['\x1b[200~hello \x1b[A\x1b[A\x1b[A q d\x1b[201~',2,'q'])
    case('raw paste unbracketed arrows (100x up)', ['\x1b[A'*100,3,'q'])
    case('unbracketed text paste "abcdefg question"', ['abc def question',3,'q'])
    case('flood up 3000', ['\x1b[A'*3000,1,'q'])
    case('flood up then space', ['\x1b[A'*3000,' ',3,'q'])
    case('below min: 100x down singly', [x for i in range(60) for x in ('\x1b[B',.04)]+[1,'q'])
    case('split esc [ A', ['\x1b',.03,'[',.03,'A',1,'\x1b',.3,'[A',1,'q'])
    case('split esc [ A 0.3 each', ['\x1b',.3,'[',.3,'A',1,'q'])
    case('SS3 arrows', ['\x1bOA',.3,'\x1bOA',1,'q'])
    case('mod arrows shift ctrl, left right pgup', ['\x1b[1;5A',.3,'\x1b[1;2A',.3,'\x1b[D',.3,'\x1b[C',.3,'\x1b[5~',.3,'\x1b[6~',1,'q'])
    case('d then space', ['d',.2,' ',3,'q'])
    case('d d d q', ['d','d','d','q'])
    case('space space (two quick stops)', ['  ',3,'q'])
    case('space x20', [' '*20,3,'q'])
    case('q q', ['qq'])
    case('Ctrl-C Ctrl-C', ['\x03\x03'])
    case('Ctrl-C x5 over 0.5 s', ['\x03',.1,'\x03',.1,'\x03',.1,'\x03',.1,'\x03'])
    case('esc alone', ['\x1b',3,'q'])
    case('Ctrl-D', ['\x04',2,'q'])
    case('uppercase Q / German', ['Q',2,'q'])
