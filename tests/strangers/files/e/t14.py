from mat import *
for rr,how in(('refused','eefail'),('refused','eekeep'),('inforce','eefail'),('cells','ram lost line')):
    for n,(i,o,v) in((480,(1,500,-1250)),(419,(0,5000,6000))):
        d=Drv(ramread=rr); st={}
        if how=='eefail': d.eefail=lambda p,ds,n=n:p==n and ds<5
        elif how=='eekeep': d.eekeep=lambda p,ds,n=n:p==n and ds<5
        else:
            # EEPROM refused, RAM taken, then the line dies for good; later it is back
            d.eefail=lambda p,ds,n=n:p==n and ds<5
            def h(k,f,d=d,n=n):
                if f[1]==101 and ((f[2]<<8|f[3])&0xfff)==n and not st.get('x'):
                    st['x']=1; threading.Timer(.005,lambda:setattr(d,'off',True)).start()
            d.hook=h
        b=d.snap(); r=load(d); end=r.j['data']['ended']; hint=r.j['error']['hint']; d.off=False; d.eefail=d.eekeep=lambda p,ds:False; d.hook=None; d.reset()
        df=diffs(b,d.snap()); r2=run(d,'dataset','undo',W+'/m.undo.toml','--yes',json_=False); a=diffs(b,d.snap())
        print('###',rr,how,n,'load rc',r.rc,end,'left',df if len(df)<5 else len(df),'| hint:',hint[:120],'| undo rc',r2.rc,'left',a,'wr',d.wr); print('     '+(r2.o+r2.e).replace('\n','\n     ')[:1500],flush=True)
        r3=run(d,'read','%d@%dram'%(n,2 if n==480 else 0),json_=False); print('     read ram:',r3.rc,(r3.o+r3.e)[-250:].replace('\n',' | ')); d.stop=True
