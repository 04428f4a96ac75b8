import sys,drv,random,subprocess,os,time,json,signal,re,collections
def mkval(p,rnd,w):
    mn,mx=p.get('min'),p.get('max'); dec=p.get('decimals') or 0
    sc=10**dec
    vals=[v['raw'] for v in p.get('values',[])] if p.get('values') else None
    if vals: return rnd.choice(vals)
    if mn is not None and mx is not None:
        lo,hi=round(float(mn)*sc),round(float(mx)*sc)
        if hi-lo>2000: hi=lo+2000
        return rnd.randint(lo,hi)
    return rnd.randint(0,300)
ENDS=['none','refonce','refalways','ee6','cut','cutob','gone','power','powerob','kill','int','int2','term','busy','other','start','garble','ignore','wrong','lost']
def trial(seed,wd,fams,kinds,ends,verbose=False):
    rnd=random.Random(seed); fam=rnd.choice(fams); kind=rnd.choice([k for k in kinds if fam!='lxm05' or k in('rtu','mbtcp')])
    end=rnd.choice(ends)
    addr=rnd.randint(1,30)
    d=drv.Drive(fam,addr,rnd,ramread=rnd.random()<.75,setread='ram' if rnd.random()<.2 else 'eeprom',unknown=rnd.choice('42'))
    cat={p['param']:p for p in drv.catalogue(fam)}
    if fam=='lxm05':
        pool=[n for n in d.ee if n not in(5638,5640,5642,5646,1544,1546) and cat[n]['access']=='rw']
        pick=rnd.sample(pool,rnd.randint(2,6)); lines=[]
        for n in pick: lines.append((n,0,mkval(cat[n],rnd,32)))
    else:
        pool=[n for n in d.w if n in cat and cat[n]['access']=='rw' and not cat[n].get('hazard') and not cat[n].get('volatile') and n not in(10,30,34,131,392,394,395,413,1375,1376,1200,1201,1202,900) and not 900<=n<1000 and not(fam=='act' and n in())]
        special=[n for n in (412,414,68,69) if n in d.w]
        pick=rnd.sample(pool,rnd.randint(2,7))+([rnd.choice(special)] if special and rnd.random()<.3 else [])
        # random state before
        for n in pick:
            if rnd.random()<.5:
                ks=[k for k in ((1,2,3,4) if n in d.four else (0,))]
                for k in ks:
                    if rnd.random()<.6:
                        v=mkval(cat[n],rnd,0)&((1<<d.w[n])-1); d.ee[n,k]=v; d.ram[n,k]=v
        if rnd.random()<.3 and d.setread!='ram':
            n=rnd.choice(pick); k=rnd.choice((1,2,3,4)) if n in d.four else 0
            d.ram[n,k]=mkval(cat[n],rnd,0)&((1<<d.w[n])-1)
        lines=[]
        for n in pick:
            if n in d.four and rnd.random()<.6:
                for k in rnd.sample((1,2,3,4),rnd.randint(1,4)): lines.append((n,k,mkval(cat[n],rnd,0)))
            else: lines.append((n,0,mkval(cat[n],rnd,0)))
        rnd.shuffle(lines)
    ram=rnd.random()<.15 and fam!='lxm05'
    fn=f'{wd}/t{seed}.toml'; uf=f'{wd}/t{seed}.undo.toml'
    for f in os.listdir(wd):
        if f.startswith(f't{seed}.'): os.unlink(f'{wd}/{f}')
    with open(fn,'w') as o:
        o.write(f'antrieb = 1\n[drive]\nfamily = "{fam}"\n[values]\n')
        for n,k,v in lines: o.write(f'"{n}{"@%d"%k if k else ""}" = "raw {v}"\n')
    want={}
    for n,k,v in sorted(lines,key=lambda x:x[1]!=0 ):
        if fam=='lxm05': want[n]=v&0xFFFFFFFF
        else:
            for i in ((1,2,3,4) if n in d.four and k==0 else (k,)): want[n,i]=v&((1<<d.w[n])-1)
    before=(dict(d.ee),dict(d.ram))
    srv=drv.Server(kind,[d])
    st={'fired':False,'n':0,'seen':False,'other':None,'exp':[]}
    where=rnd.choice([1,1,2,3,4,5,6,8,10,14,20]); wnth=rnd.randint(1,max(1,len(want)))
    secs=rnd.choice((1,2,4,16,30)) if end.startswith('power') else 0
    bywrite=rnd.random()<.5
    code=rnd.choice((0,1,4,6,7,8,10,15))
    def hook(s,dd,isw,msg):
        if isw: st['seen']=True
        if not st['seen']: return None
        if bywrite or end in('refonce','refalways','ee6','ignore','wrong'):
            if not isw and not (st['fired']): return None
            st['n']+=isw
            hit=st['n']>=wnth
        else:
            st['n']+=1; hit=st['n']>=where
        if not hit or st['fired']: return None
        st['fired']=True
        if kind=='vabus': 
            nn=dd.vab_num(msg[3:6].decode()) if not isw else dd.vab_num(msg[4:7].decode()); kk=(msg[3] if isw else msg[2])-48
        else:
            a=int.from_bytes(msg[1:3],'big'); nn,kk=(a,0) if fam=='lxm05' else (a&0xFFF,a>>12)
        if end=='refonce': dd.refuse[nn]=[1,code]
        elif end=='refalways': dd.refuse[nn]=[None,code]
        elif end=='ee6' : dd.refuse[nn]=[rnd.choice((1,None)),'eepromram']
        elif end=='cut': s.cut=True; return 'drop'
        elif end=='cutob': s.cut=True; return 'late-drop0' if False else (lambda:None)
        elif end=='gone':
            s.cut=True
            if kind=='mbtcp':
                try: s.ls.close(); s.cs.close(); s.cs=None
                except Exception: pass
            else:
                s.stop=True; os.close(s.m); os.close(s.s)
            return 'drop'
        elif end=='power': dd.power(); dd.silent_until=time.time()+secs; return 'drop'
        elif end=='powerob':
            def f(): dd.power(); dd.silent_until=time.time()+secs
            return f
        elif end=='kill': s.proc.send_signal(signal.SIGKILL); 
        elif end=='int': s.proc.send_signal(signal.SIGINT)
        elif end=='int2':
            s.proc.send_signal(signal.SIGINT)
            import threading; threading.Timer(rnd.choice((.01,.05,.2)),lambda:s.proc.poll() is None and s.proc.send_signal(signal.SIGINT)).start()
        elif end=='term': s.proc.send_signal(signal.SIGTERM)
        elif end=='busy':
            if kind=='vabus': return 'late-drop'
            return ('bytes',bytes([msg[0]|0x80,rnd.choice((5,6,7,8))]))
        elif end=='lost': return 'late-drop' if rnd.random()<.5 else 'drop'
        elif end=='garble':
            return 'late-drop'
        elif end=='other':
            c=rnd.choice(list(want)); v=(before[0][c]+7)&0xFFFF; dd.ee[c]=v; dd.ram[c]=v; st['other']=c
        elif end=='start':
            if fam=='lxm05': dd.ro[6916]=0x0637
            else: dd.ro[411]=(16,0x37 if fam=='acu' else 0x27); dd.ro[210]=(32,1000); dd.ro[241]=(32,1000)
        elif end=='ignore':
            if kind=='vabus': return ('bytes',msg[0:1]+b'\x06')
            return ('bytes',msg if fam!='lxm05' else msg[:5])
        elif end=='wrong':
            st['other']=None
            def f():
                c=(nn,(kk%5)) if fam!='lxm05' else nn
                if c in dd.ee:
                    if kk<5: dd.ee[c]=(dd.ee[c]+1)&0xFFFF
                    dd.ram[c]=(dd.ram[c]+1)&0xFFFF
            return f
        return None
    # cutob: obey, then silent
    if end=='cutob':
        def hook2(s,dd,isw,msg,h=hook):
            r=h(s,dd,isw,msg)
            return r
        h0=hook
        def hook(s,dd,isw,msg,h0=h0):
            was=st['fired']; 
            r=h0(s,dd,isw,msg)
            if st['fired'] and not was: s.cut=False; return lambda: setattr(s,'cut',True)
            return r
    srv.end=hook
    cmd=[drv.B,'--no-config','-p',srv.port,'-a',str(addr),'--json','--timeout','250ms']+(['--protocol',kind] if kind!='mbtcp' else [])
    env=dict(os.environ,LC_ALL='C.UTF-8')
    t0=time.time()
    args=cmd+['dataset','load',fn,'--yes']+(['--ram'] if ram else [])
    p=subprocess.Popen(args,stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,env=env,start_new_session=True); srv.proc=p
    bad=[]
    try: out,err=p.communicate(timeout=90)
    except subprocess.TimeoutExpired:
        p.kill(); out,err=p.communicate(); bad.append('HANG 90s')
    dt=time.time()-t0; rc=p.returncode
    try: j=json.loads(out)
    except ValueError: j=None
    data=(j or {}).get('data') or {}
    rows=data.get('values') or []
    ended=data.get('ended')
    wr=[w for w in d.writes if (fam=='lxm05' or w[1]<5)]
    def diff(ref):
        r=set()
        for c in set(ref[0]):
            if d.ee[c]!=ref[0][c]: r.add((c if fam!='lxm05' else (c,0),'eeprom'))
            if fam!='lxm05' and d.ramread and d.ram[c]!=ref[1][c]: r.add((c,'ram'))
        return r
    df=diff(before)
    named=set()
    for r in rows:
        if r['result'] not in('restored','planned','unchanged','untouched','verified','skipped'):
            named.add((r['param'],r['data_set'] if r['data_set']<5 else r['data_set']-5))
    txt=err+json.dumps((j or {}).get('warnings',''))
    for m in re.finditer(r'P?\.?(\d{2,5})@(\d)',txt): named.add((int(m[1]),int(m[2])%5))
    for m in re.finditer(r'P\.(\d{2,5})@(\d)-(\d)',txt):
        for k in range(int(m[2]),int(m[3])+1): named.add((int(m[1]),k))
    if end not in('kill',) and j is None and rc not in(130,143,-15): bad.append(f'no JSON rc {rc}')
    unn={x for x in df if x[0] not in named}
    if st['other'] is not None:
        o=st['other'] if fam!='lxm05' else (st['other'],0)
        unn={x for x in unn if x[0]!=o}
    results=collections.Counter(r['result'] for r in rows)
    if rc==0:
        for c,v in want.items():
            if not ram and d.ee[c]!=v: bad.append(f'FALSE DONE ee {c} want {v} is {d.ee[c]}')
            if fam!='lxm05' and d.ram[c]!=v and d.ramread and end not in('power','powerob'): bad.append(f'FALSE DONE ram {c} want {v} is {d.ram[c]}')
        if ended!='done': bad.append(f'rc 0 ended {ended}')
        others={x for x in df if (x[0] if fam!='lxm05' else x[0][0]) not in want}
        if others: bad.append(f'rc0 other cells changed {others}')
    elif ended in('back','untouched'):
        unn={x for x in df if st['other'] is None or x[0]!=(st['other'] if fam!='lxm05' else (st['other'],0))}
        if unn: bad.append(f'SAYS {ended} but differs {sorted(unn)} (all {sorted(df)})')
    elif ended in('torn','stored'):
        if unn: bad.append(f'{ended}: UNNAMED {sorted(unn)}')
    if data.get('eeprom_writes') is not None:
        mx=data['eeprom_writes']+(0 if rc==0 else data['eeprom_writes_back'])
        if len(wr)>mx: bad.append(f'EEPROM writes {len(wr)} > {mx}')
    # undo
    und=None
    if os.path.exists(uf) and end!='other' and (end in('kill','term','cut','cutob','gone','int2','power','powerob','start') or rnd.random()<.3) and (df or rnd.random()<.3):
        if end=='gone':
            srv.close(); srv=drv.Server(kind,[d]); cmd[3]=srv.port
        srv.end=None; srv.cut=False; d.silent_until=0; d.dead=False; d.refuse={}
        if fam=='lxm05': d.ro[6916]=592
        else: d.ro[411]=(16,d.status); d.ro[210]=(32,0); d.ro[241]=(32,0)
        nw=len(d.writes)
        u=subprocess.run(cmd+['dataset','undo',uf,'--yes'],capture_output=True,text=True,env=env,timeout=90)
        df2=diff(before); ut=u.stdout+u.stderr
        n2=set()
        for m in re.finditer(r'P?\.?(\d{2,5})@(\d)',ut): n2.add((int(m[1]),int(m[2])%5))
        for m in re.finditer(r'P\.(\d{2,5})@(\d)-(\d)',ut):
            for k in range(int(m[2]),int(m[3])+1): n2.add((int(m[1]),k))
        try:
            for r in json.loads(u.stdout)['data']['values']:
                if r['result'] not in('restored','verified','unchanged'): n2.add((r['param'],r['data_set']%5))
        except Exception as e: n2.add(('?',0))
        und=(u.returncode,len(df2))
        un2={x for x in df2 if x[0] not in n2}
        if un2: bad.append(f'UNDO rc {u.returncode}: differs unnamed {sorted(un2)} :: {u.stderr[-300:]}')
        if u.returncode==0 and any(x[1]=='eeprom' for x in df2): bad.append(f'UNDO rc 0 but ee differs {sorted(df2)}')
        if u.returncode not in(0,9): bad.append(f'UNDO rc {u.returncode}: {u.stderr[-300:]}')
    srv.close()
    line=f'{seed} {fam} {kind} {end} w{wnth if bywrite else -where} ram={ram} rr={d.ramread} sr={d.setread} code={code} fired={st["fired"]} rc={rc} {ended} df={len(df)} named={len(named)} wr={len(wr)} {dict(results)} {dt:.1f}s undo={und}'
    if bad:
        line+='\n   !!! '+'\n   !!! '.join(bad)
        open(f'{wd}/bad-{seed}.txt','w').write(line+'\n'+' '.join(args)+'\n'+out+err)
    else:
        for f in os.listdir(wd):
            if f.startswith(f't{seed}.'): os.unlink(f'{wd}/{f}')
    print(line,flush=True); return bad
if __name__=='__main__':
    a,n=int(sys.argv[1]),int(sys.argv[2])
    fams=sys.argv[3].split(',') if len(sys.argv)>3 else ['act','acu','lxm05']
    kinds=sys.argv[4].split(',') if len(sys.argv)>4 else ['rtu','ascii','vabus','mbtcp']
    ends=sys.argv[5].split(',') if len(sys.argv)>5 else ENDS
    wd=f'{drv.WD}/p'; os.makedirs(wd,exist_ok=True); os.chdir(wd)
    b=0
    for s in range(a,a+n):
        try: b+=bool(trial(s,wd,fams,kinds,ends))
        except Exception as e:
            import traceback; print(s,'MY BUG',repr(e)); traceback.print_exc()
    print('bad',b,'of',n)
