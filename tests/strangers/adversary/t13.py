from h import *
for i in range(2):
  with act('--stiff') as d:
    r=run(d,[a.replace('6s','1s') for a in RUN]+['--until','reached','--json'],limit=40,after=1); show('stiff until reached duration 1s',r); print('  ',r['err'][-400:])
  d=act('--set 420=100')   # slow ramp 1 Hz/s
  with d:
    r=run(d,['-a','1','sollwert','20Hz','--source','line','--jog','1s','--until','reached','--yes','--json'],limit=60,after=1); show('jog 1s until reached, ramp 1 Hz/s',r); print('  ',r['err'][-400:], d.report()['history'])
