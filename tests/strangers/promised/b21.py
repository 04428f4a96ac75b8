from nov import *
def q(lbl,ds,a,**k):
    c=run(ds,a,quiet=True,maxt=90,**k)
    n={}
    for t,w in c.words: n[w[0]]=n.get(w[0],0)+1
    print('%-34s rc %s %.1fs words per drive %s last %.2f | %s'%(lbl,c.rc,c.dur,n,c.words[-1][0] if c.words else 0,[l[:170] for l in c.err.split('\n') if l.startswith('error')]),flush=True)
R='--set 418=0 --running --left 20 '
os.makedirs('pj',exist_ok=True)
def toml(ds,a,lbl):
    # named drive: port is not known before: write the file in a hook through -p on the command line
    open('pj/antrieb.toml','w').write('[drives.pumpe]\naddress=1\ndrive="acu"\n')
    c=run(ds,a,quiet=True,maxt=60,cwd='pj'); n=len(c.words)
    print(lbl,'rc',c.rc,'%.1fs'%c.dur,'words',['%.2f'%t for t,w in c.words],'|',c.err.strip()[:250],flush=True)
for _ in (1,2): toml([Cube(R+'--set 638=10')],['-a','pumpe','statemachine','quick-stop'],'antrieb.toml named drive')
q('vabus --drive',[Cube(R+'--set 638=10',1,'vabus')],['--protocol','vabus','--drive','acu','-a','1','statemachine','quick-stop'])
q('acu --drive dv',[Cube(R+'--set 638=10')],['--drive','acu','-a','1','statemachine','disable-voltage'])
q('acu --drive sollwert 0',[Cube(R+'--set 434=2 --set 638=10')],['--drive','acu','-a','1','sollwert','0'])
q('acu --drive Ctrl-C at .4',[Cube(R+'--set 638=10 --set 424=500')],['--drive','acu','-a','1','statemachine','quick-stop'],triggers=[(T(.4),INT)])
d=Cube(R+'--set 638=10'); run([d],['--drive','acu','-a','1','-vv','statemachine','quick-stop'],verbose_line=True,label='--drive acu, 10 ms')
