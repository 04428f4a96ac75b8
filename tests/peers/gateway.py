"""A Modbus/TCP gateway as a process of its own: questions from a TCP port go to an RTU line, replies come back.

    gateway.py TTY

Frames are pymodbus' on both sides, the line is pyserial's; what stands in a telegram is passed on unread. Who does not
answer is told of with exception 11 (Modbus application protocol V1.1b3, 7). Says "ready on PORT" on stdout, ends on
SIGTERM.
"""

import socketserver
import sys
import time

import serial
from pymodbus.constants import ExcCodes
from pymodbus.framer import FramerRTU, FramerSocket
from pymodbus.pdu import DecodePDU

BAUD = 19_200
CHECK = 2
# A drive answers within 500 ms (CM-485 manual); a telegram is over when nothing comes for longer than 3.5 characters, and a
# machine on which bytes of a pseudo terminal come later than that now and then makes no gateway of its own.
REPLY_LIMIT_S, END_S, GAP_S = 0.5, 0.05, 0.003

NET, LINE = FramerSocket(DecodePDU(True)), FramerRTU(DecodePDU(False))


def ask(line, station, pdu):
    """The reply of a station; exception 11 if none comes."""
    time.sleep(GAP_S)
    line.reset_input_buffer()
    line.write(LINE.encode(pdu, station, 0))
    line.timeout = REPLY_LIMIT_S
    frame = line.read(1)
    line.timeout = END_S
    while more := line.read(256):
        frame += more
    sound = len(frame) > CHECK and LINE.check_CRC(frame[:-CHECK], int.from_bytes(frame[-CHECK:], "big"))
    if not sound or frame[0] != station:
        return bytes([pdu[0] | 0x80, ExcCodes.GATEWAY_NO_RESPONSE])
    return frame[1:-CHECK]


class Gateway(socketserver.BaseRequestHandler):
    """One master, until it goes."""

    def handle(self):
        waiting = b""
        while received := self.request.recv(512):
            waiting += received
            used, station, transaction, pdu = NET.decode(waiting)
            while used:
                waiting = waiting[used:]
                self.request.sendall(NET.encode(ask(self.server.line, station, pdu), station, transaction))
                used, station, transaction, pdu = NET.decode(waiting)


if __name__ == "__main__":
    # pyserial cannot ask a pseudo terminal for parity (docs/measured.md).
    with socketserver.TCPServer(("127.0.0.1", 0), Gateway) as server:
        server.line = serial.Serial(sys.argv[1], BAUD, parity="N", stopbits=2)
        print(f"ready on {server.server_address[1]}", flush=True)
        server.serve_forever()
