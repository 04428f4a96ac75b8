"""Runs the tool beside a drive, and judges what it said against what the shaft did.

`Trial` describes one case, `run` plays it, `verdict` lists what was wrong. The
judgements that hold for every case stand here; what one case wants beyond them is
its own `wants` function.
"""

import json
import os
import re
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass, field

from lexium05 import ZEROED, Readings
from wire import Disturbances, Line

BINARY = os.environ.get("ANTRIEB", "antrieb")
EXIT_CODES = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 70, 130}

# What a master may do although the manual does not print it: told, never a failure.
FORGIVEN = {"odd address or count"}  # auto recognition asks 411, which no LXM05 has


@dataclass
class Trial:
    """One command beside one drive."""

    name: str
    args: list
    readings: dict = field(default_factory=dict)
    wrong: dict = field(default_factory=dict)
    exits: tuple = (0,)
    limit: float = 30.0               # s; longer is a hang
    signals: tuple = ()               # (s after operation enabled or start, signal)
    signal_from: str = "enabled"      # "enabled", "start"
    allowed_sins: tuple = ()
    values: dict = field(default_factory=dict)   # name -> raw that a read has to show
    stands: bool = False              # the shaft must stand, without power or at a stop, afterwards
    keeps: bool = False               # the shaft is meant to turn on
    peak: float = None                # 1/min that must never be exceeded
    back: bool = True                 # what the run set must be given back
    wants: object = None              # function(outcome) -> list of complaints
    drive: str = "lxm05"
    quick: bool = False
    after: float = 0.6                # s to look at the shaft after the end
    typed: tuple = None               # a terminal, and (s after the start, text) that is typed there


@dataclass
class Outcome:
    """What happened: the tool's words beside the truth."""

    trial: Trial
    code: int = None
    seconds: float = 0.0
    hang: bool = False
    out: str = ""
    err: str = ""
    document: object = None
    at_end: dict = None
    later: dict = None
    line: Line = None

    @property
    def data(self):
        return (self.document or {}).get("data") or {}

    @property
    def device(self):
        return self.line.drive

    def tells(self, pattern):
        return re.search(pattern, self.out + self.err, re.I) is not None


def run(trial, log=None):
    """Plays a case; nothing runs longer than the trial's limit and what is needed to end it."""
    line = Line(Readings(**trial.readings), Disturbances(**trial.wrong), log=log).start()
    outcome = Outcome(trial, line=line)
    command = [BINARY, "--port", line.path, "--lang", "en", "--no-config", "--no-progress"]
    if trial.drive:
        command += ["--drive", trial.drive]
    command += trial.args
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begun = time.monotonic()
        keyboard, terminal = os.openpty() if trial.typed is not None else (None, subprocess.DEVNULL)
        process = subprocess.Popen(command, stdin=terminal, stdout=out, stderr=err if keyboard is None else terminal)
        todo, keys = list(trial.signals), list(trial.typed or ())
        while process.poll() is None:
            now = time.monotonic()
            mark = begun if trial.signal_from == "start" else line.enabled_seen
            while todo and mark is not None and now >= mark + todo[0][0]:
                process.send_signal(todo.pop(0)[1])
            while keys and now >= begun + keys[0][0]:
                os.write(keyboard, keys.pop(0)[1].encode())
            if now - begun > trial.limit:
                outcome.hang = True
                process.send_signal(signal.SIGCONT)
                process.kill()
                process.wait()
                break
            time.sleep(0.01)
        outcome.seconds = time.monotonic() - begun
        outcome.code = process.returncode
        outcome.at_end = line.look()
        line.muted_at_end = line.muted()
        for stream, name in ((out, "out"), (err, "err")):
            stream.seek(0)
            setattr(outcome, name, stream.read().decode("utf-8", "replace"))
        if keyboard is not None:
            os.set_blocking(keyboard, False)
            try:
                outcome.err += os.read(keyboard, 65536).decode("utf-8", "replace")
            except OSError:
                pass
            os.close(keyboard)
            os.close(terminal)
    time.sleep(trial.after)
    outcome.later = line.look()
    line.stop()
    if "--json" in trial.args:
        try:
            outcome.document = json.loads(outcome.out)
        except ValueError:
            outcome.document = None
    return outcome


# --------------------------------------------------------------------------- verdict


def verdict(outcome):
    """Every complaint about one outcome; an empty list is a pass."""
    trial = outcome.trial
    wrong = []
    if outcome.hang:
        wrong.append(f"HANG: still running after {trial.limit:.0f} s")
    elif outcome.code not in EXIT_CODES or outcome.code == 70 or "panicked" in outcome.err:
        wrong.append(f"CRASH: exit {outcome.code}")
    elif trial.exits and outcome.code not in trial.exits:
        wrong.append(f"exit {outcome.code}, wanted {'/'.join(map(str, trial.exits))}")
    if "--json" in trial.args and outcome.document is None and not outcome.hang:
        wrong.append("stdout is not one JSON document")
    wrong += _sins(outcome)
    wrong += _values(outcome)
    wrong += _shaft(outcome)
    if trial.wants and not outcome.hang:
        wrong += list(filter(None, trial.wants(outcome)))
    return wrong


def _sins(outcome):
    kinds = {}
    for when, kind, text in outcome.device.sins:
        if kind not in FORGIVEN and kind not in outcome.trial.allowed_sins:
            kinds.setdefault(kind, []).append(f"{when:.2f} s: {text}")
    return [f"SIN {kind} x{len(texts)} ({texts[0]})" for kind, texts in kinds.items()]


def _values(outcome):
    """A value that is shown must be the drive's; one that is missing must cost the exit code."""
    wrong = []
    shown = {}
    for row in outcome.data.get("values", []) if isinstance(outcome.data, dict) else []:
        if row.get("error") is None and row.get("raw") is not None:
            shown[row["param"]] = row["raw"]
    for address, raw in outcome.trial.values.items():
        if address in shown and shown[address] != raw:
            wrong.append(f"WRONG VALUE: {address} shown as {shown[address]}, is {raw}")
        if address not in shown and outcome.code == 0:
            wrong.append(f"exit 0 without a value of {address}")
    return wrong


def _shaft(outcome):
    """The shaft against the report."""
    trial, wrong = outcome.trial, []
    end, later, data = outcome.at_end, outcome.later, outcome.data
    turning = abs(end["speed"]) > 5 or abs(later["speed"]) > 5
    powered = later["state"] == "enabled"
    stop = data.get("stop") if isinstance(data, dict) else None
    # Without power and said to turn on by itself: true, whatever it is called.
    told = end["state"] != "enabled" and outcome.tells("still turns|turns on by itself|coasts? on")
    if isinstance(data, dict) and data.get("running") is False and abs(end["speed"]) > 5 and not told:
        wrong.append(f"FALSE: running no, shaft turns at {end['speed']:.0f} 1/min ({end['state']})")
    if isinstance(data, dict) and data.get("running") is True and not turning and not powered:
        wrong.append(f"FALSE: running yes, shaft stands ({end['state']})")
    if stop and stop.get("acknowledged") and stop.get("choice") != "keep" and abs(end["speed"]) > 5 and not told:
        wrong.append(f"FALSE: stop acknowledged, shaft turns at {end['speed']:.0f} 1/min ({end['state']})")
    heard = not outcome.line.wrong.unplug_at and not outcome.line.muted_at_end
    if heard and stop and not stop.get("acknowledged") and stop.get("choice") != "keep":
        if abs(end["speed"]) < 1 and end["state"] not in ("enabled",):
            wrong.append(f"FALSE: stop not acknowledged, but it stands in {end['state']}")
    if trial.stands and turning and not told:
        wrong.append(f"SHAFT LEFT TURNING: {end['speed']:.0f} then {later['speed']:.0f} 1/min in {later['state']}")
    if trial.stands and powered and not turning and outcome.code == 0:
        wrong.append("exit 0, but operation enabled is left standing")
    if trial.keeps and not powered:
        wrong.append(f"meant to run on, is {later['state']}")
    if trial.peak is not None and outcome.device.peak > trial.peak:
        wrong.append(f"TOO FAST: {outcome.device.peak:.0f} 1/min, at most {trial.peak:.0f} were asked for")
    if trial.back:
        for name, (old, new) in later["changed"].items():
            if name in ZEROED and new == 0:
                continue  # a setpoint that was left from before may be zeroed
            wrong.append(f"NOT GIVEN BACK: {name} {old} -> {new}")
    return wrong
