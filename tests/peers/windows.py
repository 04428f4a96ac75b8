"""Our program for Windows under Wine, its serial ports being pseudo terminals with our bench behind them.

tests/windows/build makes it; without it these cases are left out with a word. Wine gives a pseudo terminal no parity, so the
bench has none. What Wine does not have (drivers of adapters, a console window, exclusive ports) is not tried here.
"""

import signal
import subprocess
import time
from contextlib import contextmanager

from harness import (
    BENCH_LIFE,
    TARGET,
    WITHOUT_PARITY,
    Running,
    antrieb,
    bench,
    expect,
    expect_below,
    expect_text,
    group,
)

PROGRAM = TARGET / "windows/x86_64-pc-windows-gnu/debug/antrieb.exe"
PREFIX = (TARGET / "windows/wine").resolve()
WINE = "/usr/lib/wine/wine64"
# Wine's own start takes a second on a quiet machine.
PROMPT_S = 12.0

LINE = ("--parity", "none")


def windows(*words):
    """The command line of the program for Windows, in the way a script calls it."""
    wine = ["env", f"WINEPREFIX={PREFIX}", "WINEDEBUG=-all", WINE, PROGRAM]
    return [*wine, "--no-config", "--lang", "en", *words]


def run(*words):
    with Running(windows(*words)) as running:
        return running.end()


@contextmanager
def com(name):
    """A bench behind the COM port `name`; gives the pseudo terminal as well."""
    link = PREFIX / "dosdevices" / name.lower()
    with bench(WITHOUT_PARITY) as served:
        link.unlink(missing_ok=True)
        link.symlink_to(served.port)
        try:
            yield served.port
        finally:
            link.unlink()


if PROGRAM.is_file():
    case = group("Windows")
else:
    print(f"Windows: left out, {PROGRAM} is missing (tests/windows/build makes it)", flush=True)

    def case(_title):
        return lambda function: function


@case("it starts, and knows the bench")
def _():
    expect_text("--version", run("--version").exits(0).out, "antrieb ")
    found = run("--json", "--port", "sim", "scan").exits(0).data["drives"]
    expect("drives", [(device["address"], device["drive"]) for device in found], [(1, "act"), (2, "acu")])


@case("COM7: scan, read, write")
def _():
    with com("COM7"):
        found = run("--json", "--port", "COM7", *LINE, "scan").exits(0).data["drives"]
        expect("drives", [(device["address"], device["drive"]) for device in found], [(1, "act"), (2, "acu")])
        read = run("--json", "--port", "COM7", *LINE, "-a", "1", "read", "372@2", "481").exits(0).data["values"]
        expect("values", [value["raw"] for value in read], [1_390, 1_000])
        run("--json", "--port", "COM7", *LINE, "-a", "1", "--yes", "write", "480@2ram=12.5Hz").exits(0)
        again = run("--json", "--port", "COM7", *LINE, "-a", "1", "read", "480@2ram").exits(0).data["values"]
        expect("written", [value["raw"] for value in again], [1_250])


@case("COM12: names of two digits")
def _():
    with com("COM12"):
        read = run("--json", "--port", "COM12", *LINE, "-a", "2", "read", "372").exits(0).data["values"]
        expect("values", len(read), 1)


@case("a port that is not there is named")
def _():
    done = run("--port", "COM99", "read", "411", "-a", "1")
    expect("exit code", done.code, 3)
    expect_text("what it says", done.err, "COM99")


@case("COM7: Ctrl-C stops the shaft, and the report says so")
def _():
    with com("COM7") as terminal:
        words = ("--yes", "-a", "2", "sollwert", "10Hz", "--enable", "--hold", "--take-control", "--format", "ndjson")
        with Running(windows("--port", "COM7", *LINE, *words)) as held:
            held.wait_for('"phase":"held"')
            time.sleep(1.0)
            pressed = time.monotonic()
            done = held.end(signal.SIGINT).exits(130)
            expect_below("seconds from Ctrl-C to the end", time.monotonic() - pressed, PROMPT_S)
        expect_text("the report of the stop", done.out, '"type":"motion"', '"acknowledged":true')
        shown = antrieb(terminal, *LINE, "-a", "2", "read", "241", "411").exits(0).data["values"]
    frequency, status = (value["raw"] for value in shown)
    expect("frequency", frequency, 0)
    expect("operation enabled", status & 4, 0)


@case("its bench serves on a loopback port by itself")
def _():
    with Running(windows("simulate", "--for", BENCH_LIFE)) as served:
        served.wait_for("serving on ")
        port = served.output()[1].split("serving on ")[1].split(";")[0]
        shown = antrieb(port, "-a", "1", "read", "372").exits(0).data["values"]
        expect("value", [value["raw"] for value in shown], [1_390])
        served.end(signal.SIGINT).exits(0)


@case("a reader that goes away is no failure")
def _():
    line = " ".join(str(word) for word in windows("params", "--format", "csv"))
    done = subprocess.run(["bash", "-c", f"{line} | head -c 16 > /dev/null; exit ${{PIPESTATUS[0]}}"], capture_output=True)
    expect("exit code", done.returncode, 0)
