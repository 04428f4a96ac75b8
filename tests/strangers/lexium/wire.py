"""A line on a pseudo terminal with LXM05 drives on it, and what may go wrong there.

This room knows bytes and time: Modbus RTU framing (manual 5.1.3), the time that
characters take, check values, and the disturbances of a real line. What a request
means it leaves to `lexium05.Device`. One thread, one loop, no busy waiting.

    python3 wire.py --late 200 --control7 brakes --left PVn_target=900

prints the path of the pty and serves it until Ctrl-C; then the sins of the master.
"""

import argparse
import errno
import fcntl
import heapq
import os
import random
import select
import struct
import sys
import termios
import threading
import time
import tty
from dataclasses import dataclass, field, fields

from lexium05 import PARAMETERS, Device, Readings, choice, number

# --------------------------------------------------------------------------- disturbances


@dataclass
class Disturbances:
    """What the line does to telegrams. Times in ms."""

    late: int = number(0, "every reply comes so much later")
    late_every: int = number(1, "only every n-th reply is late")
    turnaround: int = number(5, "from the end of a request to the begin of its reply")
    lose: int = number(0, "every n-th reply is lost")
    lose_request: int = number(0, "every n-th request never reaches the drive")
    lose_write_reply: int = number(0, "every n-th reply to a write is lost, after it was done")
    double: int = number(0, "every n-th reply comes twice")
    double_after: int = number(50, "so long after the first")
    dice: int = number(0, "seed: replies are lost, late up to 900, doubled after up to 500, garbled, by chance")
    garble: int = number(0, "every n-th reply has one bit flipped")
    noise: int = number(0, "every n-th reply has a stray byte 2 ms before it")
    twin: str = choice("none", "after", "garbled", about="a second LXM05 at the same address")
    twin_after: int = number(12, "the twin's turnaround")
    babble: int = number(0, "a byte 55h every so many ms, for ever")
    babble_from: float = number(0.0, "s after which babble, or the other master, begins")
    other_master: str = choice("none", "polls", about="another master polls with gaps of 12 and 25 ms")
    collide: str = choice("no", "yes", about="babble and the other master spoil replies that they fall into")
    echo: str = choice("none", "whole", "behind", about="the adapter hears what it sends")
    pieces: int = number(0, "replies come in pieces of 1-8 bytes with gaps up to so many ms")
    fault_at: float = number(0.0, "s after which the drive faults")
    fault_enabled: int = number(0, "fault so many ms after operation enabled")
    fault_class: int = number(2, "class of that fault: 2 brakes, 3 coasts")
    mute_at: float = number(0.0, "s after which the drive does not answer")
    mute_for: float = number(1e9, "s that it does not")
    mute_enabled: int = number(0, "silent so many ms after operation enabled, for mute-for")
    cut_requests: str = choice("no", "yes", about="while muted, requests do not reach the drive either")
    unplug_at: float = number(0.0, "s after which the adapter is pulled")
    disable_at: float = number(0.0, "s after which somebody else switches the power stage off")
    power_cycle_at: float = number(0.0, "s after which mains fail for 1.5 s: mute, coasting, RAM gone")
    strict_line: str = choice("yes", "no", about="deaf if the master's baud rate or parity is another")


# --------------------------------------------------------------------------- Modbus RTU

TCGETS2 = 0x802C542A  # Linux: struct termios2, the only one that tells speeds set as numbers
MASTER_PATIENCE = 0.45  # s: a master that asks again sooner was told nothing by the manual


def crc(data):
    """Manual 5.1.3.3: CRC16 with A001, low byte first on the line."""
    value = 0xFFFF
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = value >> 1 ^ 0xA001 if value & 1 else value >> 1
    return value.to_bytes(2, "little")


def framed(address, pdu):
    telegram = bytes([address]) + pdu
    return telegram + crc(telegram)


def request_length(data):
    """How long the request that begins with `data` is, or None while nobody can say."""
    if len(data) < 2:
        return None
    code = data[1]
    if code in (1, 2, 3, 4, 5, 6, 8):
        return 8
    if code in (15, 16):
        return 9 + data[6] if len(data) > 6 else None
    if code == 23:
        return 13 + data[10] if len(data) > 10 else None
    if code == 43:
        return 7
    if code in (7, 11, 12, 17):
        return 4
    return None


# --------------------------------------------------------------------------- the line


@dataclass(order=True)
class Event:
    when: float
    order: int
    what: object = field(compare=False)


class Line:
    """A pty with drives on it. `start` serves in a thread; `stop` ends it."""

    def __init__(self, readings=None, disturbances=None, twin_readings=None, log=None):
        now = time.monotonic()
        self.wrong = disturbances or Disturbances()
        self.drive = Device(readings, now)
        self.twin = Device(twin_readings or Readings(left="RAMPacc=1234", family_bits="lxm32"), now)
        self.twin.axis.turns = 3.25
        self.born = now
        self.log = log
        self.master, slave = os.openpty()
        tty.setraw(slave)
        attributes = termios.tcgetattr(slave)
        attributes[4] = attributes[5] = termios.B38400
        termios.tcsetattr(slave, termios.TCSANOW, attributes)
        self.path = os.ttyname(slave)
        os.close(slave)
        os.set_blocking(self.master, False)
        self.lock = threading.Lock()
        self.events, self.order = [], 0
        self.buffer, self.buffer_at = b"", 0.0
        self.babbled_at = 0.0
        self.pending = 0            # replies that are owed
        self.asked_at = 0.0
        self.voice = (0.0, 0.0)     # our last reply: begin and end on the line
        self.replies = self.write_replies = self.requests = 0
        self.deaf = 0
        self.dice = random.Random(self.wrong.dice or 5)
        self.client_seen = False
        self.running = True
        self.enabled_seen = None
        self.thread = None
        self.muted_at_end = False
        self.dark_until = 0.0       # no mains until then
        if self.wrong.babble:
            self._at(now + self.wrong.babble_from, self._babble)
        if self.wrong.other_master != "none":
            self._at(now + self.wrong.babble_from, self._other_master)
        if self.wrong.fault_at:
            self._at(now + self.wrong.fault_at, self._fault)
        if self.wrong.power_cycle_at:
            self._at(now + self.wrong.power_cycle_at, self._power_cycle)
        if self.wrong.disable_at:
            self._at(now + self.wrong.disable_at, self._disable)

    # ---- for a judge

    def start(self):
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()
        return self

    def stop(self):
        self.running = False
        if self.thread:
            self.thread.join(2)
        try:
            os.close(self.master)
        except OSError:
            pass

    def look(self):
        """The truth about the shaft, now."""
        with self.lock:
            self.drive.advance(time.monotonic())
            return {"state": self.drive.state, "speed": self.drive.axis.speed, "mode": self.drive.mode,
                    "turns": self.drive.axis.turns, "changed": self.drive.changed()}

    def muted(self):
        """Whether nothing can be heard from the drive now."""
        return self._muted(time.monotonic())

    def say(self, text):
        if self.log:
            print(f"{time.monotonic() - self.born:9.4f} {text}", file=self.log, flush=True)

    # ---- time

    def _at(self, when, what):
        self.order += 1
        heapq.heappush(self.events, Event(when, self.order, what))

    def char(self):
        return 11.0 / self.drive.in_force["MBbaud"]

    def silence(self):
        return 3.5 * self.char()

    def serve(self):
        """The loop. Never waits longer than 20 ms, so that the shaft's time is fine enough."""
        poll = select.poll()
        poll.register(self.master, select.POLLIN)
        while self.running:
            now = time.monotonic()
            wait = 0.02
            if self.events:
                wait = min(wait, max(0.0, self.events[0].when - now))
            ready = poll.poll(wait * 1000.0)
            hung = any(flags & select.POLLHUP for _, flags in ready)
            if hung:
                time.sleep(max(0.001, min(wait, 0.01)))
            with self.lock:
                now = time.monotonic()
                self._live(now)
                if any(flags & select.POLLIN for _, flags in ready):
                    self._hear(now)
                self._frame(now)
                while self.events and self.events[0].when <= time.monotonic():
                    heapq.heappop(self.events).what()
                self.client = not hung
                if self.wrong.unplug_at and now - self.born > self.wrong.unplug_at:
                    self.say("unplugged")
                    os.close(self.master)
                    self.running = False
                    self._coast_on()
                    return

    def _coast_on(self):
        """After unplugging the drive lives on without a line."""
        def live():
            while time.monotonic() - self.born < self.wrong.unplug_at + 30:
                time.sleep(0.02)
                with self.lock:
                    self.drive.advance(time.monotonic())
        threading.Thread(target=live, daemon=True).start()

    def _live(self, now):
        self.drive.advance(now)
        self.twin.advance(now)
        if self.enabled_seen is None and self.drive.state == "enabled":
            self.enabled_seen = now
            if self.wrong.fault_enabled:
                self._at(now + self.wrong.fault_enabled / 1000.0, self._fault)

    def _power_cycle(self):
        self.say("mains fail")
        self.drive.power_cycle()
        self.dark_until = time.monotonic() + 1.5

    def _fault(self):
        self.say("fault")
        self.drive.fault(error_class=self.wrong.fault_class)

    def _disable(self):
        self.say("somebody switches the power stage off")
        self.drive.enabling = None
        self.drive._become("switch-on disabled")

    def _muted(self, now):
        if now < self.dark_until:
            return True
        begin = None
        if self.wrong.mute_at:
            begin = self.born + self.wrong.mute_at
        if self.wrong.mute_enabled and self.enabled_seen is not None:
            begin = self.enabled_seen + self.wrong.mute_enabled / 1000.0
        return begin is not None and begin <= now < begin + self.wrong.mute_for

    # ---- hearing

    def _hear(self, now):
        try:
            data = os.read(self.master, 4096)
        except OSError as error:
            if error.errno not in (errno.EIO, errno.EAGAIN):
                raise
            return
        if not data:
            return
        if not self.client_seen:
            self.client_seen = True
        if not self._same_line():
            self.deaf += 1
            self.say(f"deaf ({self._settings()}) {data.hex(' ')}")
            return
        begin, end = self.voice
        if begin <= now < end:
            self.drive.sin("speaks while the drive answers", f"{(end - now) * 1e3:.1f} ms before the end")
        elif not self.buffer and 0 <= now - end < self.silence() * 0.9:
            self.drive.sin("too early", f"{(now - end) * 1e3:.2f} ms behind a reply")
        if self.wrong.echo == "whole":
            self._voice(now + len(data) * self.char(), data, "echo")
        if not self.buffer:
            self.buffer_at = now
        self.buffer += data

    def _same_line(self):
        """The pty shows the master's settings; a wrong one makes the drive deaf."""
        if self.wrong.strict_line == "no":
            return True
        parity = {1: "none", 2: "even", 3: "odd", 4: "none"}[self.drive.in_force["MBformat"]]
        return self._settings() == (self.drive.in_force["MBbaud"], parity)

    def _settings(self):
        """Baud rate and parity of the master. A pty hides PARENB, INPCK is still seen."""
        settings = bytearray(44)
        fcntl.ioctl(self.master, TCGETS2, settings)
        iflag, _, cflag, _ = struct.unpack_from("=4I", settings)
        (speed,) = struct.unpack_from("=I", settings, 40)
        parity = "none"
        if iflag & termios.INPCK:
            parity = "odd" if cflag & termios.PARODD else "even"
        return speed, parity

    def _frame(self, now):
        """Cuts requests out of the buffer: by length and check value, or by silence."""
        while self.buffer:
            size = request_length(self.buffer)
            if size and len(self.buffer) >= size and crc(self.buffer[:size - 2]) == self.buffer[size - 2:size]:
                telegram, self.buffer = self.buffer[:size], self.buffer[size:]
                self._request(telegram)
                continue
            if now - self.buffer_at > 0.06 + len(self.buffer) * self.char():
                self.drive.sin("no telegram", self.buffer.hex(" "))
                self.drive.counters[12] += 1
                self.buffer = b""
            return

    def _request(self, telegram):
        begun = max(self.buffer_at, time.monotonic() - 0.05)
        self.requests += 1
        self.say(f"> {explain(telegram, self.drive)}")
        address = telegram[0]
        if self.pending and begun - self.asked_at < MASTER_PATIENCE:
            self.drive.sin("asks while a reply is owed", f"after {(begun - self.asked_at) * 1e3:.0f} ms")
        if self.wrong.lose_request and self.requests % self.wrong.lose_request == 0:
            self.say("  request lost")
            return
        if self._muted(begun) and (self.wrong.cut_requests == "yes" or begun < self.dark_until):
            return
        end = begun + len(telegram) * self.char()
        if address == 0:
            self.drive.sin("broadcast", telegram.hex(" "))
            self._at(end + self.silence(), lambda: self.drive.serve(telegram[1:-2], broadcast=True))
        elif address == self.drive.in_force["MBadr"]:
            self.asked_at = begun
            self.pending += 1
            self._at(end + self.silence(), lambda: self._answer(telegram))

    # ---- speaking

    def _answer(self, telegram):
        now = time.monotonic()
        self.drive.advance(now)
        self.twin.advance(now)
        address = telegram[0]
        pdu = self.drive.serve(telegram[1:-2])
        second = self.twin.serve(telegram[1:-2]) if self.wrong.twin != "none" else None
        muted = self._muted(now)
        if pdu is None or muted:
            self.pending -= 1
            self.say("  silent")
            return
        self.replies += 1
        writes = telegram[1] in (16, 23)
        self.write_replies += writes
        reply = framed(address, pdu)
        if self.wrong.twin == "garbled" and second is not None:
            other = framed(address, second).ljust(len(reply), b"\xff")
            reply = bytes(a & b for a, b in zip(reply, other))
        begin = now + self.wrong.turnaround / 1000.0
        if self.wrong.late and self.replies % self.wrong.late_every == 0:
            begin += self.wrong.late / 1000.0
        begin = max(begin, self.voice[1] + self.silence())
        fate = self.dice.random() if self.wrong.dice else 1.0
        if 0.1 <= fate < 0.22:
            begin += self.dice.uniform(0.0, 0.9)
        lost = (self._every(self.wrong.lose, self.replies)
                or writes and self._every(self.wrong.lose_write_reply, self.write_replies))
        lost = lost or fate < 0.1
        if self._every(self.wrong.garble, self.replies) or 0.22 <= fate < 0.3:
            spoiled = bytearray(reply)
            spoiled[self.dice.randrange(len(spoiled))] ^= 1 << self.dice.randrange(8)
            reply = bytes(spoiled)
        if self._every(self.wrong.noise, self.replies):
            self._voice(begin - 0.002, b"\xfc", "noise")
        if self.wrong.echo == "behind":
            reply = reply + telegram
        end = begin + len(reply) * self.char()
        if lost:
            self._at(end, self._lost)
        else:
            self._voice(end, reply, "reply", owed=True)
            self.voice = (begin, end)
        if self._every(self.wrong.double, self.replies):
            self._voice(end + self.wrong.double_after / 1000.0, reply, "double")
        if 0.3 <= fate < 0.5:
            self._voice(end + self.dice.uniform(0.0, 0.5), reply, "double")
        if self.wrong.twin == "after" and second is not None:
            other = framed(address, second)
            twin_end = max(now + self.wrong.twin_after / 1000.0, end + self.silence())
            self._voice(twin_end + len(other) * self.char(), other, "twin")

    @staticmethod
    def _every(n, count):
        return bool(n) and count % n == 0

    def _lost(self):
        self.pending -= 1
        self.say("  reply lost")

    def _voice(self, end, data, who, owed=False):
        """The last of these bytes is on the line at `end`."""
        pieces = [data]
        if self.wrong.pieces and len(data) > 2:
            pieces, rest = [], data
            while rest:
                n = self.dice.randint(1, 8)
                pieces.append(rest[:n])
                rest = rest[n:]
        for i, piece in enumerate(pieces):
            gap = self.dice.randint(1, max(1, self.wrong.pieces)) / 1000.0 if i else 0.0
            end += gap
            last = i == len(pieces) - 1
            self._at(end, lambda piece=piece, last=last: self._emit(piece, who, owed and last))

    def _emit(self, data, who, owed):
        if owed:
            self.pending -= 1
            now = time.monotonic()
            if now > self.voice[1] - 0.0001:
                self.voice = (self.voice[0], now)
            if self.wrong.collide == "yes" and now - self.babbled_at < len(data) * self.char():
                data = bytes([data[0] & 0x55]) + data[1:]
        if who == "babble":
            self.babbled_at = time.monotonic()
        try:
            os.write(self.master, data)
        except OSError:
            pass  # nobody listens, or nobody has read for long: on a wire, bytes are gone as well
        self.say(f"< {who:6} {data.hex(' ')}")

    def _babble(self):
        if getattr(self, "client", False):
            self._emit(b"\x55", "babble", False)
        self._at(time.monotonic() + self.wrong.babble / 1000.0, self._babble)

    def _other_master(self):
        """Polls station 9 and is answered by it: gaps of 12 and 25 ms, for ever."""
        question = framed(9, bytes.fromhex("03 00 10 00 01"))
        answer = framed(9, bytes.fromhex("03 02 12 34"))
        now = time.monotonic()
        asked = now + len(question) * self.char()
        answered = asked + 0.012 + len(answer) * self.char()
        if getattr(self, "client", False):
            self._at(asked, lambda: self._emit(question, "babble", False))
            self._at(answered, lambda: self._emit(answer, "babble", False))
        self._at(answered + 0.025, self._other_master)


def explain(telegram, drive):
    """A request in words, for a log."""
    address, code = telegram[0], telegram[1]

    def name(at):
        row = PARAMETERS.get(at)
        return row.name if row else str(at)

    text = telegram.hex(" ")
    if code == 3 and len(telegram) == 8:
        start, count = int.from_bytes(telegram[2:4], "big"), int.from_bytes(telegram[4:6], "big")
        return f"{address}: read {name(start)} x{count}   [{text}]"
    if code == 16 and len(telegram) >= 13:
        start = int.from_bytes(telegram[2:4], "big")
        return f"{address}: write {name(start)} = {drive._value(telegram[7:11])}   [{text}]"
    if code == 8:
        return f"{address}: diagnose {int.from_bytes(telegram[2:4], 'big')}   [{text}]"
    return f"{address}: code {code}   [{text}]"


# --------------------------------------------------------------------------- command line


def add_options(parser, shape):
    """One option for every field of a dataclass of choices and numbers."""
    for item in fields(shape):
        parser.add_argument("--" + item.name.replace("_", "-"), default=item.default,
                            type=type(item.default), choices=item.metadata.get("choices"),
                            help=item.metadata["about"] + f" [{item.default}]")


def taken(arguments, shape):
    return shape(**{item.name: getattr(arguments, item.name) for item in fields(shape)})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_options(parser.add_argument_group("readings of the manual"), Readings)
    add_options(parser.add_argument_group("disturbances"), Disturbances)
    parser.add_argument("--for", dest="seconds", type=float, default=0, help="end after so many seconds")
    parser.add_argument("--link", help="a symbolic link to the pty, for scripts")
    parser.add_argument("--log", action="store_true", help="every telegram on stderr")
    arguments = parser.parse_args()
    line = Line(taken(arguments, Readings), taken(arguments, Disturbances),
                log=sys.stderr if arguments.log else None).start()
    print(line.path, flush=True)
    if arguments.link:
        if os.path.islink(arguments.link):
            os.unlink(arguments.link)
        os.symlink(line.path, arguments.link)
    try:
        time.sleep(arguments.seconds or 1e9)
    except KeyboardInterrupt:
        pass
    truth = line.look()
    line.stop()
    print(f"state {truth['state']}, {truth['speed']:.1f} 1/min, {truth['turns']:.3f} turns, mode {truth['mode']}, "
          f"peak {line.drive.peak:.0f} 1/min, changed {truth['changed']}")
    for when, text in line.drive.events:
        print(f"{when:9.3f} {text}")
    for when, kind, text in line.drive.sins:
        print(f"{when:9.3f} SIN {kind}: {text}")


if __name__ == "__main__":
    main()
