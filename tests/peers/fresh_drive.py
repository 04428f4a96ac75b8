"""A drive as it leaves the factory, on a pty in real time: found, brought to Modbus, moved on; and the cable cut on the way."""

import time

from harness import antrieb, bench, expect, expect_in, group

case = group("fresh drive")

FRESH = """
[[drive]]
model = "acu"
protocol = "vabus"
"""
MODBUS = """
[[drive]]
model = "acu"
"""
# The write with this number is heard, and then nobody hears the drive any more for a while: its reply is lost too.
CUT = """
[[drive.event]]
after_writes = {write}
silent = "{span}"
"""

SEARCH = ["scan", "--baud", "auto", "--parity", "auto", "--protocol", "auto", "-a", "1,5", "--until-first"]
TO_RTU = ["--protocol", "vabus", "-a", 1, "--yes", "protocol", "set", "rtu"]
TO_115200 = ["-a", 1, "--yes", "line", "set", "--baud", 115200, "--parity", "odd", "--address", 5]


def where(port):
    """The one drive that a search finds, in the words of the documents."""
    drives = antrieb(port, *SEARCH).exits(0).data["drives"]
    expect("drives found", len(drives), 1)
    (drive,) = drives
    return f"{drive['protocol']} {drive['line']}, address {drive['address']}"


def moved(done):
    done.exits(0)
    expect("result", done.data["result"], "moved")
    expect("steps", {step["result"] for step in done.data["steps"]}, {"proven"})
    return done.data["now"]["text"]


@case("found, brought to RTU, moved to 115200 8O1 at 5, found again after each")
def _():
    with bench(FRESH) as served:
        expect("as it leaves the factory", where(served.port), "vabus 19200 7E1, address 1")
        expect("after protocol set", moved(antrieb(served.port, *TO_RTU)), "rtu 19200 8E1, address 1")
        expect("found there", where(served.port), "rtu 19200 8E1, address 1")
        expect("after line set", moved(antrieb(served.port, *TO_115200)), "rtu 115200 8O1, address 5")
        expect("found there", where(served.port), "rtu 115200 8O1, address 5")


@case("the way back, as it is printed, goes back")
def _():
    with bench(FRESH) as served:
        done = antrieb(served.port, *TO_RTU).exits(0)
        program, _port, _name, *words = done.data["way_back"].split()
        expect("program", program, "antrieb")
        expect("back", moved(antrieb(served.port, *words, "--yes")), "vabus 19200 7E1, address 1")


# How long nobody may hear the drive until our program has given it up for lost.
CUTS = {
    "at the protocol": (FRESH, TO_RTU, 1, 18),
    "at the address": (MODBUS, TO_115200, 1, 14),
    "at the speed": (MODBUS, TO_115200, 2, 10),
    "at the parity": (MODBUS, TO_115200, 3, 10),
    "at the restart": (MODBUS, TO_115200, 4, 26),
}


@case("cut {} for good: the last word tells where to look, and a search finds it there", each=CUTS)
def _(drive, words, write, silent_s):
    with bench(drive + CUT.format(write=write, span=f"{silent_s}s")) as served:
        done = antrieb(served.port, *words).exits(4)
        expect("result", done.data["result"], "lost")
        time.sleep(max(0, silent_s - done.seconds))
        places = [*done.data["perhaps"], *filter(None, [done.data["after_restart"]])]
        expect_in("found", where(served.port), [place["text"] for place in places])


@case("cut {} for 2 s: it ends at a place that is told", each=CUTS)
def _(drive, words, write, _long):
    with bench(drive + CUT.format(write=write, span="2s")) as served:
        done = antrieb(served.port, *words)
        expect_in("exit code", done.code, [0, 4])
        expect_in("result", done.data["result"], ["moved", "restored"])
        expect("found", where(served.port), done.data["now"]["text"])
