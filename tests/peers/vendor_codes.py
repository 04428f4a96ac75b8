"""Codes 100 and 101 of the ACTIVE family for pymodbus: read and write 32 bits (CM-485 manual 6.4.3, 6.4.4).

Written from the manual, with pymodbus' own classes for custom codes; nothing of our codec is in it.
"""

import struct

from pymodbus.pdu import ModbusPDU

STATION_AND_CODE, CHECK = 2, 2


def address_word(param, data_set=0):
    """4 bits of data set, 12 bits of parameter number (CM-485 manual 6.4)."""
    return data_set << 12 | param


class ReadLongRequest(ModbusPDU):
    """Code 100, from the master: the address word."""

    function_code = 100
    rtu_frame_size = STATION_AND_CODE + 2 + CHECK

    def encode(self):
        return struct.pack(">H", self.address)

    def decode(self, data):
        (self.address,) = struct.unpack(">H", data)


class ReadLongReply(ModbusPDU):
    """Code 100, from the drive: the value, high word first."""

    function_code = 100
    rtu_frame_size = STATION_AND_CODE + 4 + CHECK
    value = 0

    def encode(self):
        return struct.pack(">i", self.value)

    def decode(self, data):
        (self.value,) = struct.unpack(">i", data)


class WriteLong(ModbusPDU):
    """Code 101, both ways: address word and value; the reply is the echo."""

    function_code = 101
    rtu_frame_size = STATION_AND_CODE + 2 + 4 + CHECK
    value = 0

    def encode(self):
        return struct.pack(">Hi", self.address, self.value)

    def decode(self, data):
        self.address, self.value = struct.unpack(">Hi", data)
