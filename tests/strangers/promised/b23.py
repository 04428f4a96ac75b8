from nov import *
R='--set 418=0 --running --left 20 '
for i in (1,2): run([Cube(R+'--set 638=10 --set 424=500')],['--drive','acu','-a','1','statemachine','quick-stop'],triggers=[(W('P410',.35),INT)],label='Ctrl-C .35 s behind the first word',maxt=30)
run([Cube(R+'--set 638=10 --set 424=500')],['-a','1','statemachine','quick-stop'],triggers=[(W('P410',.35),INT)],label='the same without --drive',maxt=30)
# held run with --drive: is its stop proven?
run([Cube('--set 418=0 --set 638=5')],['--drive','acu','-a','1','sollwert','10Hz','--source','line','--enable','--hold','--duration','1s','--yes'],label='held run --drive')
