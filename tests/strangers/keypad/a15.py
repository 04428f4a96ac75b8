from k import *
# ndjson / json / line of a held run in pipes
def sh(cmd,d,lim=25):
    t0=time.monotonic(); p=subprocess.run(['bash','-c',cmd.replace('ANT',' '.join(h.cmd(d,[])))],capture_output=True,text=True,env=env(),timeout=lim,stdin=subprocess.DEVNULL)
    e=d.look(); time.sleep(1); print('##',cmd,'\n  ',p.returncode,f'{time.monotonic()-t0-1:.1f}s',e,d.look(),'max',maxout(d)[0],'words',[v for _,n,s,v in d.drive.writes if n==410]); print('  OUT',p.stdout[:1500],'\n  ERR',p.stderr[-500:],flush=True)
R=' '.join(RUN)+' --duration 4s'
for c in (f'ANT {R} --format ndjson | head -1; echo ${{PIPESTATUS[0]}}', f'ANT {R} --format ndjson | jq -c "keys"; echo ${{PIPESTATUS[0]}}', f'ANT {R} --json | jq .data', f'ANT {R} --format csv', f'ANT {R} --format ndjson >/dev/full; echo $?', f'(ANT {R} --format ndjson; echo $? >&2) | (sleep 1.8)', f'ANT {R} --format ndjson --view; echo $?',f'ANT {R} --format ndjson --lang de| tail -2'):
    with act() as d: sh(c,d)
