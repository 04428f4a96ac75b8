"""PROFIBUS-DP with pyprofibus as the master of our simulated SJ2-PB, on a pseudo terminal: `pyprofibus_master.py`, a process of its own."""

import json
import signal
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

from harness import BENCH_LIFE, BINARY, Failed, Running, antrieb, expect, group, run

case = group("profibus")

MASTER = Path(__file__).with_name("pyprofibus_master.py")
IDENT = "0BE7"
# The ramp of the start is short, so that the wire and not the motor takes the time; a lost master stops the motor.
LINE = """
[line]
baud = {}

[[module]]
drive = "l200"
address = 3
ident = 0x{}
set = {{ "703" = 2, "7" = -100, "9" = -100 }}
"""


@contextmanager
def simulated(baud):
    """Our line on a pseudo terminal."""
    with tempfile.TemporaryDirectory(prefix="antrieb-peers-") as directory:
        file = Path(directory) / "line.toml"
        file.write_text(LINE.format(baud, IDENT))
        words = ["simulate", "--profibus", "--link", Path(directory) / "line", "--for", BENCH_LIFE, file]
        with Running([BINARY, "--no-config", "--json", *words]) as bench:
            bench.wait_for("serving on ")
            yield bench.output()[1].split("serving on ")[1].split(";")[0]
            expect("motors that turn in the end", bench.end(signal.SIGINT).exits(0).data["turning"], 0)


@case("pyprofibus leads our slave to Data_Exchange and moves the motor, {} baud", {baud: (baud,) for baud in (19200, 500000)})
def _(baud):
    with simulated(baud) as port:
        # Warnings of pyprofibus go to stdout, too.
        came = json.loads(run(sys.executable, MASTER, port, baud, 3, IDENT).exits(0).out.splitlines()[-1])
        expect("AK of the answer to P.928 = 1", came["answered"], 1)
        expect("the frequency of a motor that stands", came["standing"], 0)
        if not came["ready"] & 0x0200 or not 0x1FF0 <= came["fastest"] <= 0x2010:
            raise Failed(f"expected control from the bus and half of A004, got {came}")
        # It left its slave to its watchdog: ours is the next master.
        ours = antrieb(port, "--baud", baud, "-a", 3, "--yes", "profibus", "read", 614, 703).exits(0)
        expect("P.614 and P.703", [row["raw"] for row in ours.data["values"]], [0, 2])
