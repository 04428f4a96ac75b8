"""A pymodbus server answers our master, over a null modem of two pseudo terminals: codes 3, 6, 8, and the drives' own.

The server is `slave.py`, a process of its own.
"""

import re
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

import slave
from harness import BINARY, Running, antrieb, expect, expect_text, group, null_modem

case = group("pymodbus slave")

SERVER = Path(slave.__file__)
RTU, ASCII = "rtu", "ascii"
FRAMINGS = {"RTU": (RTU,), "ASCII": (ASCII,)}
AS_ACT = ["-a", slave.STATION, "--drive", "act"]


@contextmanager
def station(framing, codes):
    """The server, and a function that runs our program on the other end of its line."""
    setting = ["--protocol", framing, "--parity", "none", "--data-bits", 8]
    with null_modem() as (ours, theirs), Running([sys.executable, SERVER, theirs, framing, codes]) as server:
        server.wait_for("ready")
        yield lambda *words: antrieb(ours, *setting, *words)


def raw(done):
    """Raw values by parameter and data set."""
    return {(value["param"], value["data_set"]): value["raw"] for value in done.data["values"]}


@case("{}: code 3, `read` of several words", each=FRAMINGS)
def _(framing):
    with station(framing, "stock") as ask:
        done = ask(*AS_ACT, "read", "372@all", "260", "270", "411").exits(0)
    values = raw(done)
    expect("P.372", [values[372, data_set] for data_set in (1, 2, 3, 4)], [1_310, 1_320, 1_330, 1_340])
    expect("P.260, P.270, P.411", [values[param, 0] for param in (260, 270, 411)], [0, 0, 0x0023])


@case("{}: code 6, `write` proves what it wrote", each=FRAMINGS)
def _(framing):
    with station(framing, "stock") as ask:
        done = ask(*AS_ACT, "write", "376@4=1.5kW", "--yes").exits(0)
        row = done.data["values"][0]
        expect("row", (row["old_raw"], row["raw"], row["result"]), (8, 15, "verified"))
        expect("read again", raw(ask(*AS_ACT, "read", "376@4").exits(0)), {(376, 4): 15})


@case("{}: code 8, `diag` reads the counters and tests the line", each=FRAMINGS)
def _(framing):
    with station(framing, "stock") as ask:
        drive = ask(*AS_ACT, "diag", "--link-test", 20).exits(0).data["drives"][0]
    expect("sub-functions", [counter["sub"] for counter in drive["counters"]], list(range(0x0B, 0x13)))
    expect("counters", [counter["count"] for counter in drive["counters"]], [0] * 8)
    link = drive["link"]
    expect("link test", (link["asked"], link["replies"], link["error_rate_percent"]), (20, 20, 0.0))


@case("{}: code 8, `diag --clear`", each=FRAMINGS)
def _(framing):
    with station(framing, "stock") as ask:
        drive = ask(*AS_ACT, "diag", "--clear", "--yes").exits(0).data["drives"][0]
    expect("cleared", drive["counters_cleared"], True)


@case("{}: a register that it does not have is refused, exit 6", each=FRAMINGS)
def _(framing):
    with station(framing, "stock") as ask:
        error = ask(*AS_ACT, "read", "400").exits(6).error
    expect("error", (error["class"], error["code"]), ("refused", "refused.illegal_data_address"))


WITHOUT_LONGS = {
    f"{title}: {verb} of a long": (framing, words)
    for title, (framing,) in FRAMINGS.items()
    for verb, words in (("read", ["read", "481"]), ("write", ["write", "480=-120Hz", "--yes"]))
}


@case("{} where code 100 is exception 1, exit 6", each=WITHOUT_LONGS)
def _(framing, words):
    with station(framing, "refusing") as ask:
        error = ask(*AS_ACT, *words).exits(6).error
    expect("error", (error["class"], error["code"]), ("refused", "refused.illegal_function"))


@case("{}: codes 100 and 101 as custom codes of the server", each=FRAMINGS)
def _(framing):
    with station(framing, "speaking") as ask:
        expect("P.481", raw(ask(*AS_ACT, "read", "481").exits(0)), {(481, 0): 1_000})
        row = ask(*AS_ACT, "write", "480=-120Hz", "--yes").exits(0).data["values"][0]
        expect("row", (row["old_raw"], row["raw"], row["result"]), (500, -12_000, "verified"))
        expect("read again", raw(ask(*AS_ACT, "read", "480").exits(0)), {(480, 0): -12_000})


@case("silence on code 100 ends with exit 4, and the next question gets its own reply")
def _():
    with station(RTU, "stock") as ask:
        expect("error", ask(*AS_ACT, "read", "481").exits(4).error["class"], "silence")
        values = raw(ask(*AS_ACT, "read", "481", "372@2", "411").exits(9))
    expect("values", values, {(481, 0): None, (372, 2): 1_320, (411, 0): 0x0023})


@case("an answer that fits no question ends with exit 5")
def _():
    # In ASCII, pymodbus answers a code that it does not know with function 0x80.
    with station(ASCII, "stock") as ask:
        expect("error", ask(*AS_ACT, "read", "481").exits(5).error["class"], "garbled")


STRANGERS = {
    f"{title}, {manner}": (framing, codes)
    for title, (framing,) in FRAMINGS.items()
    for manner, codes in (("which refuses code 100", "refusing"), ("as pymodbus comes", "stock"))
}


@case("`scan` lists it as unknown, with what it answered: {}", each=STRANGERS)
def _(framing, codes):
    with station(framing, codes) as ask:
        found = ask("scan", "-a", "6-8").exits(0).data
    expect("found", [(drive["address"], drive["drive"]) for drive in found["drives"]], [(slave.STATION, "unknown")])
    expect("complete", (found["asked"], found["complete"]), (3, True))
    evidence = found["drives"][0]["evidence"]
    expect("every evidence is whole", [row for row in evidence if not (row["asked"] and row["answered"])], [])
    expect_text("evidence", " ".join(row["asked"] for row in evidence), "code 100", "code 3")


@case("{}: `read` without --drive says that it knows no such drive, exit 7", each=FRAMINGS)
def _(framing):
    with station(framing, "refusing") as ask:
        error = ask("-a", slave.STATION, "read", "372@2").exits(7).error
    expect("error", error["code"], "data.unknown_drive")
    expect_text("hint", error["hint"], "--drive")


# Registers of the stock server as a maker's map would name them; addresses from 1.
MAP = """{ "mbmap": 2, "vendor": "Acme", "model": "VSD", "address_base": 1, "byte_order": "big", "word_order": "big",
 "registers": [
  {"name": "Status", "area": "holding", "address": 412, "type": "uint16", "access": "R", "enum": {"35": "Switched on"}},
  {"name": "Fault", "area": "holding", "address": 261, "type": "int16", "scale": 0.1, "unit": "V", "access": "RW"}
 ] }"""


@case("{}: a device known only from an MBMap, read and written", each=FRAMINGS)
def _(framing):
    with tempfile.TemporaryDirectory() as directory, station(framing, "stock") as ask:
        given, catalogue = Path(directory) / "map.json", Path(directory) / "map.toml"
        given.write_text(MAP)
        ours = [BINARY, "--no-config", "params", "import", given, "--output", catalogue]
        subprocess.run(ours, check=True, capture_output=True, timeout=30)
        known = ["-a", slave.STATION, "--catalogue", catalogue, "--drive", "acme-vsd"]
        done = ask(*known, "read", "status", "fault").exits(0)
        expect("texts", [value["text"] for value in done.data["values"]], ["Switched on", None])
        row = ask(*known, "write", "fault=1.5", "--yes").exits(0).data["values"][0]
        expect("row", (row["raw"], row["result"]), (15, "verified"))


# What each meter of tests/maps tells; the registers are those of `slave.METER`.
METERS = {
    "eastron-sdm630": {"frequency": (50.02, "Hz"), "imported-energy": (12345.678, "kWh")},
    "carlo-gavazzi-em530": {
        "voltage-l1-n": (230.4, "V"),
        "current-l1": (100, "A"),
        "power-factor": (-0.95, None),
        "frequency": (50, "Hz"),
        "energy": (12345.6, "kWh"),
    },
    "socomec-diris-a10": {
        "voltage-l1-l2": (400.12, "V"),
        "frequency": (50.02, "Hz"),
        "current-l1": (100, "A"),
        "active-power": (-1234.56, "W"),
        "energy": (777, None),
        "thd-u1": (3.5, "%"),
    },
}
OVER = {f"{title}, {meter}": (framing, meter) for title, (framing,) in FRAMINGS.items() for meter in METERS}


def told_by(ask, given, catalogue, options, params):
    """What a device tells of which nothing but this list is known."""
    ours = [BINARY, "--no-config", "params", "import", given, *options, "--output", catalogue]
    subprocess.run(ours, check=True, capture_output=True, timeout=30)
    drive = re.search('^family = "(.*)"', catalogue.read_text(), re.MULTILINE).group(1)
    done = ask("-a", slave.STATION, "--catalogue", catalogue, "--drive", drive, "read", *params).exits(0)
    return [(value["value"], value["unit"]) for value in done.data["values"]]


@case("{}: a meter known only from its MBMap", each=OVER)
def _(framing, meter):
    given, told = Path(__file__).resolve().parents[1] / f"maps/{meter}.mbmap.json", METERS[meter]
    with tempfile.TemporaryDirectory() as directory, station(framing, "stock") as ask:
        expect("values", told_by(ask, given, Path(directory) / "map.toml", (), told), list(told.values()))


# A list as a spreadsheet in German exports it: a byte order mark, semicolons, decimal commas, CR LF.
EXCEL = """\ufeffRegister;Bezeichnung;Einheit;Faktor;Typ
0;"Spannung; L1";V;0,1;int32
51;Frequenz;Hz;0,1;uint16
49;cos phi;;0,001;int16
""".replace("\n", "\r\n")


@case("{}: a meter known only from a list out of a spreadsheet", each=FRAMINGS)
def _(framing):
    told = {"0": (230.4, "V"), "frequenz": (50, "Hz"), "49": (-0.95, None)}
    with tempfile.TemporaryDirectory() as directory, station(framing, "stock") as ask:
        given = Path(directory) / "list.csv"
        given.write_bytes(EXCEL.encode())
        options = ("--own", "meter", "--low-half-first")
        expect("values", told_by(ask, given, Path(directory) / "meter.toml", options, told), list(told.values()))
