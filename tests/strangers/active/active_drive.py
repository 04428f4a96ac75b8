#!/usr/bin/env python3
"""An independent Bonfiglioli ACT / ACU drive on a pseudo terminal, written from the manuals alone.

Modbus RTU, Modbus ASCII (function codes 3, 6, 8, 16 = unknown, 100, 101) and VABus, in real time, with a
physical model of motor and state machine. Where the manual is silent the drive is strict: it
answers, but it keeps a list of the *sins* of its master. Everything that the manual leaves open is a
command-line option (a *reading*), and so is everything a bad line may do (a *disturbance*).

Alone:      python3 active_drive.py --family acu --baud 19200 --for 60
In a test:  with DriveServer(options("--late 300")) as drive: ... drive.path ... drive.sins

Chapters named in comments are those of the manual "Modbus-Kommunikation mit CM-232/CM-485"
(VEC 383) unless another source is named. Python 3 standard library only.
"""

import argparse
import fcntl
import heapq
import itertools
import json
import os
import pty
import random
import select
import struct
import sys
import termios
import threading
import time
import tty

# ---------------------------------------------------------------------------------------------
# Options: readings and disturbances
# ---------------------------------------------------------------------------------------------


def parser():
    """All options of the drive: what it is, how the manual is read, what the line does."""
    p = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    g = p.add_argument_group("the drive")
    g.add_argument("--family", choices=["act", "acu"], default="act")
    g.add_argument("--protocol", choices=["rtu", "ascii", "vabus"], default="rtu")
    g.add_argument("--address", type=int, default=1, help="P.1376 (Modbus) or P.394 (VABus)")
    g.add_argument("--baud", type=int, default=19200)
    g.add_argument("--parity", choices=["even", "odd", "none"], default="even")
    g.add_argument("--set", action="append", default=[], metavar="NUMBER[@SET]=RAW", help="EEPROM value at start")
    g.add_argument("--no-enable", action="store_true", help="external enable (STO) is off")
    g.add_argument("--no-start", action="store_true", help="neither S2IND nor S3IND is on")
    g.add_argument("--no-mains", action="store_true", help="ACU on external 24 V: status bit 4 is 0")
    g.add_argument("--internal", type=float, default=0.0, metavar="HZ", help="P.228, the internal setpoint")
    g.add_argument("--left", type=float, default=0.0, metavar="HZ", help="P.484 left behind by somebody before")
    g.add_argument("--word", type=lambda s: int(s, 0), default=0, help="control word left behind (P.410)")
    g.add_argument("--running", action="store_true", help="already enabled and at its setpoint at start")
    g.add_argument("--fault", type=lambda s: int(s, 0), default=0, help="fault key standing at start (P.260)")
    g.add_argument("--fault-age", type=float, default=0.0, metavar="S", help="so long ago did that fault come")
    g.add_argument("--warning", type=lambda s: int(s, 0), default=0, help="P.270")
    g.add_argument("--coast", type=float, default=8.0, metavar="HZ/S", help="how fast a coasting shaft gets slower")
    g.add_argument("--stiff", action="store_true", help="the load holds: the shaft never reaches its setpoint")

    g = p.add_argument_group("readings: where the manual leaves things open")
    g.add_argument("--command-by", choices=["level", "edge"], default="level",
                   help="a standing 0Fh starts when contact or enable come back / only a new write")
    g.add_argument("--read-back", choices=["eeprom", "force"], default="force",
                   help="reading sets 0-4 after a RAM write: EEPROM copy / value in force (chapter 7)")
    g.add_argument("--unknown", type=int, choices=[2, 4], default=4, help="exception for an unknown parameter")
    g.add_argument("--wrong-width", type=int, choices=[2, 4], default=4, help="exception for the wrong width")
    g.add_argument("--set-character", choices=["asked", "folded"], default="asked",
                   help="data set character of a VABus reply (S1 p30: from the drive 0-4)")
    g.add_argument("--switch-reply", choices=["old", "lost", "new"], default="old",
                   help="reply to P.395, 1376, 394, 34")
    g.add_argument("--reset-needs-remote", choices=["yes", "no"], default="no")
    g.add_argument("--nak-lock", choices=["nak", "silent"], default="nak", help="SELECT after a NAK before P.11 is read")
    g.add_argument("--wrong-bcc", choices=["nak", "silent"], default="nak")
    g.add_argument("--read-484", choices=["yes", "no"], default=None, help="default: ACT yes, ACU no (10.2.3)")
    g.add_argument("--bit4", choices=["mains", "running"], default="mains",
                   help="ACU status bit 4: mains (10.2) / only while running (table of 10.1)")
    g.add_argument("--x-bits", type=int, choices=[0, 1], default=0, help="status bits that the manual marks X")
    g.add_argument("--coast-shows", choices=["zero", "shaft"], default="zero",
                   help="P.210 while coasting: output stage off, so 0 / the shaft (encoder)")
    g.add_argument("--start-lost", choices=["coast", "ramp", "stays"], default="coast",
                   help="start contact lost while enabled by the control word")
    g.add_argument("--watchdog-fed-by", choices=["own", "any"], default="own")
    g.add_argument("--no-shortcut", action="store_true", help="transition 4 from 40h is not there (ACU x40)")
    g.add_argument("--width", action="append", default=[], metavar="NUMBER=BITS",
                   help="width of a parameter whose width is printed nowhere")
    g.add_argument("--contact-set", type=int, default=1, help="data set that the digital inputs select (P.414 = 0)")
    g.add_argument("--feedback", choices=["yes", "no"], default="no", help="P.217/218 show an encoder")

    g = p.add_argument_group("disturbances of the line")
    g.add_argument("--turnaround", type=float, default=10.0, metavar="MS", help="6.8: not before 10 ms")
    g.add_argument("--late", type=float, default=0.0, metavar="MS", help="every reply so much later")
    g.add_argument("--late-every", type=int, default=1, metavar="N", help="only every Nth reply is late")
    g.add_argument("--late-jitter", type=float, default=0.0, metavar="MS")
    g.add_argument("--overtake", action="store_true", help="a late reply may come behind that to a later question")
    g.add_argument("--lose", type=int, default=0, metavar="N", help="every Nth reply is lost")
    g.add_argument("--lose-chance", type=float, default=0.0, help="each reply is lost with this chance")
    g.add_argument("--deaf", type=int, default=0, metavar="N", help="every Nth telegram is not heard")
    g.add_argument("--garble", type=int, default=0, metavar="N", help="every Nth reply has a wrong bit")
    g.add_argument("--cut", type=int, default=0, metavar="N", help="every Nth reply lacks its last two bytes")
    g.add_argument("--double", type=int, default=0, metavar="N", help="every Nth reply comes twice")
    g.add_argument("--double-after", type=float, default=0.0, metavar="MS")
    g.add_argument("--twin", type=float, default=None, metavar="MS", help="a second drive at the address, so much later")
    g.add_argument("--neighbour", type=int, default=None, metavar="ADDRESS",
                   help="another, undisturbed drive on the line (P.372 = 955, P.480 = 7.77 Hz)")
    g.add_argument("--babble", action="store_true", help="byte 55h every 20 ms for ever")
    g.add_argument("--flood", action="store_true", help="bytes without any pause for ever")
    g.add_argument("--other-master", type=float, default=0.0, metavar="MS", help="another master polls, with such gaps")
    g.add_argument("--disturb-when", choices=["always", "enabled"], default="always",
                   help="babble, flood, other master, loss, lateness: always / once the drive was enabled")
    g.add_argument("--echo", choices=["none", "whole", "behind"], default="none")
    g.add_argument("--pieces", type=float, default=0.0, metavar="MS", help="the adapter delivers 1-4 bytes every so often")
    g.add_argument("--noise", action="store_true", help="a byte FFh before every reply")
    g.add_argument("--tail", action="store_true", help="a byte 00h behind every reply")
    g.add_argument("--wrong-address", type=int, default=0, metavar="N", help="every Nth reply carries another address")
    g.add_argument("--wrong-function", type=int, default=0, metavar="N", help="every Nth reply carries another code")
    g.add_argument("--any-setting", action="store_true", help="hear whatever baud and parity the client has set")

    g = p.add_argument_group("events, in seconds after the state 'operation enabled' was first reached")
    g.add_argument("--enable-lost", default=None, metavar="FROM[:TO]")
    g.add_argument("--contact-lost", default=None, metavar="FROM[:TO]")
    g.add_argument("--trip-at", default=None, metavar="T[:KEY]", help="fault at T, such as 1.5:0x0500")
    g.add_argument("--silent-at", default=None, metavar="FROM[:TO]", help="the drive says nothing any more")
    g.add_argument("--unplug-at", type=float, default=None, metavar="T", help="the adapter is pulled")
    g.add_argument("--set-changes", default=None, metavar="T:SET", help="the inputs select another data set")
    g.add_argument("--mains-lost", default=None, metavar="FROM[:TO]", help="ACU: mains off, 24 V stays")
    g.add_argument("--restart-at", type=float, default=None, metavar="T", help="mains off and on again")
    g.add_argument("--for", dest="seconds", type=float, default=60.0, help="end after this time")
    g.add_argument("--seed", type=int, default=1)
    return p


def options(text=""):
    """Options from one line of text, as the tests write them."""
    return parser().parse_args(text.split() if isinstance(text, str) else list(text))


def span(text):
    """'1.5:4' -> (1.5, 4.0); '1.5' -> (1.5, None)"""
    if text is None:
        return None
    first, _, second = text.partition(":")
    return float(first), (float(second) if second else None)


# ---------------------------------------------------------------------------------------------
# Check values and widths
# ---------------------------------------------------------------------------------------------


def crc16(data):
    """6.7.1.4, low byte first on the line"""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ 0xA001 if crc & 1 else crc >> 1
    return crc


def with_crc(data):
    crc = crc16(data)
    return bytes(data) + bytes([crc & 0xFF, crc >> 8])


def lrc(data):
    """6.7.2.3"""
    return (-sum(data)) & 0xFF


def bcc(data):
    """VABus: XOR of all behind STX up to and with ETX (S1 p31)"""
    value = 0
    for byte in data:
        value ^= byte
    return value


def signed(raw, bits):
    return raw - (1 << bits) if raw >> (bits - 1) & 1 else raw


# Causes in P.11 (6.6)
VALUE, SET, WRITE_ONLY, READ_ONLY, RUNNING, DIFFER, UNKNOWN, CHECK, SYNTAX, WIDTH = 1, 2, 3, 4, 8, 9, 11, 12, 13, 14
NODE = 20


class Refused(Exception):
    """A parameter access that the drive refuses, with its cause for P.11."""

    def __init__(self, cause):
        super().__init__(cause)
        self.cause = cause


class Row:
    """One parameter: width in bits, signedness, limits, factory value, where it lives."""

    def __init__(self, bits, low, high, default, per_set=False, access="rw", locked=False, eeprom=True):
        self.bits, self.low, self.high, self.default = bits, low, high, default
        self.per_set, self.access, self.locked, self.eeprom = per_set, access, locked, eeprom
        self.is_signed = low < 0


def table(family):
    """The parameters of this drive. Limits as printed; where nothing is printed, our own choice."""
    r = {
        10: Row(16, 1, 6, 4, locked=True),
        11: Row(16, 0, 99, 0, access="r"),
        30: Row(16, 110, 640, 110, locked=True),
        34: Row(16, 0, 9999, 0, locked=True, eeprom=False),
        66: Row(16, 0, 999, 7), 67: Row(16, 0, 999, 7), 68: Row(16, 0, 999, 71), 69: Row(16, 0, 999, 72),
        70: Row(16, 0, 999, 7), 71: Row(16, 0, 999, 7), 103: Row(16, 0, 999, 73),
        210: Row(32, -99999, 99999, 0, access="r"), 211: Row(16, 0, 9999, 0, access="r"),
        213: Row(16, -9999, 9999, 0, access="r"), 217: Row(32, -99999, 99999, 0, access="r"),
        218: Row(16, -32000, 32000, 0, access="r"), 228: Row(32, -100000, 100000, 0, access="r"),
        229: Row(32, -30000, 30000, 0, access="r"), 241: Row(32, -99999, 99999, 0, access="r"),
        249: Row(16, 1, 4, 1, access="r"), 250: Row(16, 0, 1023, 0, access="r"),
        260: Row(16, 0, 0xFFFF, 0, access="r"), 270: Row(16, 0, 0xFFFF, 0, access="r"),
        282: Row(32, -100000, 100000, 0, access="r"), 283: Row(32, -100000, 100000, 0, access="r"),
        372: Row(16, 60, 60000, 1390, per_set=True, locked=True),
        375: Row(32, 1000, 59900, 5000, per_set=True, locked=True),
        376: Row(16, 1, 10000, 40, per_set=True, locked=True),
        392: Row(16, 0, 2, 2, per_set=True),
        394: Row(16, 1, 30, 1, locked=True), 395: Row(16, 0, 3, 0, locked=True),
        400: Row(16, 1, 8, 2),
        410: Row(16, 0, 0xFFFF, 0, eeprom=False), 411: Row(16, 0, 0xFFFF, 0, access="r"),
        412: Row(16, 0, 44, 44, per_set=True), 413: Row(16, 0, 10000, 0), 414: Row(16, 0, 4, 0),
        418: Row(32, 0, 99999, 350, per_set=True), 419: Row(32, 0, 99999, 5000, per_set=True),
        434: Row(16, 1, 3, 3, per_set=True), 450: Row(16, 0, 2500, 200),
        475: Row(16, 0, 99, 1, per_set=True), 476: Row(16, 0, 99, 1, per_set=True),
        484: Row(32, -99999, 99999, 0, eeprom=False), 524: Row(32, -30000, 30000, 0, eeprom=False),
        549: Row(16, 1, 2000, 500), 632: Row(16, 0, 2000, 20, per_set=True),
        637: Row(16, 0, 1000, 10, per_set=True), 638: Row(16, 0, 2000, 5, per_set=True),
        1375: Row(16, 0, 2, 0, locked=True), 1376: Row(16, 1, 247, 1, locked=True),
    }
    for number in (420, 421, 422, 423, 424, 425):
        r[number] = Row(32, 1, 999999, 2000, per_set=True)
    for number, default in ((480, 500), (481, 1000), (482, 2500), (483, 5000)):
        r[number] = Row(32, -99900, 99900, default, per_set=True)
    r[424].default = r[425].default = 5000
    return r


# ---------------------------------------------------------------------------------------------
# The drive itself: parameters, state machine, motor
# ---------------------------------------------------------------------------------------------

INHIBIT, READY, SWITCHED_ON, ENABLED = "inhibit", "ready", "switched on", "enabled"
QUICK, REACTION, FAULT = "quick stop", "fault reaction", "fault"
CODES = {INHIBIT: 0x40, READY: 0x21, SWITCHED_ON: 0x23, ENABLED: 0x27, QUICK: 0x07, REACTION: 0x0F, FAULT: 0x08}
BAUDS = {1: 2400, 2: 4800, 3: 9600, 4: 19200, 5: 57600, 6: 115200}


class Drive:
    """The drive without its line. All times are those of time.monotonic()."""

    LOCK = 15.0  # 9.1: a fault cannot be reset before
    REBOOT = 2.0  # 5.2.1: "betriebsbereit nach wenigen Sekunden"

    def __init__(self, opt, sin, now):
        self.opt, self.sin = opt, sin
        self.rows = table(opt.family)
        self.contact_set = opt.contact_set
        for item in opt.width:
            number, _, bits = item.partition("=")
            row = self.rows[int(number)]
            row.bits = int(bits)
            row.high = min(row.high, 65535 if row.low >= 0 else 32767) if row.bits == 16 else row.high
        self.eeprom, self.ram = {}, {}
        for number, row in self.rows.items():
            for s in (1, 2, 3, 4) if row.per_set else (0,):
                self.eeprom[number, s] = row.default
        self.eeprom[412, 1] = self.eeprom[412, 2] = self.eeprom[412, 3] = self.eeprom[412, 4] = 1
        self.eeprom[395, 0] = {"vabus": 0, "rtu": 2, "ascii": 3}[opt.protocol]
        self.eeprom[1376, 0] = opt.address
        self.eeprom[394, 0] = min(opt.address, 30)
        self.eeprom[10, 0] = {b: n for n, b in BAUDS.items()}[opt.baud]
        self.eeprom[1375, 0] = ["even", "odd", "none"].index(opt.parity)
        for item in opt.set:
            left, _, raw = item.partition("=")
            number, _, s = left.partition("@")
            row = self.rows[int(number)]
            for one in ([int(s)] if s else [1, 2, 3, 4] if row.per_set else [0]):
                self.eeprom[int(number), one] = int(raw, 0)
        self.wear = []  # (time, number, set, raw) of every write into the EEPROM
        self.writes = []  # (time, number, set as sent, raw)
        self.served = []  # (time, number, set as sent, raw)
        self.history = []  # (time, state, output Hz, shaft Hz), every change of note
        self.cause = 0  # P.11
        self.line_reset()
        self.enable, self.start = not opt.no_enable, not opt.no_start
        self.mains = not opt.no_mains
        self.line_setpoint, self.percent = round(opt.left * 100), 0
        self.last_sign = -1 if opt.left < 0 else 1
        self.word, self.fresh_word = opt.word, False
        self.state = INHIBIT
        self.output = self.shaft = 0.0
        self.powered = False
        self.stopping = None  # None, "ramp", "quick", "brake"
        self.hold_until = None
        self.fault, self.fault_time, self.fault_until = 0, None, None
        self.first_enabled = None
        self.was_enabled_count = 0
        self.booting_until = None
        self.last_contact = now
        self.time = now
        self.birth = now
        if opt.fault:
            self.fault, self.fault_time, self.state = opt.fault, now - opt.fault_age, FAULT
        if opt.running:
            self.state, self.powered = ENABLED, True
            self.output = self.shaft = self.target()
            self.word = 0x0F if self.value(412) == 1 else self.word
            self.first_enabled = now
        self._note()

    # -- parameters ---------------------------------------------------------------------------

    def line_reset(self):
        """Baud and parity hold from the last reset (5.2.1); protocol and address at once."""
        self.baud_in_force = BAUDS[self.eeprom[10, 0]]
        self.parity_in_force = ("even", "odd", "none")[self.eeprom[1375, 0]]

    @property
    def active_set(self):
        return self.value(414) or self.contact_set

    def value(self, number, s=None):
        """The value in force: the RAM copy if there is one, of the active data set."""
        if self.rows[number].per_set:
            s = self.active_set if s is None else s
        else:
            s = 0
        return self.ram.get((number, s), self.eeprom[number, s])

    def hertz(self, number):
        return self.value(number) / 100.0

    @property
    def in_motion(self):
        return self.state in (ENABLED, QUICK) or self.powered

    def read(self, number, s, bits, now):
        """A read access; raises Refused."""
        row = self.rows.get(number)
        if row is None:
            raise Refused(UNKNOWN)
        if row.bits != bits:
            raise Refused(WIDTH)
        if not 0 <= s <= 9:
            raise Refused(SET)
        if number in (484, 524):
            allowed = self.opt.read_484 or ("no" if self.opt.family == "acu" else "yes")
            if s:
                raise Refused(SET)
            if allowed == "no":
                raise Refused(WRITE_ONLY)
        raw = self._live(number)
        if raw is None:
            want_ram, one = s >= 5, s - 5 if s >= 5 else s
            if not row.per_set and one:
                raise Refused(SET)

            def get(k):
                if want_ram or self.opt.read_back == "force":
                    return self.ram.get((number, k), self.eeprom[number, k])
                return self.eeprom[number, k]

            if row.per_set and one == 0:
                values = {get(k) for k in (1, 2, 3, 4)}
                if len(values) > 1:
                    raise Refused(DIFFER)
                raw = values.pop()
            else:
                raw = get(one)
        elif s not in (0, 5):
            raise Refused(SET)
        if number == 11:
            self.cause = 0
        raw &= (1 << bits) - 1
        self.served.append((now, number, s, raw))
        return raw

    def _live(self, number):
        """Values that are computed and not stored."""
        hz = lambda f: int(round(f * 100))
        shown = self.output if self.powered or self.opt.coast_shows == "zero" else self.shaft
        if self.stopping == "brake":
            shown = 0.0
        if number in (210, 241):
            return hz(shown)
        if number == 11:
            return self.cause
        if number == 211:
            return int(20 + abs(self.output)) if self.powered else 0
        if number == 213:
            return int(abs(self.output) / 5) if self.powered else 0
        if number == 217:
            return hz(self.shaft) if self.opt.feedback == "yes" else 0
        if number == 218:
            return int(self.shaft * 30) if self.opt.feedback == "yes" else 0
        if number == 228:
            return hz(self.opt.internal)
        if number == 229:
            return self.percent
        if number == 249:
            return self.active_set
        if number == 250:
            return self._contacts()
        if number == 260:
            return self.fault
        if number == 270:
            return self.opt.warning
        if number == 282:
            return self.line_setpoint
        if number == 283:
            return hz(self.target())
        if number == 410:
            return self.word
        if number == 411:
            return self.status()
        if number == 484:
            return self.line_setpoint
        if number == 524:
            return self.percent
        return None

    def _contacts(self):
        if self.value(412) == 2:  # 9.1.3: shown only with hardware enable and bit 0
            return self.word & 0x3FF if self.enable and self.word & 1 else 0
        bits = (1 if self.enable else 0) | (2 if self.start else 0)
        return bits

    def write(self, number, s, raw, bits, now):
        """A write access; raises Refused. Returns what the line must do: None, 'line', 'reboot'."""
        row = self.rows.get(number)
        if row is None:
            raise Refused(UNKNOWN)
        if row.bits != bits:
            raise Refused(WIDTH)
        if row.access == "r":
            raise Refused(READ_ONLY)
        if number in (410, 484, 524) and s != 0:
            raise Refused(SET)  # chapter 7: always zero
        one = s - 5 if s >= 5 else s
        if not 0 <= s <= 9 or (not row.per_set and one):
            raise Refused(SET)
        number_value = signed(raw, bits) if row.is_signed else raw
        if not row.low <= number_value <= row.high:
            raise Refused(VALUE)
        if number == 392 and number_value == 1 and self.value(30) // 100 != 1:
            raise Refused(VALUE)  # 9.1.2.2: only with V/f characteristics
        if row.locked and self.in_motion:
            self.sin("write-while-running", f"P.{number}")
            raise Refused(RUNNING)
        self.writes.append((now, number, s, number_value))
        if number == 410:
            self._command(number_value, now)
            return None
        if number == 484:
            if self.value(434) == 1:
                self.sin("setpoint-without-effect", "P.484 written while P.434 = 1")
            self.line_setpoint = number_value
            if number_value:
                self.last_sign = 1 if number_value > 0 else -1
            return None
        if number == 524:
            self.percent = number_value
            return None
        if number == 34:
            if number_value == 123:
                return "reboot"
            return None
        targets = [one] if one or not row.per_set else [1, 2, 3, 4]
        for k in targets:
            if s >= 5:
                self.ram[number, k] = number_value
            else:
                self.eeprom[number, k] = number_value
                self.ram.pop((number, k), None)
        if s < 5:
            self.wear.append((now, number, s, number_value))
        if number == 413:
            self.last_contact = now
        if number in (395, 394, 1376):
            return "line"
        return None

    # -- state machine ------------------------------------------------------------------------

    def status(self):
        """P.411 (9.1.2, 10.2)"""
        code = CODES[self.state]
        mode = self.value(412)
        if mode != 1 and self.state in (INHIBIT, READY):
            code = CODES[SWITCHED_ON]
        if self.state in (INHIBIT, REACTION, FAULT) and self.opt.x_bits:
            code |= 0x20
        if self.opt.family == "acu":
            lit = self.mains if self.opt.bit4 == "mains" else self.state == ENABLED
            code |= 0x10 if lit else 0
        if self.opt.warning:
            code |= 0x80
        if mode == 1 and self.enable and self.start or mode == 2 and self.enable:
            code |= 0x200
        if self.state == ENABLED and abs(self.output - self.target()) <= self.tolerance():
            code |= 0x400
        return code

    def tolerance(self):
        return self.value(549) / 10000.0 * max(0.0, self.hertz(419) - self.hertz(418))

    def target(self):
        """What goes to the ramp (9.2.1, 10.2.3)"""
        source = self.value(434)
        line = self.line_setpoint / 100.0
        if source == 1:
            f = self.opt.internal
        elif source == 2:
            least = self.hertz(418)
            f = line if abs(line) >= least else least * self.last_sign
        else:
            f = self.opt.internal + line
        top = self.hertz(419)
        return max(-top, min(top, f))

    def _can_run(self):
        return self.enable and self.start and (self.mains or self.opt.family == "act")

    def _command(self, word, now):
        before, self.word = self.word, word
        mode = self.value(412)
        if mode == 2:
            return
        if mode != 1:
            self.sin("control-word-ignored", f"P.410 = {word:04X}h while P.412 = {mode}")
            return
        if word & ~0x8F:
            self.sin("control-word-unknown-bits", f"{word:04X}h")
        rising = word & 0x80 and not before & 0x80
        remote = self.enable and self.start
        if self.state == FAULT and rising:
            age = now - self.fault_time
            if age < self.LOCK:
                self.sin("reset-inside-lock", f"{age:.1f} s after the fault")
            elif remote or self.opt.reset_needs_remote == "no":
                self.fault, self.state = 0, INHIBIT
                self._note()
                if word & 0x0F == 0x0F and self.opt.command_by == "level":
                    self.sin("reset-with-start", f"{word:04X}h")
                if self.opt.command_by == "edge":
                    return
            return
        if self.stopping == "brake":
            self.sin("word-while-braking", f"{word:04X}h")  # 9.1.2.2: not accepted before the end
            self.word = before
            return
        legal = {INHIBIT: {0x06, 0x0F, 0x00, 0x02, 0x07}, READY: {0x07, 0x0F, 0x00, 0x02, 0x06},
                 SWITCHED_ON: {0x0F, 0x06, 0x00, 0x02, 0x07}, ENABLED: {0x0F, 0x07, 0x06, 0x00, 0x02},
                 QUICK: {0x00, 0x02, 0x06, 0x07}, REACTION: {0x00, 0x02, 0x06, 0x07},
                 FAULT: {0x00, 0x02, 0x06, 0x07}}
        if word & 0x8F not in legal[self.state] and not (word & 0x80):
            self.sin("control-word-jump", f"{word:04X}h in {self.state}")
        self._obey(word, now, new=True)

    def _obey(self, word, now, new):
        """Transitions by the control word; called at a write, and all the time when the level counts."""
        if self.value(412) != 1 or self.state in (FAULT, REACTION):
            return
        on, volt, no_quick, run = word & 1, word & 2, word & 4, word & 8
        acu = self.opt.family == "acu"
        if not volt:
            if self.state in (READY, SWITCHED_ON, ENABLED, QUICK):
                if self.state == SWITCHED_ON and not new and not acu:
                    pass
                self._off(INHIBIT)  # 7, 9, 10, 12
            return
        if not no_quick:
            if self.state == ENABLED:
                self.state, self.stopping, self.hold_until = QUICK, "quick", None  # 11
                self._note()
            elif acu and self.state in (READY, SWITCHED_ON):
                self._off(INHIBIT)
            return
        if not on:
            if self.state == INHIBIT and (new or self.opt.command_by == "level"):
                self._to(READY)  # 2
            elif self.state in (SWITCHED_ON, ENABLED):
                self._off(READY)  # 6, 8
            return
        if not run:
            if self.state == READY and (self.mains or not acu):
                self._to(SWITCHED_ON)  # 3
            elif self.state == ENABLED and not self.stopping:
                self._transition_5(now)
            return
        # 0Fh
        if self.state == ENABLED:
            if self.stopping == "ramp":
                self.stopping, self.hold_until = None, None  # 9.1.2.2: runs up again
            return
        if self.state == QUICK:
            return
        if self.opt.no_shortcut and self.state == INHIBIT:
            return
        if self.state == READY:
            self._to(SWITCHED_ON)
        if self.state in (SWITCHED_ON, INHIBIT) and self._can_run():
            if new or self.opt.command_by == "level":
                self._power_on(now)

    def _to(self, state):
        if state != self.state:
            self.state = state
            self._note()

    def _power_on(self, now):
        if abs(self.shaft) > 0.5:
            self.sin("enabled-onto-turning-shaft", f"{self.shaft:.1f} Hz")
        self.powered, self.stopping, self.hold_until = True, None, None
        self.output = self.shaft
        self.state = ENABLED
        self.was_enabled_count += 1
        if self.first_enabled is None:
            self.first_enabled = now
        self._note()

    def _off(self, state):
        """Output stage off: the shaft coasts."""
        self.powered, self.stopping, self.hold_until = False, None, None
        self.output = 0.0
        self._to(state)

    def _transition_5(self, now):
        how = self.value(392)
        if how == 0:
            self._off(SWITCHED_ON)
        elif how == 1:
            self.stopping, self.hold_until = "brake", now + self.value(632) / 10.0
        else:
            self.stopping, self.hold_until = "ramp", None
        self._note()

    def trip(self, key, now):
        """Fault: reaction, then fault; the output stage is off at once."""
        if self.state in (FAULT, REACTION):
            return
        self.fault, self.fault_time, self.fault_until = key, now, now + 0.15
        self._off(REACTION)

    def reboot(self, now):
        """Software reset (P.34 = 123) or mains: RAM is lost, the line gets its new settings."""
        self._off(INHIBIT)
        self.ram.clear()
        self.word = 0
        self.line_setpoint = self.percent = 0
        self.last_sign = 1
        self.cause = 0
        if self.fault and now - self.fault_time >= self.LOCK:
            self.fault = 0
        elif self.fault:
            self.state = FAULT
        self.booting_until = now + self.REBOOT
        self.line_reset()

    # -- time ---------------------------------------------------------------------------------

    def advance(self, now):
        """Lets the time pass in steps of at most 5 ms."""
        while self.time < now:
            step = min(0.005, now - self.time)
            self.time += step
            self._step(step, self.time)

    def _step(self, dt, now):
        if self.booting_until is not None:
            if now >= self.booting_until:
                self.booting_until = None
                self.last_contact = now
            self._coast(dt)
            return
        if self.state == REACTION and now >= self.fault_until:
            self._to(FAULT)
        limit = self.value(413)
        if limit and now - self.last_contact > limit:
            self.trip(0x2010, now)
        mode = self.value(412)
        if mode == 1:
            if self.state == ENABLED and not self.enable:
                self._off(SWITCHED_ON)  # 9.1.2: coasts, "Eingeschaltet"
            elif self.state == ENABLED and not self.start and self.opt.start_lost != "stays":
                if self.opt.start_lost == "coast":
                    self._off(SWITCHED_ON)
                elif not self.stopping:
                    self.stopping, self.hold_until = "ramp", None
            elif self.state == QUICK and not self.enable:
                self._off(INHIBIT)
            elif self.opt.command_by == "level" and self.stopping != "brake" and self.opt.start_lost != "ramp":
                self._obey(self.word, now, new=False)
        else:
            self._by_contacts(mode, now)
        if not self.powered:
            self._coast(dt)
            return
        self._turn(dt, now)

    def _by_contacts(self, mode, now):
        """P.412 = 0 and 2; every other value is control by the keypad, which does not start here."""
        if self.state in (FAULT, REACTION):
            return
        if mode == 2:
            want = self.enable and self.word & 1 and bool(self.word & 2) != bool(self.word & 4)
        elif mode == 0:
            want = self.enable and self.start
        else:
            want = self.opt.running and self.enable
        if mode == 2 and not self.word & 1 or not self.enable:
            if self.state in (ENABLED, QUICK):
                self._off(SWITCHED_ON)
            return
        if want and self._can_run() and self.state != ENABLED:
            self._power_on(now)
        elif want and self.stopping == "ramp":
            self.stopping, self.hold_until = None, None
        elif not want and self.state == ENABLED and not self.stopping:
            self.stopping, self.hold_until = "ramp", None

    def _coast(self, dt):
        if self.shaft:
            step = self.opt.coast * dt
            self.shaft = max(0.0, self.shaft - step) if self.shaft > 0 else min(0.0, self.shaft + step)
            if self.shaft == 0.0:
                self._note()

    def _turn(self, dt, now):
        if self.stopping == "brake":
            left = max(self.hold_until - now, 1e-6)
            self.shaft -= self.shaft * min(1.0, dt / left)
            self.output = 0.0
            if now >= self.hold_until:
                self._off(SWITCHED_ON)
            return
        aim = 0.0 if self.stopping else self.target()
        if self.opt.stiff and not self.stopping:
            aim *= 0.5
        if self.stopping == "quick":
            down = up = self.hertz(424 if self.output >= 0 else 425)
        elif self.output > 0 or (self.output == 0 and aim > 0):
            up, down = self.hertz(420), self.hertz(421)
        else:
            up, down = self.hertz(422), self.hertz(423)
        delta = aim - self.output
        faster = (self.output == 0) or (aim * self.output > 0 and abs(aim) > abs(self.output))
        most = (up if faster else down) * dt
        if not faster and aim * self.output < 0:
            most = min(most, abs(self.output) + 1e-9)
        self.output = aim if abs(delta) <= most else self.output + (most if delta > 0 else -most)
        if abs(self.output) < 1e-6:
            self.output = 0.0
        self.shaft = self.output
        if self.stopping in ("ramp", "quick"):
            threshold = self.value(637) / 1000.0 * self.hertz(419)
            if self.hold_until is None and abs(self.output) <= threshold:
                self.hold_until = now + self.value(638) / 10.0
            if self.hold_until is not None and now >= self.hold_until:
                self._off(INHIBIT if self.stopping == "quick" else SWITCHED_ON)

    def _note(self):
        self.history.append((self.time, self.state, round(self.output, 2), round(self.shaft, 2)))

    # -- for the judge -------------------------------------------------------------------------

    def settings(self):
        """Everything that a run must give back: EEPROM and RAM copies that differ."""
        result = {f"{n}@{s}": v for (n, s), v in self.eeprom.items()}
        result.update({f"{n}@{s}ram": v for (n, s), v in self.ram.items() if v != self.eeprom[n, s]})
        return result


# ---------------------------------------------------------------------------------------------
# Protocols
# ---------------------------------------------------------------------------------------------


class Modbus:
    """Function codes 3, 6, 8, 100, 101 with the exceptions of chapters 6.4 to 6.6 and 8."""

    def __init__(self, drive, opt):
        self.drive, self.opt = drive, opt
        self.counters = {k: 0 for k in range(0x0B, 0x13)}

    @property
    def address(self):
        return self.drive.eeprom[1376, 0]

    def answer(self, frame, now):
        """Frame without check value -> (reply without check value or None, effect)."""
        d = self.drive
        self.counters[0x0B] = (self.counters[0x0B] + 1) & 0xFFFF
        address, rest = frame[0], frame[1:]
        broadcast = address == 0
        if broadcast:
            self.counters[0x0F] += 1
        elif address != self.address:
            if self.opt.watchdog_fed_by == "any":
                d.last_contact = now
            return None, None
        else:
            self.counters[0x0E] = (self.counters[0x0E] + 1) & 0xFFFF
        d.last_contact = now
        own = self.address
        try:
            body, effect = self._function(rest, now, broadcast)
        except Refused as no:
            d.cause = no.cause
            code = 4
            if no.cause == UNKNOWN:
                code = self.opt.unknown
            elif no.cause == WIDTH:
                code = self.opt.wrong_width
            body, effect = bytes([rest[0] | 0x80, code]), None
            self.counters[0x0D] += 1
        if broadcast:
            return None, effect
        return bytes([own]) + body, effect

    def _function(self, body, now, broadcast):
        d, code = self.drive, body[0]

        def exception(number):
            self.counters[0x0D] += 1
            return bytes([code | 0x80, number]), None

        lengths = {3: 5, 6: 5, 8: 5, 100: 3, 101: 7}
        if code not in lengths:
            (code == 43) or d.sin("unknown-function", f"{code}")  # today: code 43 is asked first (issue 10.4), exception 1 is harmless
            return exception(1)
        if broadcast and code in (3, 100):
            d.sin("broadcast-read", f"code {code}")
            return exception(1)
        if len(body) != lengths[code]:
            d.sin("wrong-length", body.hex(" "))
            return exception(3)
        if code == 8:
            sub, data = struct.unpack(">HH", body[1:])
            if not 0x0A <= sub <= 0x12:
                return exception(1)
            if data:
                return exception(3)
            if sub == 0x0A:
                for key in self.counters:
                    self.counters[key] = 0
                return body, None
            return bytes([8]) + struct.pack(">HH", sub, self.counters[sub]), None
        place = struct.unpack(">H", body[1:3])[0]
        s, number = place >> 12, place & 0xFFF
        if code == 3:
            if struct.unpack(">H", body[3:])[0] != 1:
                d.sin("register-count", body.hex(" "))
                return exception(2)
            return bytes([3, 2]) + struct.pack(">H", d.read(number, s, 16, now)), None
        if code == 100:
            return bytes([100]) + struct.pack(">I", d.read(number, s, 32, now)), None
        if code == 6:
            return body, d.write(number, s, struct.unpack(">H", body[3:])[0], 16, now)
        return body, d.write(number, s, struct.unpack(">I", body[3:])[0], 32, now)


class Rtu:
    """6.7.1: telegrams are parted by silence; a telegram is read when the line was still long enough."""

    data_bits = 8
    silence = 0.005

    def __init__(self, drive, opt, sin):
        self.modbus, self.opt, self.sin = Modbus(drive, opt), opt, sin
        self.drive = drive
        self.buffer = b""

    def char_bits(self):
        return 11

    def feed(self, data, now):
        self.buffer += data
        return []

    def quiet(self, now):
        """The line has been silent: what came is one telegram. Returns [(reply, effect)]."""
        frame, self.buffer = self.buffer, b""
        if not frame:
            return []
        done = []
        for one in self.split(frame):
            if len(one) < 4 or with_crc(one[:-2]) != one:
                self.modbus.counters[0x0C] += 1
                self.sin("bad-telegram", one.hex(" "))
                continue
            reply, effect = self.modbus.answer(one[:-2], now)
            done.append((with_crc(reply) if reply else None, effect))
        return done

    @staticmethod
    def split(frame):
        """Telegrams that came in one piece because this process, not the master, was late."""
        length = {3: 8, 6: 8, 8: 8, 100: 6, 101: 10}.get(frame[1] if len(frame) > 1 else 0)
        if length and len(frame) > length and with_crc(frame[:length - 2]) == frame[:length]:
            return [frame[:length]] + Rtu.split(frame[length:])
        return [frame]

    def address_of(self, frame):
        return frame[0] if frame else None

    def alter_address(self, reply):
        return with_crc(bytes([reply[0] % 247 + 1]) + reply[1:-2])

    def alter_function(self, reply):
        return with_crc(bytes([reply[0], reply[1] ^ 0x04]) + reply[2:-2])


class Ascii:
    """6.7.2: ':' … CR LF, at most one second between characters."""

    data_bits = 7
    silence = 1.0

    def __init__(self, drive, opt, sin):
        self.modbus, self.opt, self.sin = Modbus(drive, opt), opt, sin
        self.drive = drive
        self.buffer = b""

    def char_bits(self):
        return 10

    def feed(self, data, now):
        self.buffer += data
        done = []
        while True:
            start = self.buffer.find(b":")
            end = self.buffer.find(b"\r\n", max(start, 0))
            if start < 0 or end < 0:
                return done
            if start:
                self.sin("bad-telegram", self.buffer[:start].hex(" "))
            text, self.buffer = self.buffer[start + 1:end], self.buffer[end + 2:]
            again = text.rfind(b":")
            if again >= 0:
                self.sin("bad-telegram", text.hex(" "))
                text = text[again + 1:]
            try:
                if text != text.upper():
                    raise ValueError
                frame = bytes.fromhex(text.decode("ascii"))
            except ValueError:
                self.sin("bad-telegram", text.hex(" "))
                continue
            if len(frame) < 3 or lrc(frame[:-1]) != frame[-1]:
                self.modbus.counters[0x0C] += 1
                self.sin("bad-telegram", text.decode("ascii", "replace"))
                continue
            reply, effect = self.modbus.answer(frame[:-1], now)
            done.append((self.wrap(reply) if reply else None, effect))

    def quiet(self, now):
        if self.buffer:
            self.sin("bad-telegram", self.buffer.hex(" "))
            self.buffer = b""
        return []

    @staticmethod
    def wrap(body):
        return b":" + (body + bytes([lrc(body)])).hex().upper().encode() + b"\r\n"

    def alter_address(self, reply):
        body = bytes.fromhex(reply[1:-2].decode())[:-1]
        return self.wrap(bytes([body[0] % 247 + 1]) + body[1:])

    def alter_function(self, reply):
        body = bytes.fromhex(reply[1:-2].decode())[:-1]
        return self.wrap(bytes([body[0], body[1] ^ 4]) + body[2:])


EOT, STX, ETX, ENQ, ACK, NAK = 4, 2, 3, 5, 6, 0x15


class Vabus:
    """ENQUIRY and SELECT after ISO 1745 (protocols.md A, EM-RES-03 chapter 5.10.2.2)."""

    data_bits = 7
    silence = 0.030

    def __init__(self, drive, opt, sin):
        self.drive, self.opt, self.sin = drive, opt, sin
        self.buffer = b""
        self.open = False  # EOT seen
        self.locked = False  # a NAK was sent and P.11 not read since

    def char_bits(self):
        return 10

    @property
    def address(self):
        return 0x40 + self.drive.eeprom[394, 0]

    def feed(self, data, now):
        done = []
        for byte in data:
            byte &= 0x7F
            select = len(self.buffer) > 1 and self.buffer[1] == STX
            waiting_bcc = select and self.buffer[-1] == ETX and len(self.buffer) > 2
            if waiting_bcc:
                telegram, self.buffer, self.open = self.buffer + bytes([byte]), b"", False
                done += self._select(telegram, now)
            elif byte == EOT:
                if self.buffer:
                    self.sin("bad-telegram", self.buffer.hex(" "))
                self.buffer, self.open = b"", True
            elif not self.open:
                self.sin("bad-telegram", f"without EOT: {byte:02X}")
            elif byte == ENQ and not select:
                telegram, self.buffer, self.open = self.buffer, b"", False
                done += self._enquiry(telegram, now)
            else:
                self.buffer += bytes([byte])
                if len(self.buffer) > 120:
                    self.sin("bad-telegram", "too long")
                    self.buffer, self.open = b"", False
        return done

    def quiet(self, now):
        if self.buffer:
            self.sin("bad-telegram", self.buffer.hex(" "))
            self.buffer, self.open = b"", False
        return []

    def _place(self, text):
        """SYS ds n n n -> (system bus byte, data set, number); raises Refused."""
        sys_char, s, number = text[0], text[1:2], text[2:5]
        if len(text) < 5 or not s.isdigit() or not number[1:].isdigit():
            raise Refused(SYNTAX)
        head = chr(number[0])
        if head.isdigit():
            hundreds = int(head)
        elif "A" <= head <= "F":
            hundreds = 10 + ord(head) - ord("A")
        else:
            raise Refused(SYNTAX)
        if sys_char != 0x30:
            raise Refused(NODE)
        return int(s), hundreds * 100 + int(number[1:])

    def _nak(self, cause):
        self.drive.cause = cause
        self.locked = True
        return [(bytes([self.address, NAK]), None)]

    def _enquiry(self, telegram, now):
        if len(telegram) != 6:
            self.sin("bad-telegram", telegram.hex(" "))
            return []
        if telegram[0] != self.address:
            return []
        self.drive.last_contact = now
        try:
            s, number = self._place(telegram[1:])
            row = self.drive.rows.get(number)
            bits = row.bits if row else 16
            raw = self.drive.read(number, s, bits, now)
        except Refused as no:
            return self._nak(no.cause)
        if number == 11:
            self.locked = False
        digits = bits // 4
        shown = s - 5 if s >= 5 and self.opt.set_character == "folded" else s
        body = b"0" + str(shown).encode() + telegram[3:6] + f"{digits:02d}".encode()
        body += f"{raw:0{digits}X}".encode() + bytes([ETX])
        return [(bytes([self.address, STX]) + body + bytes([bcc(body)]), None)]

    def _select(self, telegram, now):
        address = telegram[0]
        broadcast = address == 0x60
        if address != self.address and not broadcast:
            return []
        body, check = telegram[2:-1], telegram[-1]
        own = self.address
        if bcc(body) & 0x7F != check:
            self.sin("bad-telegram", "BCC " + telegram.hex(" "))
            return [] if broadcast or self.opt.wrong_bcc == "silent" else self._nak(CHECK)
        self.drive.last_contact = now
        if self.locked and not broadcast:
            self.sin("select-while-locked", telegram.hex(" "))
            return [] if self.opt.nak_lock == "silent" else [(bytes([own, NAK]), None)]
        try:
            text = body[:-1]
            s, number = self._place(text)
            length, digits = text[5:7], text[7:]
            if not length.isdigit() or int(length) != len(digits):
                raise Refused(SYNTAX)
            if any(c not in b"0123456789ABCDEF" for c in digits):
                raise Refused(SYNTAX)
            effect = self.drive.write(number, s, int(digits, 16), 4 * len(digits), now)
        except Refused as no:
            return [] if broadcast else self._nak(no.cause)
        return [] if broadcast else [(bytes([own, ACK]), effect)]

    def alter_address(self, reply):
        return bytes([reply[0] + 1]) + reply[1:]

    def alter_function(self, reply):
        """Another parameter number with a right BCC"""
        if len(reply) < 8:
            return reply
        body = reply[2:6] + bytes([0x30 + (reply[6] - 0x30 + 1) % 10]) + reply[7:-1]
        return reply[:2] + body + bytes([bcc(body)])


TCGETS2 = 0x802C542A  # Linux: termios with the speed as a number

PROTOCOLS = {"rtu": Rtu, "ascii": Ascii, "vabus": Vabus}


# ---------------------------------------------------------------------------------------------
# The line: a pty, real time, and everything that can go wrong on it
# ---------------------------------------------------------------------------------------------


class DriveServer:
    """Serves a drive on a pty in a thread of its own. Use as a context manager."""

    def __init__(self, opt):
        self.opt = opt
        self.random = random.Random(opt.seed)
        self.lock = threading.RLock()
        self.sins = []  # (seconds since start, name, detail)
        self.log = []  # (seconds since start, "<" or ">", bytes)
        self.samples = []  # (time, state, output, shaft) every 20 ms
        self.born = time.monotonic()
        self.events = []
        self.order = itertools.count()
        self.stop_flag = False
        self.drive = Drive(opt, self.sin, self.born)
        self.protocol = PROTOCOLS[opt.protocol](self.drive, opt, self.sin)
        self.twin = None
        if opt.twin is not None:
            self.twin = Drive(opt, lambda *_: None, self.born)
            for key in ((372, 1), (372, 2), (372, 3), (372, 4)):
                self.twin.eeprom[key] = 955
            self.twin.eeprom[413, 0] = 17
            for key in ((480, 1), (480, 2), (480, 3), (480, 4)):
                self.twin.eeprom[key] = 777
            self.twin_protocol = PROTOCOLS[opt.protocol](self.twin, opt, lambda *_: None)
        self.neighbour = None
        if opt.neighbour is not None:
            self.neighbour = Drive(opt, lambda *_: None, self.born)
            for k in (1, 2, 3, 4):
                self.neighbour.eeprom[372, k], self.neighbour.eeprom[480, k] = 955, 777
            self.neighbour.eeprom[1376, 0] = self.neighbour.eeprom[394, 0] = opt.neighbour
            self.next_door = PROTOCOLS[opt.protocol](self.neighbour, opt, lambda *_: None)
        self.replies = 0
        self.telegrams = 0
        self.reply_start = self.reply_end = None  # of the last reply on the line
        self.owed_since = None  # end of the telegram whose reply has not begun
        self.last_byte = None
        self.silent = False
        self.line_free = 0.0
        self.fd = None
        self.path = None
        self.started_events = False

    # -- life --------------------------------------------------------------------------------

    def __enter__(self):
        master, slave = pty.openpty()
        tty.setraw(slave)
        self.fd, self.path = master, os.ttyname(slave)
        os.close(slave)
        self.wake_read, self.wake_write = os.pipe()
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.stop_flag = True
        os.write(self.wake_write, b"x")
        self.thread.join(3)
        for fd in (self.fd, self.wake_read, self.wake_write):
            if fd is not None:
                try:
                    os.close(fd)
                except OSError:
                    pass

    def sin(self, name, detail=""):
        self.sins.append((round(time.monotonic() - self.born, 4), name, detail))

    def at(self, when, what):
        heapq.heappush(self.events, (when, next(self.order), what))

    def disturbed(self):
        return self.opt.disturb_when == "always" or self.drive.first_enabled is not None

    def look(self):
        """(state, output Hz, shaft Hz) just now, for the judge."""
        with self.lock:
            self.drive.advance(time.monotonic())
            return self.drive.state, self.drive.output, self.drive.shaft

    # -- loop --------------------------------------------------------------------------------

    def _run(self):
        opt = self.opt
        poll = select.poll()
        poll.register(self.wake_read, select.POLLIN)
        poll.register(self.fd, select.POLLIN)
        end = self.born + opt.seconds
        self.at(self.born, self._tick)
        if opt.babble or opt.flood:
            self.at(self.born, self._babble)
        if opt.other_master:
            self.at(self.born, self._other_master)
        client = False
        while not self.stop_flag and time.monotonic() < end:
            now = time.monotonic()
            with self.lock:
                while self.events and self.events[0][0] <= now:
                    _, _, what = heapq.heappop(self.events)
                    what(time.monotonic())
                    if self.fd is None:
                        return
                wait = self.events[0][0] - time.monotonic() if self.events else 0.05
            if not client:
                wait = min(max(wait, 0.002), 0.02)
                time.sleep(wait)
                wait = 0
            for fd, event in poll.poll(max(0, wait) * 1000 + 0.2):
                if fd == self.wake_read:
                    return
                if event & select.POLLIN:
                    client = True
                    try:
                        data = os.read(self.fd, 4096)
                    except OSError:
                        data = b""
                    if data:
                        with self.lock:
                            self._heard(data, time.monotonic())
                elif event & select.POLLHUP:
                    if client:
                        client = False
                        with self.lock:
                            self._client_gone()
                else:
                    client = True
            if not client:
                # POLLHUP vanishes as soon as somebody has opened the other side
                probe = select.poll()
                probe.register(self.fd, select.POLLIN)
                got = probe.poll(0)
                client = not got or not got[0][1] & select.POLLHUP
            self.client = client

    client = False

    def _client_gone(self):
        """Nobody listens: what was on its way is gone, as on a real line."""
        self.protocol.buffer = b""
        self.owed_since = None

    def _tick(self, now):
        d = self.drive
        d.advance(now)
        if self.twin:
            self.twin.advance(now)
        self.samples.append((now, d.state, d.output, d.shaft))
        if d.first_enabled is not None and not self.started_events:
            self.started_events = True
            self._arm(d.first_enabled)
        self.at(now + 0.02, self._tick)

    def _arm(self, zero):
        opt, d = self.opt, self.drive

        def put(name, value):
            def act(now):
                d.advance(now)
                setattr(d, name, value)
                d._note()
            return act

        for text, name in ((opt.enable_lost, "enable"), (opt.contact_lost, "start")):
            if text:
                first, second = span(text)
                self.at(zero + first, put(name, False))
                if second is not None:
                    self.at(zero + second, put(name, True))
        if opt.set_changes:
            first, _, chosen = opt.set_changes.partition(":")
            self.at(zero + float(first), put("contact_set", int(chosen)))
        if opt.mains_lost:
            first, second = span(opt.mains_lost)
            self.at(zero + first, lambda now: (put("mains", False)(now), d.trip(0x0702, now) if d.powered else None))
            if second is not None:
                self.at(zero + second, put("mains", True))
        if opt.trip_at:
            first, _, key = opt.trip_at.partition(":")
            self.at(zero + float(first), lambda now: (d.advance(now), d.trip(int(key or "0x0500", 0), now)))
        if opt.silent_at:
            first, second = span(opt.silent_at)
            self.at(zero + first, lambda now: setattr(self, "silent", True))
            if second is not None:
                self.at(zero + second, lambda now: setattr(self, "silent", False))
        if opt.restart_at is not None:
            self.at(zero + opt.restart_at, lambda now: d.reboot(now))
        if opt.unplug_at is not None:
            self.at(zero + opt.unplug_at, self._unplug)

    def _unplug(self, now):
        os.close(self.fd)
        self.fd = None
        # the drive itself lives on: only its line is gone
        threading.Thread(target=self._live_on, daemon=True).start()

    def _live_on(self):
        while not self.stop_flag and time.monotonic() < self.born + self.opt.seconds:
            with self.lock:
                now = time.monotonic()
                self.drive.advance(now)
                self.samples.append((now, self.drive.state, self.drive.output, self.drive.shaft))
            time.sleep(0.02)

    # -- what is heard ------------------------------------------------------------------------

    def char_time(self):
        return self.protocol.char_bits() / self.drive.baud_in_force

    def _understood(self):
        """Does the client's setting fit the drive's? Parity and width as far as a pty shows them."""
        if self.opt.any_setting:
            return True
        try:
            raw = fcntl.ioctl(self.fd, TCGETS2, bytes(44))
        except OSError:
            return True
        iflag, _, cflag = struct.unpack("III", raw[:12])
        speed = struct.unpack("II", raw[36:44])[1]
        if speed != self.drive.baud_in_force:
            return False
        parity = ("odd" if cflag & termios.PARODD else "even") if iflag & termios.INPCK else "none"
        want = "even" if self.opt.protocol == "vabus" else self.drive.parity_in_force
        if parity != want:
            return False
        seven = bool(iflag & termios.ISTRIP)
        return seven == (self.protocol.data_bits == 7)

    def _heard(self, data, now):
        self.drive.advance(now)
        self.log.append((now - self.born, "<", data))
        if self.opt.echo == "whole":
            self.at(now + 0.001, lambda t: self._write(data))
        if not self._understood():
            return
        if self.drive.booting_until is not None:
            return
        if self.last_byte is None or now - self.last_byte > 0.004:
            self._judge_start(now, data)
        self.last_byte = now
        self.heard_end = now + len(data) * self.char_time()
        for item in self.protocol.feed(data, now):
            self._answer(item, self.heard_end, data)
        if self.neighbour:
            for reply, _ in self.next_door.feed(data, now):
                self._neighbour_answers(reply, self.heard_end)
        mark = self.heard_end
        if self.protocol.buffer:
            self.at(mark + self.protocol.silence, lambda t: self._quiet(mark, data, t))

    heard_end = 0.0

    def _judge_start(self, now, data):
        """The rules of 6.8 for the beginning of a telegram."""
        self.telegrams += 1
        if self.reply_end is not None and self.opt.double == 0 and self.twin is None:
            gap = now - self.reply_end
            # an adapter that gathers bytes hides the end of the reply from the master
            if self.reply_start is not None and self.reply_start < now < self.reply_end:
                self.sin("telegram-into-reply", data.hex(" "))
            elif 0 <= gap < 0.002 and not self.opt.pieces:
                self.sin("telegram-too-early", f"{gap * 1000:.2f} ms after the reply: {data.hex(' ')}")
        if self.owed_since is not None and now - self.owed_since < 0.49:
            self.sin("telegram-before-time-out", f"{(now - self.owed_since) * 1000:.0f} ms: {data.hex(' ')}")

    def _quiet(self, mark, data, now):
        if self.heard_end != mark:
            return
        self.drive.advance(now)
        for item in self.protocol.quiet(now):
            self._answer(item, mark, data)
        if self.neighbour:
            for reply, _ in self.next_door.quiet(now):
                self._neighbour_answers(reply, mark)

    def _neighbour_answers(self, reply, end):
        if reply:
            begin = end + self.opt.turnaround / 1000.0
            self.at(begin + len(reply) * self.char_time(), lambda t: self._write(reply))

    # -- what is said -------------------------------------------------------------------------

    def _answer(self, item, end, request):
        reply, effect = item
        opt = self.opt
        now = time.monotonic()
        if effect == "reboot":
            self.at(end + 0.05, lambda t: self.drive.reboot(t))
        if effect and opt.switch_reply == "lost":
            reply = None
        if effect == "line":
            previous = self.protocol
            protocol = {0: "vabus", 2: "rtu", 3: "ascii"}.get(self.drive.eeprom[395, 0])
            if protocol and protocol != opt.protocol:
                opt.protocol = protocol
                self.protocol = PROTOCOLS[protocol](self.drive, opt, self.sin)
                if opt.switch_reply == "new":
                    reply = None  # in a language of its own; the master cannot tell it from silence
            elif opt.switch_reply == "new" and isinstance(previous, Rtu) and reply:
                reply = with_crc(bytes([self.drive.eeprom[1376, 0]]) + reply[1:-2])
        if reply is None:
            return
        if self.twin:
            copy = PROTOCOLS[opt.protocol](self.twin, opt, lambda *_: None)
            copy.buffer = b""
            answers = copy.feed(request, now) or None
            answers = answers or copy.quiet(now)
            for other, _ in answers:
                if other:
                    self.at(end + (opt.turnaround + opt.twin) / 1000.0 + len(other) * self.char_time(),
                            lambda t, other=other: self._write(other))
        self.replies += 1
        n = self.replies
        hit = lambda every: every and n % every == 0 and self.disturbed()
        self.owed_since = end
        if self.silent or hit(opt.deaf) or hit(opt.lose):
            return
        if opt.lose_chance and self.disturbed() and self.random.random() < opt.lose_chance:
            return
        if hit(opt.garble):
            place = self.random.randrange(len(reply))
            reply = reply[:place] + bytes([reply[place] ^ (1 << self.random.randrange(7))]) + reply[place + 1:]
        if hit(opt.cut):
            reply = reply[:-2]
        if hit(opt.wrong_address):
            reply = self.protocol.alter_address(reply)
        if hit(opt.wrong_function):
            reply = self.protocol.alter_function(reply)
        if opt.noise:
            reply = b"\xff" + reply
        if opt.tail:
            reply = reply + b"\x00"
        late = 0.0
        if opt.late and hit(opt.late_every):
            late = opt.late + self.random.uniform(0, opt.late_jitter)
        begin = end + (opt.turnaround + late) / 1000.0
        if not opt.overtake:  # one drive works off one telegram after the other
            begin = max(begin, self.line_free + opt.turnaround / 1000.0)
        if opt.echo == "behind":
            self.at(begin + 0.0005, lambda t: self._write(request))
        duration = len(reply) * self.char_time()
        self.line_free = begin + duration
        self.at(begin, lambda t: self._begin_reply(t))
        self._send(reply, begin, duration, mine=True)
        if hit(opt.double):
            self._send(reply, begin + duration + opt.double_after / 1000.0, duration, mine=False)

    def _begin_reply(self, now):
        self.owed_since = None
        self.reply_start, self.reply_end = now, now + 10

    def _send(self, data, begin, duration, mine):
        """Writes whole at the end of its time on the line, or in the pieces of an adapter."""
        end = begin + duration

        def finished(t):
            if mine:
                self.reply_end = time.monotonic()

        if not self.opt.pieces:
            def whole(t):
                finished(t)  # before the write: a preempted drive must not accuse its master
                self._write(data)
            self.at(end, whole)
            return
        when = begin
        rest = data
        while rest:
            size = self.random.randint(1, 4)
            piece, rest = rest[:size], rest[size:]
            when = max(when + self.random.uniform(1.0, self.opt.pieces) / 1000.0, begin)
            self.at(when, lambda t, piece=piece: self._write(piece))
        self.at(when + 1e-6, finished)

    def _write(self, data):
        if self.fd is None or not self.client:
            return
        self.log.append((time.monotonic() - self.born, ">", data))
        ready = select.select([], [self.fd], [], 0)[1]
        if ready:
            try:
                os.write(self.fd, data)
            except OSError:
                pass

    def _babble(self, now):
        if self.disturbed():
            self._write(b"\x55" if self.opt.babble else bytes(self.random.randrange(256) for _ in range(8)))
        self.at(now + (0.020 if self.opt.babble else 0.004), self._babble)

    def _other_master(self, now):
        """Another master reads P.411 of drive 17, which answers; then a gap."""
        if not self.disturbed():
            self.at(now + 0.02, self._other_master)
            return
        gap = self.opt.other_master / 1000.0
        ask = bytes([17, 3, 0x01, 0x9B, 0, 1])
        reply = bytes([17, 3, 2, 0x06, 0x37])
        if self.opt.protocol == "rtu":
            ask, reply = with_crc(ask), with_crc(reply)
        elif self.opt.protocol == "ascii":
            ask, reply = Ascii.wrap(ask), Ascii.wrap(reply)
        else:
            body = b"0041104" + b"0637" + bytes([ETX])
            body = b"00411" + b"04" + b"0637" + bytes([ETX])
            ask = bytes([EOT, 0x51]) + b"00411" + bytes([ENQ])
            reply = bytes([0x51, STX]) + body + bytes([bcc(body)])
        t = self.char_time()
        self._write(ask)
        self.at(now + 0.010 + len(reply) * t, lambda _: self._write(reply))
        self.at(now + 0.010 + len(reply) * t + gap, self._other_master)

    # -- for the judge -------------------------------------------------------------------------

    def report(self):
        """What the master did, for people and for JSON."""
        d = self.drive
        zero = self.born
        return {
            "sins": [list(s) for s in self.sins],
            "eeprom_writes": [[round(t - zero, 3), n, s, v] for t, n, s, v in d.wear],
            "writes": [[round(t - zero, 3), n, s, v] for t, n, s, v in d.writes],
            "state": d.state, "output": d.output, "shaft": d.shaft,
            "history": [[round(t - zero, 3), s, o, f] for t, s, o, f in d.history],
            "telegrams": self.telegrams, "replies": self.replies,
        }


def main():
    opt = parser().parse_args()
    with DriveServer(opt) as server:
        print(server.path, flush=True)
        try:
            server.thread.join(opt.seconds)
        except KeyboardInterrupt:
            pass
        print(json.dumps(server.report(), indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
