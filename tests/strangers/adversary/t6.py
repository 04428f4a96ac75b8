from h import *
for o in ('--twin 4','--twin 100','--twin 30'):
  for i in range(2):
    with act(o) as d:
        r=run(d,['-a','1','read','372@all','480-482@2','411','1376','413'],after=0); show(o,r,True)
