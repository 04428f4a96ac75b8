from b1 import *
def ign(d):
    d.d._command=lambda w,n:None; return d
L=True
run(mk(),qs,hook=dbl(2,.3),label='2 doubled after 300',verbose_line=L)
run(mk(),qs+['--json'],hook=dbl(2,.03),label='2 doubled after 30')
run([ign(Cube(RUN,1)),Cube(RUN,2),Lx(3,turning=600.)],qs,label='1 ignores')
run([ign(Cube(RUN,1)),Cube(RUN+'--set 424=300',2),Cube(RUN+'--set 424=300',3)],['-a','1,2,3','statemachine','disable'],label='1 ignores, disable')
