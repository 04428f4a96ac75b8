from h import *
class Echo(ad.DriveServer):
    delay=0.016
    def _heard(self,data,now):
        self.at(now+self.delay,lambda t:self._write(data))
        super()._heard(data,now)
for delay in (0.004,0.016,0.025,0.04,0.06):
    for i in range(2):
        d=act('--address 7',Echo); d.delay=delay
        with d:
            r=run(d,['scan','-a','1-12','--json'],limit=60,after=0); show(f'echo after {delay*1000:.0f} ms scan',r)
            try: doc=json.loads(r['out']); print('   found',[x['address'] for x in (doc['data'] or {}).get('drives',[])], doc['error'] and doc['error']['code'], r['err'].replace('\n',' / ')[:420])
            except Exception as e: print('  ',e,r['out'][:200],r['err'][-200:])
