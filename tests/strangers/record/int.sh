B=$(realpath "${ANTRIEB:-target/debug/antrieb}"); here=$(dirname "$(realpath "$0")"); cd "$(mktemp -d)"; cp "$here"/*.toml .
timeout 280 $B simulate com1.toml --link ./ttyC --duration 270s > simC.log 2>&1 & S=$!
sleep 1
A="-p ./ttyC -a 1 procedure commission power=0.8kW voltage=400V current=2A frequency=50Hz speed=1390rpm --yes --record ci.json"
rm -f ci.json
$B $A > i1.out 2> i1.err & P=$!; while ! grep -q '\[6/9\]' i1.err; do sleep 0.2; done; sleep 3; kill -INT $P; wait $P; echo "INT rc=$?"; $B -p ./ttyC -a 1 read 411 210 412@1ram 434@1ram 413@ram --csv 2>/dev/null || $B -p ./ttyC -a 1 read 411 210 412@1ram 434@1ram 413@ram
$B $A > i2.out 2> i2.err; echo "plain resume rc=$?"; tail -3 i2.err
$B $A --again > i3.out 2> i3.err & P=$!; while ! grep -q '\[6/9\]' i3.err; do sleep 0.2; done; sleep 3; kill -9 $P; wait $P; echo "KILL rc=$?"; sleep 1;  $B -p ./ttyC -a 1 read 411 210 412@1ram 434@1ram 413@ram; sleep 4; $B -p ./ttyC -a 1 read 411 210 260
python3 -c "import json;d=json.load(open('ci.json'));print('record ok', d.keys() if isinstance(d,dict) else '')"
$B $A > i4.out 2> i4.err; echo "resume after kill rc=$?"; tail -4 i4.err
$B $A --again > i5.out 2> i5.err; echo "again rc=$?"; tail -4 i5.err
$B -p ./ttyC -a 1 read 411 210 260 412@1ram 434@1ram 413@ram
sleep 14;  $B -p ./ttyC -a 1 statemachine reset --yes 2>&1 | tail -3
$B $A --again > i6.out 2> i6.err; echo "again rc=$?"; tail -4 i6.err
$B $A > i7.out 2> i7.err; echo "once more rc=$?"; 
$B -p ./ttyC -a 1 read 411 210 260 412@1ram 434@1ram 413@ram
kill -INT $S; wait $S
