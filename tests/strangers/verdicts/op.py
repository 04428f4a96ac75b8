from mm import *
O='--family acu --set 418=0 --set 638=5 '
W=lambda *a: ['write',*a,'--yes']
go('write 434@1ram=3 internal -30, enabled at 0',W('434@1ram=3'),O+'--running --set 434=2 --internal -30 ',rep=1)
go('write 414=2 (data set), enabled',W('414@ram=2'),O+'--running --set 434@1=2 --set 434@2=3 --internal -30 ',rep=1)
go('dataset select 2',['dataset','select','2','--yes'],O+'--running --set 434@1=2 --set 434@2=3 --internal -30 ',rep=1)
go('write 421 ramp',W('423@1ram=1Hz/s'),O+'--running --left 10 --set 434=2 ',rep=1)
go('reset with word 0F and level',['statemachine','reset','--yes'],O+'--fault 0x0500 --fault-age 20 --word 15 --left 20 --set 434=2 ',rep=1)
go('write 484=0 enabled',['write','484=0'],O+'--running --left 10 --set 434=2 ',rep=1)
go('write 410=0',['write','410=0'],O+'--running --left 10 --set 434=2 ',rep=1)
go('write 410=2 broadcast',['write','410=2'],O+'--running --left 10 --set 434=2 ',rep=1)
