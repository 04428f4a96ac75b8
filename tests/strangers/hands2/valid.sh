#!/bin/bash
# Is what a verb prints what its schema says, and its exit code that of the process? valid.sh VERB WORDS…  (valid.sh read -p sim -a 1 read 372)
ANTRIEB=${ANTRIEB:-antrieb}; PYTHON=${PYTHON:-python3}; verb=$1; shift; at=$(mktemp -d)
"$ANTRIEB" schema "$verb" > "$at/schema"; "$ANTRIEB" "$@" --json > "$at/document" 2> /dev/null < /dev/null; code=$?
"$PYTHON" - "$at" $code "$*" << 'P'
import json, sys
import jsonschema
at, code, line = sys.argv[1:]
document = json.load(open(f"{at}/document"))
jsonschema.validate(document, json.load(open(f"{at}/schema")))
said = (document.get("error") or {}).get("exit", 0)
print("ok" if said == int(code) else f"EXIT DIFFERS: {said}", code, line)
P
