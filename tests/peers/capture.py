"""`sniff` beside a master that we did not write: pymodbus asks the bench, a tap copies every byte to our listener and throws garbage in
between; tshark's own Modbus RTU dissector reads the capture."""

import json
import os
import random
import select
import signal
import socket
import subprocess
import termios
import threading
import time
import tty
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from harness import BINARY, WITHOUT_PARITY, Running, bench, expect, group
from pymodbus.client import ModbusSerialClient

case = group("capture")

ROUNDS = 20
# Of every so many telegrams one has garbage before it: 5 %.
DISTURBED = 20
# No telegram begins with these, whatever follows.
GARBAGE = bytes([0xFE, 0x55, 0xFF])
# Longer than a listener waits for the rest of a telegram.
REST_S = 0.06


class Tap:
    """A line between a master and the bench. Its third end is a raw serial server."""

    def __init__(self, port):
        self.master, slave = os.openpty()
        tty.setraw(slave)
        self.name = os.ttyname(slave)
        self.bench = os.open(port, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.bench)
        # The bench looks at the speed and the format that its client has set.
        setting = termios.tcgetattr(self.bench)
        setting[4] = setting[5] = termios.B19200
        setting[2] |= termios.CSTOPB
        termios.tcsetattr(self.bench, termios.TCSANOW, setting)
        self.server = socket.create_server(("127.0.0.1", 0))
        self.ear, self.sent, self.over = None, b"", False
        self.copied = 0
        threading.Thread(target=self.carry, daemon=True).start()

    def listen(self):
        self.ear, _ = self.server.accept()

    def carry(self):
        while not self.over:
            ready, _, _ = select.select([self.master, self.bench, *([self.ear] if self.ear else [])], [], [], 0.05)
            for end in ready:
                if end is self.ear:
                    came = self.ear.recv(512)
                    self.sent += came
                    if not came:
                        self.ear = None
                    continue
                came = os.read(end, 512)
                os.write(self.bench if end == self.master else self.master, came)
                if self.ear:
                    self.ear.sendall(came)

    def disturb(self):
        time.sleep(REST_S)
        self.ear.sendall(GARBAGE)
        time.sleep(REST_S)


@contextmanager
def tapped():
    with bench(WITHOUT_PARITY) as served:
        tap = Tap(served.port)
        client = ModbusSerialClient(tap.name, baudrate=19200, parity="N", stopbits=2, timeout=1, retries=0)
        try:
            yield tap, client
        finally:
            client.close()
            tap.over = True


def session(tap, client, dice):
    """Reads, writes and refusals of two drives; how many telegrams were asked."""
    client.connect()
    asked = 0
    for nth in range(ROUNDS):
        unit = 1 + nth % 2
        for ask in (
            lambda: client.read_holding_registers(0x2174, count=1, device_id=unit),
            lambda: client.write_register(0x21E1, 500 + nth, device_id=unit),
            lambda: client.read_holding_registers(0x1FFF, count=1, device_id=unit),
            lambda: client.write_registers(0x21E2, [600 + nth], device_id=unit),
        ):
            if dice.randrange(DISTURBED // 2) == 0:
                tap.disturb()
            ask()
            asked += 1
            time.sleep(0.01)
    return asked


def dissected(capture):
    """Who was spoken to, with which function code and check value, by tshark; what is no telegram left out."""
    words = ["tshark", "-r", capture, "-d", "rtacser.data,mbrtu", "-Y", "!mbrtu.crc16.incorrect", "-T", "fields"]
    words += [word for field in ("mbrtu.unit_id", "modbus.func_code", "mbrtu.crc16") for word in ("-e", field)]
    told = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    return [tuple(int(cell, 0) for cell in line.split("\t")) for line in told.splitlines() if line.strip()]


def heard(lines):
    telegrams = [json.loads(line) for line in lines.splitlines()]
    return [record for record in telegrams if record["type"] == "telegram"], telegrams[-1]["summary"]


@case("every telegram of pymodbus is heard through garbage, nothing is sent, and tshark reads the same ones")
def _():
    with TemporaryDirectory(prefix="antrieb-peers-") as directory, tapped() as (tap, client):
        capture = Path(directory) / "heard.pcap"
        port = f"tcp://127.0.0.1:{tap.server.getsockname()[1]}"
        words = ("--format", "ndjson", "--parity", "none", "--port", port, "sniff", "--pcap", capture)
        with Running([BINARY, "--no-config", *words]) as listener:
            tap.listen()
            # What stood in the line before it listens is nobody's.
            time.sleep(0.5)
            asked = session(tap, client, random.Random(14))
            # What came last is on its way to the listener.
            time.sleep(0.5)
            telegrams, summary = heard(listener.end(signal.SIGINT).exits(0).out)
        whole = [record for record in telegrams if record["check_ok"]]
        expect("telegrams", len(whole), 2 * asked)
        expect("in turn", [record["direction"] for record in whole], ["request", "reply"] * asked)
        expect("disturbed", summary["garbled"] > 0, True)
        expect("sent by the listener", tap.sent, b"")
        stations = {row["address"]: (row["requests"], row["replies"], row["unanswered"]) for row in summary["stations"]}
        expect("stations", stations, {1: (asked // 2, asked // 2, 0), 2: (asked // 2, asked // 2, 0)})
        expect("refusals", sum(row["exceptions"] for row in summary["stations"]) > 0, True)
        read = dissected(capture)
    # The check value is the last word of a telegram, so it names the telegram.
    ours = [(row["address"], row["function"], int(row["hex"].replace(" ", "")[-4:], 16)) for row in whole]
    expect("tshark", read, ours)
