"""The simulated line: what a transaction may cost at best on it, and benches of `antrieb simulate` to measure on.

Every character has 11 bits: pyserial cannot ask a pseudo terminal for parity (docs/measured.md), so all drives are
set to 8N2, which takes as long as 8E1.
"""

import json
import os
import signal
import tempfile
import termios
import time
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import harness  # of tests/peers: `line` adds it to the path

BINARY = harness.BINARY
BITS_PER_CHARACTER = 11
SHORTEST_GAP_S = 0.002  # CM-485 manual 6.8
FIXED_T35_S = 0.001_75  # above 19200 baud (Modbus over Serial Line V1.02, 2.5.1.1)
# Between two clients of a pseudo terminal.
REST_S = 0.03

# P.372 in its four data sets: different, so that a value shows whose it is.
RATED_SPEED = 372
SPEEDS = {1: 1101, 2: 1390, 3: 1403, 4: 1404}


def register(param, data_set=0):
    """The Modbus address of a parameter (CM-485 manual 7)."""
    return data_set << 12 | param


@dataclass(frozen=True)
class Setting:
    """Protocol and speed of a line, and how long its drives take to answer."""

    protocol: str
    baud: int
    delay_ms: int = 10

    def __str__(self):
        delay = "" if self.delay_ms == 10 else f", reply after {self.delay_ms} ms"
        return f"{self.baud} {self.protocol.upper()}{delay}"

    @property
    def _t35_s(self):
        """Silence that ends a telegram; only RTU knows it."""
        t35 = 3.5 * BITS_PER_CHARACTER / self.baud if self.baud <= 19_200 else FIXED_T35_S
        return t35 if self.protocol == "rtu" else 0

    @property
    def wire_s(self):
        """Question and reply of a one-register read, and the delay between them: no drive answers before t3.5."""
        characters = {"rtu": 8 + 7, "ascii": 17 + 15}[self.protocol]
        return characters * BITS_PER_CHARACTER / self.baud + max(self.delay_ms / 1_000, self._t35_s)

    @property
    def gap_s(self):
        """Silence that a master owes after a reply: 2 ms, on RTU at least 3.5 characters."""
        return max(SHORTEST_GAP_S, self._t35_s)

    @property
    def limit_s(self):
        """The shortest time from one question to the next."""
        return self.wire_s + self.gap_s

    @property
    def words(self):
        """The setting as options of `antrieb`."""
        line = ["--baud", self.baud, "--parity", "none", "--data-bits", 8, "--stop-bits", 2]
        return [str(word) for word in ["--protocol", self.protocol, *line]]

    def drive(self, address, delay_ms=None, jitter_ms=0):
        """A drive of a bench file; it may take up to `jitter_ms` longer."""
        values = ", ".join(f'"{RATED_SPEED}@{number}" = {speed}' for number, speed in SPEEDS.items())
        delay = self.delay_ms if delay_ms is None else delay_ms
        return (
            f'[[drive]]\nmodel = "act"\naddress = {address}\nprotocol = "{self.protocol}"\nbaud = {self.baud}\n'
            f'parity = "none"\ndata_bits = 8\nreply_delay = "{delay}ms"\njitter = "{jitter_ms}ms"\n'
            f"set = {{ {values} }}\n\n"
        )


class Bus:
    """A served bench that one more client holds open, so that it need not look for who comes."""

    def __init__(self, served):
        self.served = served
        self.port = str(served.port)
        self.tty = os.open(self.port, os.O_RDWR | os.O_NOCTTY)
        self.report = None

    def rest(self):
        """Another speed between two clients: libmodbus cannot set parity on a pty that has its speed already."""
        time.sleep(REST_S)
        attributes = termios.tcgetattr(self.tty)
        attributes[4] = attributes[5] = termios.B38400
        termios.tcsetattr(self.tty, termios.TCSANOW, attributes)
        termios.tcflush(self.tty, termios.TCIFLUSH)

    def stop(self):
        """Ends the bench; `report` is what its judge says."""
        os.close(self.tty)
        self.report = json.loads(self.served.end(signal.SIGINT).out)["data"]


@contextmanager
def bus(toml):
    """A bench for the length of a `with`; its `report` is there afterwards."""
    with tempfile.TemporaryDirectory(prefix="antrieb-bench-") as directory:
        with harness.Bench(Path(directory), toml, False) as served:
            line = Bus(served)
            try:
                yield line
            finally:
                line.stop()


def our(port, setting, *words):
    """The command line of our program for a line."""
    return [str(BINARY), "--no-config", "-p", port, *setting.words, "-a", "1", "--drive", "act", *words]
