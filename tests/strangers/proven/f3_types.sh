#!/bin/sh
# a file saved from a drive whose firmware has P.480 in 16 bits ([types] 480 = "word"), loaded into a drive with the catalogue's 32 bits
B=$(realpath "$ANTRIEB"); cd $(mktemp -d)
printf '[[drive]]\nmodel="acu"\naddress=1\nmodules=["EM-RES-03"]\nother_width=[480]\nset={"480"=8}\n[[drive]]\nmodel="acu"\naddress=2\nmodules=["EM-RES-03"]\n' > ow.toml
$B --no-config -p sim:ow.toml -a 1 dataset save a.toml >/dev/null; grep 480 a.toml
$B --no-config -p sim:ow.toml -a 2 dataset check a.toml | tail -4
$B --no-config -p sim:ow.toml -a 2 -v dataset load a.toml --yes; echo rc $?
