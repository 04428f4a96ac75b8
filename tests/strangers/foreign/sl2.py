import sys
src=open('sl.py').read().split('for a in ((')[0].replace("print('sl'","open('out/sl-%s-%s-%s.txt'%(ft,dt,pr),'w').write(r['out']+r['err']+'\\nt0->EN %.3f z %.3f end %.3f\\n'%(S.get('a',0)-r['t0'],S['z']-r['t0'],r['took'])+'\\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in ln.log)+'\\nHIST '+str([(round(t-r['t0'],2),round(m,2)) for t,m in d.hist][::40]));print('sl'")
exec(src)
for a in (('los',.5,'rtu'),('los',.45,'rtu'),('los',.6,'rtu')): one(*a)
