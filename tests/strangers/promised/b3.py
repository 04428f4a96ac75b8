from b2 import *
run([Cube(RUN+'--set 434=2 --set 638=10')],['--drive','acu','-a','1','sollwert','0'],hook=L(.4),label='zero .4',verbose_line=True)
run([Cube(RUN+'--set 434=2 --set 638=10')],['-a','1','sollwert','0'],hook=L(.4),label='zero .4 auto')
run([Cube(RUN+'--set 434=2 --set 638=10')],['-a','1','sollwert','0'],hook=L(.3),label='zero .3 auto')
run([Cube(RUN+'--set 434=2 --set 638=10')],['-a','1','--timeout','1s','sollwert','0'],hook=L(.4),label='zero .4 timeout 1s')
run([Lx(1,turning=600.)],['-a','1','sollwert','0'],hook=L(.4),label='lx zero .4')
run([Cube(RUN+'--set 434=2 --set 638=20')],['-a','1','statemachine','quick-stop'],hook=L(.4),label='qs .4 auto hold 2 s',verbose_line=True)
