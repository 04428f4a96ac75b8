# at2.py [src|srcg|hup] : (cd /tmp/judge/foreign && ANTRIEB=/tmp/b/antrieb python3 ../new/at2.py src) `sollwert 0` to an ACU whose P.434 = 1 (internal setpoint) turns it; alone, in a group; P.412 = 1 and 44
import sys,os; sys.path.insert(0,os.getcwd()); sys.argv,A=[sys.argv[0]],sys.argv[1:]
from at import *
sys.argv=A
def mk1(adr,c412):
    d=ACU(adr,contact_start=c412!=1,internal=20,set={412:c412,418:0,434:1}); d.st='OE'; d.n=20; d.cw=15; return d
def src():
    for c in(1,44):
        for ex in([],['--json'],['--source','line'],['--source','sum']):
            d=mk1(1,c); ln=Line([d]); time.sleep(.1); r=run(ln,['-a','1','sollwert','0']+ex,d,verbose=False); w=[x[1:] for x in d.wr]; ln.close()
            rep('src %d %s'%(c,' '.join(ex)),r['rc'],r['took'],r['out'],r['err'],[d],'writes %s'%w,'**' if abs(r['nend'])>0 and 'STILL TURN' not in r['err'] else '')
def srcg():
    for c in(1,44):
        d1=mk1(1,c); d2=rn(ACU(2)); d3=rn(ACU(3)); ln=Line([d1,d2,d3]); time.sleep(.1); r=run(ln,['-a','1-3','sollwert','0'],d1,verbose=False); w=[x[1:] for x in d1.wr]; ln.close()
        rep('srcg %d'%c,r['rc'],r['took'],r['out'],r['err'],[d1,d2,d3],'writes %s'%w,'**' if abs(r['nend'])>0 and 'STILL TURN' not in r['err'] else '')
def gap():
    # split replies: adapter hands out bytes in two bursts d apart (USB latency), stop and hold
    for fam,cls in(('lx',LXM),('rtu',ACU)):
        for g in(.004,.016,.03):
            class SP(Line): pass
            for k in('disable','hold'):
                d=cls(3 if fam=='lx' else 1) if fam=='lx' else ACU(1,set={418:0})
                if k!='hold': rn(d)
                ln=Line([d],lambda i,t,q,r,dd:[(-.001,r[:len(r)//2]),(-.001+g,r[len(r)//2:])])
                r=run(ln,['-a',str(d.adr)]+(sp(d)+['--duration','600ms'] if k=='hold' else V[k]),d,verbose=False); ln.close()
                rep('gap %s %.3f %s'%(fam,g,k),r['rc'],r['took'],r['out'],r['err'],[d],'max %.0f'%r['max'],'**' if (abs(r['nend'])>0 or d.st=='OE') and 'STILL TURN' not in r['err'] else '')
def files():
    import tempfile,json
    td=tempfile.mkdtemp(); f=td+'/a.toml'
    d=ACU(1); ln=Line([d])
    r=run(ln,['-a','1','dataset','save',f],None,extra=(),verbose=False); print('save',r['rc'],os.path.getsize(f) if os.path.exists(f) else None)
    b=open(f,'rb').read()
    # Ctrl-C / TERM / KILL in the middle of a save over an existing file
    for s in(signal.SIGINT,signal.SIGTERM,signal.SIGKILL,signal.SIGHUP):
        p=subprocess.Popen([BIN,'-p',ln.path,'--no-config','-a','1','dataset','save',f,'--force'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,stdin=subprocess.DEVNULL); time.sleep(1.2); p.send_signal(s); o,e=p.communicate(timeout=60)
        print('save over, %s rc %s same %s left %s | %s'%(s.name,p.returncode,open(f,'rb').read()==b,os.listdir(td),e.decode().strip().splitlines()[:1]),flush=True)
    # truncated file compared
    for cut in(len(b)//2,len(b)-40):
        g=td+'/cut.toml'; open(g,'wb').write(b[:cut]); r=run(ln,['-a','1','dataset','diff',g],None,extra=(),verbose=False); print('compare cut',cut,r['rc'],(r['err'] or r['out']).strip().splitlines()[:2],flush=True)
    r=run(ln,['-a','1','dataset','diff',f],None,extra=(),verbose=False); print('compare same',r['rc'],r['out'].strip().splitlines()[-2:],flush=True)
    d.ram[480,2]=777; d.ee[480,2]=777
    r=run(ln,['-a','1','dataset','diff',f],None,extra=(),verbose=False); print('compare differs',r['rc'],r['out'].strip().splitlines()[-4:],flush=True)
    ln.close()
if __name__=='__main__':
    for n in A: globals()[n]()
