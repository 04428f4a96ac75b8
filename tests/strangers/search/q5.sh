rm -f p.res; python3 line.py '{"life":700,"log":"l.res","drives":[{"addr":60,"baud":2400,"parity":"even"},{"addr":3,"baud":38400,"parity":"odd"}]}' > p.res & LP=$!
for i in 1 2 3 4 5 6; do sleep 1; [ -s p.res ] && break; done; P=$(cat p.res)
A=${ANTRIEB:-antrieb}
OLD=$(jq -r .data.port o.res1); sed "s#$OLD#$P#g" o.res1 > o.res1b
S=$(date +%s.%N); timeout 60 $A -p $P scan --resume o.res1b > o.res3 2> e.res3; echo "res3 (table, no auto) rc=$? t=$(echo "$(date +%s.%N)-$S"|bc)" >> r.res
S=$(date +%s.%N); timeout 560 $A -p $P --baud auto --parity auto --protocol auto --json scan --resume o.res1b > o.res4 2> e.res4; echo "res4 rc=$? t=$(echo "$(date +%s.%N)-$S"|bc)" >> r.res
kill $LP
