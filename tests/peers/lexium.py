"""pymodbus' client as master of our simulated LXM05: codes 3, 8, 16, 23 and 43/14, on the pty and over raw TCP.

Addresses and values are those of the LXM05 manual. pyserial cannot ask a pseudo terminal for parity, so the drives are
set to 8N2.
"""

import logging
import struct
import time
from contextlib import contextmanager

import serial
from pymodbus.client import ModbusSerialClient, ModbusTcpClient
from pymodbus.exceptions import ModbusIOException
from pymodbus.framer import FramerType
from pymodbus.framer.rtu import FramerRTU

from harness import Failed, bench, expect, group
from refusal import Refused, expect_refused

case = group("lexium")
# It warns of the silence that some cases ask for.
logging.getLogger("pymodbus").setLevel(logging.CRITICAL)

LXM, ACT, ACU, EVERYBODY = 1, 2, 3, 0

RAMP_ACC, RAMP_DEC, SPEED_LIMIT = 1556, 1558, 1554
LIMIT_P, NODE_GUARD, STATUS, CONTROL, MODE, MODE_ACTIVE = 1544, 5644, 6916, 6914, 6918, 6920
VELOCITY, TARGET, TARGET_SPEED, POSITION, FAULT = 6938, 6940, 6942, 7700, 15362

DRIVES = f"""
[[drive]]
model = "lxm05"
address = {LXM}
parity = "none"
{{keys}}
[[drive]]
model = "act"
address = {ACT}
parity = "none"
[[drive]]
model = "acu"
address = {ACU}
parity = "none"
"""

# pymodbus keeps no silence between a reply and its next request; a drive needs t3.5.
PAUSE_S = 0.005
# Between a broadcast and the next telegram (MODBUS over Serial Line V1.02, 2.4.1: 100 to 200 ms).
TURNAROUND_S = 0.15
PATIENCE_S = 20


def registers(values, order=">"):
    """32-bit values as registers; ">" has the high word first."""
    words = [struct.unpack(">HH", struct.pack(">i", value)) for value in values]
    return [word for pair in words for word in (pair if order == ">" else pair[::-1])]


def values(words, order=">"):
    pairs = zip(words[::2], words[1::2], strict=True)
    return [struct.unpack(">i", struct.pack(">HH", *(pair if order == ">" else pair[::-1])))[0] for pair in pairs]


class Master:
    """A pymodbus client that speaks in parameters of 32 bits. Every method returns values or raises `Refused`."""

    def __init__(self, client):
        self.client = client

    def ask(self, name, *what, **how):
        time.sleep(PAUSE_S)
        reply = getattr(self.client, name)(*what, **{"device_id": LXM, **how})
        if reply is not None and reply.isError():
            raise Refused(reply.exception_code)
        return reply

    def read(self, address, count=1):
        words = self.ask("read_holding_registers", address, count=2 * count).registers
        return values(words)[0] if count == 1 else values(words)

    def write(self, address, *what):
        reply = self.ask("write_registers", address, registers(what))
        expect("echo", (reply.address, reply.count), (address, 2 * len(what)))

    def exchange(self, read, write, value):
        words = self.ask(
            "readwrite_registers", read_address=read, read_count=2, write_address=write, values=registers([value])
        ).registers
        return values(words)[0]

    def until(self, address, mask, wanted):
        deadline = time.monotonic() + PATIENCE_S
        while self.read(address) & mask != wanted:
            if time.monotonic() > deadline:
                raise Failed(f"{address} never was {wanted:X}h under {mask:X}h")

    def enable(self, mode):
        """As all worked sequences of the manual begin."""
        for word in (0x00, 0x06, 0x0F):
            self.write(CONTROL, word)
        self.until(STATUS, 0x07, 0x07)
        self.write(MODE, mode)
        self.until(MODE_ACTIVE, 0xFF, mode & 0xFF)


@contextmanager
def line(keys="", tcp=False):
    """A bench with three families and a connected master on it."""
    with bench(DRIVES.format(keys=keys), tcp) as served:
        limits = dict(framer=FramerType.RTU, timeout=0.7, retries=0)
        if tcp:
            host, port = served.port.removeprefix("tcp://").split(":")
            client = ModbusTcpClient(host, port=int(port), **limits)
        else:
            client = ModbusSerialClient(served.port, baudrate=19_200, parity="N", stopbits=2, **limits)
        with client:
            expect("connected", client.connected, True)
            yield Master(client), served


LINES = {"RTU": (False,), "RTU over TCP": (True,)}


@case("{}: code 3 reads one parameter, and neighbours in one telegram", each=LINES)
def _(tcp):
    with line("set = { FLT_err_num = 0x2300, FLT_class = 2, FLT_Time = 77, FLT_Qual = 5 }", tcp) as (master, _):
        expect("DCOMstatus", master.read(STATUS) & 0x6F, 0x40)
        expect("fault memory", master.read(FAULT, 4), [0x2300, 2, 77, 5])


@case("{}: code 16 writes one parameter, and neighbours in one telegram", each=LINES)
def _(tcp):
    with line("", tcp) as (master, served):
        master.write(TARGET, -123_456)
        expect("PPp_targetusr", master.read(TARGET), -123_456)
        master.write(LIMIT_P, 2**31 - 1, -(2**31))
        expect("SPVswLimPusr, SPVswLimNusr", master.read(LIMIT_P, 2), [2**31 - 1, -(2**31)])
    expect("answered", served.counts["answered"], 4)


@case("{}: code 23 writes and reads back in one exchange", each=LINES)
def _(tcp):
    with line("", tcp) as (master, _):
        expect("RAMPacc", master.exchange(RAMP_ACC, RAMP_ACC, 2_000), 2_000)
        expect("DCOMstatus after shut down", master.exchange(STATUS, CONTROL, 0x06) & 0x6F, 0x21)


@case("{}: code 43 tells vendor, product and revision", each=LINES)
def _(tcp):
    with line("", tcp) as (master, _):
        told = master.ask("read_device_information", read_code=1, object_id=0)
        expect("objects", told.information, {0: b"antrieb bench", 1: b"LXM05-SIM", 3: b"V02.001"})
        expect("conformity, more", (told.conformity, told.more_follows), (2, 0))


@case("code 43 in pieces: more follows, and where to go on")
def _():
    with line("servo = { in_pieces = true, revision_object = 2 }") as (master, _):
        objects, following = {}, 0
        while True:
            told = master.ask("read_device_information", read_code=1, object_id=following)
            expect("objects in one telegram", len(told.information), 1)
            objects |= told.information
            if not told.more_follows:
                break
            following = told.next_object_id
        expect("objects", objects, {0: b"antrieb bench", 1: b"LXM05-SIM", 2: b"V02.001"})


@case("code 8 echoes, counts, clears, and tells the last synchronous error")
def _():
    with line() as (master, _):
        expect("echo", master.ask("diag_query_data", b"\xa5\x37").message, b"\xa5\x37")
        master.ask("diag_clear_counters")
        expect_refused(2, lambda: master.read(0))
        expect("synchronous error", master.ask("diag_read_diagnostic_register").message, 2)
        asked = 2  # a question for a counter is counted before it is answered
        for name, wanted in (
            ("comm_error_count", 0),
            ("exception_error_count", 1),
            ("char_overrun_count", 0),
        ):
            asked += 1
            expect(name, master.ask(f"diag_read_bus_{name}").message, wanted)
        for name in ("nak", "busy"):
            asked += 1
            expect(name, master.ask(f"diag_read_device_{name}_count").message, 0)
        expect("messages", master.ask("diag_read_bus_message_count").message, asked + 1)


@case("code 8 silences the drive and wakes it again")
def _():
    with line() as (master, _):
        master.ask("diag_force_listen_only")
        time.sleep(0.5)
        try:
            raise Failed(f"expected silence, got {master.read(STATUS)}")
        except ModbusIOException:
            pass
        try:
            raise Failed(f"expected no answer, got {master.ask('diag_restart_communication', True)}")
        except ModbusIOException:
            pass
        expect("DCOMstatus", master.read(STATUS) & 0x6F, 0x40)


@case("exceptions 1 to 4")
def _():
    with line() as (master, served):
        expect_refused(1, lambda: master.ask("read_coils", 0))
        expect_refused(2, lambda: master.read(POSITION + 1))
        expect_refused(2, lambda: master.read(POSITION, 2))
        expect_refused(3, lambda: master.ask("read_holding_registers", POSITION, count=1))
        expect_refused(3, lambda: master.write(NODE_GUARD, 10_001))
        expect_refused(4, lambda: master.write(STATUS, 0))
    expect("exceptions", served.counts["exceptions"], 6)


@case("a refusal of code 43 carries the type")
def _():
    with bench(DRIVES.format(keys="")) as served:
        with serial.Serial(served.port, 19_200, stopbits=2, timeout=0.5) as port:
            # Category 2; CRC by pymodbus.
            body = bytes([LXM, 0x2B, 0x0E, 0x02, 0x00])
            port.write(body + crc(body))
            refusal = bytes([LXM, 0xAB, 0x0E, 0x03])
            expect("bytes", port.read(16), refusal + crc(refusal))


def crc(body):
    return FramerRTU.compute_CRC(body).to_bytes(2, "big")


@case("low word first, after power-on")
def _():
    with line("set = { MBdword_order = 1 }") as (master, _):
        words = registers([0x0001_0203], "<")
        master.ask("write_registers", TARGET, words)
        expect("registers", master.ask("read_holding_registers", TARGET, count=2).registers, [0x0203, 0x0001])


@case("the sequence of 5.4.1: to a position, until bit 10")
def _():
    with line() as (master, served):
        for address, value in ((RAMP_ACC, 2_000), (RAMP_DEC, 4_000), (SPEED_LIMIT, 6_000), (TARGET_SPEED, 4_000)):
            master.write(address, value)
        master.enable(1)
        master.write(TARGET, 0x30)
        master.write(CONTROL, 0x5F)
        master.until(STATUS, 0x0400, 0x0400)
        master.write(CONTROL, 0x0F)
        expect("position", master.read(POSITION), 0x30)
        master.write(CONTROL, 0x00)
    expect("energised", served.counts["energised"], 0)


@case("the sequence of 5.4.2: 1000 1/min and back to 0")
def _():
    with line() as (master, served):
        for address, value in ((RAMP_ACC, 2_000), (RAMP_DEC, 10_000), (SPEED_LIMIT, 10_000)):
            master.write(address, value)
        master.enable(3)
        for speed in (1_000, 0):
            before = master.read(POSITION)
            master.write(VELOCITY, speed)
            master.until(STATUS, 0x0400, 0x0400)
            expect("turned", master.read(POSITION) > before, True)
        master.write(CONTROL, 0x00)
    expect("turning", served.counts["turning"], 0)


@case("a master that is gone: node guard, error, reset")
def _():
    with line() as (master, _):
        master.write(RAMP_ACC, 20_000)
        master.write(NODE_GUARD, 300)
        master.enable(3)
        master.write(VELOCITY, 500)
        time.sleep(1)
        expect("DCOMstatus", master.read(STATUS) & 0x6F, 0x08)
        expect("class", master.read(FAULT + 2), 1)
        master.write(CONTROL, 0x80)
        expect("DCOMstatus after reset", master.read(STATUS) & 0x6F, 0x40)


@case("a broadcast is obeyed, and nobody answers")
def _():
    with line() as (master, _):
        master.ask("write_registers", CONTROL, registers([0x06]), device_id=EVERYBODY, no_response_expected=True)
        time.sleep(TURNAROUND_S)
        expect("DCOMstatus", master.read(STATUS) & 0x6F, 0x21)


@case("three families on one bus")
def _():
    with line() as (master, served):
        for _ in range(3):
            expect("LXM05", master.read(STATUS) & 0x6F, 0x40)
            for station in (ACT, ACU):
                reply = master.ask("read_holding_registers", 0x2174, count=1, device_id=station)
                expect(f"P.372@2 of {station}", reply.registers, [1_390])
                wrong = lambda station=station: master.ask("write_registers", CONTROL, [0, 6], device_id=station)  # noqa: E731
                expect_refused(1, wrong)
    expect("answered, exceptions", (served.counts["answered"], served.counts["exceptions"]), (15, 6))
