#!/usr/bin/env python3
"""Exchanges a second over PROFIBUS against what the wire can carry: benches/profibus.py target/release/antrieb

First `monitor --interval 0` on a simulated SJ2-PB (PPO1) in virtual time: the ratio is that of the protocol alone, and the same on every machine.
Then ours, pyprofibus (tests/peers/requirements.txt) and profirust (benches/beside), where they are to be had, with the same slave on a pseudo
terminal, in real time: what the machine and the pieces in which a pseudo terminal hands bytes over cost, it costs all. profirust pauses between two
looks as its documentation recommends for adapters, and once more for 50 us only.
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "peers"))
try:
    from pyprofibus_master import Drive
except ImportError:
    Drive = None

# PPO1 in SD2, there and back: 12 bytes of data and 9 around them, of 11 bits each; T_SYN before, the least T_SDR between (IEC 61158-4-3).
BITS = 2 * (12 + 9) * 11 + 33 + 11
COUNT = 2000
SECONDS = 5
IDENT = 0x0BE7
PROFIRUST = Path(__file__).resolve().parents[1] / "target/beside/release/profirust"
RATES = [9600, 19200, 93750, 187500, 500000]
LINE = """
[line]
baud = {}
[[module]]
drive = "l200"
address = 3
set = {{ "703" = 2 }}
"""


def ours(program, baud, port, *ends):
    """Exchanges a second, by the time of the line."""
    words = ["--no-config", "-p", port, "--protocol", "dp", "--baud", baud, "-a", 3, "--yes", "--format", "ndjson"]
    words += ["monitor", "968", "--interval", 0, *ends]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=True)
    times = [record["t"] for record in map(json.loads, done.stdout.splitlines()) if record["type"] == "sample"]
    return (len(times) - 1) / (times[-1] - times[0])


def theirs(baud, port):
    """The same with pyprofibus, by the clock."""
    drive = Drive(str(port), baud, 3, IDENT)
    drive.until("Data_Exchange", lambda *_: True)
    before, begun = drive.exchanges, time.monotonic()
    drive.until("its time", lambda *_: time.monotonic() - begun >= SECONDS)
    return (drive.exchanges - before) / (time.monotonic() - begun)


def in_rust(baud, port, environment):
    """The same with profirust."""
    words = [PROFIRUST, port, baud, 3, hex(IDENT), SECONDS]
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, env={**os.environ, **environment})
    return done.stdout.strip() or done.stderr.strip()


@contextmanager
def served(program, file, port):
    """The line of a file on a pseudo terminal."""
    words = ["--no-config", "simulate", "--profibus", "--link", port, file]
    bench = subprocess.Popen([program, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        deadline = time.monotonic() + SECONDS
        while not port.exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        yield
    finally:
        bench.send_signal(signal.SIGINT)
        bench.wait()


def main(program):
    with tempfile.TemporaryDirectory() as directory:
        for baud in RATES:
            file, port = Path(directory) / f"{baud}.toml", Path(directory) / f"line-{baud}"
            file.write_text(LINE.format(baud))
            limit, rate = baud / BITS, ours(program, baud, f"sim:{file}", "--count", COUNT, "--unpaced")
            print(f"{baud:7} Bd: {rate:6.1f} of {limit:6.1f} exchanges/s: {rate / limit:.2f}", end="", flush=True)
            with served(program, file, port):
                told = [f"ours {ours(program, baud, port, '--for', f'{SECONDS}s'):.1f}"]
                try:
                    told += [f"pyprofibus {theirs(baud, port):.1f}"] if Drive else []
                except SystemExit as why:
                    told += [f"pyprofibus: {why}"]
            for name, environment in [("profirust", {}), ("without its pauses", {"SPIN": "1"})] if PROFIRUST.is_file() else []:
                with served(program, file, port):
                    told.append(f"{name} {in_rust(baud, port, environment)}")
            print(f"; on a pseudo terminal: {', '.join(told)}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
