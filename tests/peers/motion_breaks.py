#!/usr/bin/env python3
"""Breaks a run that turns a shaft, at every one of its steps, and then asks the drive whether the shaft stands.

    tests/peers/motion_breaks.py [--quick] [--step K] [WORD...]     only groups with one of these words in their name

Our program and our bench are two processes with a pty between them, in real time. Step k is the moment at which the
k-th request telegram is on the line: `--trace` is read as it grows, so the telegrams are counted as they go out. What
breaks the run is done at that step; afterwards a fresh `antrieb read` asks the drive, and its answer is held against
what the run reported. Where the line itself must break while the drive lives on, a relay stands between a pty and the
bench's TCP port.

One line per group, then `N passed, N failed`. Tries target/debug/antrieb, or the program that ANTRIEB names.
"""

import json
import os
import pty
import re
import select
import shlex
import signal
import socket
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import tty
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from harness import ROOT, environment

BINARY = Path(os.environ.get("ANTRIEB", ROOT / "target/debug/antrieb")).absolute()

AT_ONCE = 4
# Nothing here needs longer; what does hangs.
LIMIT_S = 45.0
# Between two looks at the trace.
LOOK_MS = 1
BENCH_LIFE = "120s"
# From a signal to the stop on the line. The program looks at a closed stdout every 100 ms.
PROMPT_S = 1.0
# An unpowered shaft of the bench needs less than half a second; a driven one never stands.
COAST_S = 3.0
COASTING_S = 0.6

# Watchdog of the drive: so long that it never stops a shaft in place of a living program, or so short as it can be.
SLOW, FAST = 3, 1
FREEZE_SHORT_S, FREEZE_LONG_S = 0.4, 1.5
# A line that is dead is given up early, so that a case takes seconds.
IMPATIENT = ["--timeout", "150ms", "--retries", "1"]

CONTROL_WORD = bytes.fromhex("0106019A")
SETPOINT = bytes.fromhex("016501E4")
ENABLE = 0x000F
WATCHDOG_FAULT = 0x2010
STATE_BITS, ENABLED, QUICK_STOP = 0x6F, 0x27, 0x07


class Failed(Exception):
    """Something else came than must come."""


def demand(holds, text):
    if not holds:
        raise Failed(text)


# What is run ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Setup:
    """A run, and the drive that it is done with."""

    name: str
    words: tuple[str, ...]
    on_exit: str
    model: str = "act"
    # Beside the ones that make the bench fast; P.413 is the case's business.
    values: tuple[tuple[str, object], ...] = ()
    # The run takes these over and gives them back: number and data set on the line, raw value.
    gives_back: tuple[tuple[str, int], ...] = ()
    own_watchdog: bool = False

    def toml(self, watchdog):
        values = {"412": 1, "434": 2, "413": watchdog, "418": 0, "424": 10, "425": 10, "549": 4, "638": "1.0"}
        values |= dict(self.values)
        if self.own_watchdog:
            values["413"] = 0
        told = ", ".join(f'"{key}" = {json.dumps(value)}' for key, value in values.items())
        return f"""[[drive]]
model = "{self.model}"
address = 1
baud = 115200
reply_delay = "1ms"
set = {{ {told} }}
"""

    def command(self, watchdog):
        own = ["--watchdog", f"{watchdog}s"] if self.own_watchdog else []
        return ["-a", "1", "--yes", *self.words, "--hold", "--duration", "300ms", "--on-exit", self.on_exit, *own]


SOLLWERT = ("sollwert", "4Hz", "--enable", "--until", "reached")
# P.418 makes the drive turn as soon as it is enabled.
LIFTED = (("418", 3),)
CONTACTS = (("412", 2), ("418", 3))
CONTACTS_BACK = (("412@6", 2), ("413@5", 0))

QUICK = Setup("sollwert, quick-stop", SOLLWERT, "quick-stop")
RAMP = Setup("sollwert, ramp, ACU", SOLLWERT, "ramp", model="acu")
COAST = Setup("sollwert, coast", SOLLWERT, "coast", values=LIFTED)
KEEP = Setup("sollwert, keep", SOLLWERT, "keep")
MACHINE = Setup("statemachine enable", ("statemachine", "enable"), "quick-stop", values=LIFTED)
MACHINE_RAMP = Setup("statemachine enable, ramp, ACU", ("statemachine", "enable"), "ramp", model="acu", values=LIFTED)
TAKEN = (*SOLLWERT, "--take-control")
TAKE_QUICK = Setup("take control, quick-stop", TAKEN, "quick-stop", "act", CONTACTS, CONTACTS_BACK, True)
TAKE_RAMP = Setup("take control, ramp", TAKEN, "ramp", "act", CONTACTS, CONTACTS_BACK, True)


# Processes --------------------------------------------------------------------------------------------------------


class Bench:
    """`antrieb simulate`: on a pty, or on TCP with a relay between it and a pty of ours."""

    def __init__(self, directory, toml, relayed):
        file = directory / "bench.toml"
        file.write_text(toml)
        place = ["--tcp", "127.0.0.1:0"] if relayed else ["--link", directory / "bench"]
        self.files = (directory / "bench.out").open("w+"), (directory / "bench.err").open("w+")
        words = [BINARY, "--no-config", "--json", "simulate", *place, "--for", BENCH_LIFE, file]
        self.process = subprocess.Popen(
            words, stdin=subprocess.DEVNULL, stdout=self.files[0], stderr=self.files[1], env=environment()
        )
        self.relay = None
        try:
            told = self.wait_for("serving on ")
            self.port = told.split("serving on ")[1].split(";")[0]
            if relayed:
                host, port = self.port.removeprefix("tcp://").rsplit(":", 1)
                self.relay = Relay(socket.create_connection((host, int(port))))
                self.port = self.relay.port
        except BaseException:
            self.close()
            raise

    def wait_for(self, text):
        deadline = time.monotonic() + LIMIT_S
        while True:
            told = os.pread(self.files[1].fileno(), 1 << 16, 0).decode(errors="replace")
            if text in told:
                return told
            demand(self.process.poll() is None and time.monotonic() < deadline, f"the bench never served: {told}")
            time.sleep(0.005)

    def repair(self):
        """Makes the line whole, if it was cut."""
        if self.relay:
            self.relay = self.relay.renew()
            self.port = self.relay.port

    def counts(self):
        """Ends it, and returns what it counted."""
        self.process.send_signal(signal.SIGINT)
        demand(self.process.wait(LIMIT_S) == 0, "the bench did not end well")
        return json.loads(os.pread(self.files[0].fileno(), 1 << 16, 0))["data"]

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        if self.relay:
            self.relay.close()
        for file in self.files:
            file.close()


class Relay:
    """A line between a pty and the bench that can lose what the drive says, or be cut."""

    def __init__(self, line):
        self.line = line
        self.master, self.slave = pty.openpty()
        tty.setraw(self.slave)
        self.port = os.ttyname(self.slave)
        self.mute = False
        self.wake = os.pipe()
        self.thread = threading.Thread(target=self.carry, daemon=True)
        self.thread.start()

    def carry(self):
        while True:
            ready, _, _ = select.select([self.wake[0], self.master, self.line], [], [])
            if self.wake[0] in ready:
                return
            if self.master in ready:
                self.line.sendall(os.read(self.master, 4096))
            if self.line in ready:
                told = self.line.recv(4096)
                if not told:
                    return
                if not self.mute:
                    os.write(self.master, told)

    def cut(self):
        """The adapter is pulled: the program's side hangs up, the drive hears nothing any more."""
        if self.thread.is_alive():
            os.write(self.wake[1], b"x")
            self.thread.join()
        if self.master is not None:
            os.close(self.master)
            os.close(self.slave)
            self.master = None

    def renew(self):
        self.cut()
        for end in self.wake:
            os.close(end)
        # What the drive said to the dead line is gone: else a late reply would pass for the first answer to the next master.
        while select.select([self.line], [], [], 0)[0] and self.line.recv(4096):
            pass
        return Relay(self.line)

    def close(self):
        self.cut()
        for end in self.wake:
            os.close(end)
        self.line.close()


class Run:
    """Our program in a run, with its telegrams as they go out."""

    def __init__(self, directory, port, words):
        self.path = directory / "trace"
        self.trace = None
        self.err = (directory / "run.err").open("w+")
        self.words = [str(BINARY), "--no-config", "--json", "-b", "115200", "--trace", str(self.path), "-p", port, *words]
        self.process = subprocess.Popen(
            self.words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self.err, env=environment()
        )
        # When, and what; the n-th request is at n - 1.
        self.sent = []
        self.code = None
        self.out = None
        self.ended = None
        # When the last thing that was broken for a time was whole again.
        self.healed = 0.0

    def follow(self, breaks):
        """Reads the trace to the end of the process and breaks what is to be broken, each at its step."""
        breaks = list(breaks)
        later = []
        rest = b""
        end = os.pidfd_open(self.process.pid)
        poll = select.poll()
        poll.register(end, select.POLLIN)
        deadline = time.monotonic() + LIMIT_S
        try:
            while True:
                now = time.monotonic()
                demand(now < deadline, f"not over after {LIMIT_S:.0f} s")
                for timer in [timer for timer in later if timer[0] <= now]:
                    later.remove(timer)
                    self.heal(timer[1])
                until = min([deadline, *(at for at, _ in later)])
                # A regular file cannot be polled: it is looked at again and again.
                over = bool(poll.poll(min(max(0.0, until - now) * 1_000 + 1, LOOK_MS)))
                if chunk := self.written():
                    *lines, rest = (rest + chunk).split(b"\n")
                    for line in lines:
                        words = line.split()
                        if len(words) > 2 and words[1] == b">":
                            self.sent.append((time.monotonic(), bytes.fromhex(b"".join(words[2:]).decode())))
                            while breaks and breaks[0].step <= len(self.sent):
                                later += breaks.pop(0).fire()
                elif over:
                    break
            self.ended = time.monotonic()
            self.code = self.process.wait()
        finally:
            os.close(end)
        if not self.process.stdout.closed:
            self.out = self.process.stdout.read().decode()
        # A bench that is still frozen thaws when its time has come, not earlier.
        for at, action in sorted(later, key=lambda timer: timer[0]):
            time.sleep(max(0.0, at - time.monotonic()))
            self.heal(action)

    def written(self):
        """What the program has written to its trace since the last look."""
        if self.trace is None:
            try:
                self.trace = os.open(self.path, os.O_RDONLY)
            except FileNotFoundError:
                return b""
        return os.read(self.trace, 1 << 16)

    def heal(self, action):
        action()
        self.healed = time.monotonic()

    def stderr(self):
        return os.pread(self.err.fileno(), 1 << 20, 0).decode(errors="replace")

    def control_words(self):
        """Steps, and control words that were sent at them."""
        rows = enumerate((frame for _, frame in self.sent), 1)
        return [(step, int.from_bytes(frame[4:6], "big")) for step, frame in rows if frame.startswith(CONTROL_WORD)]

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()
        self.err.close()
        if self.trace is not None:
            os.close(self.trace)


# What is broken ---------------------------------------------------------------------------------------------------


@dataclass
class Break:
    """Something that happens at a step, once."""

    step: int
    act: Callable[[], list]
    fired: float | None = None

    def fire(self):
        self.fired = time.monotonic()
        return self.act() or []


def signals(number):
    return lambda run, bench: lambda: run.process.send_signal(number)


def close_stdout(run, bench):
    return run.process.stdout.close


def kill_bench(run, bench):
    return bench.process.kill


def freeze(seconds):
    def act(run, bench):
        def thaw():
            bench.process.send_signal(signal.SIGCONT)

        def stop():
            bench.process.send_signal(signal.SIGSTOP)
            return [(time.monotonic() + seconds, thaw)]

        return stop

    return act


def pull(run, bench):
    return bench.relay.cut


def lose_replies(seconds):
    def act(run, bench):
        def set_mute(mute):
            bench.relay.mute = mute

        def lose():
            set_mute(True)
            return [(time.monotonic() + seconds, lambda: set_mute(False))] if seconds else None

        return lose

    return act


@dataclass(frozen=True)
class Kind:
    """A way to break a run."""

    name: str
    act: Callable
    watchdog: int = SLOW
    relayed: bool = False
    options: tuple[str, ...] = ()
    # The program lives, and so does the line: it must stop the shaft itself, at once.
    prompt: bool = False
    # The bench is gone, and nobody can be asked.
    kills: bool = False
    closes: bool = False


SIGINT = Kind("SIGINT", signals(signal.SIGINT), prompt=True)
SIGTERM = Kind("SIGTERM", signals(signal.SIGTERM), prompt=True)
SIGHUP = Kind("SIGHUP", signals(signal.SIGHUP), prompt=True)
STDOUT = Kind("stdout closed", close_stdout, prompt=True, closes=True)
KILL = Kind("bench killed", kill_bench, kills=True)
FREEZE = Kind(f"no replies for {FREEZE_SHORT_S} s (SIGSTOP)", freeze(FREEZE_SHORT_S), options=tuple(IMPATIENT))
STORM = Kind(f"no replies for {FREEZE_LONG_S} s (SIGSTOP)", freeze(FREEZE_LONG_S), FAST, options=tuple(IMPATIENT))
PULL = Kind("adapter pulled", pull, FAST, relayed=True)
LOSE = Kind("replies lost from here on", lose_replies(None), FAST, relayed=True, options=tuple(IMPATIENT))
GAP = Kind(f"replies lost for {FREEZE_SHORT_S} s", lose_replies(FREEZE_SHORT_S), relayed=True, options=tuple(IMPATIENT))
NOTHING = Kind("undisturbed", lambda run, bench: lambda: None)


@dataclass
class Case:
    """A run that is broken at one step, or at two."""

    setup: Setup
    first: Kind
    step: int
    # A second break, so many steps later.
    second: Kind | None = None
    after: int = 0

    def kinds(self):
        return [self.first, *([self.second] if self.second else [])]

    def has(self, name):
        return any(getattr(kind, name) for kind in self.kinds())

    def watchdog(self):
        return min(kind.watchdog for kind in self.kinds())

    def title(self):
        second = f", then {self.second.name} at {self.step + self.after}" if self.second else ""
        return f"{self.setup.name}: {self.first.name} at step {self.step}{second}"


# What came of it --------------------------------------------------------------------------------------------------


@dataclass
class Verdict:
    """What became of the shaft, and why it is not right if it is not."""

    case: Case
    shaft: str = "?"
    failure: str | None = None
    reached: bool = True
    # From the break to the end of the program.
    seconds: float = 0.0
    story: list[str] = field(default_factory=list)


@dataclass
class Truth:
    """What the drive says when it is asked afterwards."""

    status: int
    output: int
    speed: int
    fault: int
    others: dict

    @property
    def driven(self):
        return self.status & STATE_BITS in (ENABLED, QUICK_STOP)

    def __str__(self):
        told = f"status 0x{self.status:04X}, P.210 {self.output / 100} Hz, P.241 {self.speed / 100} Hz"
        return f"{told}, fault 0x{self.fault:04X}, {self.others}"


def ask(port, setup):
    """Asks the drive itself, with a fresh process."""
    others = [name for name, _ in setup.gives_back]
    words = [BINARY, "--no-config", "--json", "-b", "115200", "-p", port, "-a", "1", "--drive", setup.model]
    done = subprocess.run(
        [*words, "read", "411", "210", "241", "260", *others],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        env=environment(),
        timeout=LIMIT_S,
    )
    demand(done.returncode == 0, f"the drive cannot be asked: exit {done.returncode}: {done.stdout}{done.stderr}")
    raws = [value["raw"] for value in json.loads(done.stdout)["data"]["values"]]
    demand(len(raws) == 4 + len(others) and None not in raws, f"the drive did not tell everything: {raws}")
    return Truth(*raws[:4], dict(zip(others, raws[4:], strict=True)))


def truth_after(case, run, bench):
    """The drive's own word, once its watchdog has had its time if the line was dead; `None` if it is gone."""
    if case.has("kills"):
        return None
    if case.watchdog() == FAST and not acknowledged(run):
        # It counts from the last telegram that the drive heard: sent by then, or kept for it while it was frozen.
        heard = max([run.healed, *(at for at, _ in run.sent)])
        time.sleep(max(0.0, heard + FAST + 0.2 - time.monotonic()))
    bench.repair()
    return ask(bench.port, case.setup)


def stands(truth, case, bench):
    """Whether the shaft comes to rest without anybody's doing."""
    deadline = time.monotonic() + COAST_S
    while not truth.driven and (truth.output or truth.speed) and time.monotonic() < deadline:
        time.sleep(0.1)
        truth = ask(bench.port, case.setup)
    return not (truth.driven or truth.output or truth.speed)


def document(run):
    if run.out is None:
        return None
    try:
        return json.loads(run.out)
    except ValueError as error:
        raise Failed(f"stdout is no JSON document ({error}): {run.out!r}") from None


def stop_of(run):
    told = document(run)
    return ((told or {}).get("data") or {}).get("stop")


def acknowledged(run):
    stop = stop_of(run)
    return bool(stop and stop["acknowledged"])


def proven_by_state(run):
    """The run saw the drive switched off by a command, and not tripped."""
    return acknowledged(run) and stop_of(run)["state"]["slug"] != "fault"


def is_touched(run):
    """Something went out that can turn a shaft. A control word 0 alone is what P.412 is given back with."""
    return any(frame.startswith(SETPOINT) for _, frame in run.sent) or any(word for _, word in run.control_words())


def step_of_stop(run):
    """The step of the command that stopped the drive: the first one behind the last enable."""
    words = run.control_words()
    enables = [step for step, word in words if word == ENABLE]
    behind = [step for step, _ in words if enables and step > enables[-1]]
    return behind[0] if behind else None


def judge(case, run, bench, breaks, verdict):
    """Holds the report against the drive's own word."""
    truth = truth_after(case, run, bench)
    verdict.story.append(f"afterwards: {truth or 'nobody to ask'}")
    turned = any(word == ENABLE for _, word in run.control_words())
    keep = case.setup.on_exit == "keep"

    # The shaft first: nothing that is said can make up for one that turns.
    if truth is None:
        verdict.shaft = "gone"
    elif stands(truth, case, bench):
        # A drive that stands already trips as well once nobody talks to it.
        by_watchdog = truth.fault == WATCHDOG_FAULT and not proven_by_state(run)
        verdict.shaft = "never" if not turned else "watchdog" if by_watchdog else "tool"
    else:
        verdict.shaft = "kept" if keep else "TURNING"
    demand(verdict.shaft != "TURNING", f"THE SHAFT WAS LEFT TURNING: {truth}")

    code = run.code
    # 7: silence to the second question of recognition is taken for a device that is no drive of ours.
    demand(code in (0, 3, 4, 5, 8, 9, 130) or (code == 7 and not is_touched(run)), f"ended with {code}")
    if truth is not None:
        demand(truth.fault in (0, WATCHDOG_FAULT), f"a fault of its own: {truth}")
    check_report(case, run, truth, turned, keep)
    check_prompt(case, run, breaks, truth, keep)
    check_given_back(case, run, truth)
    if truth is not None:
        # What the bench knows by itself; a shaft that coasts has no frequency to be read.
        if case.setup.on_exit == "coast" or truth.fault or (stop_of(run) or {}).get("standing") is not True:
            time.sleep(COASTING_S)
            # The closing counts are of the last event of the bench: make one.
            ask(bench.port, case.setup)
        counts = bench.counts()
        verdict.story.append(f"the bench: {counts}")
        turns = counts["turning"] + counts["energised"] > 0
        demand(turns == (verdict.shaft == "kept"), f"the drive said {truth}, the bench says {counts}")
        demand(counts["eeprom_writes"] == 0, "the EEPROM was written")
        if not case.second and case.first.prompt:
            talks_over = [remark for remark in counts["remarks"] if "while a drive answers" in remark]
            demand(not talks_over, f"the interrupted exchange was talked over: {talks_over}")


WITHOUT_POWER = ("switched-on", "switch-on-disabled", "ready-to-switch-on", "fault")


def check_report(case, run, truth, turned, keep):
    """What the run says of its stop must be so."""
    told = document(run)
    if told is None:
        # Nobody reads stdout: stderr and the exit code are the report.
        if truth is not None and truth.fault == WATCHDOG_FAULT and turned and not keep:
            said = re.search(r"(?i)not\s+acknowledged|watchdog", run.stderr().split("MOTION")[-1])
            demand(run.code != 0, "exit 0, though the watchdog had to stop the shaft and stdout was closed")
            demand(said, f"not a word about a stop that nobody proved: {run.stderr()!r}")
        if case.has("kills") and turned and not keep and case.second:
            demand(run.code != 0, "exit 0, though no stop was proven and stdout was closed")
        return
    error, data = told["error"], told["data"] or {}
    stop, running = data.get("stop"), data.get("running")
    demand((error is None) == (run.code == 0), f"exit {run.code}, but error is {error}")
    demand(error is None or error["exit"] == run.code, f"exit {run.code}, but error says {error}")
    if stop is None:
        demand(not is_touched(run), "the drive was commanded, but no stop is reported")
        demand(run.code != 0, "no stop was needed, yet the run was broken: it cannot be a success")
        return
    demand(stop["choice"] == case.setup.on_exit, f"another stop than was chosen: {stop}")
    if keep:
        demand("keeps running" in (stop["note"] or ""), f"keep is not said: {stop}")
        demand(not stop["acknowledged"], f"keep cannot be acknowledged: {stop}")
        if truth is not None and truth.driven:
            demand(running is not False, f"the shaft turns, but `running` is {running}")
        return
    demand(running is not True, f"`running` is true at the end of a bounded run: {data.get('to')}, {data['notes']}")
    tripped = (stop["state"] or {}).get("slug") == "fault"
    if stop["acknowledged"]:
        # It was the tool's doing, unless the report itself says that the drive had tripped.
        if truth is not None and not tripped and case.watchdog() == SLOW:
            demand(truth.fault == 0, f"said to be the tool's stop, but the watchdog tripped: {truth}")
        if tripped:
            demand(truth is None or truth.fault == WATCHDOG_FAULT, f"said to have tripped, but: {truth}")
            demand(run.code != 0, "the drive tripped, and the run is called a success")
        return
    demand(run.code != 0, "the stop was not acknowledged, and the run is called a success")
    if (stop["state"] or {}).get("slug") in WITHOUT_POWER:
        # The power is gone and nobody saw the shaft stand: that is told, and what the drive says now agrees.
        demand("without power" in error["message"] or "tripped" in error["message"], f"not told: {error['message']!r}")
        demand(data.get("standing") is not True, f"not acknowledged, but it stands: {data}")
        demand(truth is None or not truth.driven, f"said to be without power, but: {truth}")
        return
    demand("NOT acknowledged" in error["message"], f"a missing stop must be in the message: {error['message']!r}")
    demand("P.413" in (stop["note"] or ""), f"the note does not name the watchdog: {stop}")
    named = f" {case.watchdog()} s:" in stop["note"] or "not known" in stop["note"]
    demand(named, f"the note does not tell the {case.watchdog()} s of the watchdog: {stop}")
    if truth is not None:
        demand(truth.fault == WATCHDOG_FAULT, f"not acknowledged, and the watchdog did not act: {truth}")


def check_prompt(case, run, breaks, truth, keep):
    """While program and line live, the program itself stops the shaft, at once and for the right reason."""
    first = breaks[0]
    if case.second or not case.first.prompt or not first.fired:
        return
    if not keep:
        demand(truth.fault == 0, f"the watchdog stopped the shaft, not the program: {truth}")
    stop, told, at = step_of_stop(run), document(run), stop_of(run)
    if not is_touched(run):
        demand(case.has("closes") or run.code == 130, f"interrupted before anything was done, but exit {run.code}")
        return
    if told is None:
        demand(run.code in (0, 130), f"stdout closed, the stop proven, but exit {run.code}")
    elif at["because"] == "interrupted":
        demand(run.code == 130, f"interrupted, but exit {run.code}")
    else:
        late = stop is None or first.step >= stop - 1
        demand(keep or late, f"step {first.step} was before the stop at {stop}, but it is told as {at}")
        # A signal during the stop shortens it to a coast: then nobody saw the shaft stand.
        # So it is where a machine that loses 50 ms sees it only when P.638 has taken its power.
        unseen = run.code == 8 and (at["escalated"] == "coast" or "forbidden.standstill_unproven" in run.out)
        demand(run.code == 0 or unseen, f"came when the run was over, but exit {run.code}")
    if not keep and stop and first.step < stop:
        took = run.sent[stop - 1][0] - first.fired
        demand(took < PROMPT_S, f"{took:.2f} s until the stop was on the line")


def check_given_back(case, run, truth):
    """What the run changed is as before, if the drive obeyed at all."""
    told = document(run)
    if truth is None or told is None or not case.setup.gives_back:
        return
    rows = {f"{row['param']}@{row['data_set'] + 5}": row for row in (told["data"] or {}).get("changed", [])}
    for name, value in case.setup.gives_back:
        is_back = truth.others[name] == value
        if name in rows and rows[name]["restored"]:
            demand(is_back, f"said to be restored, but P.{name} is {truth.others[name]}, not {value}")
        demand(is_back or name in rows, f"P.{name} is {truth.others[name]}, and the report knows of no change")
        if case.first.prompt and not case.second and (stop_of(run) is None or proven_by_state(run)):
            demand(is_back, f"P.{name} is {truth.others[name]}, not given back as {value}")


def attempt(case):
    """Tries a case, once more if it fails: a machine that loses half a second makes another line of a good one. A shaft that
    was left turning is never forgiven."""
    verdict = trial(case)
    return verdict if not verdict.failure or verdict.shaft == "TURNING" else trial(case)


def trial(case):
    """Runs one case in a directory of its own."""
    verdict = Verdict(case)
    bench = run = None
    with tempfile.TemporaryDirectory(prefix="antrieb-breaks-") as name:
        directory = Path(name)
        try:
            watchdog = case.watchdog()
            bench = Bench(directory, case.setup.toml(watchdog), case.has("relayed"))
            options = next((kind.options for kind in case.kinds() if kind.options), ())
            run = Run(directory, bench.port, [*options, *case.setup.command(watchdog)])
            breaks = [Break(case.step, case.first.act(run, bench))]
            if case.second:
                breaks.append(Break(case.step + case.after, case.second.act(run, bench)))
            run.follow(breaks)
            verdict.reached = all(one.fired for one in breaks)
            verdict.seconds = run.ended - (breaks[0].fired or run.ended)
            verdict.story += story(run)
            if verdict.reached:
                judge(case, run, bench, breaks, verdict)
        except Exception as error:  # whatever goes wrong in a case is the case's failure, and the next one goes on
            verdict.failure = f"{type(error).__name__}: {error}"
            if run and not verdict.story:
                verdict.story += story(run)
        finally:
            for one in (run, bench):
                if one:
                    one.close()
    return verdict


def story(run):
    """What a developer needs to see of a run that went wrong."""
    lines = [f"$ {shlex.join(run.words)}", f"exit {run.code}"]
    begin = run.sent[0][0] if run.sent else 0
    lines += [f"{step:>4} {at - begin:7.3f} s > {frame.hex(' ')}" for step, (at, frame) in enumerate(run.sent, 1)][-14:]
    return [*lines, run.stderr().strip(), (run.out or "(stdout was closed)").strip()]


# The table of groups ----------------------------------------------------------------------------------------------

# Setup, kind, and at every how manieth step: in the whole table, and in the quick one (0: not at all). The five ways in
# which the line dies start at different steps, so that together they see every one.
TABLE = [
    (QUICK, SIGINT, 1, 8),
    (QUICK, SIGTERM, 3, 16),
    (QUICK, SIGHUP, 3, 16),
    (QUICK, STDOUT, 3, 12),
    (QUICK, KILL, 3, 12),
    (QUICK, FREEZE, 5, 16),
    (QUICK, STORM, 5, 16),
    (QUICK, PULL, 5, 16),
    (QUICK, LOSE, 5, 24),
    (QUICK, GAP, 5, 24),
    (RAMP, SIGINT, 5, 24),
    (RAMP, STDOUT, 8, 0),
    (RAMP, KILL, 8, 0),
    (RAMP, STORM, 10, 0),
    (RAMP, PULL, 12, 24),
    (COAST, SIGINT, 5, 24),
    (COAST, STDOUT, 9, 0),
    (COAST, KILL, 9, 0),
    (COAST, STORM, 12, 0),
    (KEEP, SIGINT, 8, 24),
    (KEEP, STDOUT, 9, 0),
    (KEEP, KILL, 9, 0),
    (KEEP, PULL, 9, 0),
    (MACHINE, SIGINT, 3, 12),
    (MACHINE, STDOUT, 5, 0),
    (MACHINE, KILL, 5, 24),
    (MACHINE, STORM, 8, 24),
    (MACHINE, PULL, 6, 0),
    (MACHINE_RAMP, SIGINT, 4, 24),
    (MACHINE_RAMP, PULL, 8, 0),
    (TAKE_QUICK, SIGINT, 4, 16),
    (TAKE_QUICK, PULL, 12, 24),
    (TAKE_QUICK, STORM, 12, 0),
    (TAKE_RAMP, SIGINT, 5, 16),
]

# Setup, two kinds, the second so many steps behind the first, which comes while the shaft turns.
DOUBLES = [
    (QUICK, SIGINT, SIGINT, range(1, 9, 2), (1,)),
    (QUICK, SIGINT, KILL, range(1, 9), (1,)),
    (QUICK, SIGINT, PULL, range(1, 9, 2), (2,)),
    (QUICK, SIGINT, STORM, range(1, 9, 2), (1,)),
    (RAMP, SIGINT, SIGINT, range(1, 9, 2), (2,)),
    (RAMP, SIGTERM, SIGINT, range(2, 9, 3), ()),
    (RAMP, SIGTERM, PULL, range(1, 9, 2), ()),
    (QUICK, SIGINT, STDOUT, range(1, 9, 3), ()),
    (QUICK, STDOUT, STORM, range(1, 9, 3), (1,)),
    (QUICK, STDOUT, PULL, range(1, 9, 3), ()),
]


@dataclass
class Group:
    """One line of the report."""

    name: str
    cases: list[Case]


def groups(lengths, quick):
    """The groups with their cases; `lengths` tells how many steps an undisturbed run has, and where it stops."""
    for number, (setup, kind, stride, quick_stride) in enumerate(TABLE):
        stride = quick_stride if quick else stride
        if stride:
            # Not the same steps for all, so that together they see more of them.
            steps = range(1 + number % stride, lengths[setup][0] + 1, stride)
            yield Group(f"{setup.name}: {kind.name}", [Case(setup, kind, step) for step in steps])
    for setup, first, second, after, quick_after in DOUBLES:
        step = lengths[setup][1] - 3
        cases = [Case(setup, first, step, second, gap) for gap in (quick_after if quick else after)]
        if cases:
            yield Group(f"{setup.name}: {first.name}, then {second.name}", cases)


def measure(setup):
    """How many steps an undisturbed run has, and at which one it stops the drive; on a machine that has the time for it."""
    for _ in range(2):
        try:
            return undisturbed(setup)
        except Exception as error:  # whatever goes wrong three times is wrong
            print(f"      {setup.name}, undisturbed, again: {str(error).splitlines()[0]}", flush=True)
    return undisturbed(setup)


def undisturbed(setup):
    with tempfile.TemporaryDirectory(prefix="antrieb-breaks-") as name:
        bench = run = None
        try:
            bench = Bench(Path(name), setup.toml(SLOW), False)
            run = Run(Path(name), bench.port, setup.command(SLOW))
            run.follow([])
            demand(run.code == 0, f"{setup.name}, undisturbed: exit {run.code}\n" + "\n".join(story(run)))
            return len(run.sent), step_of_stop(run) or len(run.sent)
        finally:
            for one in (run, bench):
                if one:
                    one.close()


# The question ------------------------------------------------------------------------------------------------------


def at_the_question(number):
    """A signal while the program waits for a yes: it ends at once, and the yes that is typed behind it does nothing."""
    with tempfile.TemporaryDirectory(prefix="antrieb-breaks-") as name:
        bench = Bench(Path(name), QUICK.toml(SLOW), False)
        keyboard, terminal = pty.openpty()
        words = [word for word in QUICK.command(SLOW) if word != "--yes"]
        words = [str(BINARY), "--no-config", "--lang", "en", "-v", "-b", "115200", "-p", bench.port, *words]
        process = subprocess.Popen(
            words, stdin=terminal, stdout=subprocess.DEVNULL, stderr=terminal, env=environment()
        )
        try:
            shown, deadline = b"", time.monotonic() + LIMIT_S
            while b"go on? [y/N]" not in shown:
                demand(time.monotonic() < deadline, f"no question: {shown.decode(errors='replace')}")
                if select.select([keyboard], [], [], 0.1)[0]:
                    shown += os.read(keyboard, 4096)
            asked = time.monotonic()
            process.send_signal(number)
            os.write(keyboard, b"y\n")
            code = process.wait(LIMIT_S)
            took = time.monotonic() - asked
            demand(code == 130, f"exit {code}")
            demand(took < PROMPT_S, f"{took:.1f} s until it ended")
            while select.select([keyboard], [], [], 0.1)[0]:
                shown += os.read(keyboard, 4096)
            written = [line for line in shown.splitlines() if b"> 01 06" in line or b"> 01 65" in line]
            demand(not written, f"written all the same: {written}")
            truth = ask(bench.port, QUICK)
            demand(not (truth.driven or truth.output or truth.speed), f"the shaft turns: {truth}")
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()
            os.close(keyboard)
            os.close(terminal)
            bench.close()


def questions():
    """The group of these; returns how many passed and failed."""
    passed = failed = 0
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        try:
            at_the_question(number)
            passed += 1
        except Exception as error:  # as in a case of the table
            failed += 1
            print(f"      {number.name} at the question: {type(error).__name__}: {error}", flush=True)
    print(f"{'FAIL' if failed else 'ok':<4}  {'signals at the question':<60}  {passed}/{passed + failed}", flush=True)
    return passed, failed


SHAFTS = ("tool", "watchdog", "never", "gone", "kept", "TURNING")
NAMES = {
    "tool": "stopped by the tool",
    "watchdog": "by the watchdog",
    "never": "never turned",
    "gone": "drive gone",
    "kept": "kept turning as asked",
    "TURNING": "LEFT TURNING",
}


def counted(shafts):
    return ", ".join(f"{shafts[name]} {NAMES[name]}" for name in SHAFTS if shafts[name])


def main(words):
    quick, only = "--quick" in words, None
    if "--step" in words:
        at = words.index("--step")
        only = int(words[at + 1])
        del words[at : at + 2]
    words = [word for word in words if word != "--quick"]
    if not BINARY.is_file():
        sys.exit(f"{BINARY} is missing: `cargo build` makes it, or name another one with ANTRIEB")
    started = time.monotonic()
    setups = list(dict.fromkeys(row[0] for row in [*TABLE, *DOUBLES]))
    shafts, passed, failed, missed = Counter(), 0, 0, 0
    with ThreadPoolExecutor(AT_ONCE) as pool:
        lengths = dict(zip(setups, pool.map(measure, setups), strict=True))
        wanted = [group for group in groups(lengths, quick) if not words or any(word in group.name for word in words)]
        for group in wanted if only else []:
            group.cases = [Case(group.cases[0].setup, group.cases[0].first, only)]
        todo = [(group, [pool.submit(attempt, case) for case in group.cases]) for group in wanted]
        for group, results in todo:
            verdicts = [result.result() for result in results]
            reached = [verdict for verdict in verdicts if verdict.reached]
            bad = [verdict for verdict in verdicts if verdict.failure]
            here = Counter(verdict.shaft for verdict in reached)
            good = sum(1 for verdict in reached if not verdict.failure)
            shafts, passed, failed = shafts + here, passed + good, failed + len(bad)
            missed += len(verdicts) - good - len(bad)
            of = lengths[group.cases[0].setup][0]
            longest = max((verdict.seconds for verdict in reached), default=0.0)
            told = f"{good}/{good + len(bad)} of {of} steps: {counted(here)}; over within {longest:.1f} s"
            print(f"{'FAIL' if bad else 'ok':<4}  {group.name:<60}  {told}", flush=True)
            for number, verdict in enumerate(bad):
                print(f"      {verdict.case.title()}: {verdict.failure}", flush=True)
                if number < 2:
                    print(textwrap.indent("\n".join(verdict.story), " " * 10), flush=True)
    if not words or any(word in "signals at the question" for word in words):
        more, bad = questions()
        passed, failed = passed + more, failed + bad
    seconds = time.monotonic() - started
    print(f"motion breaks: {passed + failed} cases in {seconds:.0f} s: {counted(shafts)}; {missed} steps not reached")
    print(f"shafts left turning: {shafts['TURNING']}")
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed or not passed else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
