import os,sys,subprocess,time,resource
BIN=os.path.abspath(os.environ.get('ANTRIEB','target/debug/antrieb'))
ENV={k:v for k,v in os.environ.items() if not k.startswith('ANTRIEB')}; ENV.update(LANG='C.UTF-8',HOME='/tmp/nov22home')
N=[0]
def t(label,cmd,limit=20,cwd='/tmp/adv22',show=220,env=None):
    "cmd: shell text with $B"
    t0=time.monotonic(); e=dict(ENV,B=BIN,**(env or {}))
    p=subprocess.Popen(['bash','-c',cmd],stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE,cwd=cwd,env=e,start_new_session=True)
    hung=False
    try: o,er=p.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        hung=True; os.killpg(p.pid,9); o,er=p.communicate()
    dt=time.monotonic()-t0; N[0]+=1
    bad='HANG ' if hung else ''
    if p.returncode==70 or b'panicked' in er: bad+='CRASH '
    if p.returncode in(134,139,137,-6,-11): bad+='KILLED '
    print('%s%-34s rc=%s %.1fs out=%d | %s'%(bad,label,p.returncode,dt,len(o),(er.decode(errors='replace').strip() or o.decode(errors='replace').strip())[:show].replace('\n',' / '))); sys.stdout.flush()
    return p.returncode,o,er
if __name__=='__main__':
    os.chdir('/tmp/adv22')
    w=lambda n,b: open(n,'wb').write(b)
    os.system('rm -rf /tmp/adv22/*; mkfifo ff nowriter; ln -s loop loop; mkdir dir; ln -s /dev/zero zero.csv; ln -s /etc/passwd pw.csv')
    w('ok.csv',b'Nr.;Bezeichnung;Einheit;Typ;Nachkommastellen;Min;Max;Zugriff\nP.370;Test;Hz;Long;2;0;99,99;rw\n')
    w('bom.csv',b'\xef\xbb\xbf'+open('ok.csv','rb').read()); w('u16.csv','\ufeff'.encode('utf-16-le')+open('ok.csv').read().encode('utf-16-le'))
    w('latin.csv','Nr.;Bezeichnung;Einheit;Typ;Nachkommastellen;Min;Max;Zugriff\nP.370;Größe;Hz;Long;2;0;99,99;rw\n'.encode('latin-1'))
    w('nul.csv',b'Nr.;Bezeichnung;Einheit\nP.370;A\0B;Hz\n\0\0\0'); w('empty.csv',b''); w('crlf.csv',open('ok.csv','rb').read().replace(b'\n',b'\r\n')); w('cr.csv',open('ok.csv','rb').read().replace(b'\n',b'\r'))
    w('oneline.csv',b'Nr.;Bezeichnung\nP.370;'+b'x'*20_000_000+b'\n'); w('quote.csv',b'Nr.;Bezeichnung\nP.370;"never closed\n'+b'a;b\n'*100000)
    w('rows.csv',b'Nr.;Bezeichnung;Einheit;Typ\n'+b''.join(b'%d;Name %d;Hz;Long\n'%(i,i) for i in range(400000)))
    w('wide.csv',b';'.join(b'c%d'%i for i in range(100000))+b'\n'+b'1;'*100000+b'\n')
    w('num.csv',b'Nr.;Bezeichnung;Einheit;Typ;Nachkommastellen;Min;Max;Zugriff\n99999999999999999999;a;Hz;Long;2;0;1;rw\n-5;b;Hz;Long;2;0;1;rw\n371;c;Hz;Long;400;0;1;rw\n372;d;Hz;Long;2;5;1;rw\n373;e;Hz;Long;-3;0;1;rw\n374;f;Hz;Long;2;-1e308;1e308;rw\n376;g\x1b[2J\x07;H\x1bz;Long;2;0;1;rw\n377;"h\nnewline";Hz;Long;2;0;1;rw\n377;dup;Hz;Long;2;0;1;rw\n378;;Hz;Long;2;NaN;inf;rw\n')
    w('deep.json',b'['*1000000); w('deep2.json',b'{"a":'*200000); w('bad.json',b'{"mbmap":2,"registers":[{"address":1}]}'); w('null.json',b'null'); w('trunc.json',b'{"registers":[{"addr'); w('huge.json',b'{"registers":['+b','.join(b'{"address":%d,"name":"r%d"}'%(i,i) for i in range(300000))+b']}')
    for f in sorted(os.listdir('.')):
        if f in('ff','nowriter','dir','loop'): continue
        t('import '+f,'$B params import %s --output /tmp/adv22/out.toml --force'%f,show=260); 
    t('import fifo endless','(timeout 25 cat /dev/zero > ff & ) ; $B params import ff',30); t('import fifo text endless','(timeout 25 yes "370;Name;Hz" > ff & ) ; $B params import ff',30)
    t('import fifo no writer','$B params import nowriter',12); t('import dir','$B params import dir'); t('import loop','$B params import loop'); t('import none','$B params import nix.csv'); t('import stdin -','$B params import - < ok.csv'); t('import /dev/stdin','cat ok.csv | $B params import /dev/stdin'); t('import /dev/tty','$B params import /dev/tty',10)
    for o in ('/dev/full','dir','dir/nix/x.toml','loop','/proc/version','/dev/stdout','nowriter'):
        t('output '+o,'$B params import ok.csv --output %s --force; r=$?; ls -la dir; exit $r'%o,10)
    w('keep.toml',b'precious'); t('output existing','$B params import ok.csv --output keep.toml; r=$?; cat keep.toml; exit $r'); os.system('ln -sf keep.toml lnk.toml'); t('output symlink force','$B params import ok.csv --output lnk.toml --force; r=$?; ls -la lnk.toml; head -c 30 keep.toml; exit $r')
    t('output ulimit -f 0','ulimit -f 0; $B params import ok.csv --output small.toml --force; r=$?; ls -la small.toml*; exit $r')
    w('keep2.toml',b'precious2'); t('output ulimit -f 0 existing','ulimit -f 0; $B params import rows.csv --output keep2.toml --force; r=$?; head -c 30 keep2.toml; ls; exit $r',show=400)
    t('stdout full','$B params import ok.csv > /dev/full'); t('stdout closed','$B params import ok.csv >&-'); t('head','$B params import rows.csv | head -1; echo ${PIPESTATUS[0]}')
    print(N[0],'cases')
