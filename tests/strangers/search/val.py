import json,subprocess,jsonschema,sys
A=os.environ.get('ANTRIEB', 'antrieb')
def schema(v): return json.loads(subprocess.run([A,'schema',v],capture_output=True,text=True).stdout)
S={}
def val(v,txt,name):
    if v not in S: S[v]=schema(v)
    try: d=json.loads(txt)
    except Exception as e: print(name,'NOJSON',e); return
    es=list(jsonschema.Draft202012Validator(S[v]).iter_errors(d))
    print(name,'ok' if not es else ('BAD',es[0].message[:200],list(es[0].path)))
for f in ('o.nobody','o.babble2','o.res1','o.res2'): val('scan',open(f).read(),f)
for c in ['read 372@all 411','diag','statemachine','identify','sollwert','dataset show','dataset diff 1 2','write 480=7Hz --yes','write 480=999999Hz --yes','read nix','params 411','decode fault F0700','diag line','line show','scan -a 1-3','read 411 --bogus','monitor 210 --bogus']:
    r=subprocess.run([A,'--json','-p','sim','-a','2']+c.split(),capture_output=True,text=True,stdin=subprocess.DEVNULL)
    val(c.split()[0],r.stdout,c+' rc=%d'%r.returncode)
