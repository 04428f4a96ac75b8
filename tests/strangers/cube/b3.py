from b2 import *
R='--yes sollwert 10Hz --enable --hold --duration 1s'
for n in (7,9,10,11,12,13,14): sh('ulimit -n %d'%n,'ulimit -n %d'%n,R)
for n in (9,10,11): sh('ulimit -n %d trace json'%n,'ulimit -n %d'%n,R+' --trace t%d.rec --force --json'%n)
