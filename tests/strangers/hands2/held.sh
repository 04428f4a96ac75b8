#!/bin/bash
# Ends held runs at random moments, and looks whether they left the drive as it was: held.sh SIGNAL COUNT [double]
# The state has to be switched-on, P.210 to be 0, P.412, P.434, P.484 and P.413 as before.
ANTRIEB=${ANTRIEB:-antrieb}; WD=${WD:-$(mktemp -d)}; signal=${1:-INT}; count=${2:-10}; double=$3
cd "$WD" || exit 1
"$ANTRIEB" simulate --link "$WD/line" > simulate.log 2>&1 & bench=$!; trap 'kill $bench' EXIT
until [ -e line ]; do sleep 0.1; done
values() { "$ANTRIEB" -p line -a 1 read 210 412@1ram 434@1ram 484 413@ram --json 2> /dev/null | jq -r '[.data.values[]|.value]|join(" ")'; }
before=$(values)
for i in $(seq "$count"); do
  after=$(awk -v s=$RANDOM 'BEGIN{srand(s); printf "%.3f", 0.1+rand()*3}')
  setsid "$ANTRIEB" -p line -a 1 sollwert 15Hz --enable --hold --take-control --source line --watchdog 2s --yes --json > out 2> err < /dev/null & run=$!
  sleep "$after"; kill -"$signal" $run 2> /dev/null
  [ "$double" ] && { sleep 0.$((RANDOM % 60 + 10)); kill -"$signal" $run 2> /dev/null; }
  wait $run; code=$?
  state=$("$ANTRIEB" -p line -a 1 state --json 2> /dev/null | jq -r '.data.drives[0].state.slug'); now=$(values)
  echo "$i after=$after code=$code $(jq -c '[.data.stop.acknowledged?,.data.stop.standstill?,.error.message]' out) $state [$now]"
  [ "$state" = switched-on ] && [ "$now" = "$before" ] || echo "   odd: before it was [$before]"
done
