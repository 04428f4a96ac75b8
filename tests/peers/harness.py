"""What every case needs: a table of cases, processes that surely end, and comparisons that say what came.

Knows how to start our program and the counterparts. Does not know Modbus: numbers of telegrams are the cases' business.
"""

import json
import os
import shlex
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
BINARY = Path(os.environ.get("ANTRIEB", TARGET / "release/antrieb"))

# A process that is not over by then never will be; no counterpart needs more than a few seconds.
PATIENCE_S = 30
# A simulated bench ends by itself, also if whoever started it was killed.
BENCH_LIFE = "60s"


# The table of cases -----------------------------------------------------------------------------------------------

CASES = []


@dataclass
class Case:
    """One line of the report."""

    group: str
    title: str
    run: Callable[[], None]


def group(name):
    """A decorator that adds a function to the table; with `each`, once per row, and `{}` in the title is its name."""

    def case(title, each=None):
        def add(function):
            for key, row in (each or {}).items():
                CASES.append(Case(name, title.format(key), lambda row=row: function(*row)))
            if each is None:
                CASES.append(Case(name, title, function))
            return function

        return add

    return case


# Comparisons ------------------------------------------------------------------------------------------------------


class LeftOut(Exception):
    """What a case needs is not to be had on this machine: it tells nothing, for or against."""


class Failed(Exception):
    """Something else came than was expected."""


def expect(what, got, wanted):
    if got != wanted:
        raise Failed(f"{what}: expected {wanted!r}, got {got!r}")


def expect_in(what, got, allowed):
    if got not in allowed:
        raise Failed(f"{what}: expected one of {allowed!r}, got {got!r}")


def expect_text(what, text, *parts):
    for part in parts:
        if part not in text:
            raise Failed(f"{what}: expected {part!r} in it, got {text!r}")


def expect_below(what, got, limit):
    if not got < limit:
        raise Failed(f"{what}: expected less than {limit}, got {got:.3f}")


# Processes --------------------------------------------------------------------------------------------------------

# What was run in the present case, with its output: printed when the case fails.
TRAIL = []
LONGEST_TRAIL = 60


def shorten(text):
    """The begin and the end of what a process wrote."""
    lines = text.splitlines()
    left_out = len(lines) - LONGEST_TRAIL
    if left_out <= 0:
        return text
    half = LONGEST_TRAIL // 2
    return "\n".join([*lines[:half], f"… {left_out} lines …", *lines[-half:]])


@dataclass
class Done:
    """How a process ended."""

    words: list[str]
    code: int | str
    out: str
    err: str
    seconds: float

    def __post_init__(self):
        told = shorten(self.out + self.err)
        TRAIL.append(f"$ {shlex.join(self.words)}\n{told}\nexit {self.code} after {self.seconds:.2f} s")

    @property
    def document(self):
        """The one JSON document on stdout."""
        try:
            return json.loads(self.out)
        except ValueError as error:
            raise Failed(f"stdout is no JSON document ({error}): {self.out!r}") from None

    @property
    def data(self):
        return self.document["data"]

    @property
    def error(self):
        return self.document["error"]

    def exits(self, code):
        """Checks the exit code, and hands the result on."""
        expect(f"exit code of {shlex.join(self.words)}", self.code, code)
        return self


def environment():
    """Nothing of the developer's own settings may decide how a case ends."""
    keep = {name: os.environ[name] for name in ("PATH", "HOME", "TMPDIR") if name in os.environ}
    return {**keep, "LC_ALL": "C.UTF-8"}


class Running:
    """A process whose output goes to files, so that it can neither block nor be lost."""

    def __init__(self, words):
        self.words = [str(word) for word in words]
        self.files = tempfile.TemporaryFile("w+"), tempfile.TemporaryFile("w+")
        self.started = time.monotonic()
        self.process = subprocess.Popen(
            self.words, stdin=subprocess.DEVNULL, stdout=self.files[0], stderr=self.files[1], env=environment()
        )

    def output(self):
        """What it wrote to stdout and stderr so far."""
        return tuple(os.pread(file.fileno(), 1 << 20, 0).decode(errors="replace") for file in self.files)

    def wait_for(self, text):
        """Waits until it has written `text`."""
        deadline = time.monotonic() + PATIENCE_S
        while not any(text in written for written in self.output()):
            if self.process.poll() is not None or time.monotonic() > deadline:
                self.end(signal.SIGTERM)
                raise Failed(f"{self.words[0]} never said {text!r}")
            time.sleep(0.005)

    def signal(self, number):
        self.process.send_signal(number)

    def end(self, number=None):
        """Waits for its end, after a signal if one is given; what does not end is killed."""
        if number is not None and self.process.poll() is None:
            self.signal(number)
        try:
            code = self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            code = f"killed: not over after {PATIENCE_S} s ({self.process.wait()})"
        out, err = self.output()
        return Done(self.words, code, out, err, time.monotonic() - self.started)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.end(signal.SIGTERM)
        for file in self.files:
            file.close()


def run(*words):
    """Runs a program to its end."""
    with Running(words) as running:
        return running.end()


def our(port, *words):
    """The command line of our program in the way a script calls it."""
    return [BINARY, "--no-config", "--json", "--port", port, *words]


def antrieb(port, *words):
    """Runs our program to its end."""
    return run(*our(port, *words))


# The bench, and lines between two masters' ends -------------------------------------------------------------------


class Bench(Running):
    """`antrieb simulate` in real time: an ACT at 1 and an ACU at 2, or what a bench file says."""

    def __init__(self, directory, toml, tcp):
        place = ["--tcp", "127.0.0.1:0"] if tcp else ["--link", directory / "bench"]
        self.file = directory / "bench.toml" if toml else None
        if toml:
            self.file.write_text(toml)
        files = [self.file] if toml else []
        super().__init__([BINARY, "--no-config", "--json", "simulate", *place, "--for", BENCH_LIFE, *files])
        self.counts = None
        self.wait_for("serving on ")
        self.port = self.output()[1].split("serving on ")[1].split(";")[0]

    def stop(self):
        """Ctrl-C: it ends well, tells its counts and leaves nothing behind."""
        self.counts = self.end(signal.SIGINT).exits(0).data
        if os.path.lexists(self.port):
            raise Failed(f"{self.port} was left behind")
        return self.counts


# An ACT at 1 and an ACU at 2, for whoever cannot ask a pseudo terminal for parity.
WITHOUT_PARITY = """
[[drive]]
model = "act"
address = 1
parity = "none"

[[drive]]
model = "acu"
address = 2
parity = "none"
"""


@contextmanager
def bench(toml=None, tcp=False):
    """A bench for the length of a `with`; its `counts` are there afterwards."""
    with tempfile.TemporaryDirectory(prefix="antrieb-peers-") as directory:
        with Bench(Path(directory), toml, tcp) as served:
            yield served
            if served.process.poll() is None:
                served.stop()


@contextmanager
def null_modem():
    """Two pseudo terminals with a line between them (socat)."""
    with tempfile.TemporaryDirectory(prefix="antrieb-peers-") as directory:
        ends = [Path(directory) / name for name in ("master", "slave")]
        with Running(["socat", "-d", "-d", *(f"pty,rawer,link={end}" for end in ends)]) as socat:
            socat.wait_for("starting data transfer loop")
            yield ends
