rm -f p.res; python3 line.py '{"life":700,"log":"l.res","drives":[{"addr":60,"baud":2400,"parity":"even"},{"addr":3,"baud":38400,"parity":"odd"}]}' > p.res & LP=$!
for i in 1 2 3 4 5 6; do sleep 1; [ -s p.res ] && break; done; P=$(cat p.res)
A=${ANTRIEB:-antrieb}
S=$(date +%s.%N); timeout -s INT 25 $A -p $P --baud auto --parity auto --protocol auto --json scan > o.res1 2> e.res1; echo "res1 rc=$? t=$(echo "$(date +%s.%N)-$S"|bc)" > r.res
S=$(date +%s.%N); timeout 480 $A -p $P --json scan --resume o.res1 > o.res2 2> e.res2; echo "res2 rc=$? t=$(echo "$(date +%s.%N)-$S"|bc)" >> r.res
kill $LP
