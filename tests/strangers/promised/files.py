import subprocess,os,time,sys,resource,stat
B='target/debug/antrieb'
os.makedirs('w',exist_ok=True); os.chdir('w')
def fifo(n):
    if not os.path.exists(n): os.mkfifo(n)
    return n
fifo('ff'); fifo('antrieb-fifo.toml')
open('reg','w').write('x\n'); 
if not os.path.islink('dang'): os.symlink('nowhere','dang')
if not os.path.islink('lz'): os.symlink('/dev/zero','lz')
if not os.path.islink('loop'): os.symlink('loop','loop')
os.makedirs('dir',exist_ok=True)
if not os.path.exists('sparse'):
    f=open('sparse','w'); f.truncate(3<<30); f.close()
bad=['ff','/dev/zero','/dev/random','/dev/tty','/dev/stdin','lz','dang','loop','dir','sparse','/proc/kmsg','/dev/null']
opts={
'catalogue':lambda x:['--catalogue',x,'params','372'],
'config':lambda x:['--config',x,'-p','sim','-a','1','read','411'],
'trace':lambda x:['--trace',x,'-p','sim','-a','1','read','411'],
'profile':lambda x:['-p','sim','-a','1','sollwert','--profile',x,'--enable','--hold','--dry-run'],
'record':lambda x:['-p','sim','-a','1','monitor','--count','2','--record',x],
'textfile':lambda x:['-p','sim','-a','1','monitor','--count','2','--textfile',x],
'plot':lambda x:['plot',x],
'svg':lambda x:['plot','good.csv','--svg',x],
'report-record':lambda x:['-p','sim','-a','1','report','--record',x],
'resume':lambda x:['-p','sim','scan','--resume',x],
'init-resume':lambda x:['-p','sim','init','--resume',x,'i.toml','--force'],
'init-out':lambda x:['-p','sim','-a','1','init',x],
'save':lambda x:['-p','sim','-a','1','dataset','save',x],
'load':lambda x:['-p','sim','-a','1','dataset','load',x,'--yes'],
'undofile':lambda x:['-p','sim','-a','1','dataset','load','v.toml','--undo-file',x,'--yes'],
'undo':lambda x:['-p','sim','-a','1','dataset','undo',x,'--yes'],
'check':lambda x:['-p','sim','-a','1','dataset','check',x],
'import':lambda x:['params','import',x],
'import-out':lambda x:['params','import','list.csv','--output',x],
'dtrace':lambda x:['decode','trace',x],
'candump':lambda x:['decode','trace','t.trace','--candump',x],
'tape':lambda x:['-p','tape:'+x,'-a','1','read','411'],
'sim':lambda x:['-p','sim:'+x,'-a','1','read','411'],
'pcap':lambda x:['-p','sim','sniff','--for','300ms','--pcap',x],
'link':lambda x:['simulate','--link',x],
'port':lambda x:['-p',x,'-a','1','read','411'],
}
open('v.toml','w').write('antrieb = 1\n[drive]\nfamily="act"\n[values]\n"480@1"=6\n')
open('list.csv','w').write('id;name;unit\n9000;Test;Hz\n')
subprocess.run([B,'-p','sim','-a','1','--trace','t.trace','--force','read','411'],capture_output=True)
subprocess.run([B,'-p','sim','-a','1','monitor','--count','5','--interval','100ms','--record','good.csv','--force'],capture_output=True)
only=sys.argv[1:]
for k,f in opts.items():
    if only and k not in only: continue
    for x in bad:
        t=time.time()
        p=subprocess.Popen([B]+f(x),stdin=subprocess.DEVNULL,stdout=subprocess.PIPE,stderr=subprocess.PIPE,preexec_fn=lambda:(os.setsid(),resource.setrlimit(resource.RLIMIT_AS,(3<<30,3<<30))))
        try: o,e=p.communicate(timeout=8); rc=p.returncode
        except subprocess.TimeoutExpired:
            p.kill(); o,e=p.communicate(); rc='HANG'
        dt=time.time()-t
        el=e.decode('utf8','replace').strip().split('\n')
        flag='' if rc in(7,) else ' <<<' if rc in ('HANG',70,-6,-9,101) or dt>3 else ' *' if rc!=2 else ''
        print('%-13s %-11s rc %-4s %.2fs %s%s'%(k,x,rc,dt,[l for l in el if 'rror' in l][:1] or el[:1],flag),flush=True)
        for y in ('dang','nowhere'):
            if os.path.exists('nowhere'): print('    FOLLOWED dangling link -> nowhere'); os.unlink('nowhere')
        if not os.path.islink('dang'): print('   link replaced'); 
        if not os.path.islink('dang'): 
            try: os.unlink('dang')
            except OSError: pass
            os.symlink('nowhere','dang')
        for n,tg in(('lz','/dev/zero'),('loop','loop')):
            if not os.path.islink(n):
                print('   link replaced',n); 
                os.unlink(n); os.symlink(tg,n)
        for n in('ff',):
            if not stat.S_ISFIFO(os.stat(n).st_mode): print('   FIFO replaced',n); os.unlink(n); os.mkfifo(n)
