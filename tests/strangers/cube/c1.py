import subprocess,json,csv,io,os,sys,time
from b1 import BIN,ENV
VERBS=[['scan'],['identify'],['read'],['read','@all'],['read','372@all','480-483'],['read','nix'],['write','480@2=7,5Hz','--yes'],['write','411=1','--yes'],['dataset'],['dataset','show'],['dataset','active'],['dataset','select','2','--yes'],['dataset','copy','1','2','--yes'],['dataset','diff','1','2'],['diag'],['diag','--check'],['diag','--link-test','10'],['diag','line'],['statemachine'],['statemachine','enable','--hold','--duration','500ms','--take-control','--yes'],['statemachine','disable'],['statemachine','reset','--yes'],['sollwert'],['sollwert','10Hz','--enable','--hold','--duration','1s','--take-control','--yes'],['monitor','--count','2'],['protocol','show'],['line','show'],['params','ramp'],['params','411'],['params'],['params','nixda'],['decode','status','0x0237'],['decode','control','0x000F'],['decode','warnings','0x008B'],['decode','fault','F0500'],['decode','error','11'],['decode','telegram','01 03 21 74 00 01 CE 2C'],['schema','read'],['schema'],['completions','bash'],['simulate','--for','300ms'],['sniff','--for','500ms'],['line','set','--address','9','--yes'],['protocol','set','ascii','--yes'],['params','export'],['nix'],['read','--fnord']]
bad=0
def run(a,env=None):
    p=subprocess.run([BIN]+a,stdin=subprocess.DEVNULL,capture_output=True,env=dict(ENV,**(env or {})),cwd='/tmp/adv22/cfg',timeout=60); return p.returncode,p.stdout.decode(errors='replace'),p.stderr.decode(errors='replace')
for v in VERBS:
    port=[] if v[0] in('params','decode','schema','completions','simulate','nix') else ['-p','sim']
    if port and v[0] not in('scan','sniff'): port+=['-a','2']
    line=[]
    for f in ('table','json','ndjson','csv'):
        for lg in ('en','de'):
            try: rc,o,e=run(port+['--lang',lg,'--format',f]+v)
            except subprocess.TimeoutExpired: print('HANG',v,f); continue
            pr=[]
            if rc==70 or 'panicked' in e: pr.append('CRASH')
            if f=='json' and v[0] not in('completions',):
                try:
                    j=json.loads(o)
                    if v[0]!='schema':
                        if j.get('ok')!=(rc==0): pr.append('ok %s rc %s'%(j.get('ok'),rc))
                        if rc and (j.get('error') or {}).get('exit')!=rc: pr.append('error.exit!=rc')
                except Exception as x: pr.append('no JSON: '+repr(o[:60]))
            if f=='ndjson' and v[0] not in('completions','schema'):
                L=o.splitlines()
                try: js=[json.loads(x) for x in L]
                except Exception as x: pr.append('ndjson '+repr(o[:80])); js=[]
                line.append('nd%d'%len(L))
            if f=='csv' and o:
                rows=list(csv.reader(io.StringIO(o))); w={len(r) for r in rows if r}
                if len(w)>1: pr.append('csv widths %s'%sorted(w))
                line.append('csv%d'%len(rows))
            if f=='table':
                mx=max([len(x) for x in o.splitlines()] or [0])
                if mx>80: line.append('%s wide %d'%(lg,mx))
            if f=='table' and lg=='de' and rc==0 and not e and not o: pr.append('empty')
            if pr: bad+=1; print('!!',' '.join(v),f,lg,'rc',rc,pr,'|',e.strip()[:120].replace('\n',' / '))
            if f=='table' and lg=='en': line.append('rc%d'%rc)
    print(' '.join(v),line)
print('bad',bad)
