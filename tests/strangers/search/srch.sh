# name cfgjson args... : runs one search
N=$1; rm -f p.$1; CFG=$2; shift 2
python3 line.py "$CFG" > p.$N & LP=$!; for i in 1 2 3 4 5 6 7 8 9; do sleep 1; [ -s p.$N ] && break; done; P=$(cat p.$N)
S=$(date +%s.%N); timeout 590 ${ANTRIEB:-antrieb} -p $P --baud auto --parity auto --protocol auto "$@" >o.$N 2>e.$N; RC=$?; E=$(date +%s.%N)
echo "== $N rc=$RC t=$(echo "$E-$S"|bc)"; head -c 3000 o.$N; head -1 e.$N; grep -v "nobody; found" e.$N | head -30 | cut -c1-400; tail -2 e.$N | cut -c1-300
kill $LP 2>/dev/null; wait $LP 2>/dev/null
