from nov import *
for a in (['sollwert','0'],['statemachine','quick-stop'],['statemachine','disable'],['sollwert','300rpm','--enable','--hold','--duration','800ms','--yes']):
    run([Lx(1,product='other',**(dict(turning=600.) if len(a)<4 else {}))],['-a','1']+a,label='product other')
# lost code 43 replies
def lose43(n):
    st=[0]
    def h(c,f,r,now,d):
        if f[1]==0x2B: 
            st[0]+=1
            if st[0]<=n: return []
        return [(.01,r)]
    return h
for n in (1,3): run([Lx(1,turning=600.)],['-a','1','statemachine','quick-stop'],hook=lose43(n),label='%d code-43 replies lost'%n)
run([Lx(1,turning=600.)],['-a','1','sollwert','0'],hook=lose43(3),label='3 code-43 replies lost, sollwert 0')
run([Lx(1)],['-a','1','identify'],hook=lose43(1),label='identify')
run([Lx(1)],['-a','1','identify'],hook=lose43(3),label='identify 3')
