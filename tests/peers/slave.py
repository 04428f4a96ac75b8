"""A pymodbus server as a process of its own: a station that answers our master.

    slave.py PORT rtu|ascii stock|refusing|speaking

`stock` is pymodbus as it comes: codes 3, 4, 6 and 8, and what it makes of codes that it does not know. `refusing` answers
codes 100 and 101 with exception 1, as the norm wants it of any slave. `speaking` knows both, as custom codes.
Says "ready" on stdout, and ends on SIGTERM.
"""

import asyncio
import sys

from pymodbus.constants import ExcCodes
from pymodbus.framer import FramerType
from pymodbus.pdu import ExceptionResponse
from pymodbus.server import ModbusSerialServer
from pymodbus.simulator import DataType, SimData, SimDevice

from vendor_codes import ReadLongReply, ReadLongRequest, WriteLong, address_word

STATION = 7
BAUD = 19_200

# Address word -> value; every other register is exception 2.
WORDS = {
    address_word(11): 0,  # error register
    address_word(250): 0,  # digital inputs
    address_word(260): 0,  # fault
    address_word(270): 0,  # warnings
    address_word(411): 0x0023,  # status word
    address_word(412): 0,  # control mode
    address_word(412, 5): 0,  # the one in force: RAM
    address_word(413): 0,  # watchdog
    address_word(413, 5): 0,
    **{address_word(372, data_set): 1_300 + 10 * data_set for data_set in (1, 2, 3, 4)},
    **{address_word(376, data_set): 8 for data_set in (1, 2, 3, 4)},
}
# What the meters of tests/maps have in their registers; codes 3 and 4 read alike here.
METER = {
    # Floats: 50.02 Hz, 12345.678 kWh.
    **{70: 0x4248, 71: 0x147B, 72: 0x4640, 73: 0xE6B6},
    # The lower half first: 230.4 V, 100 A, -0.95, 50 Hz, 12345.6 kWh.
    **{0: 2304, 1: 0, 12: 0x86A0, 13: 1, 49: 0xFC4A, 51: 500, 52: 0xE240, 53: 1},
    # The upper half first: 400.12 V, 50.02 Hz, 100 A, -1234.56 W, 777, 3.5 %.
    **{50514: 0, 50515: 40012, 50526: 0, 50527: 5002, 50528: 1, 50529: 0x86A0, 50536: 0xFFFE, 50537: 0x1DC0},
    **{50780: 0, 50781: 777, 51539: 35},
}
LONGS = {address_word(480): 500, address_word(481): 1_000}


class RefuseRead(ReadLongRequest):
    async def datastore_update(self, context, device_id):
        return ExceptionResponse(self.function_code, ExcCodes.ILLEGAL_FUNCTION)


class RefuseWrite(WriteLong):
    async def datastore_update(self, context, device_id):
        return ExceptionResponse(self.function_code, ExcCodes.ILLEGAL_FUNCTION)


class Read(ReadLongRequest):
    async def datastore_update(self, context, device_id):
        if self.address not in LONGS:
            return ExceptionResponse(self.function_code, ExcCodes.DEVICE_FAILURE)
        reply = ReadLongReply(dev_id=device_id)
        reply.value = LONGS[self.address]
        return reply


class Write(WriteLong):
    async def datastore_update(self, context, device_id):
        if self.address not in LONGS:
            return ExceptionResponse(self.function_code, ExcCodes.DEVICE_FAILURE)
        LONGS[self.address] = self.value
        return self


CODES = {"stock": [], "refusing": [RefuseRead, RefuseWrite], "speaking": [Read, Write]}


def only_for(station):
    """pymodbus 3.16.1 answers for every station; on a line with several addresses a slave hears only its own."""
    return lambda sending, telegram: telegram if sending or telegram.dev_id == station else None


async def serve(port, framer, codes):
    registers = [SimData(word, values=[value], datatype=DataType.REGISTERS) for word, value in sorted({**WORDS, **METER}.items())]
    server = ModbusSerialServer(
        SimDevice(STATION, registers),
        framer=framer,
        port=port,
        baudrate=BAUD,
        parity="N",  # pyserial cannot ask a pseudo terminal for more (docs/measured.md)
        stopbits=2,
        custom_pdu=codes,
        trace_pdu=only_for(STATION),
    )
    await server.serve_forever(background=True)
    print("ready", flush=True)
    await server.serving


if __name__ == "__main__":
    asyncio.run(serve(sys.argv[1], FramerType(sys.argv[2]), CODES[sys.argv[3]]))
