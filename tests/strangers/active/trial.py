#!/usr/bin/env python3
"""Trial of `antrieb` by a stranger: every verb against an independent ACT / ACU drive.

    ANTRIEB=path/to/antrieb python3 trial.py [--quick] [--jobs N] [--only TEXT] [--list] [--verbose]

Each case starts a drive of `active_drive.py` under one reading of the manual and one disturbance of
the line, runs the real program against it as a user would, and judges what it did: whether it
ended in time, whether every value it printed is one that this drive really holds, whether what it
claims of the shaft is true, whether the shaft is left turning, what it wore off the EEPROM, whether
it gave back what it changed, and which rules of the manual it broke on the line.

One line for each case, last line `N passed, N failed`; exit status 1 if any failed. Python 3
standard library only. The drive and the program are given a limit each: everything ends by itself.
"""

import argparse
import concurrent.futures
import json
import os
import pty
import random
import re
import select
import signal
import subprocess
import sys
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from active_drive import ENABLED, FAULT, INHIBIT, QUICK, READY, SWITCHED_ON, DriveServer, options  # noqa: E402

BINARY = os.environ.get("ANTRIEB", "antrieb")
SLACK = 0.6  # seconds that a loaded machine may add to a bound
SETUP = {  # parameters of motion that make runs short and the arithmetic plain
    "fast": "--set 418=0 --set 420=5000 --set 421=5000 --set 422=5000 --set 423=5000 --set 424=10000 --set 425=10000",
    "slow": "--set 418=0 --set 420=1000 --set 421=500 --set 422=1000 --set 423=500 --set 424=1000 --set 425=1000",
}


class Case:
    """One trial: a name, the drive, the command line, and how to judge."""

    def __init__(self, name, drive, args, judges=(), bound=15.0, signals=(), answers=None, after=0.6,
                 exits=None, sins=(), quick=False, wear=0, stdin=None, env=None):
        self.name, self.drive, self.args = name, drive, args
        self.judges, self.bound, self.signals, self.answers = list(judges), bound, list(signals), answers
        self.after, self.exits, self.allowed_sins, self.quick, self.wear = after, exits, set(sins), quick, wear
        self.env = env or {}


class Run:
    """What came of a case: output, exit status, times, and the drive as it was when the program ended."""

    out = err = ""
    rc = None
    hung = False
    seconds = 0.0
    server = None
    at_exit = None  # (state, output, shaft) when the program ended
    at_end = None  # the same after Case.after
    top_after = 0.0  # fastest that the output stage drove the shaft after the end
    before = after_settings = None

    def document(self):
        try:
            return json.loads(self.out)
        except ValueError:
            return None

    def lines(self):
        """The documents of a stream, one a line."""
        got = []
        for line in self.out.splitlines():
            try:
                got.append(json.loads(line))
            except ValueError:
                return None
        return got

    @property
    def said(self):
        return self.out + "\n" + self.err


def execute(case):
    """Runs a case; never raises for what the program does."""
    run = Run()
    text = case.drive + f" --for {case.bound + case.after + 30}"
    opt = options(text)
    with DriveServer(opt) as server:
        run.server = server
        run.before = server.drive.settings()
        run.setpoint_before = server.drive.line_setpoint
        command = [BINARY, "-p", server.path, "--no-config", "--lang", "en"] + case.args.split()
        if opt.protocol != "rtu" and "--protocol" not in case.args:
            command += ["--protocol", opt.protocol]
        env = dict(os.environ, HOME="/nonexistent", TERM="dumb", **case.env)
        for name in ("ANTRIEB_PORT", "ANTRIEB"):
            env.pop(name, None)
        master = None
        if case.answers is not None:
            master, slave = pty.openpty()
            streams = dict(stdin=slave, stdout=slave, stderr=slave)
        else:
            streams = dict(stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        begin = time.monotonic()
        child = subprocess.Popen(command, env=env, start_new_session=True, **streams)
        if master is not None:
            os.close(slave)
        collected = {"out": b"", "err": b""}

        def drain(pipe, key):
            while True:
                piece = os.read(pipe.fileno(), 65536)
                if not piece:
                    return
                collected[key] += piece

        readers = []
        if master is None:
            for pipe, key in ((child.stdout, "out"), (child.stderr, "err")):
                reader = threading.Thread(target=drain, args=(pipe, key), daemon=True)
                reader.start()
                readers.append(reader)
        signals, answers = list(case.signals), list(case.answers or [])
        run.signalled = []
        while child.poll() is None:
            now = time.monotonic()
            if now - begin > case.bound + SLACK:
                run.hung = True
                child.kill()
                break
            if signals:
                after, number = signals[0]
                if after is None or isinstance(after, str):
                    zero = None
                elif after < 0:
                    zero = begin
                else:
                    zero = server.drive.first_enabled
                if zero is not None and now >= zero + abs(after):
                    signals.pop(0)
                    run.signalled.append(now)
                    child.send_signal(number)
            if master is not None:
                if select.select([master], [], [], 0.01)[0]:
                    try:
                        collected["out"] += os.read(master, 65536)
                    except OSError:
                        pass
                if answers and answers[0][0].encode() in collected["out"]:
                    _, reply = answers.pop(0)
                    collected["out"] += b""
                    if isinstance(reply, str):
                        os.write(master, reply.encode())
                    else:
                        run.signalled.append(time.monotonic())
                        child.send_signal(reply)
            else:
                time.sleep(0.01)
        run.rc = child.wait()
        ended = time.monotonic()
        run.seconds = ended - begin
        run.at_exit = server.look()
        for reader in readers:
            reader.join(1.0)
        if master is not None:
            while select.select([master], [], [], 0.05)[0]:
                try:
                    piece = os.read(master, 65536)
                except OSError:
                    break
                if not piece:
                    break
                collected["out"] += piece
            os.close(master)
        else:
            child.stdout.close()
            child.stderr.close()
        run.out = collected["out"].decode("utf-8", "replace")
        run.err = collected["err"].decode("utf-8", "replace")
        run.count_at_exit = server.drive.was_enabled_count
        time.sleep(case.after)
        run.at_end = server.look()
        run.after_settings = server.drive.settings()
        run.setpoint_after = server.drive.line_setpoint
        run.top_after = max([abs(o) for t, s, o, f in list(server.samples) if t > ended] or [0.0])
    return run


# ---------------------------------------------------------------------------------------------
# Judges. Each takes (case, run) and returns a list of complaints.
# ---------------------------------------------------------------------------------------------

WARNS = re.compile(r"may still (be )?turn|still turn|may turn on|keeps running|keep running|runs on|may be running"
                   r"|may run on|coasts|coasting|coasted|without power|is not known|NOT acknowledged|not acknowledged", re.I)


def in_time(case, run):
    if run.hung:
        return [f"HANG: not ended after {case.bound + SLACK:.1f} s"]
    return []


def no_crash(case, run):
    if run.hung:
        return []
    bad = []
    if run.rc == 70 or run.rc in (101, 134, -6, -11) or "panicked" in run.said:
        bad.append(f"CRASH: exit {run.rc}")
    elif run.rc < 0:
        bad.append(f"ended by signal {-run.rc}")
    elif run.rc not in (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 130):
        bad.append(f"exit {run.rc} is in no contract")
    return bad


def expected_exit(case, run):
    if case.exits is not None and not run.hung and run.rc not in case.exits:
        last = (run.err.strip().splitlines() or [""])[0][:160]
        return [f"exit {run.rc}, expected {'/'.join(map(str, sorted(case.exits)))}: {last}"]
    return []


def whole_document(case, run):
    """--json: exactly one document, whose `ok` is the exit status."""
    if "--json" not in case.args or run.hung or case.answers is not None or "monitor" in case.args:
        return []
    doc = run.document()
    if doc is None:
        return ["stdout is not one JSON document"]
    if bool(doc.get("ok")) != (run.rc == 0):
        return [f"ok = {doc.get('ok')} with exit {run.rc}"]
    error = doc.get("error")
    if run.rc and error and error.get("exit") != run.rc:
        return [f"error.exit = {error.get('exit')} with exit {run.rc}"]
    return []


def rows_of(node):
    """Every value row anywhere in a document."""
    if isinstance(node, dict):
        if "param" in node and node.get("raw") is not None and "old_raw" not in node:
            yield node
        for value in node.values():
            yield from rows_of(value)
    elif isinstance(node, list):
        for value in node:
            yield from rows_of(value)


DYNAMIC = {210, 211, 213, 217, 218, 228, 229, 241, 249, 250, 260, 270, 282, 283, 410, 411, 484, 524, 11}


def true_values(case, run):
    """Every value printed is one that this drive really gave for that parameter and data set."""
    if "--json" not in case.args:
        return []
    docs = [run.document()] if "monitor" not in case.args else run.lines()
    if not docs or docs[0] is None:
        return []
    drive, bad = run.server.drive, []
    served = {}
    for _, number, s, raw in drive.served:
        served.setdefault((number, s), set()).add(raw)
    for row in rows_of(docs):
        number, s, raw = row["param"], row.get("data_set") or 0, row["raw"]
        if run.server.neighbour is not None and row.get("address") == run.server.opt.neighbour:
            given = {r for _, n, k, r in run.server.neighbour.served if n == number and k in (s, s + 5)}
            if raw & 0xFFFFFFFF not in given:
                bad.append(f"WRONG VALUE: neighbour's P.{number}@{s} = {raw}, it gave {sorted(given)[:4]}")
            continue
        if number not in drive.rows:
            bad.append(f"WRONG VALUE: P.{number} = {raw}, this drive has no such parameter")
            continue
        bits = drive.rows[number].bits
        got = served.get((number, s), set()) | served.get((number, s + 5), set())
        if raw & ((1 << bits) - 1) not in got:
            bad.append(f"WRONG VALUE: P.{number}@{s} = {raw}, the drive gave {sorted(got)[:4]}")
        elif number not in DYNAMIC and not drive.writes:
            kept = {drive.eeprom.get((number, k)) for k in ([s] if s else [0, 1, 2, 3, 4])}
            kept |= {drive.ram.get((number, k)) for k in ([s] if s else [0, 1, 2, 3, 4])}
            if raw not in kept:
                bad.append(f"WRONG VALUE: P.{number}@{s} = {raw}, it is {kept}")
    return bad[:4]


def nothing_worn(case, run):
    worn = run.server.drive.wear
    if len(worn) > case.wear:
        return [f"EEPROM: {len(worn)} writes, {case.wear} expected: {[w[1:] for w in worn][:5]}"]
    return []


def no_sins(case, run):
    bad, seen = [], set()
    for when, name, detail in run.server.sins:
        if name not in case.allowed_sins and name not in seen:
            seen.add(name)
            count = sum(1 for s in run.server.sins if s[1] == name)
            bad.append(f"sin {name} x{count}, first at {when:.2f} s: {detail}")
    return bad


GENERAL = [in_time, no_crash, expected_exit, whole_document, true_values, nothing_worn, no_sins]


def given_back(case, run):
    """A held run leaves every parameter as it was, and no setpoint behind."""
    if run.hung:
        return []
    bad = []
    for key in sorted(set(run.before) | set(run.after_settings)):
        if run.before.get(key) != run.after_settings.get(key):
            was, now = run.before.get(key), run.after_settings.get(key)
            number = key.split("@")[0]
            told = [c for c in (((run.document() or {}).get("data") or {}).get("changed") or [])
                    if c["param"] == int(number) and c.get("restored") is False]
            if told:
                continue
            if f"P.{number}" in run.err and re.search(r"not (be )?given back|NOT given back|left|unknown|restor", run.err):
                continue
            bad.append(f"NOT GIVEN BACK: P.{key} {was} -> {now}")
    if run.setpoint_after not in (0, run.setpoint_before) and reachable(run):
        bad.append(f"setpoint left behind: P.484 = {run.setpoint_after / 100} Hz")
    return bad


def truth_of_stop(case, run):
    """What is claimed of the shaft must be so; what is turning must be told."""
    if run.hung:
        state, output, shaft = run.at_exit
        return [f"SHAFT TURNING at {shaft:.1f} Hz in {state} when killed"] if abs(shaft) > 0.3 else []
    bad = []
    state, output, shaft = run.at_exit
    doc = run.document() if "--json" in case.args else None
    data = (doc or {}).get("data") or {}
    stop = data.get("stop") or {}
    running = data.get("running")
    keep = "keep" in case.args
    turning = abs(shaft) > 0.6
    if running is False and (state in (ENABLED, QUICK) and run.server.drive.powered):
        bad.append(f"FALSE REPORT: running = false, the drive is in {state} at {shaft:.1f} Hz")
    elif running is False and turning and not WARNS.search(run.err) and not stop.get("note"):
        bad.append(f"FALSE REPORT: running = false without a word, the shaft turns at {shaft:.1f} Hz in {state}")
    if stop.get("acknowledged") and state == ENABLED and not keep:
        bad.append("FALSE REPORT: stop acknowledged, the drive is enabled")
    if stop.get("acknowledged") and turning and not WARNS.search(run.err) and not stop.get("note") and not keep:
        bad.append(f"FALSE REPORT: stop acknowledged without a word, the shaft turns at {shaft:.1f} Hz")
    held = "--hold" in case.args or "--jog" in case.args
    if held and not keep:
        if run.rc == 0 and (state in (ENABLED, QUICK) or (turning and not WARNS.search(run.said))):
            bad.append(f"FALSE REPORT: exit 0, but {state} at {shaft:.1f} Hz")
        if state == ENABLED:
            if not WARNS.search(run.err):
                bad.append(f"SHAFT TURNING: {shaft:.1f} Hz in {state} at the end, stderr does not say so")
            elif reachable(run):
                bad.append(f"SHAFT TURNING: {shaft:.1f} Hz in {state} at the end (told), though the drive hears and answers")
    return bad


def reachable(run):
    """Could the drive have been stopped over its line?"""
    opt = run.server.opt
    return not (opt.silent_at or opt.unplug_at)


def stays_down(case, run):
    """After the end nothing may set the shaft in motion again by itself."""
    if run.hung or "keep" in case.args:
        return []
    state, output, shaft = run.at_exit
    if run.server.drive.was_enabled_count > run.count_at_exit:
        return [f"RUNS UP AGAIN after the end: {run.top_after:.1f} Hz, control word {run.server.drive.word:04X}h, "
                f"P.412 in force {run.server.drive.value(412)}"]
    if run.at_end[0] == ENABLED and abs(run.at_end[2]) > 0.6 and run.rc == 0:
        return [f"SHAFT LEFT TURNING: {run.at_end[2]:.1f} Hz, exit 0"]
    return []


def once_enabled(case, run):
    """Every start of the shaft follows a control word of the master, never a contact that came back."""
    drive, zero = run.server.drive, run.server.born
    words = [t for t, n, s, v in drive.writes if n == 410 and v & 0x0F in (0x0F, 0x03)]
    bad, last = [], None
    for t, state, output, shaft in drive.history:
        if state == ENABLED and last not in (ENABLED, None) and not any(0 <= t - w <= 0.1 for w in words) and t > zero + 0.15:
            bad.append(round(t - zero, 2))
        last = state
    if bad:
        return [f"STARTED BY ITSELF at {bad[:6]} s (enable or contact came back, or P.412 changed), "
                f"top {max(abs(o) for _, _, o, _ in run.server.samples):.1f} Hz"]
    return []


def moved(case, run):
    """The run did move the shaft (else the case shows nothing)."""
    if not run.server.drive.was_enabled_count and run.rc == 0:
        return ["exit 0, but the drive was never enabled"]
    return []


def reached_is_reached(case, run):
    """`reached: true` only if the shaft was at its setpoint, within the drive's own tolerance."""
    doc = run.document()
    setpoint = ((doc or {}).get("data") or {}).get("setpoint") or {}
    if setpoint.get("reached") is not True:
        return []
    drive = run.server.drive
    near = drive.tolerance() + 0.3
    if not any(s == ENABLED and abs(o - setpoint["value"]) <= near for _, s, o, _ in run.server.samples):
        top = max(abs(o) for _, _, o, _ in run.server.samples)
        return [f"FALSE REPORT: reached {setpoint['value']} Hz, the shaft never was there (top {top:.1f} Hz)"]
    return []


def follows_setpoint(hertz):
    """The shaft went to this frequency and not beyond it."""
    def judge(case, run):
        top = max([abs(o) for _, _, o, _ in run.server.samples] or [0.0])
        if run.rc == 0 and top < abs(hertz) - 0.6:
            return [f"the shaft came to {top:.1f} Hz only, promised {hertz}"]
        if top > abs(hertz) + 0.3:
            return [f"WRONG SPEED: the shaft came to {top:.1f} Hz, promised {hertz}"]
        return []
    return judge


def keeps_running(case, run):
    state, output, shaft = run.at_exit
    if run.rc == 0 and state != ENABLED:
        return [f"--on-exit keep: {state} at the end"]
    if run.rc == 0 and run.document() and run.document()["data"].get("running") is not True:
        return ["keeps running, but does not say so in `running`"]
    if re.search(r"NOT acknowledged", run.said):
        return ["keep says that a stop was not acknowledged"]
    return []


def ends_in(*states):
    """Exit 0 only in one of these states."""
    def judge(case, run):
        if run.rc == 0 and run.at_exit[0] not in states:
            return [f"FALSE REPORT: exit 0 in {run.at_exit[0]} at {run.at_exit[2]:.1f} Hz"]
        return []
    return judge


def stopped_within(seconds):
    """From the first signal until the output stage is off or the shaft stands."""
    def judge(case, run):
        if not run.signalled:
            return ["the signal was never sent: the run did not get so far"]
        zero = run.signalled[0]
        for t, s, o, f in run.server.samples:
            if t >= zero and s != ENABLED:
                return [] if t - zero <= seconds else [f"STOP LATE: {t - zero:.1f} s after the signal"]
        return ["STOP never came after the signal"]
    return judge


def wrote(number, s, raw, old):
    """Exit 0 means written; nothing but the old and the new value may ever stand there."""
    def judge(case, run):
        drive, bad = run.server.drive, []
        sets = [s] if s or not drive.rows[number].per_set else [1, 2, 3, 4]
        for k in sets:
            is_now = drive.ram.get((number, k), drive.eeprom[number, k])
            if run.rc == 0 and is_now != raw:
                bad.append(f"FALSE REPORT: exit 0, P.{number}@{k} is {is_now}, promised {raw}")
            if is_now not in (raw, old):
                bad.append(f"WRONG VALUE WRITTEN: P.{number}@{k} is {is_now}")
            doc = run.document() or {}
            for row in ((doc.get("data") or {}).get("values") or []):
                if row["param"] == number and row.get("result") in ("not_sent", "not sent", "refused") and is_now == raw != old:
                    bad.append(f"FALSE REPORT: result {row['result']}, but it is written")
        return bad
    return judge


def nothing_sent(case, run):
    sent = [data.hex(" ") for _, way, data in run.server.log if way == "<"]
    return [f"something was sent: {sent[:3]}"] if sent else []


def nothing_written(case, run):
    return [f"written: {run.server.drive.writes[:3]}"] if run.server.drive.writes else []


def stop_sent_within(seconds):
    """The stop goes out at once: from the first byte on the line to the telegram that writes P.410 (or P.484)."""
    marks = {"rtu": (b"\x06\x01\x9a", b"\x65\x01\xe4"), "ascii": (b"06019A", b"6501E4"), "vabus": (b"\x0200410", b"\x0200484")}

    def judge(case, run):
        first = next((t for t, way, _ in run.server.log if way == "<"), None)
        for t, way, data in run.server.log:
            if way == "<" and any(m in data for m in marks[run.server.opt.protocol]):
                return [] if t - first <= seconds else [f"STOP SENT LATE: {t - first:.1f} s after the first question"]
        return [f"STOP NEVER SENT in {run.seconds:.1f} s"]
    return judge


def no_word_ignored(case, run):
    """Nothing is left in P.410 that could act later, when P.412 changes."""
    word = run.server.drive.word
    if word & 0x80 or (run.rc and word & 0x0F == 0x0F):
        return [f"control word {word:04X}h is left in the drive"]
    return []


def says(*patterns):
    def judge(case, run):
        return [f"does not say /{p}/" for p in patterns if not re.search(p, run.said, re.I | re.S)]
    return judge


def never_says(*patterns):
    def judge(case, run):
        return [f"says /{p}/" for p in patterns if re.search(p, run.said, re.I | re.S)]
    return judge


# ---------------------------------------------------------------------------------------------
# The cases
# ---------------------------------------------------------------------------------------------

READERS = {
    "identify": ("-a 1 identify --json", 12),
    "read": ("-a 1 read 372@all 480-482@2 411 1376 413 --json", 14),
    "read-actual": ("-a 1 read @actual --json", 16),
    "dataset-show": ("-a 1 dataset show 372 480 --json", 16),
    "dataset-diff": ("-a 1 dataset diff 1 2 480 481 --json", 12),
    "diag": ("-a 1 diag --json", 16),
    "diag-line": ("-a 1 diag line --count 12 --json", 30),
    "state": ("-a 1 statemachine --json", 12),
    "sollwert": ("-a 1 sollwert --json", 22),
    "protocol": ("-a 1 protocol show --json", 9),
    "line": ("-a 1 line show --json", 9),
    "monitor": ("-a 1 monitor --interval 200ms --duration 2s --json", 10),
}

# a master that takes the copy for its reply asks on while the drive still works: a consequence, no sin of its own
TWICE = ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early", "bad-telegram")

# disturbance: (options, sins that are nobody's fault, time factor)
DISTURBANCES = {
    "late100": ("--late 100", (), 1.5),
    "late300": ("--late 300", (), 2.5),
    "late600": ("--late 600", ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early"), 8),
    "late900": ("--late 900", ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early"), 16),
    "late2of3": ("--late 700 --late-every 3", ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early"), 6),
    "overtake": ("--late 700 --late-every 3 --overtake", ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early"), 6),
    "jitter": ("--late 1 --late-jitter 600", ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early"), 6),
    "lost3": ("--lose 3", (), 5),
    "deaf4": ("--deaf 4", (), 4),
    "garble3": ("--garble 3", (), 5),
    "cut3": ("--cut 3", (), 5),
    "double": ("--double 3", TWICE, 4),
    "double40": ("--double 2 --double-after 40", TWICE, 4),
    "double200": ("--double 2 --double-after 200", TWICE, 4),
    "double500": ("--double 1 --double-after 500", TWICE, 6),
    "twin": ("--twin 4", TWICE, 6),
    "twin100": ("--twin 100", TWICE, 6),
    "babble": ("--babble", (), 4),
    "flood": ("--flood", (), 4),
    "master12": ("--other-master 12", ("telegram-before-time-out",), 5),
    "master25": ("--other-master 25", ("telegram-before-time-out",), 5),
    "echo": ("--echo whole", (), 2),
    "echo-behind": ("--echo behind", (), 3),
    "echo-late": ("--echo whole --late 150", (), 4),
    "pieces": ("--pieces 16", (), 3),
    "noise": ("--noise", (), 3),
    "tail": ("--tail", (), 3),
    "other-address": ("--wrong-address 3", (), 5),
    "other-function": ("--wrong-function 3", (), 5),
}
ALWAYS = ("late", "lost", "deaf", "double", "pieces", "echo")  # a patient master gets through these

READINGS = {
    "act": "--family act",
    "acu": "--family acu",
    "acu-bit4": "--family acu --bit4 running --x-bits 1",
    "edge": "--command-by edge",
    "eeprom-copy": "--read-back eeprom",
    "unknown2": "--unknown 2 --wrong-width 2",
    "folded": "--set-character folded",
    "nak-silent": "--nak-lock silent --wrong-bcc silent",
    "reset-remote": "--reset-needs-remote yes",
    "coast-shown": "--coast-shows shaft --set 392=0",
    "encoder": "--feedback yes --set 392=0",
    "turn1": "--turnaround 1",
    "slow500": "--late 430",
}


def reading_cases():
    """Verbs that only read, under every reading, protocol and disturbance."""
    for verb, (args, bound) in READERS.items():
        for protocol in ("rtu", "ascii", "vabus"):
            for reading, text in READINGS.items():
                if reading in ("folded", "nak-silent") and protocol != "vabus":
                    continue
                factor = 8 if reading == "slow500" else 1
                exits = {0}
                yield Case(f"read/{protocol}/{verb}/{reading}", f"--protocol {protocol} {text}", args,
                           GENERAL, bound + 4 * factor, exits=exits, after=0.0,
                           quick=(protocol == "rtu" and reading in ("act", "acu", "unknown2"))
                           or (protocol == "vabus" and reading == "folded"))
            for name, (text, sins, factor) in DISTURBANCES.items():
                passes = name.startswith(ALWAYS) and name not in ("late600", "late900", "double500", "late2of3", "deaf4", "lost3")
                exits = {0} if passes else {0, 1, 3, 4, 5, 6, 9}
                yield Case(f"read/{protocol}/{verb}/{name}", f"--protocol {protocol} {text}", args,
                           GENERAL, bound * factor, exits=exits, sins=sins, after=0.0,
                           quick=protocol == "rtu" and verb in ("read", "identify") or
                           protocol == "vabus" and verb == "read")
    # two drives on one line: the late reply of the first meets the question to the second (6.8)
    for protocol in ("rtu", "ascii", "vabus"):
        for name in ("late300", "late600", "late900", "lost3", "late2of3", "jitter", "garble3", "double40", "double200", "echo"):
            text, sins, factor = DISTURBANCES[name]
            yield Case(f"two/{protocol}/read/{name}", f"--protocol {protocol} --neighbour 2 {text}",
                       "-a 1,2 read 372@1 480@2 --json", GENERAL, 12 * factor, after=0,
                       sins=TWICE + tuple(sins), quick=protocol == "rtu")
            yield Case(f"two/{protocol}/diag/{name}", f"--protocol {protocol} --neighbour 2 {text}",
                       "-a 1,2 diag --json", GENERAL, 16 * factor, after=0, sins=TWICE + tuple(sins))
            yield Case(f"two/{protocol}/monitor/{name}", f"--protocol {protocol} --neighbour 2 {text}",
                       "-a 1,2 monitor 372@1 480@2 --interval 100ms --duration 4s --json", GENERAL, 12 * factor, after=0,
                       sins=TWICE + tuple(sins), quick=protocol == "rtu")
    differ = "--set 480@2=777 --set 372@3=955"
    for protocol in ("rtu", "ascii", "vabus"):
        p = f"--protocol {protocol} {differ}"
        yield Case(f"differ/{protocol}/read", p, "-a 1 read 480 --json", GENERAL, 8, quick=True)
        yield Case(f"differ/{protocol}/diff", p, "-a 1 dataset diff 1 2 480 481 --json", GENERAL, 8, exits={1}, quick=True)
        yield Case(f"differ/{protocol}/show", p, "-a 1 dataset show 480 372 --json", GENERAL, 8, exits={0})
        yield Case(f"unknown/{protocol}/read", p, "-a 1 read 1599 --json", GENERAL, 8, exits={6, 9}, quick=True)
        yield Case(f"raw/{protocol}/read", p, "-a 1 read 638 637 632 424 --json", GENERAL, 8, exits={0}, quick=True)
        yield Case(f"fault/{protocol}/check", f"--protocol {protocol} --fault 0x0503", "-a 1 diag --check --json",
                   GENERAL, 8, exits={1}, quick=True)
    yield Case("fault/shown", "--fault 0x2010 --warning 0x008B", "-a 1 diag",
               GENERAL + [says("F2010|0x2010|watchdog")], 8, exits={0}, quick=True)


def scan_cases():
    """Scanning and sniffing."""
    for protocol in ("rtu", "ascii", "vabus"):
        for name in ("clean", "late100", "late300", "late600", "lost3", "double40", "babble", "master25", "echo", "pieces",
                     "flood", "twin"):
            text, sins, factor = ("", (), 1) if name == "clean" else DISTURBANCES[name]
            finds = name in ("clean", "late100", "late300", "echo", "pieces", "double40")

            def judge(case, run, finds=finds):
                doc = run.document() or {}
                found = [d["address"] for d in ((doc.get("data") or {}).get("drives") or [])]
                extra = [a for a in found if a not in (7, 17)]
                bad = [f"FALSE REPORT: found {extra}, only 7 is there"] if extra else []
                if finds and 7 not in found:
                    bad.append(f"drive 7 not found: {found}")
                return bad

            yield Case(f"scan/{protocol}/{name}", f"--protocol {protocol} --address 7 {text}",
                       "scan -a 1-12 --json", GENERAL + [judge], 40,
                       sins=tuple(sins) + ("telegram-before-time-out", "telegram-into-reply", "telegram-too-early"),
                       exits={0} if finds else {0, 1, 4, 5, 8, 9}, after=0, quick=protocol == "rtu" or name == "clean")
        yield Case(f"scan/{protocol}/thorough", f"--protocol {protocol} --address 3 --late 450",
                   "scan -a 1-4 --thorough --json", GENERAL, 40, exits={0}, after=0,
                   sins=("telegram-before-time-out", "telegram-too-early"))
        yield Case(f"sniff/{protocol}/master", f"--protocol {protocol} --other-master 25", "sniff --for 2s --json",
                   GENERAL + [nothing_sent], 6, exits={0}, after=0, quick=True)
        yield Case(f"sniff/{protocol}/babble", f"--protocol {protocol} --babble", "sniff --for 2s --json",
                   GENERAL + [nothing_sent], 6, after=0, exits={0, 1, 5}, quick=True)
        yield Case(f"sniff/{protocol}/flood", f"--protocol {protocol} --flood", "sniff --for 2s --json",
                   GENERAL + [nothing_sent], 6, after=0, exits={0, 1, 5})
    yield Case("scan/auto", "--protocol vabus --baud 9600 --address 2", "scan -a 1-3 --baud auto --protocol auto --json",
               GENERAL, 120, exits={0}, after=0, sins=("bad-telegram", "telegram-before-time-out", "telegram-into-reply",
                                                     "telegram-too-early"))


def write_cases():
    """Writes: proven, not repeated needlessly, never wrong."""
    disturbed = {"clean": ("", (), 1)}
    disturbed.update(DISTURBANCES)
    for protocol in ("rtu", "ascii", "vabus"):
        for name, (text, sins, factor) in disturbed.items():
            quick = name in ("clean", "double40", "late600", "lost3", "twin", "garble3", "echo") and protocol != "ascii"
            exits = {0} if name in ("clean", "late100", "late300", "double", "double40", "pieces", "echo") else {0, 3, 4, 5, 6, 8, 9}
            yield Case(f"write/{protocol}/eeprom/{name}", f"--protocol {protocol} {text}",
                       "-a 1 write 480@2=12.5Hz --yes --json", GENERAL + [wrote(480, 2, 1250, 500)],
                       10 * factor, exits=exits, sins=sins, wear=3, after=0.2, quick=quick)
            yield Case(f"write/{protocol}/ram/{name}", f"--protocol {protocol} {text}",
                       "-a 1 write 638@1ram=1.5s --yes --json", GENERAL + [wrote(638, 1, 15, 5)],
                       10 * factor, exits=exits, sins=sins, wear=0, after=0.2, quick=quick and protocol == "rtu")
        for reading, text in READINGS.items():
            yield Case(f"write/{protocol}/reading/{reading}", f"--protocol {protocol} {text}",
                       "-a 1 write 480@2=12.5Hz 481@3ram=-3Hz 413=4 --yes --json",
                       GENERAL + [wrote(480, 2, 1250, 500), wrote(481, 3, -300, 1000), wrote(413, 0, 4, 0)],
                       25, exits={0}, wear=2, after=0.2, quick=reading in ("eeprom-copy", "act"))
        p = f"--protocol {protocol}"
        yield Case(f"write/{protocol}/same", p, "-a 1 write 480@2=5Hz --yes --json", GENERAL + [nothing_written],
                   6, exits={0}, wear=0, after=0, quick=True)
        yield Case(f"write/{protocol}/running", p + " --running --left 10 " + SETUP["fast"],
                   "-a 1 write 372@1=1400 --yes --json", GENERAL + [wrote(372, 1, 1400, 1390)], 8,
                   exits={6, 8}, sins=("write-while-running",), after=0, quick=True)
        yield Case(f"write/{protocol}/range", p, "-a 1 write 434=7 --yes --json", GENERAL + [nothing_sent], 6,
                   exits={7}, after=0, quick=True)
        yield Case(f"write/{protocol}/refused", p, "-a 1 write 375@2=9Hz --force --yes --json",
                   GENERAL + [nothing_written], 8, exits={6}, after=0, quick=True)
        yield Case(f"write/{protocol}/after-nak", p, "-a 1 write 375@2=9Hz 480@2=7Hz --force --yes --json",
                   GENERAL, 10, exits={6, 9}, wear=1, after=0, quick=True)
        yield Case(f"write/{protocol}/nak-silent", p + " --nak-lock silent",
                   "-a 1 write 375@2=9Hz 480@2=7Hz --force --yes --json", GENERAL, 12, exits={6, 9}, wear=1, after=0)
        yield Case(f"write/{protocol}/readonly", p, "-a 1 write 411=3 --yes --json", GENERAL + [nothing_sent], 6,
                   exits={7}, after=0, quick=True)
        yield Case(f"dataset/{protocol}/copy", p + " --set 480@1=777 --set 481@1=888",
                   "-a 1 dataset copy 1 2 480 481 --yes --json",
                   GENERAL + [wrote(480, 2, 777, 500), wrote(481, 2, 888, 1000)], 8, exits={0}, wear=2, after=0, quick=True)
        yield Case(f"dataset/{protocol}/copy-ram", p + " --set 480@1=777 --set 481@1=888",
                   "-a 1 dataset copy 1 2 480 481 --ram --yes --json",
                   GENERAL + [wrote(480, 2, 777, 500), wrote(481, 2, 888, 1000)], 8, exits={0}, wear=0, after=0)
        yield Case(f"dataset/{protocol}/copy-ram-copy-shown", p + " --read-back eeprom --set 480@1=777",
                   "-a 1 dataset copy 1 2 480 --ram --yes --json",
                   GENERAL + [wrote(480, 2, 777, 500)], 8, exits={0}, wear=0, after=0)
        yield Case(f"dataset/{protocol}/select", p, "-a 1 dataset select 2 --yes --json",
                   GENERAL + [wrote(414, 0, 2, 0)], 8, exits={0}, wear=1, after=0, quick=True)
        yield Case(f"dataset/{protocol}/select-ram", p, "-a 1 dataset select 3 --ram --yes --json",
                   GENERAL + [wrote(414, 0, 3, 0)], 8, exits={0}, wear=0, after=0)
        for reply in ("old", "lost", "new"):
            for other in ("rtu", "ascii", "vabus"):
                if other != protocol:
                    yield Case(f"protocol/{protocol}-{other}/{reply}", p + f" --switch-reply {reply}",
                               f"-a 1 --protocol {protocol} protocol set {other} --yes --json", GENERAL, 25, exits={0},
                               wear=2, after=0, sins=("bad-telegram", "telegram-before-time-out"), quick=reply == "lost")
    yield Case("write/question/ctrl-c", "", "-a 1 write 480@2=12.5Hz", [in_time, nothing_written], 8,
               answers=[("[y/N]", signal.SIGINT), ("\0never", "y\n")], exits={130}, after=0.2, quick=True)
    yield Case("write/question/no", "", "-a 1 write 480@2=12.5Hz", GENERAL + [nothing_written], 8,
               answers=[("[y/N]", "n\n")], exits={8}, after=0, quick=True)
    yield Case("write/question/yes", "", "-a 1 write 480@2=12.5Hz", GENERAL, 8,
               answers=[("[y/N]", "y\n")], exits={0}, wear=1, after=0, quick=True)


STOP_JUDGES = GENERAL + [truth_of_stop, stays_down, once_enabled, given_back, reached_is_reached]


def motion_cases():
    """Held runs: every way to end, every reading, every disturbance."""
    fast, slow = SETUP["fast"], SETUP["slow"]
    run20 = "-a 1 sollwert 20Hz --source line --enable --hold --duration 1500ms --yes --json"
    for protocol in ("rtu", "ascii", "vabus"):
        for family in ("act", "acu"):
            base = f"--protocol {protocol} --family {family}"
            for on_exit in ("ramp", "quick-stop", "coast", "keep"):
                for p392 in (0, 1, 2):
                    judges = GENERAL + [keeps_running, moved] if on_exit == "keep" else STOP_JUDGES + [moved, follows_setpoint(20)]
                    yield Case(f"hold/{protocol}/{family}/{on_exit}/392={p392}", f"{base} {fast} --set 392={p392}",
                               run20 + f" --on-exit {on_exit}", judges, 14, exits={0} if p392 == 2 or on_exit == "keep" else {0, 8}, after=0.5,
                               quick=protocol == "rtu" and (p392 == 2 or on_exit == "ramp"))
            for reading, text in READINGS.items():
                if reading in ("act", "acu", "acu-bit4") and not text.endswith(family) and "--family" in text:
                    continue
                yield Case(f"hold/{protocol}/{family}/reading/{reading}", f"{base} {fast} {text}",
                           run20 + " --watchdog 2s", STOP_JUDGES + [moved, follows_setpoint(20)], 40 if "late" in text else 16,
                           exits={0, 8} if "late" in text else {0}, after=0.5, quick=protocol == "rtu" and family == "act")
    for protocol in ("rtu", "vabus", "ascii"):
        for name, (text, sins, factor) in DISTURBANCES.items():
            for when in ("enabled", "always"):
                exits = {0, 8} if name == "late300" else {0} if name in ("late100", "double40", "double", "pieces", "echo") else None
                yield Case(f"hold/{protocol}/{name}/{when}", f"--protocol {protocol} {fast} {text} --disturb-when {when}",
                           run20, STOP_JUDGES, 12 + 6 * factor, exits=exits, sins=sins, after=0.6,
                           quick=protocol == "rtu" and (when == "enabled" or name == "twin"))
                if when == "enabled" and name in ("babble", "flood", "master12", "master25", "late600", "lost3", "twin",
                                                  "late900", "double200", "garble3"):
                    yield Case(f"hold/{protocol}/{name}/ctrl-c", f"--protocol {protocol} {fast} {text} --disturb-when enabled",
                               "-a 1 sollwert 20Hz --source line --enable --hold --yes --json",
                               STOP_JUDGES + [stopped_within(3.0)], 30, sins=sins, signals=[(1.0, signal.SIGINT)],
                               exits=None, after=0.6, quick=protocol == "rtu")
                    yield Case(f"hold/{protocol}/{name}/watchdog", f"--protocol {protocol} {fast} {text} --disturb-when enabled",
                               run20 + " --watchdog 2s", STOP_JUDGES, 14 + 6 * factor, sins=sins, exits=None, after=0.6)
        # events in the run
        events = {
            "enable-lost-early": ("--enable-lost 0.02:2.5", None),
            "enable-lost-50ms": ("--enable-lost 0.05:2.5", None),
            "enable-lost-100ms": ("--enable-lost 0.1:3", None),
            "enable-lost-late": ("--enable-lost 0.8:3.5", None),
            "enable-blink": ("--enable-lost 0.8:0.95", None),
            "enable-blink2": ("--enable-lost 0.6:0.63", None),
            "contact-lost": ("--contact-lost 0.8:3.5", None),
            "contact-lost-ramp": ("--contact-lost 0.8:3.5 --start-lost ramp", None),
            "trip-early": ("--trip-at 0.03:0x0500", None),
            "trip": ("--trip-at 0.8:0x0503", None),
            "set-changes-to-contacts": ("--set 412@2=0 --set 480@2=700 --set-changes 0.8:2", None),
            "set-changes-to-keypad": ("--set 412@2=44 --set-changes 0.8:2", None),
            "mains-lost": ("--family acu --mains-lost 0.8:3", None),
            "silent": ("--silent-at 0.8", None),
            "silent-back": ("--silent-at 0.8:2.5", None),
            "silent-watchdog": ("--silent-at 0.8:4 --set 413=1", None),
            "unplug": ("--unplug-at 0.8", None),
            "restart": ("--restart-at 0.8", None),
        }
        for name, (text, _) in events.items():
            for command_by in ("level", "edge"):
                for late in (0, 100):
                    judges = list(STOP_JUDGES)
                    exits = {3, 4, 5, 6, 8, 9}
                    if name in ("silent-back",):
                        exits = None
                    if name == "enable-lost-early":  # still waiting for the state: the enable may come late
                        exits = None
                        judges.remove(once_enabled)
                    if "blink" in name:  # shorter than the time between two looks: nobody can see it
                        exits = None
                        judges.remove(once_enabled)
                    extra = 5.0 if "lost" in name or "silent" in name else 1.0
                    yield Case(f"event/{protocol}/{name}/{command_by}/late{late}",
                               f"--protocol {protocol} {fast} {text} --command-by {command_by} --late {late}",
                               "-a 1 sollwert 20Hz --source line --enable --hold --duration 2s --yes --json",
                               judges, 40, exits=exits, after=extra, sins=("telegram-before-time-out", "telegram-too-early",
                               "enabled-onto-turning-shaft", "control-word-ignored"), quick=protocol == "rtu" and late == 0)
        # signals
        for name, signals, on_exit in (("sigint", [(0.8, signal.SIGINT)], "ramp"), ("sigterm", [(0.8, signal.SIGTERM)], "ramp"),
                                       ("sighup", [(0.8, signal.SIGHUP)], "ramp"),
                                       ("sigint-early", [(0.0, signal.SIGINT)], "ramp"),
                                       ("sigint-quick", [(0.8, signal.SIGINT)], "quick-stop"),
                                       ("sigint-coast", [(0.8, signal.SIGINT)], "coast"),
                                       ("sigint-twice", [(0.8, signal.SIGINT), (1.4, signal.SIGINT)], "ramp"),
                                       ("sigint-thrice", [(0.8, signal.SIGINT), (1.2, signal.SIGINT), (1.6, signal.SIGINT)], "ramp")):
            yield Case(f"signal/{protocol}/{name}", f"--protocol {protocol} {slow}",
                       f"-a 1 sollwert 10Hz --source line --enable --hold --yes --json --on-exit {on_exit}",
                       STOP_JUDGES, 20, signals=signals, exits={130}, after=0.5, quick=protocol == "rtu")
        for at in (-0.05, -0.1, -0.2, -0.3, -0.4, -0.5, -0.6, -0.8):
            yield Case(f"signal/{protocol}/sigint-at{-at:.2f}s", f"--protocol {protocol} {fast}",
                       "-a 1 sollwert 20Hz --source line --enable --hold --watchdog 2s --yes --json",
                       STOP_JUDGES, 15, signals=[(at, signal.SIGINT)], exits={130}, after=0.5)
        # settings that decide what the drive will really do
        p = f"--protocol {protocol}"
        yield Case(f"source/{protocol}/sum-10hz", f"{p} {fast} --internal 10",
                   "-a 1 sollwert 20Hz --enable --hold --duration 1500ms --until reached --yes --json",
                   STOP_JUDGES + [says("10")], 14, after=0.5, quick=True)
        yield Case(f"source/{protocol}/line", f"{p} {fast} --internal 10",
                   "-a 1 sollwert 20Hz --source line --enable --hold --duration 1500ms --until reached --yes --json",
                   STOP_JUDGES + [follows_setpoint(20)], 14, exits={0}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/internal-only", f"{p} {fast} --internal 10 --set 434=1",
                   "-a 1 sollwert 20Hz --enable --hold --duration 1500ms --until reached --yes --json",
                   STOP_JUDGES, 14, exits={4, 5, 6, 7, 8, 9}, sins=("setpoint-without-effect",), after=0.5, quick=True)
        yield Case(f"source/{protocol}/fmin", f"{p} {fast} --set 418=350 --set 434=2",
                   "-a 1 sollwert 1Hz --enable --hold --duration 1500ms --until reached --yes --json",
                   STOP_JUDGES + [says(r"3[.,]50?")], 14, after=0.5, quick=True)
        yield Case(f"source/{protocol}/fmax", f"{p} {fast} --set 419=3000",
                   "-a 1 sollwert 40Hz --enable --hold --duration 1500ms --until reached --yes --json",
                   STOP_JUDGES, 14, exits={4, 5, 6, 7, 8, 9}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/left-behind", f"{p} {fast} --left 45",
                   "-a 1 statemachine enable --hold --duration 1s --yes --json",
                   STOP_JUDGES + [says("45")], 14, after=0.5, quick=True)
        yield Case(f"source/{protocol}/left-behind-sollwert", f"{p} {fast} --left 45",
                   "-a 1 sollwert 5Hz --source line --enable --hold --duration 1s --yes --json",
                   STOP_JUDGES + [follows_setpoint(5)], 14, exits={0}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/stiff", f"{p} {fast} --stiff",
                   "-a 1 sollwert 20Hz --source line --enable --hold --duration 1s --until reached --yes --json",
                   STOP_JUDGES, 20, exits={1, 4, 5, 6, 8, 9}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/percent", f"{p} {fast}",
                   "-a 1 sollwert 30% --enable --hold --duration 1s --yes --json", STOP_JUDGES, 14, after=0.5)
        yield Case(f"source/{protocol}/reverse", f"{p} {fast}",
                   "-a 1 sollwert=-15Hz --yes --json".replace("sollwert=-15Hz", "sollwert -15Hz --source line --enable --hold --duration 1500ms --until reached"),
                   STOP_JUDGES + [follows_setpoint(-15)], 14, exits={0}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/ramp", f"{p} {fast}",
                   "-a 1 sollwert --ramp 0Hz:20Hz:2s --source line --enable --hold --duration 3s --yes --json",
                   STOP_JUDGES + [follows_setpoint(20)], 16, exits={0}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/jog", f"{p} {fast}", "-a 1 sollwert 10Hz --source line --jog 1s --yes --json",
                   STOP_JUDGES + [follows_setpoint(10)], 14, exits={0}, after=0.5, quick=True)
        yield Case(f"source/{protocol}/huge", f"{p} {fast}", "-a 1 sollwert 92233720368547458.07rpm --yes --json",
                   GENERAL + [nothing_written], 8, exits={7}, after=0.2, quick=True)
        yield Case(f"source/{protocol}/acu-mains-off", f"{p} --family acu --no-mains {fast}",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --yes --json", STOP_JUDGES, 20, exits={8, 6, 4},
                   after=0.3, quick=True)
        # stops that take long: the time follows from the drive's own ramps and holding times
        for name, text, hz in (("ramp-10s", "--set 421=100", 10), ("ramp-10s-reverse", "--set 423=100", -10),
                               ("hold-4s", "--set 638=40", 10), ("brake-5s", "--set 392=1 --set 632=50", 10),
                               ("threshold-0", "--set 637=0 --set 638=0", 10), ("threshold-20", "--set 637=200 --set 638=0", 10)):
            yield Case(f"long/{protocol}/{name}", f"{p} {fast} {text}",
                       f"-a 1 sollwert {hz}Hz --source line --enable --hold --duration 1s --yes --json",
                       STOP_JUDGES, 25, exits={0}, after=0.5, quick=protocol == "rtu")
        yield Case(f"long/{protocol}/quick-8s", f"{p} {fast} --set 424=100",
                   "-a 1 sollwert 8Hz --source line --enable --hold --duration 1s --on-exit quick-stop --yes --json",
                   STOP_JUDGES, 25, exits={0}, after=0.5, quick=protocol == "rtu")
        # rows whose width is printed nowhere
        for number, bits in ((418, 16), (419, 16), (421, 16), (424, 16), (549, 32), (638, 32), (475, 32), (30, 32), (229, 16)):
            yield Case(f"width/{protocol}/{number}={bits}", f"{p} {fast} --width {number}={bits}",
                       "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --until reached --yes --json",
                       STOP_JUDGES + [follows_setpoint(10)], 14, exits={0}, after=0.3, quick=protocol == "rtu" and number in (419, 421, 638))
        for number, bits in ((418, 16), (549, 32), (229, 16)):
            yield Case(f"width/{protocol}/read-{number}={bits}", f"{p} --width {number}={bits}",
                       f"-a 1 read {number} --json", GENERAL, 8, exits={0}, after=0, quick=protocol == "rtu")
        yield Case(f"control/{protocol}/acu-x40", f"{p} {fast} --family acu --set 30=240 --no-shortcut",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --yes --json",
                   STOP_JUDGES, 14, exits=None, after=0.3, quick=protocol == "rtu")
        yield Case(f"control/{protocol}/contact-set-3", f"{p} {fast} --contact-set 3 --set 412@1=44 --set 434@3=2",
                   "-a 1 sollwert 10Hz --enable --hold --duration 1s --until reached --yes --json",
                   STOP_JUDGES + [follows_setpoint(10)], 14, exits={0}, after=0.3, quick=True)
        yield Case(f"control/{protocol}/contact-set-3-taken", f"{p} {fast} --contact-set 3 --set 412@3=44",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --take-control --yes --json",
                   STOP_JUDGES + [follows_setpoint(10)], 14, exits={0}, after=1.0, quick=True)
        # without --hold: the drive keeps running, and the tool says so
        yield Case(f"free/{protocol}/enable", f"{p} {fast}", "-a 1 statemachine enable --yes --json",
                   GENERAL + [says("keeps running|keep running"), ends_in(ENABLED)], 10, exits={0}, after=0.3, quick=True)
        yield Case(f"free/{protocol}/sollwert", f"{p} {fast} --running",
                   "-a 1 sollwert 20Hz --until reached --yes --json",
                   GENERAL + [reached_is_reached, ends_in(ENABLED), says("keeps running|keep running")], 10, exits={0}, after=0.3, quick=True)
        yield Case(f"free/{protocol}/sollwert-enable", f"{p} {fast}",
                   "-a 1 sollwert 20Hz --source line --enable --until reached --yes --json",
                   GENERAL + [reached_is_reached, ends_in(ENABLED), says("keeps running|keep running")], 10, exits=None, after=0.3)
        # a bad day: several at once
        for n, text in enumerate(("--late 250 --lose 6 --double 4 --double-after 120", "--garble 5 --late 100 --late-jitter 300 --pieces 12",
                                  "--lose-chance 0.15", "--lose-chance 0.3", "--echo whole --lose 5 --late 60", "--cut 4 --double 3 --double-after 20")):
            for command, what in (("--duration 3s", "plain"), ("--duration 3s --watchdog 2s", "watchdog")):
                yield Case(f"bad-day/{protocol}/{n}/{what}", f"{p} {fast} {text} --disturb-when enabled",
                           f"-a 1 sollwert 20Hz --source line --enable --hold {command} --yes --json",
                           STOP_JUDGES, 40, after=1.0, sins=TWICE, quick=protocol == "rtu")
        # who has control
        for mode in (0, 2, 44):
            yield Case(f"control/{protocol}/412={mode}/refused", f"{p} {fast} --set 412={mode}" + (" --no-start" if mode == 0 else ""),
                       "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --yes --json",
                       STOP_JUDGES, 12, exits={8}, after=0.5, quick=True)
            yield Case(f"control/{protocol}/412={mode}/taken", f"{p} {fast} --set 412={mode}",
                       "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --take-control --yes --json",
                       STOP_JUDGES, 16, after=2.0, sins=("enabled-onto-turning-shaft",), quick=True)
        yield Case(f"control/{protocol}/second-set", f"{p} {fast} --set 414=2 --set 412@2=44",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --take-control --yes --json",
                   STOP_JUDGES, 16, exits={0}, after=1.0, quick=True)
        yield Case(f"control/{protocol}/no-enable", f"{p} {fast} --no-enable",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --yes --json",
                   STOP_JUDGES + [says("enable")], 14, exits={8}, after=0.3, quick=True)
        yield Case(f"control/{protocol}/no-start", f"{p} {fast} --no-start",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --yes --json",
                   STOP_JUDGES + [says("start|S2IND|contact")], 14, exits={8}, after=0.3, quick=True)
        yield Case(f"control/{protocol}/fault", f"{p} {fast} --fault 0x0500",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 1s --yes --json",
                   STOP_JUDGES, 14, exits={8}, after=0.3, quick=True)
        yield Case(f"control/{protocol}/watchdog-set", f"{p} {fast} --set 413=5",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 2500ms --watchdog 1s --yes --json",
                   STOP_JUDGES, 14, exits={0}, after=0.3, quick=True)
        yield Case(f"control/{protocol}/watchdog-eeprom-copy", f"{p} {fast} --set 413=5 --read-back eeprom",
                   "-a 1 sollwert 10Hz --source line --enable --hold --duration 2500ms --watchdog 1s --yes --json",
                   STOP_JUDGES, 14, exits={0}, after=0.3, quick=True)
        # freeze: the tool is stopped for 3 s, the drive's watchdog trips
        yield Case(f"control/{protocol}/frozen", f"{p} {fast}",
                   "-a 1 sollwert 20Hz --source line --enable --hold --duration 6s --watchdog 1s --yes --json",
                   STOP_JUDGES, 25, exits={8, 6, 9}, signals=[(0.7, signal.SIGSTOP), (3.7, signal.SIGCONT)], after=0.5, quick=True)


def machine_cases():
    """`statemachine` and its sub-commands."""
    fast, slow = SETUP["fast"], SETUP["slow"]
    for protocol in ("rtu", "ascii", "vabus"):
        for family in ("act", "acu"):
            p = f"--protocol {protocol} --family {family}"
            quick = protocol == "rtu"
            running = f"{p} {fast} --running --left 20"
            for verb, states in (("disable", (SWITCHED_ON,)), ("quick-stop", (INHIBIT, QUICK)), ("disable-voltage", (INHIBIT,))):
                for name in ("clean", "late300", "lost3", "double40", "babble", "master12", "echo", "twin", "late600", "garble3",
                             "flood", "master25", "late900"):
                    text, sins, factor = ("", (), 1) if name == "clean" else DISTURBANCES[name]

                    def stops(case, run):
                        if run.at_end[0] == ENABLED:
                            return [f"STOP NOT DONE: still enabled at {run.at_end[2]:.1f} Hz, exit {run.rc}"]
                        return []
                    yield Case(f"machine/{protocol}/{family}/{verb}/{name}", f"{running} {text}", f"-a 1 statemachine {verb} --json",
                               GENERAL + [stops, ends_in(*states), truth_of_stop, stop_sent_within(2.0)], 12 * factor, after=0.5, sins=sins,
                               exits={0} if name in ("clean", "late300", "double40", "echo") else None,
                               quick=quick and (family == "act" or name == "clean"))
                for mode in (0, 2, 44):
                    yield Case(f"machine/{protocol}/{family}/{verb}/412={mode}", f"{running} --set 412={mode} --word 3",
                               f"-a 1 statemachine {verb} --json", GENERAL + [truth_of_stop], 15,
                               exits={8}, after=0.3, sins=("control-word-ignored", "control-word-jump"))
            yield Case(f"machine/{protocol}/{family}/sollwert-0", f"{running}", "-a 1 sollwert 0Hz --json",
                       GENERAL, 8, exits={0}, after=1.0, quick=quick)
            yield Case(f"machine/{protocol}/{family}/sollwert-0-fmin", f"{running} --set 418=350 --set 434=2",
                       "-a 1 sollwert 0Hz --json", GENERAL + [says(r"3[.,]5")], 8, after=1.0, quick=quick)
            yield Case(f"machine/{protocol}/{family}/walk", f"{p} {fast}", "-a 1 statemachine goto switched-on --yes --json",
                       GENERAL + [ends_in(SWITCHED_ON)], 10, exits={0}, after=0.2, quick=quick)
            yield Case(f"machine/{protocol}/{family}/enable-hold", f"{p} {fast}",
                       "-a 1 statemachine enable --hold --duration 1s --yes --json", STOP_JUDGES + [moved], 12,
                       exits={0}, after=0.5, quick=quick)
            yield Case(f"machine/{protocol}/{family}/enable-hold-running", running,
                       "-a 1 statemachine enable --hold --duration 1s --yes --json",
                       GENERAL + [truth_of_stop, stays_down], 12, exits={0}, after=1.0, quick=quick)
            yield Case(f"machine/{protocol}/{family}/goto-hold-running", running,
                       "-a 1 statemachine goto operation-enabled --hold --duration 1s --yes --json",
                       GENERAL + [truth_of_stop, stays_down], 12, exits={0}, after=1.0, quick=quick)
            yield Case(f"machine/{protocol}/{family}/enable-no-start", f"{p} {fast} --no-start",
                       "-a 1 statemachine enable --hold --duration 1s --yes --json",
                       STOP_JUDGES + [says("start|S2IND|contact")], 14, exits={8}, after=0.3, quick=quick)
            yield Case(f"machine/{protocol}/{family}/level-trap", f"{p} {fast} --no-start --left 10",
                       "-a 1 statemachine enable --yes --json", GENERAL + [no_word_ignored], 14, exits={8}, after=0.3, quick=quick)
            yield Case(f"machine/{protocol}/{family}/reset-no-fault", f"{p} {fast}", "-a 1 statemachine reset --yes --json",
                       GENERAL + [nothing_written], 8, exits={0, 8}, after=0.3, quick=quick)
            yield Case(f"machine/{protocol}/{family}/reset-old", f"{p} {fast} --fault 0x0500 --fault-age 60",
                       "-a 1 statemachine reset --yes --json", GENERAL + [ends_in(INHIBIT, SWITCHED_ON, READY), no_word_ignored],
                       30, exits={0}, after=0.3, quick=quick)
            for mode in (0, 2, 44):
                yield Case(f"machine/{protocol}/{family}/reset-412={mode}", f"{p} {fast} --fault 0x0500 --fault-age 60 --set 412={mode}"
                           + (" --no-start" if mode == 0 else ""),
                           "-a 1 statemachine reset --yes --json", GENERAL + [nothing_written, no_word_ignored], 8, exits={8},
                           after=0.3, sins=(), quick=quick)
            yield Case(f"machine/{protocol}/{family}/reset-lock", f"{p} {fast} --fault 0x0500 --fault-age 0",
                       "-a 1 statemachine reset --yes --json", GENERAL + [no_word_ignored], 40, exits={0, 8}, after=0.3, quick=quick)
            yield Case(f"machine/{protocol}/{family}/reset-start-standing", f"{p} {fast} --fault 0x0500 --fault-age 60 --word 0x0F --left 20",
                       "-a 1 statemachine reset --yes --json",
                       GENERAL + [ends_in(INHIBIT, SWITCHED_ON, READY), stays_down, once_enabled], 30, exits={0, 8}, after=1.0, quick=quick)
            yield Case(f"machine/{protocol}/{family}/reset-remote-missing",
                       f"{p} {fast} --fault 0x0500 --fault-age 60 --no-enable --reset-needs-remote yes",
                       "-a 1 statemachine reset --yes --json", GENERAL + [ends_in(INHIBIT), no_word_ignored], 40, exits={6, 8, 4}, after=0.3)
            yield Case(f"machine/{protocol}/{family}/contacts", f"{p} {fast} --set 412=2",
                       "-a 1 statemachine contacts S1IND S2IND --hold --duration 1s --yes --json",
                       GENERAL + [truth_of_stop, stays_down], 15, after=2.5, quick=quick)
            yield Case(f"machine/{protocol}/{family}/state-in-force", f"{p} --set 412=44 --read-back eeprom --running",
                       "-a 1 statemachine --json", GENERAL, 8, exits={0}, after=0)
        yield Case(f"machine/{protocol}/question/ctrl-c", f"--protocol {protocol} {fast}",
                   "-a 1 sollwert 20Hz --source line --enable --hold --duration 1s",
                   [in_time, nothing_written, expected_exit], 8, answers=[("[y/N]", signal.SIGINT)], exits={130}, after=0.5, quick=True)
        yield Case(f"machine/{protocol}/question/term", f"--protocol {protocol} {fast}",
                   "-a 1 sollwert 20Hz --source line --enable --hold --duration 1s",
                   [in_time, nothing_written, expected_exit], 8, answers=[("[y/N]", signal.SIGTERM)], exits={130}, after=0.5, quick=True)
        yield Case(f"machine/{protocol}/question/enter", f"--protocol {protocol} {fast}",
                   "-a 1 sollwert 20Hz --source line --enable --hold --duration 1s",
                   [in_time, nothing_written, expected_exit], 8, answers=[("[y/N]", "\n")], exits={8}, after=0.5, quick=True)


def cases():
    every = [*reading_cases(), *scan_cases(), *write_cases(), *motion_cases(), *machine_cases()]
    return [c for c in every if c is not None]


# ---------------------------------------------------------------------------------------------


def judge(case):
    try:
        run = execute(case)
    except Exception as broken:  # the harness itself: tell it, and go on
        return None, [f"HARNESS: {type(broken).__name__}: {broken}"]
    complaints = []
    for one in case.judges:
        try:
            complaints += one(case, run)
        except Exception as broken:
            complaints.append(f"HARNESS: {one.__name__}: {type(broken).__name__}: {broken}")
    return run, complaints


def main():
    p = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    p.add_argument("--quick", action="store_true", help="the most telling part of the cases")
    p.add_argument("--jobs", type=int, default=3)
    p.add_argument("--only", default="", help="cases whose name holds this regular expression")
    p.add_argument("--list", action="store_true")
    p.add_argument("--verbose", action="store_true", help="show output and drive of every failed case")
    p.add_argument("--log", help="append failures with everything known to this file")
    p.add_argument("--sample", type=float, default=1.0, help="this share of the cases, by chance")
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--limit", type=float, default=7200.0, help="begin no case after so many seconds")
    arg = p.parse_args()
    chosen = [c for c in cases() if re.search(arg.only, c.name) and (c.quick or not arg.quick)]
    dice = random.Random(arg.seed)
    if arg.sample < 1:
        chosen = [c for c in chosen if dice.random() < arg.sample]
    if arg.list:
        for case in chosen:
            print(f"{case.name}: antrieb {case.args}   [drive: {case.drive}]")
        print(len(chosen), "cases")
        return 0
    start, passed, failed = time.monotonic(), 0, 0
    lock = threading.Lock()

    def one(case):
        nonlocal passed, failed
        if time.monotonic() - start > arg.limit:
            return
        run, complaints = judge(case)
        with lock:
            if complaints:
                failed += 1
                print(f"FAILED {case.name}: {' | '.join(complaints)}", flush=True)
                text = (f"### {case.name}\n    antrieb {case.args}\n    drive: {case.drive}\n    signals: {case.signals}\n"
                        f"    exit {run and run.rc}, {run and round(run.seconds, 2)} s, at exit {run and run.at_exit}, "
                        f"later {run and run.at_end}\n" + "".join(f"    - {c}\n" for c in complaints))
                if run:
                    d = run.server.drive
                    text += f"    writes: {[(round(t - run.server.born, 2), n, s, v) for t, n, s, v in d.writes][-24:]}\n"
                    text += f"    history: {[(round(t - run.server.born, 2), s, o, f) for t, s, o, f in d.history][-14:]}\n"
                    text += "    stderr: " + run.err.strip().replace("\n", "\n            ")[:2500] + "\n"
                    if "--json" in case.args:
                        doc = run.document()
                        data = (doc or {}).get("data") or {}
                        keep = {k: data.get(k) for k in ("from", "to", "stop", "running", "setpoint", "changed", "notes", "watchdog_s")
                                if isinstance(data, dict) and k in data}
                        text += f"    document: ok={doc and doc.get('ok')} error={json.dumps((doc or {}).get('error'))} {json.dumps(keep)}\n"
                    else:
                        text += "    stdout: " + run.out.strip()[:1500] + "\n"
                if arg.verbose:
                    print(text)
                if arg.log:
                    with open(arg.log, "a") as f:
                        f.write(text + "\n")
            else:
                passed += 1
                print(f"ok     {case.name} ({run.seconds:.1f} s)", flush=True)

    with concurrent.futures.ThreadPoolExecutor(arg.jobs) as pool:
        list(pool.map(one, chosen))
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
