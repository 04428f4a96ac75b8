"""What is measured, each for our program and for the masters beside it, in turns, on benches of the same kind.

Times of ours are those of whole processes. What many reads cost is the difference to a process with one read.
"""

import json
import os
import statistics
import subprocess
import sys
import time
from contextlib import ExitStack
from itertools import cycle, islice, product

import harness
from masters import MASTERS, Missed, one_shot
from wire import BINARY, RATED_SPEED, SPEEDS, Setting, bus, our, register

OURS = "antrieb"
DATA_SET = 2
READ = f"{RATED_SPEED}@{DATA_SET}"
REGISTER = register(RATED_SPEED, DATA_SET)

SETTINGS = [Setting("rtu", 9_600), Setting("rtu", 19_200), Setting("rtu", 115_200), Setting("ascii", 19_200)]
USUAL = Setting("rtu", 19_200)
NO_DELAY = Setting("rtu", 115_200, delay_ms=0)

# The late-reply trial: every fifth reply 150 ms late, 100 ms time-out. Drives that take 10 to 30 ms, so that late
# replies meet the later telegrams anywhere.
JITTER_MS = 20
LATE = '[[disturb]]\nevery = 5\nkind = "late"\nby = "150ms"\n'
LATE_TIMEOUT_S = 0.1

# The scan: three drives, of which one takes its time.
SLOW_MS = 300
SCANNED = {1: None, 17: None, 42: SLOW_MS}
LAST_ADDRESS = 247
UNKNOWN = list(product((2_400, 4_800, 9_600, 19_200, 57_600, 115_200), ("even", "odd", "none"), ("rtu", "ascii")))
NOBODY_S = 60  # a search that takes longer has failed


# Processes ----------------------------------------------------------------------------------------------------------


def wall_s(words):
    """From before the start of a process to after its end. posix_spawn, because it costs the least."""
    null = [(os.POSIX_SPAWN_OPEN, stream, os.devnull, os.O_RDWR, 0) for stream in (0, 1, 2)]
    started = time.perf_counter()
    process = os.posix_spawnp(words[0], words, os.environ, file_actions=null)
    _, status = os.waitpid(process, 0)
    elapsed = time.perf_counter() - started
    if status != 0:
        sys.exit(f"{' '.join(words[:20])} failed: status {status}")
    return elapsed


def peak_mb(words):
    """Memory of a process at its peak.

    A child starts with the peak of the process that it was forked from, and Python's would hide that of a small
    program. So a shell forks it and leaves, and the orphan comes to us (`adopt_orphans`).
    """
    fork = '"$@" >/dev/null 2>&1 & echo $!'
    shell = subprocess.run(["sh", "-c", fork, "sh", *words], stdout=subprocess.PIPE, check=True)
    _, status, usage = os.wait4(int(shell.stdout), 0)
    if status != 0:
        sys.exit(f"{words[0]} failed: status {status}")
    return usage.ru_maxrss * 1_024 / 1e6


def document(words):
    """Runs our program; the document that it prints, and how long it took."""
    started = time.perf_counter()
    done = subprocess.run(
        [*words, "--json"], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, timeout=4 * NOBODY_S
    )
    elapsed = time.perf_counter() - started
    try:
        return json.loads(done.stdout), elapsed
    except ValueError:
        sys.exit(f"{' '.join(words[:20])} printed no document: exit {done.returncode}, {done.stderr.strip()!r}")


def speaking(setting):
    return [master for master in MASTERS if setting.protocol in master.protocols]


# Transactions a second ------------------------------------------------------------------------------------------------


def rates(setting, rounds, reads):
    """One-register reads, one after the other: time of each, and what the judge of the bench saw of the gaps."""
    masters = {OURS: None} | {master.name: master for master in speaking(setting)}
    times = {name: [] for name in masters}
    with ExitStack() as stack:
        lines = {name: stack.enter_context(bus(setting.drive(1))) for name in masters}
        for _ in range(rounds):
            for name, master in masters.items():
                measure = our_reads if master is None else peer_reads
                times[name].append(measure(lines[name], setting, master, reads))
    return {name: rate(setting, times[name], lines[name].report) for name in masters}


def our_reads(line, setting, _, reads):
    line.rest()
    check(line, setting)
    single = []
    for _ in range(3):
        line.rest()
        single.append(wall_s(our(line.port, setting, "read", READ)))
    line.rest()
    whole = wall_s(our(line.port, setting, "read", *[READ] * reads))
    return (whole - statistics.median(single)) / (reads - 1)


def check(line, setting):
    """The answer must be right before its time means anything; it also brings the program into the page cache."""
    values = document(our(line.port, setting, "read", READ))[0]["data"]["values"]
    if [value["raw"] for value in values] != [SPEEDS[DATA_SET]]:
        sys.exit(f"{OURS} read {values}")


def peer_reads(line, setting, master, reads):
    line.rest()
    opened = master(line.port, setting, timeout_s=0.5)
    try:
        opened.read(REGISTER)
        started = time.perf_counter()
        values = {opened.read(REGISTER) for _ in range(reads)}
        elapsed = time.perf_counter() - started
    finally:
        opened.close()
    if values != {SPEEDS[DATA_SET]}:
        sys.exit(f"{master.name} read {values}")
    return elapsed / reads


def rate(setting, times, report):
    median = statistics.median(times)
    return {
        "ratio": round(setting.limit_s / median, 4),
        "best": round(setting.limit_s / min(times), 4),
        # By the judge's clock, and without the disturbances of a busy machine.
        "typical": round(setting.limit_s / (setting.wire_s + report["gaps"]["median_us"] / 1e6), 4),
        "per_second": round(1 / median, 2),
        "over_limit_us": round((median - setting.limit_s) * 1e6),
        "gaps": report["gaps"],
        "remarks": len(report["remarks"]),
    }


# One read, a whole process --------------------------------------------------------------------------------------------


def one_shots(runs):
    """Whole processes that read one register."""
    with bus(USUAL.drive(1)) as line:
        words = {OURS: our(line.port, USUAL, "read", READ), **one_shot(line.port, USUAL, REGISTER)}
        times = {name: [] for name in words}
        for _ in range(runs + 1):
            for name, command in words.items():
                line.rest()
                times[name].append(wall_s(command) * 1_000)
        memory = {}
        for name, command in words.items():
            line.rest()
            memory[name] = peak_mb(command)
    empty = statistics.median(wall_s(["true"]) for _ in range(runs)) * 1_000
    # The first run brings a program into the page cache.
    return {name: single(times[name][1:], memory[name], empty) for name in words}


def single(times, memory, empty_ms):
    wire_ms = USUAL.wire_s * 1_000
    return {
        "wall_ms": round(statistics.median(times), 2),
        "over_wire_ms": round(statistics.median(times) - wire_ms, 2),
        "fastest_over_wire_ms": round(min(times) - wire_ms, 2),
        "empty_process_ms": round(empty_ms, 2),
        "peak_mb": round(memory, 1),
    }


# Late replies ---------------------------------------------------------------------------------------------------------


def late_replies(reads):
    """Every fifth reply late: how many values were believed that belong to another question?"""
    sets = list(islice(cycle(SPEEDS), reads))
    trials = {OURS: lambda line: our_late(line, sets)}
    trials |= {master.name: lambda line, master=master: peer_late(line, master, sets) for master in speaking(USUAL)}
    rows = {}
    for name, trial in trials.items():
        with bus(USUAL.drive(1, jitter_ms=JITTER_MS) + LATE) as line:
            line.rest()
            started = time.perf_counter()
            got = trial(line)
            elapsed = time.perf_counter() - started
        right = sum(value == SPEEDS[number] for number, value in zip(sets, got, strict=True))
        missed = sum(value is None for value in got)
        rows[name] = {
            "reads": reads,
            "wrong": reads - right - missed,
            "missed": missed,
            "right_per_second": round(right / elapsed, 2),
        }
    return rows


def our_late(line, sets):
    words = our(line.port, USUAL, "--timeout", f"{LATE_TIMEOUT_S * 1_000:.0f}ms", "read")
    rows = document([*words, *(f"{RATED_SPEED}@{number}" for number in sets)])[0]["data"]["values"]
    return [row["raw"] for row in rows]


def peer_late(line, master, sets):
    opened = master(line.port, USUAL, timeout_s=LATE_TIMEOUT_S)
    try:
        return [attempt(opened, register(RATED_SPEED, number)) for number in sets]
    finally:
        opened.close()


def attempt(opened, number, station=1):
    """A value, or `None`: what a user's own loop does about an exception."""
    try:
        return opened.read(number, station)
    except Missed:
        return None


# Scan -----------------------------------------------------------------------------------------------------------------


def scans(budget_s):
    """Addresses 1 to 247 at a known setting. A master that takes longer than the budget asks fewer silent addresses."""
    toml = "".join(USUAL.drive(address, delay) for address, delay in SCANNED.items())
    with bus(toml) as line:
        line.rest()
        words = [str(BINARY), "--no-config", "-p", line.port, *USUAL.words, "scan"]
        found, elapsed = document(words)
        rows = {OURS: scan_row([drive["address"] for drive in found["data"]["drives"]], elapsed, LAST_ADDRESS)}
    for master in speaking(USUAL):
        with bus(toml) as line:
            line.rest()
            rows[master.name] = peer_scan(line, master, budget_s)
    return rows


def peer_scan(line, master, budget_s):
    opened = master(line.port, USUAL)
    found, silent, started = [], 0, time.perf_counter()
    try:
        for address in range(1, LAST_ADDRESS + 1):
            over = time.perf_counter() - started > budget_s
            if over and address not in SCANNED:
                continue
            silent += address not in SCANNED
            if attempt(opened, REGISTER, address) is not None:
                found.append(address)
    finally:
        opened.close()
    asked = silent + len(SCANNED)
    return scan_row(found, (time.perf_counter() - started) * LAST_ADDRESS / asked, asked)


def scan_row(found, seconds, asked):
    return {"found": found, "seconds": round(seconds, 2), "asked": asked}


def unknown_scans(count):
    """A drive at address 1 with a setting that nobody knows: how long until it is found? `None` where it is not.

    Steps of 7 through the 36 settings: every speed is among the first six.
    """
    times = {}
    for baud, parity, protocol in (UNKNOWN[7 * turn % len(UNKNOWN)] for turn in range(count)):
        drive = f'[[drive]]\nmodel = "act"\nbaud = {baud}\nparity = "{parity}"\nprotocol = "{protocol}"\n'
        with bus(drive) as line:
            auto = [word for name in ("--baud", "--parity", "--protocol") for word in (name, "auto")]
            words = [str(BINARY), "--no-config", "-p", line.port, *auto, "scan", "--until-first"]
            line.rest()
            found, elapsed = document(words)
        drives = (found["data"] or {}).get("drives")
        times[f"{baud} {parity} {protocol}"] = round(elapsed, 2) if drives else None
    return times


# Full read ------------------------------------------------------------------------------------------------------------


def full_read(setting):
    """The whole catalogue, in four data sets where there are four. The others read what is one register wide of it."""
    with bus(setting.drive(1)) as line:
        line.rest()
        values, elapsed = document(our(line.port, setting, "read", *everything()))
    rows = [row for row in values["data"]["values"] if row["raw"] is not None]
    result = {OURS: full_row(len(rows), elapsed)}
    narrow = [register(row["param"], row["data_set"]) for row in rows if row["data_type"] != "long"]
    for master in speaking(setting):
        with bus(setting.drive(1)) as line:
            line.rest()
            opened = master(line.port, setting, timeout_s=0.5)
            started = time.perf_counter()
            got = [attempt(opened, number) for number in narrow]
            elapsed = time.perf_counter() - started
            opened.close()
        result[master.name] = full_row(sum(value is not None for value in got), elapsed)
    return result


def everything():
    """Every parameter that the simulated drive has, as selectors: four data sets where it has them."""
    program = [str(BINARY), "--no-config", "-p", "sim", "-a", "1", "--drive", "act", "read"]
    selectors = {}
    for words in (["@all"], ["@all@all"]):
        for row in document([*program, *words])[0]["data"]["values"]:
            if row["raw"] is not None:
                selectors.setdefault(row["param"], set()).add(row["data_set"])
    names = ((number, data_set) for number, sets in selectors.items() for data_set in sorted(sets - {0} or sets))
    return [f"{number}@{data_set}" if data_set else str(number) for number, data_set in names]


def full_row(values, seconds):
    return {"values": values, "seconds": round(seconds, 2), "per_second": round(values / seconds, 2)}


def allow_long_benches():
    """A bench ends by itself, but not before the longest trial."""
    harness.BENCH_LIFE = "20m"
