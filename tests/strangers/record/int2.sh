B=$(realpath "${ANTRIEB:-target/debug/antrieb}"); here=$(dirname "$(realpath "$0")"); cd "$(mktemp -d)"; cp "$here"/*.toml .
timeout 280 $B simulate res.toml --link ./ttyR --duration 200s > simR.log 2>&1 & S=$!
sleep 1
A="-p ./ttyR -a 1 procedure resolver-offset resolver-pairs=1 current=3.6A --yes --record ri2.json"
rm -f ri2.json
R="$B -p ./ttyR -a 1 read 411 417 728 210 417@0ram 728@0ram 382@1ram 382@1 434@1ram 413@ram 766@1 260"
$R
$B $A > r1.out 2> r1.err & P=$!; while ! grep -q '\[7/8\]' r1.err; do sleep 0.2; done; sleep 5; kill -9 $P; wait $P; echo "KILL rc=$?"; $R; sleep 5; $R | head -3
$B $A > r2.out 2> r2.err; echo "resume rc=$?"; tail -2 r2.err
sleep 12; $B -p ./ttyR -a 1 statemachine reset --yes 2>&1 | tail -3
$B $A --again > r3.out 2> r3.err; echo "again rc=$?"; tail -3 r3.err; grep -A8 "7  " r3.out
$R
kill -INT $S; wait $S
