"""The masters beside ours, one class each: a line is opened, registers are read one by one, the line is closed.

Each is used as its documentation shows first: a failed read raises `Missed`, and what it does about the telegrams that
may still come is its own business.
"""

import ctypes
import ctypes.util
import logging
import shutil
import subprocess
import sys
from pathlib import Path

import minimalmodbus
import serial
from pymodbus.client import ModbusSerialClient
from pymodbus.exceptions import ModbusException
from pymodbus.framer import FramerType

# It warns of every telegram that was not expected.
logging.getLogger("pymodbus").setLevel(logging.CRITICAL)


class Missed(Exception):
    """No value came."""


class Minimalmodbus:
    """minimalmodbus; its own time-out is 50 ms."""

    name = "minimalmodbus"
    protocols = ("rtu", "ascii")
    own_timeout_s = 0.05

    def __init__(self, port, setting, timeout_s=None):
        line = serial.Serial(port, setting.baud, stopbits=2, timeout=timeout_s or self.own_timeout_s)
        self.instrument = minimalmodbus.Instrument(line, 1, mode=setting.protocol)

    def read(self, register, station=1):
        self.instrument.address = station
        try:
            return self.instrument.read_register(register)
        except (minimalmodbus.ModbusException, serial.SerialException, ValueError) as error:
            raise Missed(str(error)) from error

    def close(self):
        self.instrument.serial.close()


class Pymodbus:
    """pymodbus, synchronous; its own time-out is 3 s, and it repeats three times."""

    name = "pymodbus"
    protocols = ("rtu", "ascii")
    own_timeout_s = 3.0

    def __init__(self, port, setting, timeout_s=None):
        framer = FramerType[setting.protocol.upper()]
        line = {"baudrate": setting.baud, "bytesize": 8, "parity": "N", "stopbits": 2}
        self.client = ModbusSerialClient(port, framer=framer, timeout=timeout_s or self.own_timeout_s, **line)
        self.client.connect()

    def read(self, register, station=1):
        try:
            reply = self.client.read_holding_registers(register, count=1, device_id=station)
        except ModbusException as error:
            raise Missed(str(error)) from error
        if reply.isError():
            raise Missed(str(reply))
        return reply.registers[0]

    def close(self):
        self.client.close()


class Libmodbus:
    """libmodbus, which mbpoll is made of; its own time-out is 500 ms. Knows no ASCII."""

    name = "libmodbus"
    protocols = ("rtu",)
    own_timeout_s = 0.5
    path = ctypes.util.find_library("modbus") or "libmodbus.so.5"

    def __init__(self, port, setting, timeout_s=None):
        self.library = ctypes.CDLL(self.path, use_errno=True)
        self.library.modbus_new_rtu.restype = ctypes.c_void_p
        arguments = [port.encode(), setting.baud, ctypes.c_char(b"N"), 8, 2]
        self.context = ctypes.c_void_p(self.library.modbus_new_rtu(*arguments))
        timeout_us = round((timeout_s or self.own_timeout_s) * 1e6)
        self.library.modbus_set_response_timeout(self.context, timeout_us // 1_000_000, timeout_us % 1_000_000)
        self.value = ctypes.c_uint16()
        if self.library.modbus_connect(self.context) != 0:
            raise OSError(ctypes.get_errno(), f"libmodbus cannot open {port}")

    def read(self, register, station=1):
        self.library.modbus_set_slave(self.context, station)
        if self.library.modbus_read_registers(self.context, register, 1, ctypes.byref(self.value)) != 1:
            raise Missed(f"libmodbus: error {ctypes.get_errno()}")
        return self.value.value

    def close(self):
        self.library.modbus_close(self.context)
        self.library.modbus_free(self.context)


class TokioModbus:
    """tokio-modbus, by benches/beside, which is asked over pipes; it has no time-out of its own. Knows no ASCII."""

    name = "tokio-modbus"
    protocols = ("rtu",)
    own_timeout_s = 0.5
    path = Path(__file__).resolve().parents[1] / "target/beside/release/tokio_modbus"

    def __init__(self, port, setting, timeout_s=None):
        words = [str(self.path), port, str(setting.baud), str(round((timeout_s or self.own_timeout_s) * 1_000))]
        self.program = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def read(self, register, station=1):
        self.program.stdin.write(f"{station} {register}\n")
        said = self.program.stdout.readline().strip()
        if not said.isdigit():
            raise Missed(said)
        return int(said)

    def close(self):
        self.program.stdin.close()
        self.program.wait()


MASTERS = [Minimalmodbus, Pymodbus, Libmodbus]
if TokioModbus.path.is_file():
    MASTERS.append(TokioModbus)


def one_shot(port, setting, register):
    """Whole programs that read one register and print it, by name: as short as each library lets them be."""
    values = {"port": port, "baud": setting.baud, "register": register}
    scripts = {
        "minimalmodbus": (
            "import minimalmodbus, serial\n"
            "line = serial.Serial({port!r}, {baud}, stopbits=2, timeout=0.5)\n"
            "print(minimalmodbus.Instrument(line, 1).read_register({register}))"
        ),
        "pymodbus": (
            "from pymodbus.client import ModbusSerialClient\n"
            "client = ModbusSerialClient({port!r}, baudrate={baud}, stopbits=2)\n"
            "client.connect()\n"
            "print(client.read_holding_registers({register}, count=1, device_id=1).registers[0])"
        ),
    }
    programs = {name: [sys.executable, "-c", script.format(**values)] for name, script in scripts.items()}
    if shutil.which("mbpoll"):
        line = ["-m", "rtu", "-b", str(setting.baud), "-P", "none", "-s", "2"]
        programs["mbpoll"] = ["mbpoll", *line, "-a", "1", "-0", "-r", str(register), "-1", port]
    if TokioModbus in MASTERS:
        programs[TokioModbus.name] = [str(TokioModbus.path), port, str(setting.baud), "500", "1", str(register)]
    return programs
