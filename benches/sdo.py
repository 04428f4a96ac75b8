#!/usr/bin/env python3
"""SDO reads a second over CAN, ours beside python's canopen on the same adapter: benches/sdo.py target/release/antrieb

The adapter speaks SLCAN on a TCP port, and the drive behind it answers at once, as on a bus without wires: what is left is what the program and
the machine take. canopen comes from tests/peers/requirements.txt; it is left out where it is not installed. Both read P.411 one after the other.
"""

import multiprocessing
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    import can
    import canopen
except ImportError:
    can = canopen = None

NODE, PARAM, VALUE = 1, 411, 0x33
COUNT, ROUNDS = 2000, 3
# The fastest that a bus has: a frame of eight bytes takes 0.135 ms, and ours keeps that time between questions.
RATE = 1_000_000
# A question for P.411 over SDO2, in the characters of the adapter.
QUESTION = "> " + " ".join(f"{ord(letter):02X}" for letter in f"t{0x640 + NODE:03X}8409B01")
# Questions and answers of both channels (EM-RES-03 manual 5.9.4).
REPLIES = {0x640 + NODE: 0x5C0 + NODE, 0x600 + NODE: 0x580 + NODE}


def answer(word):
    """What the adapter says to a word of its host, with the frame of the drive behind it."""
    if not word.startswith("t"):
        return {"V": "V1013\r", "F": "F00\r"}.get(word[:1], "\r")
    request = int(word[1:4], 16)
    if request not in REPLIES:
        return "z\r"
    multiplexer = word[7:13]
    return f"z\rt{REPLIES[request]:03X}842{multiplexer}{VALUE.to_bytes(4, 'little').hex().upper()}\r"


def serve(listener):
    """Hosts, one after the other."""
    while True:
        connection, _ = listener.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        rest = ""
        try:
            while piece := connection.recv(4096):
                *words, rest = (rest + piece.decode("ascii")).split("\r")
                connection.sendall("".join(map(answer, words)).encode())
        except ConnectionError:
            pass
        connection.close()


def ours(program, port):
    """Milliseconds that a read takes, by the times of the program's own recording."""
    with tempfile.TemporaryDirectory() as folder:
        recording = Path(folder) / "line.txt"
        words = ["--no-config", "-p", f"slcan:tcp://127.0.0.1:{port}", "-b", RATE, "-a", NODE, "--drive", "acu"]
        words += ["--trace", recording, "diag", "--link-test", COUNT]
        subprocess.run([program, *map(str, words)], capture_output=True, check=True, timeout=60)
        asked = [int(line.split()[0]) for line in recording.read_text().splitlines() if QUESTION in line]
    asked = asked[-COUNT:]
    return (asked[-1] - asked[0]) / (len(asked) - 1) / 1000


def theirs(port):
    """The same with canopen, by the clock."""
    bus = can.Bus(interface="slcan", channel=f"socket://127.0.0.1:{port}", bitrate=RATE, sleep_after_open=0)
    network = canopen.Network(bus)
    network.connect()
    node = canopen.RemoteNode(NODE, canopen.ObjectDictionary())
    network.add_node(node)
    begun = time.monotonic()
    for _ in range(COUNT):
        node.sdo.upload(PARAM, 0)
    took = time.monotonic() - begun
    network.disconnect()
    return took / COUNT * 1000


def main(program):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        adapter = multiprocessing.Process(target=serve, args=(listener,), daemon=True)
        adapter.start()
        for _ in range(ROUNDS):
            told = [f"ours {(own := ours(program, port)):.3f} ms"]
            if canopen:
                other = theirs(port)
                told += [f"canopen {other:.3f} ms", f"ratio {own / other:.2f}"]
            print(f"an SDO read: {', '.join(told)}", flush=True)
        adapter.terminate()


if __name__ == "__main__":
    main(sys.argv[1])
