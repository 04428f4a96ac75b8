"""A Schneider Lexium LXM05, written from its Modbus manual alone (0198441113237, V1.04).

This room knows the device: its parameters, its CiA 402 state machine, its axis
(position, velocity, ramps), node guarding, faults, and the five function codes.
It knows neither a clock nor a port: time comes as an argument (seconds), requests
and replies are PDUs (function code and data, without address and check value).

Where the manual leaves a question open, `Readings` has an option for each answer
that a drive of the real world could give. Where the manual is silent about what a
master may do, the device obliges, but writes down a *sin*.
"""

import math
import struct
from dataclasses import dataclass, field, fields

# --------------------------------------------------------------------------- readings


def choice(*values, about):
    """A reading with a closed list of answers; the first one is the default."""
    return field(default=values[0], metadata={"choices": values, "about": about})


def number(default, about):
    """A reading that is a number."""
    return field(default=default, metadata={"about": about})


@dataclass
class Readings:
    """Every question that the manual leaves open, and what is left standing in the drive."""

    mode_change_turning: str = choice(
        "refused", "accepted", "brakes-first",
        about="DCOMopmode while the shaft turns (6.3.1)")
    mode_before_enable: str = choice(
        "acts", "waits", "refused",
        about="DCOMopmode before operation enabled: active at once, at enabling, or refused")
    setpoints: str = choice(
        "kept", "zeroed", about="setpoints and *reference after a run and after a mode change")
    control7: str = choice(
        "coasts", "brakes", "refused", about="control word 7 on a turning shaft")
    guard_state: str = choice(
        "quick-stop", "fault", about="state after node guarding has acted (5.6)")
    guard_fed_by: str = choice(
        "all", "writes", about="which messages feed node guarding")
    guard_acts: str = choice(
        "enabled", "always", about="node guarding acts in operation enabled only, or in every state")
    guard_write: str = choice(
        "any-state", "not-enabled", about="when MBnode_guard may be written")
    bit6: str = choice(
        "absolute", "relative", about="bit 6 of the control word: as printed (5.4.1) or as CiA 402")
    fc23_first: str = choice("writes", "reads", about="what FC23 does first")
    line_when: str = choice(
        "power-on", "at-once", about="when MBadr, MBbaud, MBformat act")
    order_when: str = choice("power-on", "at-once", about="when MBdword_order acts")
    fc8_restart: str = choice(
        "keeps", "applies", about="FC8 sub 1 leaves line settings alone, or puts stored ones in force")
    fc16_refused: str = choice(
        "nothing", "before", about="one refused register in FC16: what has been written")
    fault_number: str = choice(
        "stays", "next", about="reading FLT_err_num stays, or moves to the next entry")
    exceptions: str = choice(
        "fitting", "1", "2", "3", "4", about="which exception code a refusal has (6.2)")
    product: str = choice(
        "lxm05", "other", about="whether the product code begins with LXM05 (5.2.5)")
    fc43: str = choice("answers", "refused", "silent", about="whether FC43 is there at all")
    revision_id: int = number(2, "object id of the revision: 2 (standard) or 3 (as printed)")
    quick_stop_ends: str = choice(
        "stays", "by-itself", about="quick stop active stays until disable voltage, or ends at standstill")
    quick_stop_enable: str = choice(
        "ignored", "returns", about="control F in quick stop active (transition 16 is not printed)")
    short_cut: str = choice(
        "ignored", "refused", about="control 7 or F in switch-on disabled")
    enable_steps: str = choice(
        "both", "one-by-one", about="control F in ready: 3 and 4 together (5.4), or only 3")
    enable_delay: int = number(80, "ms from control F to operation enabled (power stage, brake)")
    disable_delay: int = number(0, "ms from a stopping control word to its state")
    setpoint_lag: int = number(0, "ms until a written setpoint or mode acts; status is the old one until then")
    speed_ramps: str = choice("none", "ramps", about="whether mode -4 follows RAMPacc and RAMPdecel")
    ramps_turning: str = choice("act", "refused", about="RAMP* written while the shaft turns")
    halt: str = choice("honoured", "ignored", about="bit 8 of the control word")
    family_bits: str = choice("none", "lxm32", about="status bits 13-15: none, or as in LXM32")
    status_high: int = number(0, "upper 16 bits of DCOMstatus")
    reached_disabled: str = choice("0", "1", about="status bit 10 while not enabled")
    limits: str = choice("refused", "clipped", about="speed setpoints beyond RAMPn_max")
    persistence: str = choice("at-once", "save", about="settings survive power-off at once, or need saving")

    # What the mechanics and the wiring are.
    usr_per_rev: int = number(16384, "user units per turn of the shaft")
    dither: int = number(0, "standstill: _p_act wavers by so many units")
    friction: float = number(300.0, "1/min/s that a shaft without power loses")
    quick_stop_ramp: float = number(6000.0, "1/min/s of a quick stop")
    gear_input: float = number(600.0, "1/min at the position interface")
    analog: float = number(0.0, "1/min that the analog input asks for (SPEEDreference 1)")
    load_limit: float = number(0.0, "1/min that the load lets the shaft reach at most; 0 is no limit")
    no_mains: str = choice("mains", "no-mains", about="whether the power stage has mains")

    # What stands in the drive from before.
    left: str = number("", "parameters left from before: PVn_target=900,GEARreference=1")
    turning: float = number(0.0, "enabled by somebody else, in mode 3, at this speed")
    begin: str = choice("switch-on disabled", "ready", "switched on", "enabled", "quick stop", "fault reaction",
                        about="state at the start; enabled stands in the mode that is left")
    order_in_force: str = choice("as-stored", "high", "low",
                                 about="word order in force, if MBdword_order was changed since power-on")
    faults_stored: int = number(0, "entries in the fault memory from before")
    fault_left: str = choice("none", "curable", "lasting", about="a fault that stands at the start")


# --------------------------------------------------------------------------- parameters


@dataclass(frozen=True)
class Parameter:
    """One row: 32 bits, two registers, at an even address."""

    name: str
    default: int = 0
    low: int = -(2**31)
    high: int = 2**31 - 1
    writable: bool = True
    allowed: tuple = ()

    def takes(self, value):
        if self.allowed:
            return value in self.allowed
        return self.low <= value <= self.high


SPEED = 13200
HOMING_METHODS = (1, 2, *range(7, 15), 17, 18, *range(23, 31), 33, 34, 35)

# Addresses: manual 4.1, 5.2-5.6. Limits and defaults that it does not print are strict guesses.
PARAMETERS = {
    1284: Parameter("IOposInterfac", 0, 0, 2),
    1544: Parameter("SPVswLimPusr", 2**31 - 1),
    1546: Parameter("SPVswLimNusr", -(2**31)),
    1554: Parameter("RAMPn_max", SPEED, 60, SPEED),
    1556: Parameter("RAMPacc", 600, 30, 3_000_000),
    1558: Parameter("RAMPdecel", 750, 30, 3_000_000),
    5638: Parameter("MBbaud", 19200, allowed=(9600, 19200, 38400)),
    5640: Parameter("MBadr", 1, 1, 247),
    5642: Parameter("MBformat", 2, 1, 4),
    5644: Parameter("MBnode_guard", 0, 0, 10000),
    5646: Parameter("MBdword_order", 0, 0, 1),
    6914: Parameter("DCOMcontrol", 0, 0, 0xFFFF),
    6916: Parameter("DCOMstatus", writable=False),
    6918: Parameter("DCOMopmode", 0, allowed=(-4, -3, -2, -1, 1, 3, 6)),
    6920: Parameter("_DCOMopmd_act", writable=False),
    6930: Parameter("JOGactivate", 0, allowed=(0, 1, 2, 5, 6)),
    6936: Parameter("HMmethod", 18, allowed=HOMING_METHODS),
    6938: Parameter("PVn_target", 0, -SPEED, SPEED),
    6940: Parameter("PPp_targetusr", 0),
    6942: Parameter("PPn_target", 60, 1, SPEED),
    6944: Parameter("CURreference", 0, 0, 2),
    6946: Parameter("SPEEDreference", 0, 0, 2),
    6948: Parameter("GEARreference", 0, 0, 2),
    7700: Parameter("_p_act", writable=False),
    8200: Parameter("CUR_I_target", 0, -3000, 3000),
    8456: Parameter("SPEEDn_target", 0, -SPEED, SPEED),
    9734: Parameter("GEARdenom", 1, 1, 2**31 - 1),
    9736: Parameter("GEARnum", 1),
    10248: Parameter("HMn", 60, 1, SPEED),
    10250: Parameter("HMn_out", 6, 1, 3000),
    10504: Parameter("JOGn_slow", 60, 1, SPEED),
    10506: Parameter("JOGn_fast", 180, 1, SPEED),
    15362: Parameter("FLT_err_num", writable=False),
    15364: Parameter("FLT_class", writable=False),
    15366: Parameter("FLT_Time", writable=False),
    15368: Parameter("FLT_Qual", writable=False),
}
AT = {row.name: address for address, row in PARAMETERS.items()}

LINE_SETTINGS = ("MBadr", "MBbaud", "MBformat", "MBdword_order")
# In which modes a setpoint is one: anywhere else it is written into the wrong mode.
SETPOINT_OF = {
    "PVn_target": 3, "PPp_targetusr": 1, "CUR_I_target": -3, "SPEEDn_target": -4,
    "JOGactivate": -1, "CURreference": -3, "SPEEDreference": -4, "GEARreference": -2,
}
ZEROED = ("PVn_target", "CUR_I_target", "SPEEDn_target", "JOGactivate",
          "CURreference", "SPEEDreference", "GEARreference")

# CiA 402, mask 6F.
STATE_BITS = {
    "not ready": 0x00, "switch-on disabled": 0x40, "ready": 0x21, "switched on": 0x23,
    "enabled": 0x27, "quick stop": 0x07, "fault reaction": 0x0F, "fault": 0x08,
}
# 5.4, 5.5 print 0, 6, F, 1F, 5F; 7 is the state machine's own "switch on".
PRINTED_CONTROL = (0x00, 0x06, 0x07, 0x0F, 0x1F, 0x5F)
# Not printed, but CiA 402: quick stop, fault reset.
KNOWN_CONTROL = (0x02, 0x0B, 0x80)

NUMBER = {"address": 0x1101, "value": 0x1100, "read-only": 0x1104, "state": 0x1105,
          "count": 0x1102, "function": 0x1B00, "sub-function": 0x1B01, "power": 0x1106}
FITTING = {"address": 2, "value": 3, "read-only": 2, "state": 4, "count": 3,
           "function": 1, "sub-function": 1, "power": 4}
GUARD_FAULT, TEST_FAULT = 0xB200, 0x2300

STILL = 0.5  # 1/min: less is standstill


class Refused(Exception):
    """A synchronous error (6.3.1): answered by an exception code."""

    def __init__(self, case):
        super().__init__(case)
        self.case = case


# --------------------------------------------------------------------------- the axis


class Axis:
    """A shaft: turns and 1/min. Somebody else says what it shall do."""

    def __init__(self):
        self.turns = 0.0
        self.speed = 0.0

    def approach(self, wanted, up, down, dt):
        """Changes the speed towards `wanted`, by `up` or `down` 1/min/s."""
        faster = abs(wanted) > abs(self.speed) and wanted * self.speed >= 0
        most = (up if faster else down) * dt
        change = max(-most, min(most, wanted - self.speed))
        self.speed += change
        self.turns += self.speed / 60.0 * dt

    @property
    def still(self):
        return abs(self.speed) < STILL


# --------------------------------------------------------------------------- the device


class Device:
    """One LXM05 with its shaft. `now` in seconds must never go back."""

    def __init__(self, readings=None, now=0.0):
        self.readings = readings or Readings()
        self.value = {row.name: row.default for row in PARAMETERS.values()}
        self.acting = dict(self.value)      # what the control loop sees (setpoint_lag)
        self.later = []                     # (time, what) that still has to act
        self.axis = Axis()
        self.state = "switch-on disabled"
        self.mode = 0
        self.mode_wanted = None             # a mode change that waits for standstill
        self.control_word = 0
        self.enabling = None                # time at which operation enabled is reached
        self.braking_off = False            # control 7 brakes; power goes at standstill
        self.homing = None
        self.homed = False
        self.start = None                   # mode 1: target in turns, or None
        self.reached = False
        self.halted = False
        self.faults = []                    # (number, class, seconds, qualifier)
        self.fault_pointer = 0
        self.fault_curable = True
        self.sync_error = 0
        self.counters = dict.fromkeys((11, 12, 13, 16, 17, 18), 0)
        self.listen_only = False
        self.fed = None
        self.sins = []
        self.events = []
        self.peak = 0.0                     # highest speed since the start
        self.now = now
        self.born = now
        for pair in filter(None, self.readings.left.split(",")):
            name, text = pair.split("=")
            self.value[name] = self.acting[name] = int(text, 0)
        if self.value["DCOMopmode"] and self.readings.mode_before_enable != "waits":
            self.mode = self.value["DCOMopmode"]
        self.in_force = {name: self.value[name] for name in LINE_SETTINGS}
        if self.readings.order_in_force != "as-stored":
            self.in_force["MBdword_order"] = int(self.readings.order_in_force == "low")
        for entry in range(self.readings.faults_stored):
            self.faults.append((0x3200 + entry, 1 + entry % 4, 100 * entry, 40 + entry))
        self.state = self.readings.begin
        if self.state == "enabled":
            self.mode = self.value["DCOMopmode"]
            self.control_word = self.value["DCOMcontrol"] = 0x0F
        if self.readings.turning:
            self.state, self.mode = "enabled", 3
            self.control_word = self.value["DCOMcontrol"] = 0x0F
            self.value["DCOMopmode"] = 3
            self.value["PVn_target"] = self.acting["PVn_target"] = int(self.readings.turning)
            self.axis.speed = self.readings.turning
        if self.readings.fault_left != "none":
            self.fault_curable = self.readings.fault_left == "curable"
            self.state = "fault"
            self.faults.append((TEST_FAULT, 3, 0, 7))
        self.first = dict(self.value)       # to judge what has been given back

    # ---- what a judge asks

    def sin(self, kind, text):
        self.sins.append((round(self.now - self.born, 3), kind, text))

    def event(self, text):
        self.events.append((round(self.now - self.born, 3), text))

    def changed(self):
        """Parameters that are not as they were at the start, with both values."""
        skip = ("DCOMcontrol", "DCOMopmode", "PPp_targetusr")
        return {name: (self.first[name], value) for name, value in self.value.items()
                if value != self.first[name] and name not in skip}

    # ---- time

    def advance(self, now):
        """Lets the axis and the state machine live up to `now`."""
        while self.now < now:
            dt = min(0.002, now - self.now)
            self.now += dt
            for item in [item for item in self.later if item[0] <= self.now]:
                self.later.remove(item)
                item[1]()
            self._guard()
            if self.enabling is not None and self.now >= self.enabling:
                self._enabled()
            self._move(dt)
            self.peak = max(self.peak, abs(self.axis.speed))

    def _soon(self, ms, what):
        if ms <= 0:
            what()
        else:
            self.later.append((self.now + ms / 1000.0, what))

    def _become(self, state):
        if state != self.state:
            self.event(f"{self.state} -> {state} at {self.axis.speed:.0f} 1/min")
            if self.state == "enabled":
                self._run_ends()
            self.state = state

    def _run_ends(self):
        self.start = self.homing = None
        self.mode_wanted = None
        if self.readings.setpoints == "zeroed":
            self._zero_setpoints()

    def _zero_setpoints(self):
        for name in ZEROED:
            self.value[name] = self.acting[name] = 0

    def _guard(self):
        """5.6: no message in time stops what the bus has started, by a quick stop."""
        limit = self.value["MBnode_guard"]
        if not limit or self.fed is None or self.now - self.fed < limit / 1000.0:
            return
        powered = self.state == "enabled"
        if powered or (self.readings.guard_acts == "always" and self.state in ("ready", "switched on")):
            self.event("node guarding acts")
            if self.readings.guard_state == "fault" or not powered:
                self.fault(GUARD_FAULT, 2)
            else:
                self.faults.append((GUARD_FAULT, 1, int(self.now - self.born), 0))
                self._become("quick stop")
        self.fed = None

    def fault(self, error=TEST_FAULT, error_class=2):
        """An asynchronous fault: class 2 brakes first, class 3 drops the power at once."""
        self.faults.append((error, error_class, int(self.now - self.born), 0))
        braking = self.state in ("enabled", "quick stop") and error_class < 3 and not self.axis.still
        self.enabling = None
        self._become("fault reaction" if braking else "fault")

    def power_cycle(self):
        """Off and on: RAM is gone, line settings come into force."""
        kept = dict(self.value if self.readings.persistence == "at-once" else self.first)
        for name in (*ZEROED, "DCOMcontrol", "DCOMopmode", "MBnode_guard"):
            kept[name] = 0
        self.value, self.acting = kept, dict(kept)
        self.in_force = {name: kept[name] for name in LINE_SETTINGS}
        self.state, self.mode, self.control_word = "switch-on disabled", 0, 0
        self.enabling = self.start = self.homing = self.mode_wanted = None
        self.listen_only = self.homed = False
        self.fed = None
        self.event("power cycle")

    # ---- the shaft

    def _move(self, dt):
        axis, value = self.axis, self.acting
        if self.state in ("quick stop", "fault reaction"):
            axis.approach(0.0, 0.0, self.readings.quick_stop_ramp, dt)
            if axis.still:
                axis.speed = 0.0
                if self.state == "fault reaction":
                    self._become("fault")
                elif self.readings.quick_stop_ends == "by-itself":
                    self._become("switch-on disabled")
            return
        if self.braking_off:
            axis.approach(0.0, 0.0, value["RAMPdecel"], dt)
            self.braking_off = not axis.still
            return
        if self.state != "enabled":
            axis.approach(0.0, 0.0, self.readings.friction, dt)
            if axis.still:
                axis.speed = 0.0
            return
        self._follow(dt)

    def _follow(self, dt):
        """Operation enabled: the active mode says what the shaft does."""
        axis, value = self.axis, self.acting
        up, down = value["RAMPacc"], value["RAMPdecel"]
        if self.mode_wanted is not None:
            axis.approach(0.0, up, down, dt)
            if axis.still:
                self._enter_mode(self.mode_wanted)
            return
        if self.halted:
            axis.approach(0.0, up, down, dt)
            self.reached = axis.still
            return
        if self.mode == 1:
            self._position(dt, up, down)
        elif self.mode == 6:
            self._home(dt, up, down)
        elif self.mode == -3:
            amps = value["CUR_I_target"] / 100.0 if value["CURreference"] == 2 else 0.0
            self._push(amps, dt)
        else:
            wanted = self.wanted_speed()
            if self.mode == -4 and self.readings.speed_ramps == "none":
                up = down = 20000.0
            limit = self.readings.load_limit or abs(wanted)
            axis.approach(max(-limit, min(limit, wanted)), up, down, dt)
            self.reached = abs(axis.speed - wanted) < 1.0

    def _push(self, amps, dt):
        """Current control: 250 1/min/s for every ampere, less dry friction (60 1/min/s at most)."""
        axis, most = self.axis, self.acting["RAMPn_max"]
        free = axis.speed + amps * 250.0 * dt
        loss = math.copysign(min(min(60.0, self.readings.friction) * dt, abs(free)), free)
        axis.speed = max(-most, min(most, free - loss))
        axis.turns += axis.speed / 60.0 * dt
        self.reached = True

    def wanted_speed(self):
        """1/min that the active mode asks for without any start bit."""
        value, most = self.acting, self.acting["RAMPn_max"]
        wanted = 0.0
        if self.mode == 3:
            wanted = value["PVn_target"]
        elif self.mode == -4:
            wanted = {0: 0.0, 1: self.readings.analog, 2: value["SPEEDn_target"]}[value["SPEEDreference"]]
        elif self.mode == -2 and value["GEARreference"]:
            wanted = self.readings.gear_input * value["GEARnum"] / value["GEARdenom"]
        elif self.mode == -1 and value["JOGactivate"]:
            speed = value["JOGn_fast"] if value["JOGactivate"] & 4 else value["JOGn_slow"]
            wanted = -speed if value["JOGactivate"] & 2 else speed
        elif self.mode == -3 and value["CURreference"] == 2:
            wanted = value["CUR_I_target"]  # not 1/min, but not nothing either
        return max(-most, min(most, wanted))

    def _position(self, dt, up, down):
        axis = self.axis
        if self.start is None:
            axis.approach(0.0, up, down, dt)
            return
        left = self.start - axis.turns
        # v in 1/min, a in 1/min/s: way of braking in turns is v * v / (2 * a * 60).
        may = math.sqrt(2.0 * down * 60.0 * abs(left))
        wanted = math.copysign(min(self.acting["PPn_target"], self.acting["RAMPn_max"], may), left)
        axis.approach(wanted, up, max(down, 1.0) * 1.5, dt)
        if abs(self.start - axis.turns) < 0.002 and abs(axis.speed) < 30.0:
            axis.turns, axis.speed = self.start, 0.0
            self.start, self.reached = None, True

    def _home(self, dt, up, down):
        """Towards a limit switch two turns away, off it again, zero."""
        axis = self.axis
        if self.homing is None:
            axis.approach(0.0, up, down, dt)
            return
        phase, edge, sign = self.homing
        if phase == "search":
            axis.approach(sign * self.acting["HMn"], up, down, dt)
            if (axis.turns - edge) * sign >= 0:
                self.homing = ("clear", edge, sign)
        else:
            axis.approach(-sign * self.acting["HMn_out"], up, max(down, 5000), dt)
            if (axis.turns - edge) * sign < -0.02:
                self.homing = None
                axis.turns = axis.speed = 0.0
                self.homed = self.reached = True

    # ---- the state machine

    def status(self):
        word = STATE_BITS[self.state]
        if self.readings.no_mains == "mains":
            word |= 0x10
        word |= 0x200
        reached = self.reached if self.state == "enabled" else self.readings.reached_disabled == "1"
        word |= 0x400 if reached else 0
        if self.mode == 6 and self.homed:
            word |= 0x1000
        if self.mode == 1 and self.state == "enabled" and self.control_word & 0x10:
            word |= 0x1000
        if self.readings.family_bits == "lxm32":
            word |= 0x4000 if self.axis.still else 0
            word |= 0x8000 if self.homed else 0
        return word | self.readings.status_high << 16

    def control(self, word):
        """A new DCOMcontrol: table H of CiA 402, as the manual's examples use it."""
        if word not in PRINTED_CONTROL and word not in KNOWN_CONTROL:
            self.sin("control value not printed", f"{word:04X} in {self.state}")
        before, self_state = self.control_word, self.state
        rising = word & ~before
        if self_state == "fault":
            if rising & 0x80:
                if not self.fault_curable:
                    raise Refused("state")
                self._become("switch-on disabled")
            self.control_word = word
            return
        if self_state == "fault reaction":
            self.control_word = word
            return
        command = ("disable voltage" if not word & 2 else "quick stop" if not word & 4
                   else "shutdown" if not word & 1 else "switch on" if not word & 8 else "enable")
        self._transition(command)
        self.control_word = word
        if self.state == "enabled":
            self.halted = bool(word & 0x100) and self.readings.halt == "honoured"
            if rising & 0x10:
                self._start_bit(word)

    def _transition(self, command):
        state = self.state
        if state == "switch-on disabled":
            if command == "shutdown":
                self._become("ready")
            elif command in ("switch on", "enable"):
                self.sin("short cut", f"{command} in switch-on disabled")
                if self.readings.short_cut == "refused":
                    raise Refused("state")
        elif state in ("ready", "switched on"):
            self._from_ready(command)
        elif state == "enabled":
            self._from_enabled(command)
        elif state == "quick stop":
            if command == "disable voltage":
                self._stop_to("switch-on disabled")
            elif command == "enable" and self.readings.quick_stop_enable == "returns":
                self._become("enabled")

    def _from_ready(self, command):
        if command in ("disable voltage", "quick stop"):
            self.enabling = None
            self._become("switch-on disabled")
        elif command == "shutdown":
            self.enabling = None
            self._become("ready")
        elif command == "switch on":
            self.enabling = None
            self._become("switched on")
        elif command == "enable":
            if self.readings.no_mains == "no-mains":
                raise Refused("power")
            direct = self.state == "switched on" or self.readings.enable_steps == "both"
            self._become("switched on")
            if direct and self.enabling is None:
                if not self.axis.still:
                    self.sin("enable while turning", f"at {self.axis.speed:.0f} 1/min")
                self.enabling = self.now + self.readings.enable_delay / 1000.0

    def _enabled(self):
        self.enabling = None
        self.braking_off = False
        self._become("enabled")
        self.reached = False
        self.halted = False
        self.start = self.homing = None
        if self.readings.mode_before_enable == "waits" and self.value["DCOMopmode"]:
            self.mode = self.value["DCOMopmode"]
        if abs(self.wanted_speed()) >= 1:
            self.sin("enabled with a leftover setpoint",
                     f"mode {self.mode} asks for {self.wanted_speed():.0f} at once")

    def _from_enabled(self, command):
        if command == "disable voltage":
            self._stop_to("switch-on disabled")
        elif command == "quick stop":
            self._stop_to("quick stop")
        elif command == "shutdown":
            self._stop_to("ready")
        elif command == "switch on":
            if not self.axis.still:
                if self.readings.control7 == "refused":
                    raise Refused("state")
                if self.readings.control7 == "brakes":
                    self.braking_off = True
            self._stop_to("switched on")

    def _stop_to(self, state):
        self._soon(self.readings.disable_delay, lambda: self._become(state))

    def _start_bit(self, word):
        """Rising bit 4: modes 1 and 6 begin."""
        if self.mode == 1:
            if not self.axis.still:
                self.sin("start while moving", f"control {word:04X} at {self.axis.speed:.0f} 1/min")
            target = self.value["PPp_targetusr"] / self.readings.usr_per_rev
            relative = bool(word & 0x40) == (self.readings.bit6 == "relative")
            self.reached = False
            self.start = target + (self.axis.turns if relative else 0.0)
            self.event(f"starts to {self.start:.3f} turns ({'relative' if relative else 'absolute'})")
        elif self.mode == 6:
            self.reached = self.homed = False
            method = self.value["HMmethod"]
            if method == 35:
                self.axis.turns, self.homed, self.reached = 0.0, True, True
                return
            sign = -1 if method in (1, 17, *range(11, 15), *range(27, 31), 33) else 1
            self.homing = ("search", self.axis.turns + 2 * sign, sign)

    def _set_mode(self, mode):
        if self.state != "enabled":
            if self.readings.mode_before_enable == "refused":
                raise Refused("state")
            if self.readings.mode_before_enable == "acts":
                self._enter_mode(mode)
            return
        if mode == self.mode:
            return
        if not self.axis.still:
            self.sin("mode change while turning",
                     f"{self.mode} -> {mode} at {self.axis.speed:.0f} 1/min")
            if self.readings.mode_change_turning == "refused":
                raise Refused("state")
            if self.readings.mode_change_turning == "brakes-first":
                self.mode_wanted = mode
                return
        self._soon(self.readings.setpoint_lag, lambda: self._enter_mode(mode))

    def _enter_mode(self, mode):
        self.mode_wanted = None
        if mode == self.mode:
            return
        self.event(f"mode {self.mode} -> {mode}")
        self.mode = mode
        self.start = self.homing = None
        self.reached = False
        if self.readings.setpoints == "zeroed":
            self._zero_setpoints()
        if self.state == "enabled" and abs(self.wanted_speed()) >= 1:
            self.sin("mode entered with a leftover setpoint",
                     f"mode {mode} asks for {self.wanted_speed():.0f} at once")

    # ---- parameters

    def read(self, address):
        row = PARAMETERS.get(address)
        if row is None:
            raise Refused("address")
        if row.name == "DCOMstatus":
            return self.status()
        if row.name == "_DCOMopmd_act":
            return self.mode
        if row.name == "_p_act":
            waver = 0
            if self.readings.dither:
                waver = int(self.now * 1000) // 7 % (2 * self.readings.dither + 1) - self.readings.dither
            return _wrap(round(self.axis.turns * self.readings.usr_per_rev) + waver)
        if row.name.startswith("FLT_"):
            return self._fault_row(row.name)
        return self.value[row.name]

    def _fault_row(self, name):
        column = ("FLT_err_num", "FLT_class", "FLT_Time", "FLT_Qual").index(name)
        newest = list(reversed(self.faults))
        if self.readings.fault_number == "next" and column == 0:
            self.fault_pointer = self.fault_pointer % (len(newest) + 1) + 1
        index = self.fault_pointer - 1 if self.readings.fault_number == "next" else 0
        return newest[index][column] if 0 <= index < len(newest) else 0

    def check(self, address, value):
        """Whether a value may be written now, without writing it."""
        row = PARAMETERS.get(address)
        if row is None:
            raise Refused("address")
        if not row.writable:
            raise Refused("read-only")
        if not row.takes(value):
            raise Refused("value")
        if row.name in ("PVn_target", "SPEEDn_target") and self.readings.limits == "refused":
            if abs(value) > self.value["RAMPn_max"]:
                raise Refused("value")
        if row.name.startswith("RAMP") and not self.axis.still:
            if value != self.value[row.name]:
                self.sin("ramp changed while turning", f"{row.name} at {self.axis.speed:.0f} 1/min")
            if self.readings.ramps_turning == "refused":
                raise Refused("state")
        if row.name == "MBnode_guard" and self.state == "enabled":
            if self.readings.guard_write == "not-enabled":
                raise Refused("state")
        mode = SETPOINT_OF.get(row.name)
        if mode is not None and self.state == "enabled" and self.mode != mode and value:
            self.sin("setpoint in the wrong mode", f"{row.name}={value} in mode {self.mode}")

    def write(self, address, value):
        self.check(address, value)
        name = PARAMETERS[address].name
        if name == "DCOMcontrol":
            self.control(value)
            self.value[name] = value
            return
        if name == "DCOMopmode":
            self._set_mode(value)
            self.value[name] = value
            return
        old = self.value[name]
        self.value[name] = value
        if name in LINE_SETTINGS:
            self.event(f"{name} {old} -> {value}")
            when = self.readings.order_when if name == "MBdword_order" else self.readings.line_when
            if when == "at-once":
                self._soon(1, lambda: self.in_force.__setitem__(name, value))
        self._soon(self.readings.setpoint_lag, lambda: self.acting.__setitem__(name, value))

    # ---- function codes (5.2)

    def serve(self, pdu, broadcast=False):
        """A request with a right check value: does it, and gives the reply or None."""
        self.counters[11] += 1
        code = pdu[0]
        if self.listen_only:
            if code == 8 and pdu[1:3] == b"\0\1":
                self.listen_only = False
            return None
        if self.readings.guard_fed_by == "all" or code in (16, 23):
            self.fed = self.now
        try:
            reply = self._function(code, pdu)
        except Refused as refused:
            self.sync_error = NUMBER[refused.case]
            self.counters[13] += 1
            self.event(f"refused: {refused.case}: {pdu.hex(' ')}")
            fitting = FITTING[refused.case]
            answer = fitting if self.readings.exceptions == "fitting" else int(self.readings.exceptions)
            middle = b"\x0e" if code == 43 else b""
            reply = bytes([code | 0x80]) + middle + bytes([answer])
        return None if broadcast else reply

    def _function(self, code, pdu):
        if code == 3:
            return self._fc3(pdu)
        if code == 8:
            return self._fc8(pdu)
        if code == 16:
            return self._fc16(pdu)
        if code == 23:
            return self._fc23(pdu)
        if code == 43:
            return self._fc43(pdu)
        self.sin("function code not in 5.2", str(code))
        raise Refused("function")

    def _pairs(self, start, count):
        """The addresses of `count` registers: pairs only, all of them known."""
        if start % 2 or count % 2:
            self.sin("odd address or count", f"{start} x {count}")
        if start % 2:
            raise Refused("address")
        if count % 2 or not 2 <= count <= 124:
            raise Refused("count")
        addresses = range(start, start + count, 2)
        if any(address not in PARAMETERS for address in addresses):
            raise Refused("address")
        return addresses

    def _words(self, value):
        raw = struct.pack(">i", _wrap(value))
        return raw if self.in_force["MBdword_order"] == 0 else raw[2:] + raw[:2]

    def _value(self, raw):
        ordered = raw if self.in_force["MBdword_order"] == 0 else raw[2:] + raw[:2]
        return struct.unpack(">i", ordered)[0]

    def _fc3(self, pdu):
        start, count = struct.unpack(">HH", pdu[1:5])
        data = b"".join(self._words(self.read(address)) for address in self._pairs(start, count))
        return bytes([3, len(data)]) + data

    def _write_many(self, addresses, data):
        values = [self._value(data[4 * i:4 * i + 4]) for i in range(len(addresses))]
        if self.readings.fc16_refused == "nothing":
            for address, value in zip(addresses, values):
                self.check(address, value)
        for address, value in zip(addresses, values):
            self.write(address, value)

    def _fc16(self, pdu):
        start, count, size = struct.unpack(">HHB", pdu[1:6])
        if size != 2 * count or len(pdu) != 6 + size:
            raise Refused("count")
        self._write_many(self._pairs(start, count), pdu[6:])
        return pdu[:5]

    def _fc23(self, pdu):
        rstart, rcount, wstart, wcount, size = struct.unpack(">HHHHB", pdu[1:10])
        if size != 2 * wcount or len(pdu) != 10 + size:
            raise Refused("count")
        to_read, to_write = self._pairs(rstart, rcount), self._pairs(wstart, wcount)
        if self.readings.fc23_first == "writes":
            self._write_many(to_write, pdu[10:])
        data = b"".join(self._words(self.read(address)) for address in to_read)
        if self.readings.fc23_first == "reads":
            self._write_many(to_write, pdu[10:])
        return bytes([23, len(data)]) + data

    def _fc8(self, pdu):
        sub, data = struct.unpack(">HH", pdu[1:5])
        if sub == 0:
            return pdu
        if sub not in (1, 2, 4, 10, 11, 12, 13, 16, 17, 18):
            self.sin("reserved sub-function of FC8", str(sub))
            raise Refused("sub-function")
        if data and sub != 1:
            raise Refused("value")
        if sub == 1:
            self.sin("communication restarted", f"data {data:04X}")
            if self.readings.fc8_restart == "applies":
                self.in_force = {name: self.value[name] for name in LINE_SETTINGS}
            return pdu
        if sub == 4:
            self.sin("muted", "FC8 sub 4")
            self.listen_only = True
            return None
        if sub == 10:
            self.counters = dict.fromkeys(self.counters, 0)
            self.sync_error = 0
            return pdu
        answer = self.sync_error if sub == 2 else self.counters[sub] & 0xFFFF
        return pdu[:3] + struct.pack(">H", answer)

    def _fc43(self, pdu):
        if self.readings.fc43 == "silent":
            return None
        if self.readings.fc43 == "refused":
            raise Refused("function")
        if pdu[1] != 14:
            raise Refused("function")
        if pdu[2] != 1 or pdu[3] != 0:
            raise Refused("value")
        product = b"LXM05AD10M2" if self.readings.product == "lxm05" else b"AC10M2-0001"
        objects = ((0, b"TELEMECANIQUE"), (1, product), (self.readings.revision_id, b"V02.001"))
        body = b"".join(bytes([number_, len(text)]) + text for number_, text in objects)
        return bytes([43, 14, 1, 2, 0, 0, len(objects)]) + body


def _wrap(value):
    return (int(value) + 2**31) % 2**32 - 2**31


def reading_fields():
    """The fields of `Readings`, for a command line."""
    return fields(Readings)
