"""A PROFIBUS-DP master that we did not write: pyprofibus leads one SJ2-PB (PPO1) to Data_Exchange, takes the right to control over PKW,
runs the motor and stops it. A process of its own, without a GSD.

    pyprofibus_master.py PORT BAUD ADDRESS IDENT     prints what came as one line of JSON
"""

import json
import struct
import sys
import time
from types import SimpleNamespace

from pyprofibus.dp import DpCfgDataElement
from pyprofibus.dp_master import DPM1, DpSlaveDesc
from pyprofibus.phy_serial import CpPhySerial

MASTER = 2
PATIENCE_S = 20
# SJ2-PB manual 4.1.1: a new word; 4.1.2.1: OFF1, ready, run; 5.1: P.928.
WRITE, RIGHT = 2, 928
OFF1, READY, RUN = 0x047E, 0x0406, 0x047F
HALF = 0x2000


class Drive:
    """PKW, STW and HSW out; PKW, ZSW and HIW in."""

    def __init__(self, port, baud, address, ident):
        phy = CpPhySerial(port)
        phy.setConfig(baudrate=baud)
        self.master = DPM1(phy, MASTER)
        conf = SimpleNamespace(gsd=None, addr=address, name="sj2-pb", index=None, inputSize=12, outputSize=12, diagPeriod=0)
        self.slave = DpSlaveDesc(conf)
        self.slave.setPrmTelegram.identNumber = ident
        self.slave.setCfgDataElements([DpCfgDataElement(0xF3), DpCfgDataElement(0xF1)])
        self.slave.setWatchdog(1000)
        self.master.addSlave(self.slave)
        self.master.initialize()
        self.pkw, self.words, self.exchanges = bytes(8), (OFF1, 0), 0

    def until(self, what, is_so):
        """Exchanges data until the inputs are as wanted."""
        deadline = time.monotonic() + PATIENCE_S
        while time.monotonic() < deadline:
            self.slave.setMasterOutData(bytearray(self.pkw + struct.pack(">2H", *self.words)))
            self.master.run()
            came = self.slave.getMasterInData()
            if came is None:
                continue
            self.exchanges += 1
            pke, _, _, zsw, hiw = struct.unpack(">2Hl2H", came)
            if is_so(pke, zsw, hiw):
                return pke, zsw, hiw
        sys.exit(f"{what}: not within {PATIENCE_S} s")

    def write(self, number, value):
        """A request behind an empty channel."""
        self.pkw = bytes(8)
        self.until("an empty channel", lambda pke, *_: pke >> 12 == 0)
        self.pkw = struct.pack(">2HL", WRITE << 12 | number, 0, value)
        pke, _, _ = self.until("an answer", lambda pke, *_: pke & 0x07FF == number)
        self.pkw = bytes(8)
        return pke >> 12


def main(port, baud, address, ident):
    drive = Drive(port, int(baud), int(address), int(ident, 16))
    drive.until("Data_Exchange", lambda *_: True)
    answered = drive.write(RIGHT, 1)
    drive.words = (READY, 0)
    _, ready, _ = drive.until("ready", lambda _, zsw, __: zsw & 0x0231 == 0x0231)
    drive.words = (RUN, HALF)
    _, running, fastest = drive.until("half of A004", lambda _, zsw, hiw: zsw & 0x0007 == 7 and hiw >= HALF - 16)
    drive.words = (OFF1, 0)
    _, _, standing = drive.until("standstill", lambda _, __, hiw: hiw == 0)
    print(json.dumps({
        "answered": answered, "ready": ready, "running": running, "fastest": fastest, "standing": standing,
        "exchanges": drive.exchanges,
    }))


if __name__ == "__main__":
    main(*sys.argv[1:])
