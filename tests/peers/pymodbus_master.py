"""pymodbus' synchronous client as master: RTU and ASCII on the pty, RTU over raw TCP, 100 and 101 as custom codes.

pyserial cannot ask a pseudo terminal for parity or 7 bits (docs/measured.md), so these drives are set to 8N.
"""

import logging
import time
from contextlib import contextmanager

from pymodbus.client import ModbusSerialClient, ModbusTcpClient
from pymodbus.exceptions import ModbusIOException
from pymodbus.framer import FramerType
from pymodbus.pdu.diag_message import ReturnBusMessageCountRequest

from harness import Failed, bench, expect, group
from refusal import Refused, expect_refused
from vendor_codes import ReadLongReply, ReadLongRequest, WriteLong, address_word

case = group("pymodbus master")
# It warns of the silence that some cases ask for.
logging.getLogger("pymodbus").setLevel(logging.CRITICAL)

ACT, ACU, EVERYBODY = 1, 2, 0

DRIVES = "".join(
    f"""
[[drive]]
model = "{model}"
address = {address}
protocol = "{{protocol}}"
parity = "none"
data_bits = 8
"""
    for model, address in (("act", ACT), ("acu", ACU))
)

# Between a broadcast and the next telegram (MODBUS over Serial Line V1.02, 2.4.1: 100 to 200 ms).
TURNAROUND_S = 0.15
# pymodbus keeps no silence between a reply and its next request; a drive needs t3.5, and 2 ms (CM-485 manual 6.8).
PAUSE_S = 0.005


class Master:
    """A pymodbus client that speaks in parameters and data sets. Every method returns a value or raises `Refused`."""

    def __init__(self, client):
        self.client = client
        client.register(ReadLongReply)
        client.register(WriteLong)

    def ask(self, request, **how):
        time.sleep(PAUSE_S)
        return self.check(self.client.execute(how.get("no_response_expected", False), request))

    @staticmethod
    def check(reply):
        if reply is not None and reply.isError():
            raise Refused(reply.exception_code)
        return reply

    def read(self, station, param, data_set=0, count=1):
        time.sleep(PAUSE_S)
        reply = self.client.read_holding_registers(address_word(param, data_set), count=count, device_id=station)
        return self.check(reply).registers[0]

    def write(self, station, param, value, data_set=0):
        time.sleep(PAUSE_S)
        self.check(self.client.write_register(address_word(param, data_set), value, device_id=station))

    def read_long(self, station, param, data_set=0):
        return self.ask(ReadLongRequest(dev_id=station, address=address_word(param, data_set))).value

    def write_long(self, station, param, value, data_set=0):
        request = WriteLong(dev_id=station, address=address_word(param, data_set))
        request.value = value
        echo = self.ask(request)
        expect("echo", (echo.address, echo.value), (request.address, value))

    def broadcast(self, param, value, data_set=0):
        time.sleep(PAUSE_S)
        word = address_word(param, data_set)
        self.client.write_register(word, value, device_id=EVERYBODY, no_response_expected=True)
        time.sleep(TURNAROUND_S)

    def counter(self, name):
        """Code 8: one of pymodbus' `diag_…` questions."""
        time.sleep(PAUSE_S)
        return self.check(getattr(self.client, f"diag_{name}")(device_id=ACT)).message


def expect_silence(ask):
    try:
        came = ask()
    except ModbusIOException:
        return
    raise Failed(f"expected silence, got {came!r}")


@contextmanager
def line(framing):
    """A bench and a connected master on it."""
    tcp = framing == "RTU over TCP"
    framer = FramerType.ASCII if framing == "ASCII" else FramerType.RTU
    with bench(DRIVES.format(protocol=framer.value), tcp) as served:
        limits = dict(framer=framer, timeout=0.7, retries=0)
        if tcp:
            host, port = served.port.removeprefix("tcp://").split(":")
            client = ModbusTcpClient(host, port=int(port), **limits)
        else:
            client = ModbusSerialClient(served.port, baudrate=19_200, parity="N", stopbits=2, **limits)
        with client:
            expect("connected", client.connected, True)
            yield Master(client), served


def lines(*framings):
    return {framing: (framing,) for framing in framings}


EVERY_LINE = lines("RTU", "ASCII", "RTU over TCP")
SERIAL_LINES = lines("RTU", "ASCII")


@case("{}: code 3 reads words, every data set and its RAM copy", each=EVERY_LINE)
def _(framing):
    with line(framing) as (master, _):
        for data_set in (1, 2, 3, 4, 6, 7, 8, 9):
            expect(f"P.372@{data_set}", master.read(ACU, 372, data_set), 1_390)
        expect("P.411 of the ACT", master.read(ACT, 411), 0x0023)
        expect("P.411 of the ACU", master.read(ACU, 411), 0x0033)


@case("{}: code 6 writes a word", each=EVERY_LINE)
def _(framing):
    with line(framing) as (master, served):
        others = master.read(ACU, 376, 4), master.read(ACT, 376, 3)
        master.write(ACT, 376, 22, data_set=4)
        expect("read back", master.read(ACT, 376, 4), 22)
        expect("the other drive, the other set", (master.read(ACU, 376, 4), master.read(ACT, 376, 3)), others)
    expect("EEPROM writes", served.counts["eeprom_writes"], 1)


@case("{}: its own codes 100 and 101 read and write a long", each=EVERY_LINE)
def _(framing):
    with line(framing) as (master, _):
        expect("P.481", master.read_long(ACT, 481), 1_000)
        for value in (-12_000, 99_900, 0):
            master.write_long(ACT, 480, value, data_set=2)
            expect("P.480@2", master.read_long(ACT, 480, 2), value)


@case("{}: exceptions 1 to 4, and the cause of 4 in P.11, once", each=EVERY_LINE)
def _(framing):
    with line(framing) as (master, served):
        expect_refused(1, lambda: master.check(master.client.read_coils(0, device_id=ACT)))
        expect_refused(2, lambda: master.read(ACT, 372, 2, count=2))
        expect_refused(3, lambda: master.ask(ReturnBusMessageCountRequest(1, dev_id=ACT)))
        for ask, cause in (
            (lambda: master.read(ACT, 1_600, 2), 11),
            (lambda: master.write(ACT, 376, 0, data_set=2), 1),
            (lambda: master.write_long(ACT, 375, 900, data_set=2), 1),
            (lambda: master.write(ACT, 411, 1), 4),
            (lambda: master.read_long(ACT, 372, 2), 14),
        ):
            expect_refused(4, ask)
            expect("P.11", master.read(ACT, 11), cause)
            expect("P.11, read again", master.read(ACT, 11), 0)
    expect("exceptions", served.counts["exceptions"], 8)


@case("{}: code 8 counts, and clears", each=SERIAL_LINES)
def _(framing):
    with line(framing) as (master, _):
        master.read(ACT, 411)
        master.counter("clear_counters")
        master.read(ACT, 411)
        master.read(ACU, 411)
        expect_refused(2, lambda: master.read(ACT, 372, 2, count=2))
        master.broadcast(376, 22, data_set=4)
        asked = 2

        def counter(name):
            nonlocal asked  # a question for a counter is counted before it is answered
            asked += 1
            return master.counter(name)

        expect("0x0C transmission errors", counter("read_bus_comm_error_count"), 0)
        expect("0x0D exceptions", counter("read_bus_exception_error_count"), 1)
        expect("0x0E messages to this drive", counter("read_device_message_count"), asked)
        expect("0x0F broadcasts", counter("read_device_no_response_count"), 1)
        expect("0x10 negative acknowledgements", counter("read_device_nak_count"), 0)
        expect("0x11 busy", counter("read_device_busy_count"), 0)
        expect("0x12 overruns", counter("read_bus_char_overrun_count"), 0)
        # Its own, the broadcast, and the ACU's request and reply.
        expect("0x0B messages on the bus", counter("read_bus_message_count"), asked + 3)
        expect_refused(1, lambda: master.counter("read_iop_overrun_count"))


@case("{}: everybody obeys a broadcast, and nobody answers", each=SERIAL_LINES)
def _(framing):
    with line(framing) as (master, served):
        master.broadcast(376, 22, data_set=4)
        expect("bytes on the line", master.client.socket.in_waiting, 0)
        expect("ACT", master.read(ACT, 376, 4), 22)
        expect("ACU", master.read(ACU, 376, 4), 22)
    expect("answered", served.counts["answered"], 2)


@case("{}: silence at an address that nobody has", each=SERIAL_LINES)
def _(framing):
    with line(framing) as (master, _):
        expect_silence(lambda: master.read(3, 372, 2))
        expect("the next question", master.read(ACT, 372, 2), 1_390)


@case("a client that comes again finds the drives as it left them")
def _():
    with line("RTU") as (master, served):
        master.write(ACT, 376, 22, data_set=9)
        master.client.close()
        time.sleep(0.1)
        expect("connected again", master.client.connect(), True)
        expect("RAM", master.read(ACT, 376, 9), 22)
    expect("clients", served.counts["clients"], 2)
