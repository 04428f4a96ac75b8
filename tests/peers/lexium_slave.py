"""A pymodbus server that looks like an LXM05 answers our master: codes 3, 8, 16, 23 and 43/14.

On a null modem of two pseudo terminals, over raw TCP, and over Modbus/TCP. The server is `servo.py`, a process of its
own, which tells what was asked: the cases look at the telegrams that came, not only at what our program says of them.
"""

import re
import sys
from contextlib import contextmanager
from pathlib import Path

import servo
from harness import Running, antrieb, expect, expect_text, group, null_modem

case = group("lexium slave")

SERVER = Path(servo.__file__)
READ, DIAGNOSTICS, WRITE, EXCHANGE, IDENTIFY = 3, 8, 16, 23, 43
LINES = {"RTU": ("tty",), "RTU over TCP": ("tcp",), "Modbus/TCP": ("mbtcp",)}
FRAMES = {"tty": "rtu", "tcp": "rtu", "mbtcp": "socket"}
AS_LXM = ["--drive", "lxm05"]


class Station:
    """The server, and our program on the other end of its line."""

    def __init__(self, server, port, setting):
        self.server, self.port, self.setting, self.told = server, port, setting, 0

    def ask(self, *words, addresses=servo.STATION):
        return antrieb(self.port, *self.setting, "-a", addresses, *words)

    def asked(self):
        """Function code and data of every request since the last call."""
        came = re.findall(r"asked (\d+) ([0-9a-f]*)", self.server.output()[0])
        new, self.told = came[self.told :], len(came)
        return [(int(code), data) for code, data in new]


@contextmanager
def station(line, *manner):
    """A server with the upper half first and every code, if `manner` says nothing else."""
    words = [FRAMES[line], *(manner or ["high"])]
    if line == "tty":
        with null_modem() as (ours, theirs), Running([sys.executable, SERVER, theirs, *words]) as server:
            server.wait_for("ready")
            yield Station(server, ours, ["--parity", "none", "--stop-bits", 2])
        return
    with Running([sys.executable, SERVER, "-", *words]) as server:
        server.wait_for("ready on ")
        yield Station(server, f"{line}://127.0.0.1:{server.output()[0].split()[2]}", [])


def span(address, parameters):
    """Data of a request for parameters of two registers each."""
    return f"{address:04x}{2 * parameters:04x}"


def raw(done):
    return {value["param"]: value["raw"] for value in done.data["values"]}


@case("{}: code 43, `identify` knows an LXM05 by its product code", each=LINES)
def _(line):
    with station(line) as servo_drive:
        drive = servo_drive.ask("identify").exits(0).data["drives"][0]
        asked = servo_drive.asked()
    expect("drive", (drive["address"], drive["drive"]), (servo.STATION, "lxm05"))
    expect_text("evidence", str(drive["evidence"]), servo.VENDOR, servo.PRODUCT, servo.REVISION)
    # 411 comes later: an LXM05 refuses it, which overwrites its last synchronous error.
    expect("first", asked[:1], [(IDENTIFY, "0e0100")])


# A drive that somebody named is asked for a counter before its first value: the second answer to it would tell of two drives at
# the address. Modbus/TCP numbers its questions, so there it is not.
COUNTER = (DIAGNOSTICS, "000b0000")


def greeting(line):
    """Which half comes first, and the counter."""
    order = (READ, span(servo.ADDRESS, 1))
    return [order] if line == "mbtcp" else [order, COUNTER]


@case("{}: code 3, `read` takes neighbours in one telegram", each=LINES)
def _(line):
    with station(line) as servo_drive:
        names = ["FLT_err_num", "FLT_class", "FLT_Time", "FLT_Qual", "_p_act"]
        values = raw(servo_drive.ask(*AS_LXM, "read", *names).exits(0))
        asked = servo_drive.asked()
    fault = {servo.FAULT + 2 * at: value for at, value in enumerate([0x2300, 2, 77, 5])}
    expect("values", values, {**fault, servo.POSITION: -123_456})
    wanted = [(READ, data) for data in (span(servo.FAULT, 4), span(servo.POSITION, 1))]
    expect("telegrams", asked, [*greeting(line), *wanted])


@case("{}: code 23, `write` proves what it wrote in one exchange", each=LINES)
def _(line):
    with station(line) as servo_drive:
        row = servo_drive.ask(*AS_LXM, "write", "RAMPacc=2000", "--yes").exits(0).data["values"][0]
        asked = servo_drive.asked()
        again = raw(servo_drive.ask(*AS_LXM, "read", "RAMPacc").exits(0))
    expect("row", (row["old_raw"], row["raw"], row["result"]), (600, 2_000, "verified"))
    expect("read again", again, {servo.RAMP_ACC: 2_000})
    written = f"{span(servo.RAMP_ACC, 1)}{span(servo.RAMP_ACC, 1)}04000007d0"
    expect("telegrams", asked, [*greeting(line), (READ, span(servo.RAMP_ACC, 1)), (EXCHANGE, written)])


@case("{}: code 16, `write` where code 23 is exception 1, and reads back", each=LINES)
def _(line):
    with station(line, "high", "without-23") as servo_drive:
        row = servo_drive.ask(*AS_LXM, "write", "PPp_targetusr=-123456", "--yes").exits(0).data["values"][0]
        asked = servo_drive.asked()
    expect("row", (row["old_raw"], row["raw"], row["result"]), (0, -123_456, "verified"))
    greeted = [code for code, _ in greeting(line)]
    expect("codes", [code for code, _ in asked], [*greeted, READ, EXCHANGE, DIAGNOSTICS, WRITE, READ])
    expect("code 16", asked[-2][1], f"{span(servo.TARGET, 1)}04fffe1dc0")


@case("{}: the lower half first, as the drive says", each=LINES)
def _(line):
    with station(line, "low") as servo_drive:
        values = raw(servo_drive.ask(*AS_LXM, "read", "_p_act", "MBdword_order").exits(0))
        row = servo_drive.ask(*AS_LXM, "write", "PPp_targetusr=-123456", "--yes").exits(0).data["values"][0]
        asked = servo_drive.asked()
    expect("values", values, {servo.POSITION: -123_456, servo.WORD_ORDER: 1})
    expect("row", (row["raw"], row["result"]), (-123_456, "verified"))
    expect("code 23", asked[-1], (EXCHANGE, f"{span(servo.TARGET, 1)}{span(servo.TARGET, 1)}041dc0fffe"))


@case("--word-order high against a drive with the lower half first is what it says")
def _():
    with station("tty", "low") as servo_drive:
        values = raw(servo_drive.ask(*AS_LXM, "--word-order", "high", "read", "FLT_Time").exits(0))
        asked = servo_drive.asked()
    expect("values", values, {servo.FAULT + 4: 77 << 16})
    expect("telegrams", asked, [COUNTER, (READ, span(servo.FAULT + 4, 1))])


REFUSED = {
    f"{title}: {what}": (line, words, code)
    for title, (line,) in LINES.items()
    for what, words, code in (
        ("an address that it does not have", ["read", "9998"], "refused.illegal_data_address"),
        ("writing what is read only", ["write", "_p_act=1", "--yes", "--force"], "refused.illegal_data_address"),
        ("a bad value", ["write", "MBnode_guard=10001", "--yes", "--force"], "refused.illegal_data_value"),
    )
}


@case("{} is refused, exit 6, and code 8 asks why", each=REFUSED)
def _(line, words, code):
    with station(line) as servo_drive:
        error = servo_drive.ask(*AS_LXM, *words).exits(6).error
        asked = servo_drive.asked()
    expect("error", (error["class"], error["code"]), ("refused", code))
    expect("last", asked[-1], (DIAGNOSTICS, "00020000"))


@case("{}: code 8, `diag` reads the counters and tests the line", each=LINES)
def _(line):
    with station(line) as servo_drive:
        drive = servo_drive.ask("diag", "--link-test", 20).exits(0).data["drives"][0]
        asked = servo_drive.asked()
    expect("counters", [counter["sub"] for counter in drive["counters"]], [11, 12, 13, 16, 17, 18])
    expect("state", drive["status"]["state"]["slug"], "switch-on-disabled")
    expect("link test", (drive["link"]["asked"], drive["link"]["replies"]), (20, 20))
    echoes = [data for code, data in asked if code == DIAGNOSTICS and data.startswith("0000")]
    expect("echoes", len(echoes), 20)


@case("{}: `scan` names it", each=LINES)
def _(line):
    with station(line) as servo_drive:
        found = servo_drive.ask("--timeout", "100ms", "scan", addresses=f"{servo.STATION}-6").exits(0).data
    expect("found", [(drive["address"], drive["drive"]) for drive in found["drives"]], [(servo.STATION, "lxm05")])
