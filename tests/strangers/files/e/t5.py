from mat import *
import resource
A=HERE+'/adv'; shutil.rmtree(A,ignore_errors=True); os.makedirs(A)
H='antrieb = 1\n[drive]\nfamily = "act"\n'
def short(r): return 'rc=%s t=%.1f %s'%(r.rc,r.t,(r.e.strip().splitlines() or [''])[-1][:330] if r.rc else '')
# hostile files
hf={
'empty':b'','nul':b'\0'*100,'bom':b'\xef\xbb\xbf'+(H+'[values]\n"372@2"="1450"\n').encode(),'utf16':(H+'[values]\n"372@2"="1450"\n').encode('utf-16'),'latin1':(H+'[values]\n"372@2"="1450"  # Pumpe gro\xdf\n').encode('latin-1'),
'crlf':(H+'[values]\n"372@2"="1450"\n').replace('\n','\r\n').encode(),
'nan':(H+'[values]\n"480@2"=nan\n').encode(),'inf':(H+'[values]\n"480@2"=inf\n').encode(),'exp':(H+'[values]\n"480@2"=1e1\n').encode(),'hex':(H+'[values]\n"480@2"="0x4E2"\n').encode(),'bool':(H+'[values]\n"480@2"=true\n').encode(),
'dup0':(H+'[values]\n"480"="5"\n"fixed-frequency-1"="6"\n').encode(),'dup@':(H+'[values]\n"480@2"="5"\n"fixed-frequency-1@2"="6"\n').encode(),'@0':(H+'[values]\n"480@0"="5.5"\n').encode(),'@5':(H+'[values]\n"480@5"="5.5"\n').encode(),'@2ram':(H+'[values]\n"480@2ram"="5.5"\n').encode(),'@02':(H+'[values]\n"480@02"="5.5"\n').encode(),'0480':(H+'[values]\n"0480@2"="5.5"\n').encode(),' 480':(H+'[values]\n" 480@2 "="5.5"\n').encode(),
'thousand':(H+'[values]\n"372@2"="1.450"\n').encode(),'t3000':(H+'[values]\n"372@2"="3.000"\n').encode(),'n3.0':(H+'[values]\n"372@2"=3.000\n').encode(),'komma':(H+'[values]\n"480@2"="12,5 Hz"\n').encode(),'komma3':(H+'[values]\n"372@2"="3,000"\n').encode(),'kHz':(H+'[values]\n"480@2"="0.0125 kHz"\n').encode(),'rpm':(H+'[values]\n"480@2"="100 1/min"\n').encode(),'wrongunit':(H+'[values]\n"480@2"="5 A"\n').encode(),'toodec':(H+'[values]\n"480@2"="5.005"\n').encode(),'huge':(H+'[values]\n"480@2"="1e308"\n').encode(),'neg0':(H+'[values]\n"480@2"="-0"\n').encode(),'raw':(H+'[values]\n"480@2"="raw 1250"\n').encode(),'raw32':(H+'[values]\n"480@2"="raw 4294966046"\n').encode(),
'ver2':H.replace('= 1','= 2').encode(),'ver0':H.replace('= 1','= 0').encode(),'acu':(H.replace('act','acu')+'[values]\n"372@2"="1450"\n').encode(),'novalues':H.encode(),'typo':(H+'[value]\n"372@2"="1450"\n').encode(),'deep':(H+'[values]\n"372@2"='+'['*5000+']'*5000+'\n').encode(),'long':(H+'[values]\n"'+'x'*100000+'"="1"\n').encode(),'esc':(H+'[values]\n"\\u001b[2J480"="1"\n').encode(),'rtl':(H+'[values]\n"480@2"="\\u202e5"\n').encode(),
'types':(H+'[types]\n480 = "int"\n[values]\n"480@2"="6.00"\n').encode(),'types2':(H+'[types]\n372 = "long"\n[values]\n"372@2"="1450"\n').encode(),'incomplete':(H+'[saved]\ncomplete = false\n[values]\n"372@2"="1450"\n').encode(),'sig':(H+'[saved]\nsignature = "0000000000000000"\n[values]\n"372@2"="1450"\n').encode(),
'411':(H+'[values]\n"411"="5"\n').encode(),'410':(H+'[values]\n"410"="15"\n').encode(),'1376':(H+'[values]\n"1376"="9"\n').encode(),'34':(H+'[values]\n"34"="123"\n').encode(),'10':(H+'[values]\n"10"="5"\n').encode(),'unknown':(H+'[values]\n"1599"="5"\n').encode(),'1600':(H+'[values]\n"1600"="5"\n').encode()}
if os.environ.get('HOST','1')=='1':
    for n,c in hf.items():
        d=Drv(); p=A+'/h.toml'; open(p,'wb').write(c); b=d.snap()
        for f in os.listdir(A):
            if 'undo' in f: os.remove(A+'/'+f)
        d.reset(); r=run(d,'dataset','load',p,'--yes',json_=False,timeout=40); print('hostile %-10s %s nw=%d %s'%(n,short(r),d.nw,diffs(b,d.snap())),flush=True); d.stop=True
