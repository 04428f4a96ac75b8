from nov import *
for k in (dict(),dict(turning=600.)):
  for a in (['sollwert','0'],['statemachine','quick-stop'],['statemachine','disable']):
    run([Lx(1,fc43='refused',**k)],['-a','1']+a,label=str(k))
run([Lx(1,fc43='silent',turning=600.)],['-a','1','sollwert','0'],label='fc43 silent')
