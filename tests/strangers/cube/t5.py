from judge import *
d=Drive(life=40,p412=1,ascii=1,log='log/t5.log'); r=Run(['--protocol','ascii','identify','-v'],d,json_=False); print(r.err[:5000]); e=r.atend; print(len(e['viol']),e['viol']); d.stop()
d=Drive(life=40,p412=1,ascii=1,log='log/t5b.log'); r=Run(['--protocol','ascii','read','@actual','372@1','372@2'],d,json_=False); e=r.atend; print(len(e['viol']),e['viol']); d.stop()
