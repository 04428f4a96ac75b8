"""The same drives over a tty, and behind servers that we did not write: ser2net raw and with RFC 2217, and a Modbus/TCP
gateway made of pymodbus (`gateway.py`).

The bench has no parity here: ser2net asks a pseudo terminal for it in a way that the terminal does not pass on
(docs/measured.md: what shows parity there is INPCK, which ser2net leaves alone).
"""

import json
import signal
import socket
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

from harness import PATIENCE_S, Failed, Running, antrieb, bench, expect, expect_below, group, our

case = group("links")

DRIVES = """
[[drive]]
model = "act"
address = 1
parity = "none"
baud = {baud}

[[drive]]
model = "acu"
address = 2
parity = "none"
baud = {baud}
"""
CONNECTION = """
connection: &drives
  accepter: {accepter},127.0.0.1,{port}
  connector: serialdev,{tty},19200n82,local
  options:
    kickolduser: true
"""
# How ser2net listens, by what it speaks; the cases' rows are the scheme of our port and that.
RAW, RFC2217 = "tcp", "telnet(rfc2217),tcp"
SERVERS = {"tcp": ("tcp", RAW), "rfc2217": ("rfc2217", RFC2217)}
# Debian puts it where not every user's PATH looks.
SER2NET = "/usr/sbin/ser2net"

# What a technician does first. The counters of `diag` tell how many telegrams went over the line before: as many on
# every line. A scan that does not wait by the book finds the drives in the order in which they happen to answer.
COMMANDS = (
    ["-a", "1,2", "read", "372@all", "481", "411", "260", "270"],
    ["-a", "1,2", "identify"],
    ["-a", "1,2", "diag"],
    ["-a", "1-3", "scan", "--thorough"],
)
GATEWAY = Path(__file__).with_name("gateway.py")
# A line that is gone: a user must not be left waiting.
PROMPT_S = 1.0


def drives(baud=19_200):
    return bench(DRIVES.format(baud=baud))


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def listens(port):
    """Whether somebody listens; asking by connecting would open the serial port behind it."""
    rows = [row.split() for row in Path("/proc/net/tcp").read_text().splitlines()[1:]]
    return any(row[1].endswith(f":{port:04X}") and row[3] == "0A" for row in rows)


@contextmanager
def device_server(accepter, tty):
    """ser2net in front of a tty; yields the process and HOST:PORT."""
    port = free_port()
    with tempfile.TemporaryDirectory(prefix="antrieb-peers-") as directory:
        config = Path(directory) / "ser2net.yaml"
        config.write_text(CONNECTION.format(accepter=accepter, port=port, tty=tty))
        with Running([SER2NET, "-n", "-d", "-c", config]) as server:
            deadline = time.monotonic() + PATIENCE_S
            while not listens(port):
                if server.process.poll() is not None or time.monotonic() > deadline:
                    raise Failed(f"ser2net does not listen: {server.output()}")
                time.sleep(0.01)
            yield server, f"127.0.0.1:{port}"


@contextmanager
def gateway(tty):
    """The Modbus/TCP gateway in front of a tty; yields HOST:PORT."""
    with Running([sys.executable, GATEWAY, tty]) as server:
        server.wait_for("ready on ")
        yield f"127.0.0.1:{server.output()[0].split()[-1]}"


def data(port):
    """What every command finds, without the name of the port."""
    found = []
    for words in COMMANDS:
        done = antrieb(port, "--parity", "none", *words).exits(0)
        told = json.loads(done.out.replace(str(port), "PORT"))["data"]
        for drive in told.get("drives", []):
            for counter in drive.get("counters", []):
                # How many telegrams there were depends on how soon they were answered.
                del counter["count"]
        found.append(told)
    return found


@case("{}: `read`, `scan`, `identify`, `diag` bring what the tty brings", each=SERVERS)
def _(scheme, accepter):
    with drives() as served:
        by_tty = data(served.port)
    with drives() as served, device_server(accepter, served.port) as (_, address):
        by_server = data(f"{scheme}://{address}")
    for words, ours, theirs in zip(COMMANDS, by_server, by_tty, strict=True):
        expect(" ".join(words), ours, theirs)


def without_line(found):
    """Without what a gateway hides: the line behind it."""
    if isinstance(found, list):
        return [without_line(part) for part in found]
    if not isinstance(found, dict):
        return found
    return {key: without_line(part) for key, part in found.items() if key not in ("line", "protocol")}


@case("mbtcp: `read`, `identify`, `diag`, `scan` bring what the tty brings")
def _():
    with drives() as served:
        by_tty = data(served.port)
    with drives() as served, gateway(served.port) as address:
        by_gateway = data(f"mbtcp://{address}")
    for words, ours, theirs in zip(COMMANDS, by_gateway, by_tty, strict=True):
        expect(" ".join(words), without_line(ours), without_line(theirs))


@case("rfc2217: the speed is set at the server, also another one than it has")
def _():
    with drives(baud=9_600) as served, device_server(RFC2217, served.port) as (_, address):
        antrieb(f"rfc2217://{address}", "--parity", "none", "-b", "9600", "-a", "1", "read", "411").exits(0)


@case("rfc2217: a wrong speed is silence, exit 4")
def _():
    with drives() as served, device_server(RFC2217, served.port) as (_, address):
        antrieb(f"rfc2217://{address}", "--parity", "none", "-b", "9600", "-a", "1", "read", "411").exits(4)


@case("rfc2217: a raw port is told from one that speaks RFC 2217, exit 3")
def _():
    with drives() as served, device_server(RAW, served.port) as (_, address):
        error = antrieb(f"rfc2217://{address}", "-a", "1", "read", "411").exits(3).error
    expect("error", error["code"], "port.no_rfc2217")


@case("tcp: nobody there, exit 3")
def _():
    error = antrieb(f"tcp://127.0.0.1:{free_port()}", "-a", "1", "read", "411").exits(3).error
    expect("error", error["code"], "port.unreachable")


@case("{}: the server dies amid a run, exit 3 at once", each=SERVERS)
def _(scheme, accepter):
    with drives() as served, device_server(accepter, served.port) as (server, address):
        words = our(f"{scheme}://{address}", "--parity", "none", "-a", "1", "diag", "--link-test", "5000")
        with Running(words) as running:
            time.sleep(0.5)
            server.end(signal.SIGKILL)
            lost = time.monotonic()
            error = running.end().exits(3).error
            expect_below("seconds until the end", time.monotonic() - lost, PROMPT_S)
    expect("error", error["code"], "port.lost")


@case("tape: a recording of a line plays back to the same document")
def _():
    with drives() as served, tempfile.TemporaryDirectory(prefix="antrieb-peers-") as directory:
        tape = f"tape:{directory}/run.trace"
        for words in COMMANDS:
            words = ["--parity", "none", *words]
            done = antrieb(served.port, "--force", "--trace", tape.removeprefix("tape:"), *words).exits(0)
            played = antrieb(tape, *words).exits(0)
            by_tty, by_tape = (out.replace(str(port), "PORT") for out, port in ((done.out, served.port), (played.out, tape)))
            expect(" ".join(words), json.loads(by_tape)["data"], json.loads(by_tty)["data"])
