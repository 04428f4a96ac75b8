bash srch.sh noise5 '{"life":300,"log":"l.noise5","drives":[{"addr":5,"baud":19200,"parity":"even"}],"noise":{"gap":1.0,"n":6}}' scan --within 60s > r.noise5 2>&1
bash srch.sh noise5b '{"life":300,"log":"l.noise5b","drives":[{"addr":5,"baud":19200,"parity":"even"}],"noise":{"gap":1.3,"n":2}}' scan --until-first --within 60s > r.noise5b 2>&1
