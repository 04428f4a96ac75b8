import sys,subprocess,os,time,random,json,signal,drv
os.makedirs(f'{drv.WD}/sd',exist_ok=True); os.makedirs(f'{drv.WD}/sd',exist_ok=True); os.chdir(f'{drv.WD}/sd'); os.system('rm -rf *')
B=drv.B
evs=['','refuses = 480','power_cycle = true','silent = "2s"','silent = "60s"','set = { "481@2" = 77 }','ignores = 372','KILL','INT','INT2','TERM','fault = "F0500"']
for t in range(int(sys.argv[1])):
    rnd=random.Random(t+int(sys.argv[2])); ev=evs[t%len(evs)]; k=rnd.randint(1,9)
    b='[[drive]]\nmodel="acu"\naddress=1\nmodules=["EM-RES-03"]\nset={"900"=1, "903"=8, "481@2"=12}\n[drive.readings]\nram_reads="%s"\n'%rnd.choice(('eeprom','eeprom','in-force'))
    if ev and ev[0]!='K' and ev[:3] not in('INT','TER'): b+=f'[[drive.event]]\nafter_writes={k}\n{ev}\n'
    open('b.toml','w').write(b)
    sim=subprocess.Popen([B,'--no-config','simulate','--can','b.toml','--link','adp','--duration','100s'],stdout=subprocess.DEVNULL,stderr=open('sim.err','w')); time.sleep(.5)
    A=[B,'--no-config','-p','slcan:adp','-b','1000000','-a','1']
    for f in os.listdir('.'):
        if f.startswith(('s.','l.')): os.unlink(f)
    r=subprocess.run(A+['dataset','save','s.toml'],capture_output=True,text=True)
    if r.returncode: print('save',r.returncode,r.stderr[:300],open('sim.err').read()[:300]); sim.kill(); continue
    open('l.toml','w').write('antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n"480" = "8 Hz"\n"481@2" = "3 Hz"\n"372" = 1440\n"400" = 4\n')
    p=subprocess.Popen(A+['--json','dataset','load','l.toml','--yes'],stdout=subprocess.PIPE,stderr=subprocess.PIPE,text=True,start_new_session=True)
    if ev in('KILL','INT','INT2','TERM'):
        time.sleep(1.3+rnd.random()*.5); sg={'K':signal.SIGKILL,'I':signal.SIGINT,'T':signal.SIGTERM}[ev[0]]
        if p.poll() is None: p.send_signal(sg)
        if ev=='INT2':
            time.sleep(.05); p.poll() is None and p.send_signal(sg)
    t0=time.time()
    try: o,e=p.communicate(timeout=90)
    except subprocess.TimeoutExpired: p.kill(); o,e=p.communicate(); print('HANG')
    try: j=json.loads(o)['data']; ended=j['ended']; res=[x['result'] for x in j['values']]; un=[(x['param'],x['data_set']) for x in j['values'] if x['result']=='unrestored']
    except Exception: ended=None;res=[];un=[]
    if 'power' in ev or 'silent' in ev: time.sleep(3)
    ck=None
    if '60s' not in ev:
        c=subprocess.run(A+['dataset','check','s.toml','--json'],capture_output=True,text=True)
        try: ck=(c.returncode,[(x.get('param'),x.get('data_set')) for x in json.loads(c.stdout)['data'].get('differences',json.loads(c.stdout)['data'].get('values',[])) ][:12])
        except Exception as ex: ck=(c.returncode,c.stdout[:200])
    u=None
    if os.path.exists('l.undo.toml') and (ev=='KILL' or (ck and ck[0])) and p.returncode!=0:
        x=subprocess.run(A+['dataset','undo','l.undo.toml','--yes'],capture_output=True,text=True); c=subprocess.run(A+['dataset','check','s.toml'],capture_output=True,text=True); u=(x.returncode,c.returncode,c.stdout.splitlines()[-2:] if c.returncode else '')
    print(t,repr(ev),k,'rc',p.returncode,ended,sorted(set(res)),'unrest',un,'check',ck,'undo',u,f'{time.time()-t0:.1f}',flush=True)
    sim.terminate(); sim.wait()
