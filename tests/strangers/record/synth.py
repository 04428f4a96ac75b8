import math,sys
z,wn,dt,step,td=float(sys.argv[1]),4.0,float(sys.argv[2]),20.0,0.3
def y(t):
    t-=1.0+td
    if t<=0: return 10.0
    wd=wn*math.sqrt(1-z*z)
    return 10+step*(1-math.exp(-z*wn*t)*(math.cos(wd*t)+z/math.sqrt(1-z*z)*math.sin(wd*t)))
print("t,n,address,drive,state,status-word,status-word_bits,ramp-reference-frequency,stator-frequency,rms-current,current-fault,warnings,warnings_bits,error")
n=0; t=0.0
vals=[]
while t<12:
    sp=10 if t<1.0-1e-9 else 30
    print(f"{t:.3f},{n},1,act,operation-enabled,0x0627,,{sp:.2f},{y(t):.2f},{1.5+0.1*math.sin(t):.1f},0,0x0000,,")
    vals.append((t,round(y(t),2))); n+=1; t=n*dt
p=max(v for _,v in vals); last=vals[-1][1]
print("OS",(math.exp(-math.pi*z/math.sqrt(1-z*z)))*100,"sampled OS",(p-30)/20*100,file=sys.stderr)
ts=max(t for t,v in vals if abs(v-30)>0.4); print("settle (last outside)",ts-1.0,file=sys.stderr)
t10=min(t for t,v in vals if v>=12); t90=min(t for t,v in vals if v>=28); print("slope ~",16/(t90-t10),"t10,t90",t10,t90,file=sys.stderr)
a=sum((b[0]-a[0])*(a[1]+b[1])/2 for a,b in zip(vals,vals[1:]))/(vals[-1][0]-vals[0][0])
r=math.sqrt(sum((b[0]-a[0])*(a[1]**2+a[1]*b[1]+b[1]**2)/3 for a,b in zip(vals,vals[1:]))/(vals[-1][0]-vals[0][0]))
print("mean",a,"rms",r,file=sys.stderr)
