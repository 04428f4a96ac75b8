bash srch.sh babble '{"life":300,"log":"l.babble","drives":[{"addr":1,"baud":19200,"parity":"even"}],"noise":{"gap":0.05,"n":6}}' scan --within 40s > r.babble 2>&1
bash srch.sh babble2 '{"life":300,"log":"l.babble2","drives":[],"noise":{"gap":1.0,"n":6}}' --json scan --within 30s > r.babble2 2>&1
bash srch.sh ascii '{"life":300,"log":"l.ascii","drives":[{"addr":60,"baud":4800,"parity":"odd","ascii":1},{"addr":7,"baud":4800,"parity":"odd","ascii":1}]}' -a 1-70 scan --until-first --within 5m > r.ascii 2>&1
