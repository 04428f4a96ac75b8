from h import *
import random
class Torn(ad.DriveServer):
    split=3; gap=0.1; every=1; n=0
    def _send(self,data,begin,duration,mine):
        self.n+=1
        if self.n%self.every or len(data)<=self.split: return super()._send(data,begin,duration,mine)
        k=self.split; a,b=data[:k],data[k:]
        if mine: self.at(begin+duration,lambda t:self._write(a))
        def rest(t):
            self._write(b)
            if mine: self.reply_end=time.monotonic()
        self.at(begin+duration+self.gap,rest)
WANT={(480,2):500,(481,2):1000,(482,2):2500,(372,1):1390,(372,2):1390,(413,0):0}
def main(proto):
    bad=0;n=0
    lens={'rtu':range(1,9,2),'ascii':range(1,17,4),'vabus':range(1,12,3)}[proto]
    for every in (1,3):
      for k in lens:
        for gap in (0.05,0.2,0.45,0.52,0.9,1.6):
            def mk():
                d=act(f'--protocol {proto}',Torn); d.split=k; d.gap=gap; d.every=every; return d
            with mk() as d:
                r=run(d,['--protocol',proto,'--drive','act','-a','1','read','480@2','481@2','482@2','372@1','372@2','413','--json'],limit=60,after=0)
            n+=1
            try: doc=json.loads(r['out'])
            except Exception: doc=None
            msgs=[]
            if r['hang']: msgs.append('HANG')
            if doc is None: msgs.append('no doc')
            else:
                for v in (doc.get('data') or {}).get('values',[]):
                    if v.get('raw') is not None and v.get('error') is None and WANT.get((v['param'],v['data_set'])) != v['raw']: msgs.append(f"WRONG {v['param']}@{v['data_set']}={v['raw']}")
                if doc['ok']!=(r['code']==0): msgs.append('ok/exit')
            if r['code'] not in (0,4,5,9): msgs.append('exit %d'%r['code'])
            if r['s']>25: msgs.append('slow %.1f'%r['s'])
            if msgs: bad+=1; print(proto,every,k,gap,r['code'],r['s'],msgs,r['err'][-200:],flush=True)
    print(proto,n,'cases',bad,'bad',flush=True)
main(sys.argv[1])
