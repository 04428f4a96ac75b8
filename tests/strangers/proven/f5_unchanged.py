import sys,drv,random,subprocess,os
os.makedirs(f'{drv.WD}/f5',exist_ok=True); os.makedirs(f'{drv.WD}/f5',exist_ok=True); os.chdir(f'{drv.WD}/f5')
def go(kind,mode,proto):
    os.system('rm -f *'); d=drv.Drive('acu',2,random.Random(1)); s=drv.Server(proto,[d])
    open('x.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'+('"30" = "raw 210"\n' if mode=='p30' else '"372" = 1450\n')+'"480" = "5 Hz"\n"376" = "raw 15"\n"400" = 4\n')
    d.ee[376,0]=d.ram[376,0]=15
    for k in (1,2,3,4):
        if (376,k) in d.ee: d.ee[376,k]=d.ram[376,k]=15
    n={'w':0}
    def hook(sv,dd,isw,msg):
        if isw:
            n['w']+=1
            if n['w']==1:
                def f():
                    if mode!='none': dd.ee[480,1]=dd.ram[480,1]=777
                return f
    s.end=hook
    r=subprocess.run([drv.B,'--no-config','-p',s.port,'-a','2']+(['--protocol',proto] if proto!='mbtcp' else [])+['dataset','load','x.toml','--yes'],capture_output=True,text=True)
    print(mode,proto,'rc',r.returncode,[l for l in r.stdout.splitlines() if l.startswith('result') or 'unchanged' in l],'P.480@1 in the drive:',d.ee[480,1],'writes',d.writes[:6], r.stderr.strip().splitlines()[-1][:160])
    c=subprocess.run([drv.B,'--no-config','-p',s.port,'-a','2']+(['--protocol',proto] if proto!='mbtcp' else [])+['dataset','check','x.toml'],capture_output=True,text=True); print('   check right behind it rc',c.returncode,c.stdout.splitlines()[-1])
    s.close()
for m in ('other','p30'):
    for p in ('rtu','mbtcp','vabus'): go('acu',m,p)
