from mat import *
import codecs
H='antrieb = 1\n[drive]\nfamily = "acu"\n[values]\n'
C={
'over range':H+'"412"="99"\n','over 16bit':H+'"372"="70000"\n','neg for unsigned':H+'"372"="-5 1/min"\n','neg raw':H+'"372"="raw -5"\n','below min 375':H+'"375"="1.00 Hz"\n','dup row':H+'"372"="1450"\n"372"="1460"\n','dup slug/num':H+'"372"="1450"\n"rated-speed"="1460"\n','dup same set slug':H+'"480@2"="3 Hz"\n"fixed-frequency-1@2"="4 Hz"\n',
'wrong unit':H+'"372"="1450 Hz"\n','unit kHz':H+'"480"="0.010 kHz"\n','newer':H.replace('= 1','= 2'),'version 0':H.replace('= 1','= 0'),'version str':H.replace('= 1','= "1"'),'broken':H+'"372" = \n','broken2':H+'"372" = "14\n','empty':'','nul':H+'"372"="14\x0050"\n','nofam':'antrieb = 1\n[values]\n"372"="1450"\n','otherfam':H.replace('acu','act')+'"372"="1450"\n','lxm':H.replace('acu','lxm05')+'"372"="1450"\n','unknown fam':H.replace('acu','xyz'),
'unknown param':H+'"99999"="1"\n','unk 1599':H+'"1599"="1"\n','unknown key':H+'[foo]\na=1\n','ram set':H+'"480@2ram"="3 Hz"\n','set 5':H+'"480@5"="3 Hz"\n','set 0':H+'"480@0"="3 Hz"\n','set on single':H+'"549@2"="3 %"\n','readonly':H+'"241"="3 Hz"\n','writeonly':H+'"484"="3 Hz"\n','ctrl':H+'"410"="0x0F"\n','p34':H+'"34"="4444"\n','bus':H+'"1376"="5"\n','bus2':H+'"413"="5 s"\n','p395':H+'"395"="3"\n','refused on drive':H+'"474"="1"\n','toomany decimals':H+'"480"="3.1234 Hz"\n','comma':H+'"480"="3,5 Hz"\n','exp':H+'"480"="1e1 Hz"\n','nan':H+'"480"="nan"\n','inf':H+'"480"=inf\n','float':H+'"480"=3.5\n','int':H+'"372"=1450\n','bool':H+'"372"=true\n','array':H+'"372"=[1]\n','hexint':H+'"372"=0x5AA\n','huge':H+'"372"="99999999999999999999999"\n','huge neg':H+'"480"="-99999999999999"\n','i32 wrap':H+'"480"="raw 4294967295"\n','u16 wrap':H+'"372"="raw 65535"\n','s16 as u':H+'"601"="raw 65535"\n','unicode minus':H+'"480"="−3 Hz"\n','empty val':H+'"480"=""\n','only head':H,
'two ways dep':H+'"480"="3 Hz"\n"480@2"="4 Hz"\n','sig wrong':H.replace('[values]','[saved]\nsignature="0000000000000000"\n[values]')+'"372"="1450"\n','incomplete':H.replace('[values]','[saved]\ncomplete=false\n[values]')+'"372"="1450"\n','undo as load':H+'"372"="1450"\n[undo]\nmemory="eeprom"\n[undo.values]\n"372"="1400"\n','types lie':H.replace('[values]','[types]\n372 = "long"\n[values]')+'"372"="1450"\n','types lie2':H.replace('[values]','[types]\n480 = "uint"\n[values]')+'"480"="3 Hz"\n','types 518int':H.replace('[values]','[types]\n518 = "int"\n[values]')+'"518"="3 %"\n','types 518 ulong?':H.replace('[values]','[types]\n999 = "uint"\n[values]')+'"999"="3"\n',
}
RAW={'utf16':codecs.BOM_UTF16_LE+(H+'"372"="1450"\n').encode('utf-16-le'),'utf8bom':codecs.BOM_UTF8+(H+'"372"="1450"\n').encode(),'latin1':(H+'"372"="1450" # \xe4\n').encode('latin1'),'crlf':(H+'"372"="1450"\n').replace('\n','\r\n').encode(),'cr':(H+'"372"="1450"\n').replace('\n','\r').encode(),'big':(H+'# '+'x'*3000000+'\n"372"="1450"\n').encode(),'zero':b'\0'*5000}
for k,v in C.items(): RAW[k]=v.encode()
d=Drive()
for k,v in RAW.items():
    open(W+'/x.toml','wb').write(v)
    for f in glob.glob(W+'/x.undo*'): os.remove(f)
    d.P=table(); d.clr(); b=d.snap()
    r=run(['dataset','load','x.toml','--yes','--timeout','150ms'],d,limit=60)
    ch={n:(b[n],x) for n,x in d.snap().items() if x!=b[n]}
    ch={n:(x[1][0] if len(set(x[1][0]))>1 else x[1][0][:1]) for n,x in ch.items()}
    e=(r.j or {}).get('error') or {}
    print('%-18s rc=%s t=%.1f n=%d w=%s ended=%s ch=%s | %s | %s'%(k,r.rc,r.t,d.n,[w[1:4] for w in d.wlog],((r.j or {}).get('data') or {}).get('ended'),ch,e.get('message','')[:150],e.get('code'))); 
    if ((r.j or {}).get('data') or {}).get('left_out'): print('    left',json.dumps(r.j['data']['left_out'])[:300])
    for w in (r.j or {}).get('warnings',[]): print('    warn',w['message'][:160])
    if r.j is None: print('   NOJSON',r.out[:200],r.err[:300])
