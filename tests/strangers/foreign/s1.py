from mx import *
import re
def isstop(b):
    h=b.hex()
    if b[:1]==b':': 
        try: h=bytes.fromhex(b[1:-2].decode()).hex()
        except Exception: h=''
    if b[1:2]==b'\x10' or h[2:4]=='10':
        return h[4:8] in('1b02','1b1a','2108','1b12')
    if h[2:4]in('06','65') and h[5:8] in('19a','1e4','20c'): return True
    if b[0]==4 and b'\x02' in b and re.search(rb'\x02.?(410|484|524)',b): return True
    return False
class Dead(Base):
    st='SOD'
    def tick(s,t): pass
    def handle(s,q,t): return None
def one(name,args,drives,protoargs=[],to=None,ext=[]):
    L=Line(drives); L.ascii='ascii' in protoargs
    try:
        r=run(L,protoargs+args+(['--timeout',to] if to else []),None,timeout=60,extra=('--yes',)+tuple(ext))
        w=[(t-r['t0'],b) for t,k,b in L.log if k=='>' and isstop(b)]
        dst={}
        for t,b in w: dst.setdefault(b[0] if not L.ascii else b[1:3],t)
        cap='STILL TURN' in r['err']
        print('%-40s rc %s took %5.2f n %d stop at %s cap %s'%(name,r['rc'],r['took'],len(w),{str(k):round(v,2) for k,v in dst.items()},cap),flush=True)
        open('out/s1-'+name.replace(' ','_').replace('/','-')+'.txt','w').write(r['out']+r['err']+'\n'.join('%.3f %s %s'%(t-r['t0'],k,b.hex()) for t,k,b in L.log))
    finally: L.close()
if __name__=='__main__':
    jobs=[]
    V={'disable':['statemachine','disable'],'zero':['sollwert','0'],'qs':['statemachine','quick-stop'],'dv':['statemachine','disable-voltage']}
    for v,a in V.items():
        for fam in (None,'acu','lxm05'):
            for pr in ('rtu','ascii','vabus'):
                if fam=='lxm05' and pr!='rtu': continue
                for to in (None,'0.2s','3s','10s'):
                    if pr!='rtu' and to in('3s',): continue
                    p=([] if pr=='rtu' else ['--protocol',pr])+([] if not fam else ['--drive',fam])+['-a','3']
                    jobs.append(('%s-%s-%s-%s'%(v,fam,pr,to),a,p,to))
    with ThreadPoolExecutor(6) as ex:
        fs=[ex.submit(one,n,a,[Dead(3)],p,to) for n,a,p,to in jobs]
        for f in fs:
            try: f.result()
            except Exception as e: print('ERR',repr(e))
