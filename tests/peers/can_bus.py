"""The system bus with python's canopen at either end: its client asks our simulated drives through our simulated SLCAN adapter, by way of
python-can; and its server answers our client (`can_node.py`)."""

import sys
from contextlib import contextmanager
from pathlib import Path

import can
import can_node
import canopen
from harness import Failed, Running, antrieb, expect, group
from harness import BENCH_LIFE, BINARY

case = group("can")

SERVER = Path(can_node.__file__)
# Parameters of the bench's ACUs, and codes of its aborts (EM-RES-03 manual 5.10.1).
STATUS_WORD, FIXED_FREQUENCY, SETPOINT, NOBODYS = 411, 480, 484, 1234
UNKNOWN, NOT_READABLE = 11, 3


@contextmanager
def simulated():
    """Our bus behind our adapter, and its address."""
    words = [BINARY, "--no-config", "--json", "simulate", "--can", "--tcp", "127.0.0.1:0", "--for", BENCH_LIFE]
    with Running(words) as bench:
        bench.wait_for("serving on ")
        yield bench.output()[1].split("serving on tcp://")[1].split(";")[0]


@contextmanager
def client(address):
    """canopen's client for node 1."""
    bus = can.Bus(interface="slcan", channel=f"socket://{address}", bitrate=500_000, sleep_after_open=0)
    network = canopen.Network(bus)
    network.connect()
    node = canopen.RemoteNode(1, canopen.ObjectDictionary())
    network.add_node(node)
    try:
        yield node.sdo
    finally:
        network.disconnect()


def refused(sdo, index):
    try:
        sdo.upload(index, 0)
    except canopen.SdoAbortedError as error:
        return error.code
    raise Failed(f"{index} was not refused")


@case("canopen's client reads and writes our simulated drive")
def _():
    with simulated() as address:
        with client(address) as sdo:
            expect("P.480", sdo.upload(FIXED_FREQUENCY, 1), (500).to_bytes(4, "little"))
            sdo.download(FIXED_FREQUENCY, 1, (650).to_bytes(4, "little"))
            expect("P.480 behind a write", sdo.upload(FIXED_FREQUENCY, 1), (650).to_bytes(4, "little"))
            codes = refused(sdo, NOBODYS), refused(sdo, SETPOINT)
            expect("codes of aborts", codes, (UNKNOWN, NOT_READABLE))
        words = ["--baud", 500_000, "-a", 1, "read", f"{FIXED_FREQUENCY}@1"]
        ours = antrieb(f"slcan:tcp://{address}", *words).exits(0)
        expect("what our client reads then", ours.data["values"][0]["raw"], 650)


@contextmanager
def foreign():
    """canopen's server, and how our program reaches it. It has but one channel, which is SDO1."""
    with Running([sys.executable, SERVER]) as server:
        server.wait_for("ready on ")
        port = f"slcan:tcp://127.0.0.1:{server.output()[0].split()[2]}"
        words = ["--protocol", "sdo1", "--baud", 500_000, "--drive", "acu", "-a", can_node.NODE]
        yield lambda *more: antrieb(port, *words, *more)


@case("canopen's server answers our client")
def _():
    with foreign() as ask:
        done = ask("read", can_node.STATUS_WORD, can_node.FIXED_FREQUENCY, f"{can_node.OFFSET}@1").exits(0)
        expect("values", [row["raw"] for row in done.data["values"]], [0x33, 500, -125])


@case("canopen's server takes what our client writes")
def _():
    with foreign() as ask:
        done = ask("--yes", "write", f"{can_node.FIXED_FREQUENCY}@2=6.5Hz", f"{can_node.OFFSET}@1=-7.5").exits(0)
        expect("results", [row["result"] for row in done.data["values"]], ["verified", "verified"])


@case("an abort of CiA 301 is told with its code")
def _():
    with foreign() as ask:
        error = ask("read", NOBODYS).exits(6).error
        expect("code", error["code"], "refused.abort")
        if "06020000h" not in error["message"]:
            raise Failed(f"no code in {error['message']!r}")
