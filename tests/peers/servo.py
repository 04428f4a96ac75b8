"""A pymodbus server as a process of its own: a station that looks like an LXM05 to our master.

    servo.py PORT|- rtu|socket high|low [without-23]

Answers on a tty, or on a TCP port of its own choice (`-`) in frames of RTU or of Modbus/TCP. Two registers per
parameter, the upper or the lower half first. `without-23` refuses code 23 with exception 1, as a device that does not have it.
Says "ready" on stdout, with ` on PORT` for TCP, and then "asked CODE DATA" for every request; ends on SIGTERM.

Addresses are those of the LXM05 manual. Its revision is object 2, as in the norm (facts G4).
"""

import asyncio
import struct
import sys

from pymodbus.constants import ExcCodes
from pymodbus.framer import FramerType
from pymodbus.pdu import ExceptionResponse
from pymodbus.pdu.device import ModbusDeviceIdentification
from pymodbus.pdu.register_message import ReadWriteMultipleRegistersRequest
from pymodbus.server import ModbusSerialServer, ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

STATION = 5
BAUD = 19_200

VENDOR, PRODUCT, REVISION = "pymodbus", "LXM05AD10M2", "V02.001"

ADDRESS = 5640  # MBadr, which proves the word order in force
RAMP_ACC, NODE_GUARD, WORD_ORDER, STATUS, TARGET, POSITION, FAULT = 1556, 5644, 5646, 6916, 6940, 7700, 15362
GUARD_LIMIT_MS = 10_000

# Address -> value; every other register is exception 2.
VALUES = {
    RAMP_ACC: 600,
    1558: 700,  # RAMPdecel
    5638: 19_200,  # MBbaud
    ADDRESS: STATION,
    5642: 4,  # MBformat: 8N2
    NODE_GUARD: 0,
    STATUS: 0x40,
    TARGET: 0,
    POSITION: -123_456,
    FAULT: 0x2300,
    FAULT + 2: 2,  # FLT_class
    FAULT + 4: 77,  # FLT_Time
    FAULT + 6: 5,  # FLT_Qual
}
READ_ONLY = {STATUS, POSITION, FAULT}


def registers(value, order):
    """The two registers of a value; `low` has the lower half first."""
    high, low = struct.unpack(">HH", struct.pack(">i", value))
    return [high, low] if order == "high" else [low, high]


def refuse(order):
    """What a drive refuses besides unknown addresses: a node guard that is out of range (LXM05 manual 4.1)."""

    async def action(_code, _start, address, _count, _registers, values):
        if values is None or address != NODE_GUARD:
            return None
        high, low = values if order == "high" else values[::-1]
        return ExcCodes.ILLEGAL_VALUE if high << 16 | low > GUARD_LIMIT_MS else None

    return action


class Refuse23(ReadWriteMultipleRegistersRequest):
    async def datastore_update(self, context, device_id):
        return ExceptionResponse(self.function_code, ExcCodes.ILLEGAL_FUNCTION)


def listen(sending, telegram):
    """Tells what was asked. pymodbus 3.16.1 answers for every station; on a line a slave hears only its own."""
    if sending:
        return telegram
    if telegram.dev_id != STATION:
        return None
    print("asked", telegram.function_code, telegram.encode().hex(), flush=True)
    return telegram


async def serve(port, framer, order, without):
    held = {**VALUES, WORD_ORDER: int(order == "low")}
    rows = [
        SimData(address, values=registers(value, order), datatype=DataType.REGISTERS, readonly=address in READ_ONLY)
        for address, value in sorted(held.items())
    ]
    device = SimDevice(STATION, rows, action=refuse(order))
    about = dict(
        framer=framer,
        identity=ModbusDeviceIdentification(info={0: VENDOR, 1: PRODUCT, 2: REVISION}),
        custom_pdu=[Refuse23] if without == ["without-23"] else [],
        trace_pdu=listen,
    )
    if port == "-":
        server = ModbusTcpServer(device, address=("127.0.0.1", 0), **about)
    else:
        # pyserial cannot ask a pseudo terminal for more than 8N2 (docs/measured.md).
        server = ModbusSerialServer(device, port=port, baudrate=BAUD, parity="N", stopbits=2, **about)
    await server.serve_forever(background=True)
    place = f" on {server.transport.sockets[0].getsockname()[1]}" if port == "-" else ""
    print(f"ready{place}", flush=True)
    await server.serving


if __name__ == "__main__":
    asyncio.run(serve(sys.argv[1], FramerType(sys.argv[2]), sys.argv[3], sys.argv[4:]))
