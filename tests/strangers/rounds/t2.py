from line import *
import sys
def tele(R,n=60):
    for l in R.log[:n]: print('    %.3f %s %s'%l)
w=sys.argv[1]
if w=='sw':
    run([Act(1),Act(2)],['-a','1,2','sollwert','0'])
    run([Act(1),Act(2)],['-a','1,2','sollwert','0','--lang','de','--json'])
    run([Act(1)],['-a','1','sollwert','0'])
