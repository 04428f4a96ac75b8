#!/usr/bin/env python3
"""Exchanges a second over PROFIBUS against what the wire can carry: benches/profibus.py target/release/antrieb

Ours: `monitor --interval 0` on a simulated SJ2-PB (PPO1) in virtual time, so the ratio is that of the protocol alone and the same on every machine.
pyprofibus: the same slave on a pseudo terminal in real time (tests/peers/pyprofibus_master.py), where it is installed.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

# PPO1 in SD2, there and back: 12 bytes of data and 9 around them, of 11 bits each; T_SYN before, the least T_SDR between (IEC 61158-4-3).
BITS = 2 * (12 + 9) * 11 + 33 + 11
COUNT = 2000
RATES = [9600, 19200, 93750, 187500, 500000]
LINE = """
[line]
baud = {}
[[module]]
drive = "l200"
address = 3
set = {{ "703" = 2 }}
"""


def ours(program, baud, directory):
    """Exchanges a second, by the time of the line."""
    file = directory / f"{baud}.toml"
    file.write_text(LINE.format(baud))
    words = ["--no-config", "-p", f"sim:{file}", "--protocol", "dp", "--baud", baud, "-a", 3, "--yes", "--format", "ndjson"]
    words += ["monitor", "968", "--interval", 0, "--count", COUNT, "--unpaced"]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=True)
    times = [record["t"] for record in map(json.loads, done.stdout.splitlines()) if record["type"] == "sample"]
    return (len(times) - 1) / (times[-1] - times[0])


def main(program):
    with tempfile.TemporaryDirectory() as directory:
        for baud in RATES:
            limit, rate = baud / BITS, ours(program, baud, Path(directory))
            print(f"{baud:7} Bd: {rate:6.1f} of {limit:6.1f} exchanges/s: {rate / limit:.2f}")


if __name__ == "__main__":
    main(sys.argv[1])
