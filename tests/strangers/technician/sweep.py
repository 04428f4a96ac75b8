import subprocess,json,sys,shlex,os
import jsonschema
A='./antrieb'
schemas={}
def schema(v):
    if v not in schemas:
        r=subprocess.run([A,'schema',v],capture_output=True,text=True)
        try: schemas[v]=json.loads(r.stdout)
        except Exception as e: print('SCHEMA',v,r.returncode,r.stdout[:100],r.stderr[:200]); schemas[v]=None
    return schemas[v]
P='--port sim'
B='--port sim:b1.toml'
cmds=open(sys.argv[1]).read().strip().splitlines()
for c in cmds:
    if not c.strip() or c.startswith('#'): continue
    args=shlex.split(c)
    for lang in ('de',):
        try: r=subprocess.run([A,'--lang',lang,'--json']+args,capture_output=True,text=True,timeout=60,stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired: print('TIMEOUT',c); continue
        out=r.stdout
        docs=[];pos=0;d=json.JSONDecoder();err=None
        s=out
        while pos<len(s):
            while pos<len(s) and s[pos].isspace(): pos+=1
            if pos>=len(s): break
            try: o,pos=d.raw_decode(s,pos); docs.append(o)
            except Exception as e: err=str(e); break
        prob=[]
        if err: prob.append('NOTJSON '+err)
        if len(docs)!=1: prob.append('DOCS=%d'%len(docs))
        if docs:
            o=docs[0]
            verb=o.get('command')
            if len(docs)==1 and verb:
                sc=schema(verb)
                if sc is not None:
                    try:
                        v=jsonschema.Draft202012Validator(sc)
                        es=list(v.iter_errors(o))
                        for e in es[:2]: prob.append('SCHEMA %s: %s'%('/'.join(map(str,e.absolute_path)),e.message[:200]))
                    except Exception as e: prob.append('SCHEMAERR %r'%e)
                else: prob.append('NOSCHEMA for command=%r'%verb)
                if o.get('ok')!=(r.returncode==0): prob.append('ok=%s rc=%d'%(o.get('ok'),r.returncode))
                if o.get('error') and o['error'].get('exit')!=r.returncode: prob.append('error.exit=%s rc=%d'%(o['error'].get('exit'),r.returncode))
                if r.returncode not in (0,) and not o.get('error'): prob.append('rc=%d, no error object'%r.returncode)
            else: prob.append('no command: keys %s'%list(o)[:6])
        e=(docs[0].get('error') or {}) if docs else {}
        print(('!! ' if prob else 'ok ')+'rc=%d %-60s %s'%(r.returncode,c,e.get('code','')), '|', (e.get('message') or '')[:110])
        for p in prob: print('      ',p)
        if len(sys.argv)>2: print(out[:int(sys.argv[2])])
