from g3 import *
def play(s,seq,dur):
    def f():
        t=time.monotonic()
        while time.monotonic()-t<dur and not s.stopme:
            for b,gap in seq:
                s.raw(b); time.sleep(len(b)*11*s.bit+gap)
    threading.Thread(target=f,daemon=True).start()
req=sd2(9,2,0x7D,bytes.fromhex('0000000000000000047f2000')); rep=sd2(2,9,0x08,bytes.fromhex('000000000000000007372000'))
fdl=b'\x10\x0b\x02\x49\x56\x16'; fdlr=b'\x10\x02\x09\x00\x0b\x16'
for nm,seq in (('tok only',[(TOK,.02)]),('req rep tok',[(req,.001),(rep,.004),(TOK,.02)]),('req rep tok gap40',[(req,.001),(rep,.04),(TOK,.02)]),('fdl tok',[(fdl,.03),(TOK,.02)]),('req tok (no reply)',[(req,.03),(TOK,.02)]),('sc tok',[(sd2(9,2,0x7D,b'\xf3\xf1',62,62),.001),(b'\xE5',.01),(TOK,.02)]),('tok to other 2>4',[(bytes.fromhex('dc0402'),.01),(bytes.fromhex('dc0204'),.02)])):
    s=Slave('h3'); s.start(); play(s,seq,4)
    r=run(s,quiet=True,raw=[BIN,'-p',s.path,'--protocol','dp','--baud','19200','--no-config','sniff','--cfg','ppo1','--duration','1500ms']); s.close()
    L=r.out.splitlines(); print('##',nm,r.err.strip()[-80:]); 
    for x in L[:6]: print('   ',x[:120])
