import sys,drv,random,subprocess,os
os.makedirs(f'{drv.WD}/c',exist_ok=True); os.chdir(f'{drv.WD}/c')
d=drv.Drive('acu',2,random.Random(1)); 
for n in (700,1300): 
    d.w[n]=16; d.ee[n,0]=5; d.ram[n,0]=5
s=drv.Server('rtu',[d])
def R(*a):
    r=subprocess.run([drv.B,'--no-config','-p',s.port,'-a','2',*a],capture_output=True,text=True); print('$',*a,'->',r.returncode); print('\n'.join(l[:170] for l in (r.stdout+r.stderr).splitlines()[:25]))
open('x.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"372" = 1450\n"700" = "raw 400"\n"1300" = "raw 7"\n')
for f in('dis.toml','x.undo.toml'):
    if os.path.exists(f): os.unlink(f)
R('dataset','load','x.toml','--only','all,bus','--yes')
print(d.ee[700,0],d.ee[1300,0],d.ee[372,1])
R('dataset','check','x.toml'); R('dataset','check','x.toml','--only','all,bus'); R('dataset','check','x.toml','--only','all')
R('dataset','load','x.toml','--only','700','--yes')
R('dataset','load','x.toml','--yes')
R('dataset','save','--discover','dis.toml')
os.system("grep -E '\"(700|1300)\"|discovered|scope' dis.toml")
s.close()
