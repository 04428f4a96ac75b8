from judge import *
Y=['--yes']; A=['--protocol','ascii']; one=dict(p412=1,ascii=1); c=lambda s:(lambda r,d:d.cmd(s))
case('f 30% 434=2 today',Y+['sollwert','30%','--enable','--hold','--duration','2s'],dict(p412=1,p434=2),json_=False,show=True)
case('f profile 434=2 today',Y+['sollwert','--profile','/tmp/nov22.prof','--enable','--hold','--duration','4s'],dict(p412=1,p434=2),json_=False,show=True)
R=A+Y+['sollwert','10Hz','--enable','--hold','--duration','3s']
case('asc silent 3s',R,one,at=[(2,c('silent 3'))]); case('asc babble',R,one,at=[(2,c('babble 3'))]); case('asc garble',R,one,at=[(2,c('garble 5'))]); case('asc drop',R,one,at=[(2,c('drop 4'))]); case('asc INT',R,one,at=[(2,lambda r,d:INT(r))]); case('asc dead',R,one,at=[(2,c('dead'))],after=1); case('asc stop babble',A+['statemachine','quick-stop'],one,pre=['p 484 2000','set cw 15',2,'babble 20'],limit=60)
