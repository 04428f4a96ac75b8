#!/bin/bash
# Ends a load at random moments, looks what the drive holds, and takes it back: load.sh SIGNAL COUNT [double]
# What the report says (`ended`), what a check finds, and what an undo leaves must agree; a line with !!! or odd does not.
here=$(dirname "$(realpath "$0")"); ANTRIEB=${ANTRIEB:-antrieb}; WD=${WD:-$(mktemp -d)}; signal=${1:-INT}; count=${2:-10}; double=$3
cd "$WD" || exit 1
cp "$here/base.toml" "$here/new.toml" .
"$ANTRIEB" simulate --link "$WD/line" > simulate.log 2>&1 & bench=$!; trap 'kill $bench' EXIT
until [ -e line ]; do sleep 0.1; done
"$ANTRIEB" -p line -a 1 dataset load base.toml --yes > /dev/null 2>&1; rm -f ./*undo*
for i in $(seq "$count"); do
  rm -f ./*undo*
  after=$(awk -v s=$RANDOM 'BEGIN{srand(s); printf "%.3f", 0.05+rand()*3.2}')
  setsid "$ANTRIEB" -p line -a 1 dataset load new.toml --yes --json > out 2> err < /dev/null & load=$!
  sleep "$after"; kill -"$signal" $load 2> /dev/null
  [ "$double" ] && { sleep 0.$((RANDOM % 40 + 10)); kill -"$signal" $load 2> /dev/null; }
  wait $load; code=$?
  ended=$(jq -r '[.. | .ended? // empty] | join(",")' out 2> /dev/null)
  "$ANTRIEB" -p line -a 1 dataset check base.toml > /dev/null 2>&1; base=$?
  "$ANTRIEB" -p line -a 1 dataset check new.toml > /dev/null 2>&1; new=$?
  undo=-
  if [ $base != 0 ]; then
    ls ./*undo* > /dev/null 2>&1 || echo "!!! changed, and no undo file"
    "$ANTRIEB" -p line -a 1 dataset undo new.undo.toml --yes > undone 2>&1; undo=$?
    "$ANTRIEB" -p line -a 1 dataset check base.toml > /dev/null 2>&1 || echo "!!! not as before behind the undo"
  fi
  echo "$i after=$after code=$code ended=$ended base=$base new=$new undo=$undo"
  case "$code:$ended:$base:$new" in
    130:untouched:0:1 | 130:back:0:1 | 9:back:0:1 | 0:done:1:0 | 137:* | 143:*) ;;
    *) echo "   odd" ;;
  esac
done
