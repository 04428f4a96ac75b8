from h import *
class Gate(ad.DriveServer):
    """from `cut` s after enabling (or from the start) the drive hears nothing, and a gateway answers exception `code` to everything"""
    code=11; cut=0.5
    def _heard(self,data,now):
        f=self.drive.first_enabled
        if (self.cut is None or (f is not None and now>f+self.cut)) and len(data)>=4:
            self.drive.advance(now); self.log.append((now-self.born,'<',data))
            r=ad.with_crc(bytes([data[0],data[1]|0x80,self.code]))
            self.at(now+0.02,lambda t:self._write(r)); return
        super()._heard(data,now)
def one(n,code,cut,opts,args,base='enabled'):
    d=act(opts,Gate); d.code=code; d.cut=cut
    with d:
        r=run(d,args+['--json'],limit=70,after=0.5,base=base)
        show(n,r)
        try:
            x=json.loads(r['out']); D=x['data'] or {}; e=x['error'] or {}; print('   ',e.get('message'),'|',e.get('hint'),'| running',D.get('running'),'standing',D.get('standing'),'stop',D.get('stop'),'notes',D.get('notes'))
        except Exception as ex: print('  nodoc',r['out'][:200],r['err'][-300:])
for code in (11,6,4,10):
    one(f'run, gateway answers {code} from 0.5 s on',code,0.5,'',[a.replace('6s','2s') for a in RUN])
for v in (['statemachine','quick-stop'],['statemachine','disable-voltage'],['sollwert','0']):
    for fam in ([],['--drive','act']):
        one(f'running, gateway answers 11 to all: {fam} {v}',11,None,'--running --left 20',fam+['-a','1']+v,base='start')
one('statemachine show',11,None,'--running --left 20',['--drive','act','-a','1','statemachine'],base='start')
one('monitor-like identify',11,None,'--running --left 20',['-a','1','identify'],base='start')
