"""Our program and our bench, two processes with a pty between them: what users see when all is well, wrong, or gone."""

import signal
import time

from harness import Running, antrieb, bench, expect, expect_below, expect_in, expect_text, group, our

case = group("second process")

LINES = {"RTU": ("rtu",), "ASCII": ("ascii",)}
DRIVES = """
[[drive]]
model = "act"
address = 1
protocol = "{protocol}"

[[drive]]
model = "acu"
address = 2
protocol = "{protocol}"
"""

# Adapter gone, or Ctrl-C: a user must not be left waiting.
PROMPT_S = 1.0


def drives(protocol):
    return bench(DRIVES.format(protocol=protocol))


def values(done):
    return [(value["address"], value["param"], value["data_set"], value["raw"]) for value in done.data["values"]]


def no_remarks(served):
    """The judge of the bench saw our own master keep every rule of the manual.

    For cases without a time-out: in real time a telegram is seen late, never early, so 500 ms may look like 499.
    """
    expect("remarks of the judge", served.counts["remarks"], [])


@case("{}: `read 372@2 481 411 260 270` of both drives", each=LINES)
def _(protocol):
    with drives(protocol) as served:
        done = antrieb(served.port, "--protocol", protocol, "-a", "1,2", "read", "372@2", "481", "411", "260", "270")
        done.exits(0)
    wanted = [(372, 2, 1_390), (481, 0, 1_000), (411, 0, 0x0023), (260, 0, 0), (270, 0, 0)]
    acu = [(param, data_set, 0x0033 if param == 411 else raw) for param, data_set, raw in wanted]
    expect("values", values(done), [(1, *row) for row in wanted] + [(2, *row) for row in acu])
    no_remarks(served)


@case("{}: the pty brings what `sim` brings", each=LINES)
def _(protocol):
    words = ["--protocol", protocol, "-a", "1,2", "read", "@modbus"]
    with drives(protocol) as served:
        by_pty = antrieb(served.port, *words)
        by_sim = antrieb(f"sim:{served.file}", *words)
    expect("exit code", by_pty.code, by_sim.code)
    expect("values", values(by_pty), values(by_sim))
    no_remarks(served)


@case("{}: `write 376@4=1.5kW` is proven, and goes to the EEPROM once", each=LINES)
def _(protocol):
    with drives(protocol) as served:
        words = ["--protocol", protocol, "-a", 1, "write", "376@4=1.5kW", "--yes"]
        expect("result", antrieb(served.port, *words).exits(0).data["values"][0]["result"], "verified")
        # What the drive has already is not sent again.
        antrieb(served.port, *words).exits(0)
        read = antrieb(served.port, "--protocol", protocol, "-a", 1, "read", "376@all").exits(0)
        expect("data set 4", values(read)[3], (1, 376, 4, 15))
    expect("EEPROM writes", served.counts["eeprom_writes"], 1)
    no_remarks(served)


REFUSALS = {
    f"{title}, {words}": (protocol, words, cause)
    for title, (protocol,) in LINES.items()
    for words, cause in (
        ("write 376@2=0 --yes", 1),
        ("write 375@2=9Hz --yes", 1),
        ("read 1600@2 --type long", 11),
        ("write 411=1 --force --yes", 4),
    )
}


@case("refused with exit 6 and the cause from P.11: {}", each=REFUSALS)
def _(protocol, words, cause):
    with drives(protocol) as served:
        error = antrieb(served.port, "--protocol", protocol, "-a", 1, *words.split()).exits(6).error
    context = error["context"]
    told = (error["class"], context["exception"], context["p11"])
    expect("class, exception, P.11", told, ("refused", "4", str(cause)))
    expect("EEPROM writes", served.counts["eeprom_writes"], 0)
    no_remarks(served)


SILENCES = {
    "another baud rate": (["-a", 1, "-b", 9_600],),
    "odd parity": (["-a", 1, "--parity", "odd"],),
    "no parity": (["-a", 1, "--parity", "none"],),
    "ASCII at an RTU drive": (["-a", 1, "--protocol", "ascii"],),
    "an address that nobody has": (["-a", 3],),
}


@case("exit 4 after three silent tries: {}", each=SILENCES)
def _(setting):
    with bench() as served:
        done = antrieb(served.port, *setting, "--drive", "act", "read", "372@2")
        expect("error", done.exits(4).error["code"], "silence.no_reply")
        # The greeting, and three times the question, of 500 ms each; the machine may be slow.
        expect_below("seconds", done.seconds, 8.0)
        antrieb(served.port, "-a", 1, "--drive", "act", "read", "372@2").exits(0)
    expect("answered: the greeting and the question", served.counts["answered"], 2)


LOADED = """
[[drive]]
model = "act"
load = "high"   # replies after 700 ms
"""


@case("a drive under load is read with a longer --timeout")
def _():
    with bench(LOADED) as served:
        done = antrieb(served.port, "-a", 1, "--drive", "act", "--timeout", "1s", "read", "372@2", "411").exits(0)
    expect("values", values(done), [(1, 372, 2, 1_390), (1, 411, 0, 0x0023)])
    no_remarks(served)


@case("a late reply is never believed: not by the question behind it, and not by the next process")
def _():
    with bench(LOADED) as served:
        first = antrieb(served.port, "-a", 1, "--drive", "act", "read", "372@2", "411").exits(0)
        second = antrieb(served.port, "-a", 1, "--drive", "act", "--timeout", "1s", "read", "372@2", "411").exits(0)
    for done in (first, second):
        expect("values", values(done), [(1, 372, 2, 1_390), (1, 411, 0, 0x0023)])


@case("`scan` of addresses 1 to 5 finds both drives")
def _():
    with bench() as served:
        found = antrieb(served.port, "-a", "1-5", "scan").exits(0).data
    expect("found", [(drive["address"], drive["drive"]) for drive in found["drives"]], [(1, "act"), (2, "acu")])
    expect("asked", (found["asked"], found["addresses"], found["complete"]), (5, 5, True))


@case("Ctrl-C in a scan leaves a partial, honest result, exit 130")
def _():
    with bench() as served:
        with Running(our(served.port, "scan")) as scan:
            scan.wait_for("found acu at 2")
            time.sleep(0.7)
            pressed = time.monotonic()
            done = scan.end(signal.SIGINT)
            expect_below("seconds until it ended", time.monotonic() - pressed, PROMPT_S)
    done.exits(130)
    expect("ok, class", (done.document["ok"], done.error["class"]), (False, "interrupted"))
    expect("found", [drive["address"] for drive in done.data["drives"]], [1, 2])
    expect("complete", done.data["complete"], False)
    expect_in("addresses that were asked", done.data["asked"], range(3, 247))


LONG_WORK = {
    "a scan": (["scan"],),
    "a read of many drives": (["-a", "1-9", "read"],),
    "a link test": (["-a", 1, "diag", "--link-test", 10_000],),
}


@case("Ctrl-C in {}: exit 130 within a second", each=LONG_WORK)
def _(words):
    with bench() as served:
        done = cut_short(served, words, lambda client: client.signal(signal.SIGINT))
    expect("error", done.exits(130).error["class"], "interrupted")


@case("the line goes in {}: exit 3 within a second", each=LONG_WORK)
def _(words):
    with bench() as served:
        done = cut_short(served, words, lambda _: served.end(signal.SIGKILL))
    expect("error", done.exits(3).error["code"], "port.lost")


def cut_short(served, words, cut):
    """Lets something happen in the middle of long work, and waits for its end."""
    with Running(our(served.port, *words)) as client:
        served.wait_for("a client connected")
        time.sleep(0.4)
        started = time.monotonic()
        cut(client)
        done = client.end()
        expect_below("seconds until it ended", time.monotonic() - started, PROMPT_S)
    return done


@case("a port that does not exist: exit 3, and the ports that do")
def _():
    error = antrieb("/dev/antrieb-has-no-such-port", "-a", 1, "read", "411").exits(3).error
    expect("error", error["code"], "port.not_found")
    expect_text("hint", error["hint"], "sim")


@case("a port that somebody else has: exit 3, busy")
def _():
    with bench() as served:
        with Running(our(served.port, "-a", 1, "diag", "--link-test", 1_000)):
            served.wait_for("a client connected")
            error = antrieb(served.port, "-a", 1, "read", "411").exits(3).error
    expect("error", error["code"], "port.busy")
