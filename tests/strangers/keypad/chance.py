#!/usr/bin/env python3
"""Random key sequences in a terminal of their own, against the drives of strangers; no shaft may be left turning.

ANTRIEB=target/debug/antrieb python3 tests/strangers/keypad/chance.py [COUNT [FIRST_SEED [JOBS]]]

A line of JSON for each sequence on stdout, the sum on stderr; exit 1 if a shaft was left turning, the program hung or ended otherwise than
with 0, 130 or 128 + a signal. What the shaft does is told by the motor of the drive itself, every 20 ms, and not by a question. A
control goes first: the program is killed where it cannot stop anything (SIGKILL), and the trial must see that shaft turn.
"""
import collections
import json
import random
import subprocess
import sys
import threading
import time

UP, DOWN = ["\x1b[A", "\x1bOA"], ["\x1b[B", "\x1bOB"]
PLAIN = [" ", "q", "d", "\x1b", "x", "5", "\r", "\t", "\x1b[C", "\x1b[D", "\x1b[5~", "\x1b[200~q\x1b[201~", "\x04", "\x11"]
SIZES = [(24, 80), (5, 20), (1, 1), (50, 200), (10, 40), (24, 30)]
ACT = ["-a", "1", "sollwert", "15Hz", "--source", "line", "--enable", "--hold", "--yes"]
LXM = ["-a", "1", "sollwert", "300", "--mode", "velocity", "--enable", "--hold", "--yes"]
KEYS = ["--view", "--step", "1Hz", "--min", "-5Hz", "--max", "20Hz"]
RUNS = [
    ("view", "act", ACT + KEYS),
    ("view", "act", ACT + KEYS + ["--duration", "6s"]),
    ("view", "acu", ACT + KEYS + ["--take-control"]),
    ("line", "act", ACT + ["--duration", "5s"]),
    ("line", "act", ["-a", "1", "statemachine", "enable", "--hold", "--yes"]),
    ("view", "act", ["-a", "1", "statemachine", "enable", "--hold", "--view", "--yes"]),
    ("view", "act", ["-a", "1", "sollwert", "8Hz", "--source", "line", "--jog", "4s", "--view", "--yes"]),
    ("view", "act", ["-a", "1", "sollwert", "--ramp", "0Hz:15Hz:3s", "--source", "line", "--enable", "--hold", "--view", "--yes"]),
    ("dead", "act", ACT + KEYS[1:] + ["--dead-man"]),
    ("dead", "act", ACT + ["--dead-man"]),
    ("view", "act", ACT + ["--view", "--on-exit", "quick-stop"]),
    ("view", "act", ACT + ["--view", "--on-exit", "coast"]),
    ("view", "lxm", LXM + ["--view", "--duration", "8s"]),
    ("view", "lxm", LXM + ["--view", "--step", "50", "--max", "600"]),
    ("dead", "lxm", LXM + ["--dead-man"]),
]


class Shaft(threading.Thread):
    """What the motor does, every 20 ms: Hz of an ACTIVE, 1/min of an LXM05."""

    def __init__(self, drive):
        super().__init__(daemon=True)
        self.drive, self.seen, self.over = drive, [], False

    def now(self):
        look = self.drive.look()
        return abs(look[2]), look[0]

    def run(self):
        while not self.over:
            self.seen.append((time.monotonic(), *self.now()))
            time.sleep(0.02)

    def fastest(self, until=None):
        return max((speed for when, speed, _ in self.seen if until is None or when <= until), default=0)


def drive_of(k, kind):
    if kind == "lxm":
        return k.LX()
    # The internal setpoint of 10 Hz is what `statemachine enable` follows.
    return k.act(f"--family {kind} --internal 10 --coast 40")


def press(k, dice, terminal, manner, told):
    """One thing that somebody does; whether it may have ended the program."""
    what = dice.random()
    if manner == "dead" and what < 0.5:
        key = dice.choice(["\r"] + UP[:1])
        for _ in range(dice.randint(8, 60)):
            if terminal.p.poll() is not None:
                break
            terminal.key(key)
            time.sleep(0.033)
        told.append("HELD")
        return
    if what < 0.62:
        key = dice.choice(UP + DOWN + UP + DOWN + PLAIN)
        told.append(repr(key)[1:-1])
        terminal.key(key)
    elif what < 0.70:
        burst = "".join(dice.choice(UP + DOWN + PLAIN[4:9]) for _ in range(30))
        told.append("BURST")
        terminal.key(burst)
    elif what < 0.82:
        rows, columns = dice.choice(SIZES)
        told.append(f"{rows}x{columns}")
        terminal.size(rows, columns)
        terminal.sig(k.signal.SIGWINCH)
    elif what < 0.87:
        key = dice.choice(["\x1a", "\x1c", "\x13"])
        told.append(repr(key)[1:-1])
        terminal.key(key)
        if key == "\x13":
            time.sleep(0.3)
            terminal.key("\x11")
    elif what < 0.93:
        told.append("STOP/CONT")
        terminal.sig(k.signal.SIGSTOP)
        time.sleep(dice.choice([0.1, 0.3, 0.8]))
        terminal.sig(k.signal.SIGCONT)
    elif what < 0.97:
        told.append("^C")
        terminal.key("\x03")
    else:
        kind = dice.choice(["SIGHUP", "SIGTERM", "SIGINT"])
        told.append(kind)
        terminal.sig(getattr(k.signal, kind))


def end(k, dice, terminal, told):
    """How it ends: by a key, two Ctrl-C, a signal, the loss of the terminal, or by itself."""
    how = dice.choice(["q", "space q", "^C", "^C ^C", "lost", "SIGTERM", "SIGHUP", "wait"])
    told.append("END " + how)
    if how in ("SIGTERM", "SIGHUP"):
        terminal.sig(getattr(k.signal, how))
    elif how == "lost":
        terminal.hang()
    elif how == "wait":
        terminal.wait(9)
        if terminal.p.poll() is None:
            terminal.key("\x03")
    else:
        for key in how.split():
            terminal.key({"q": "q", "space": " ", "^C": "\x03"}[key])
            time.sleep(dice.choice([0.05, 0.4]))
        if "^C" not in how:
            # A plain line knows no keys.
            terminal.wait(6)
            if terminal.p.poll() is None:
                terminal.key("\x03")
    return how


def one(k, seed, kill=False):
    dice = random.Random(seed)
    manner, kind, line = RUNS[0] if kill else dice.choice(RUNS)
    told = []
    with drive_of(k, kind) as drive:
        shaft = Shaft(drive)
        shaft.start()
        terminal = k.T(drive, line, ixon=True)
        if manner == "dead":
            time.sleep(1.2)
            for _ in range(40):
                terminal.key("\r")
                time.sleep(0.033)
        else:
            terminal.enabled(8)
            time.sleep(dice.choice([0.0, 0.2, 1.0]))
        if kill:
            time.sleep(1.5)
            ended = time.monotonic()
            terminal.sig(k.signal.SIGKILL)
        else:
            for _ in range(dice.randint(2, 10)):
                if terminal.p.poll() is not None:
                    break
                press(k, dice, terminal, manner, told)
                time.sleep(dice.choice([0.02, 0.1, 0.3, 0.6]))
            ended = time.monotonic()
            if terminal.p.poll() is None:
                end(k, dice, terminal, told)
        hung = not terminal.wait(45)
        code = terminal.p.poll()
        # What still goes down may do so for a moment; what turns then was left turning.
        time.sleep(1.5)
        speed, state = shaft.now()
        shaft.over = True
        shaft.join(1)
        terminal.kill()
    still = 0.05 if kind != "lxm" else 1
    return {
        "seed": seed, "drive": kind, "run": " ".join(line[2:]), "keys": told, "code": code, "hung": hung, "state": str(state),
        "turned": shaft.fastest() > 20 * still, "fastest": round(shaft.fastest(), 2), "turned_before_its_end": shaft.fastest(ended) > 20 * still,
        "left_turning": speed > still, "speed": round(speed, 2), "tail": terminal.tail(300) if hung or speed > still or code is None or code < 0 else "",
    }


def child(first, count):
    import k

    for seed in range(first, first + count):
        print(json.dumps(one(k, seed)), flush=True)


def main(count=20, first=1, jobs=4):
    import k

    control = one(k, 0, kill=True)
    print(json.dumps(control), flush=True)
    assert control["left_turning"], f"a shaft that turns is not seen to turn: {control}"
    share = [count // jobs + (job < count % jobs) for job in range(jobs)]
    starts = [first + sum(share[:job]) for job in range(jobs)]
    command = [sys.executable, __file__, "--child"]
    children = [
        subprocess.Popen([*command, str(start), str(many)], stdout=subprocess.PIPE, text=True)
        for start, many in zip(starts, share)
    ]
    lines = [[] for _ in children]

    def hear(job):
        for line in children[job].stdout:
            lines[job].append(json.loads(line))
            print(line, end="", flush=True)

    ears = [threading.Thread(target=hear, args=(job,)) for job in range(jobs)]
    [ear.start() for ear in ears]
    [ear.join() for ear in ears]
    rows = sorted((row for rows in lines for row in rows), key=lambda row: row["seed"])
    turned = sum(row["turned_before_its_end"] for row in rows)
    left = [row["seed"] for row in rows if row["left_turning"]]
    hung = [row["seed"] for row in rows if row["hung"]]
    codes = collections.Counter(row["code"] for row in rows)
    odd = [row["seed"] for row in rows if row["code"] not in (0, 130, 129, 131, 143)]
    by = collections.Counter(row["drive"] for row in rows)
    pressed = sum(len(row["keys"]) for row in rows)
    print(
        f"{len(rows)} sequences ({dict(by)}), {pressed} things done; the shaft had turned before the end in {turned}, at any time in "
        f"{sum(row['turned'] for row in rows)}; left turning: {len(left)} {left}; hung: {len(hung)} {hung}; codes {dict(codes)}; other codes: {odd}; "
        f"control (SIGKILL): left turning at {control['speed']} Hz",
        file=sys.stderr,
    )
    sys.exit(bool(left or hung or odd or len(rows) != count))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        child(*map(int, sys.argv[2:4]))
    else:
        main(*map(int, sys.argv[1:4]))
