timeout 300 ${ANTRIEB:-antrieb} simulate vb.toml --link ./vbtty > o.sim 2>&1 & SP=$!
sleep 4
S=$(date +%s.%N); timeout 290 ${ANTRIEB:-antrieb} -p ./vbtty --baud auto --parity auto --protocol auto scan --until-first --within 4m > o.vb 2> e.vb; echo "vb rc=$? t=$(echo "$(date +%s.%N)-$S"|bc)" > r.vb
kill $SP
