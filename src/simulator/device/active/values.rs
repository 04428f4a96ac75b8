//! What a drive makes of its parameters, its terminals and the line: setpoints, the inputs of the state machine, actual
//! values, the status word.
//!
//! Choices where the manual is silent:
//! - the internal frequency channel stands still at what the bench file says for P.228, and the internal percentage at
//!   what it says for P.229, whatever P.475 and P.476 are; P.524 is always added to it (CM-485 manual 10.2.3), and the
//!   sum stays inside the range of P.229;
//! - P.418 limits the line setpoint with P.434 = 2 only, for which 9.2.1 names it; P.419 limits all three ways to form
//!   the setpoint, in both directions, and status bit 11 tells it;
//! - status bit 10 compares setpoint and actual frequency P.241, so a slip wider than P.549 keeps it away;
//! - in the V/f configurations nothing measures a coasting shaft: P.241 shows 0, and P.217 to 220, of encoders that sit
//!   on this shaft, show how it turns;
//! - the current limit (a torque above 150 %) takes the frequency down to 0 as long as it lasts, sets status bit 11 and
//!   bit 5 of P.270;
//! - STOB has no bit in P.250.

use super::machine::{Control, Inputs};
use super::readings::Reading;
use super::resolver::{Angle, Follows};
use super::setup::Contacts;
use super::state::Active;
use crate::simulator::device::motor::Motor;
use crate::simulator::device::shaft::Ramps;
use crate::tick::Span;

/// Warnings that also set bit 15: Ixt, heat sink, inside, motor temperature, mains phase (CM-485 manual 9.1.1).
const CRITICAL: u16 = 0x0001 | 0x0002 | 0x0004 | 0x0008 | 0x0010 | 0x0080 | 0x0100;
/// Warning I-Limit (CM-485 manual 12.1).
const CURRENT_LIMIT: u16 = 0x0020;
/// Warning Sysbus (EM-RES-03 manual 5.8.3).
const SYSTEM_BUS: u16 = 0x2000;
/// What takes its value from a source (EM-RES-03 manual 5.11.5.3).
const CONTROL_WORD_SOURCE: u32 = 99;
const RAMP_INPUT_SOURCE: u32 = 137;
/// Signal sources that are always on and always off (sources B).
const TRUE: i64 = 6;
const FALSE: i64 = 7;
/// Largest percentage, 0.01 % (CM-485 manual 11.1).
const MOST_PERCENT: i64 = 30_000;

/// Who commands, and what reaches the state machine of the wires, real or by control word.
struct Release {
    control: Control,
    enable: bool,
    right: bool,
    left: bool,
}

impl Active {
    /// What the state machine looks at.
    pub(crate) fn inputs(&self) -> Inputs {
        let Release { control, enable, right, left } = self.release();
        let limit = self.value(419).max(0);
        let tenths = |number| Span::from_millis(u64::try_from(self.value(number)).unwrap_or(0) * 100);
        Inputs {
            acu: self.acu,
            control,
            word: self.control_word() as u16,
            enable,
            right,
            left,
            mains: self.contacts.mains,
            positioning: self.acu && self.value(30) % 100 == 40,
            strict_remote: self.strict_remote,
            edge: self.has(Reading::ControlByEdge),
            reset_needs_remote: self.has(Reading::ResetNeedsRemote),
            goal: self.reference().clamp(-limit, limit),
            ramps: self.ramps,
            quick_ramps: Ramps { down_right: self.value(424), down_left: self.value(425), ..self.ramps },
            transition5: self.value(392),
            threshold: limit * self.value(637) / 1_000,
            holding: tenths(638),
            braking: tenths(632),
            motor: Motor::new(
                self.value(375),
                self.value(372),
                self.value(373),
                self.value(376),
                self.torque,
                !self.brakes(),
            ),
            follows: self.resolver.map_or(Follows::Setpoint, |resolver| resolver.follows(self.angle())),
        }
    }

    /// Where the drive looks for the rotor.
    fn angle(&self) -> Angle {
        Angle { offset: self.value(382), motor_pairs: self.value(373), resolver_pairs: self.value(381) }
    }

    /// P.219: what the resolver tells, also of a shaft that a hand turns.
    fn resolver_frequency(&self) -> i64 {
        let turns = match self.machine.shaft.powered() {
            true => self.machine.shaft.speed(),
            false => self.machine.shaft.speed() + self.hand,
        };
        let inverted = self.resolver.is_some_and(|resolver| resolver.inverted) != (self.value(492) == 1);
        if inverted { -turns } else { turns }
    }

    fn release(&self) -> Release {
        let enable = self.contacts.enable();
        let bit = |number: u8| self.control_word() >> number & 1 == 1;
        let control = match self.value(412) {
            0 | 2 => Control::Contacts,
            1 => Control::StateMachine,
            _ if self.has(Reading::OtherModesAreContacts) => Control::Contacts,
            _ => Control::Keypad,
        };
        // Remote contacts take the place of the terminals; the enable needs both (CM-485 manual 9.1.3, 10.1).
        let (enable, right, left) = match self.value(412) {
            2 => (enable && bit(0), bit(1), bit(2)),
            _ => (enable, self.contacts.right, self.contacts.left),
        };
        Release { control, enable, right: self.linked(68, right), left: self.linked(69, left) }
    }

    /// A start contact may be tied to "on" or "off" for good (CM-485 manual 9.1.2, 10.2: P.68, P.69), or to the system bus.
    fn linked(&self, number: u32, contact: bool) -> bool {
        match self.value(number) {
            TRUE => true,
            FALSE => false,
            _ => self.over_bus(number).map_or(contact, |value| value != 0),
        }
    }

    /// The control word that counts: P.99 may take it from the system bus (EM-RES-03 manual 5.11.5.3).
    pub(super) fn control_word(&self) -> i64 {
        let own = self.value(410);
        match self.over_bus(CONTROL_WORD_SOURCE) {
            Some(word) if self.has(Reading::LinkedWordIsBeside) => word | own,
            word => word.unwrap_or(own),
        }
    }

    /// The setpoint by P.434 (CM-485 manual 9.2.1, 10.2.3), 0.01 Hz.
    fn reference(&self) -> i64 {
        let (internal, line) = (self.value(228), self.value(484));
        let sum = match self.value(434) {
            1 => internal,
            2 if self.backwards => line.min(-self.value(418)),
            2 => line.max(self.value(418)),
            _ => internal.saturating_add(line),
        };
        let sum = self.over_bus(RAMP_INPUT_SOURCE).unwrap_or(sum);
        let release = self.release();
        let turned = release.control == Control::Contacts && release.left && !release.right;
        if turned { sum.saturating_neg() } else { sum }
    }

    /// Values that the drive works out; `None` for everything that is simply stored.
    pub(crate) fn actual(&self, number: u32) -> Option<i64> {
        if number == 229 {
            return Some(self.value(229).saturating_add(self.value(524)).clamp(-MOST_PERCENT, MOST_PERCENT));
        }
        if self.pinned.contains(&number) {
            return None;
        }
        let shaft = &self.machine.shaft;
        let per_minute = |frequency: i64| frequency.saturating_mul(60) / (100 * self.value(373).max(1));
        Some(match number {
            11 => i64::from(self.register),
            210 if !shaft.powered() && self.has(Reading::CoastShowsShaft) => shaft.speed(),
            210 => shaft.stator(),
            211 => shaft.current(),
            213 => shaft.power(),
            217 => shaft.speed(),
            218 => per_minute(shaft.speed()),
            219 => self.resolver_frequency(),
            220 => per_minute(shaft.speed()).abs(),
            235 => self.resolver.map_or(0, |resolver| resolver.flux_voltage(shaft.speed(), self.angle())),
            241 => self.actual_frequency(),
            249 => i64::from(self.active_set()),
            250 => self.digital_inputs(),
            253 => self.analog.shown(),
            260 => i64::from(self.machine.fault),
            270 => i64::from(self.all_warnings()),
            282 => self.value(484),
            283 => shaft.ramp(),
            411 => i64::from(self.status()),
            _ => return None,
        })
    }

    fn actual_frequency(&self) -> i64 {
        let shaft = &self.machine.shaft;
        if shaft.powered() || !self.brakes() { shaft.speed() } else { 0 }
    }

    fn digital_inputs(&self) -> i64 {
        let Contacts { sto_a, right, left, .. } = self.contacts;
        match self.value(412) {
            // CM-485 manual 9.1.3: the bits of the control word, if enabled by hardware and bit 0.
            2 if self.contacts.enable() && self.control_word() & 1 == 1 => self.control_word() & 0x3FF,
            2 => 0,
            _ => i64::from(sto_a) | i64::from(right) << 1 | i64::from(left) << 2,
        }
    }

    /// The drive is held back by its current limit.
    fn overloaded(&self) -> bool {
        let inputs = self.inputs();
        inputs.motor.overloaded() && self.machine.runs()
    }

    fn all_warnings(&self) -> u16 {
        let of = |stands: bool, bit: u16| if stands { bit } else { 0 };
        self.warnings | of(self.overloaded(), CURRENT_LIMIT) | of(self.links.emergency, SYSTEM_BUS)
    }

    pub(super) fn status(&self) -> u16 {
        let (inputs, reference, warnings) = (self.inputs(), self.reference(), self.all_warnings());
        // P.549 in percent of P.419 - P.418 (sources B).
        let band = (self.value(419) - self.value(418)).abs().saturating_mul(self.value(549)) / 10_000;
        let reached = (reference - self.actual_frequency()).abs() <= band;
        let limited = reference != inputs.goal || inputs.motor.overloaded();
        // With remote contacts the Remote bit shows the hardware enable alone (CM-485 manual 9.1.3).
        let remote_contacts = self.value(412) == 2 && self.contacts.enable();
        self.machine.status(&inputs, reached, limited)
            | u16::from(remote_contacts) << 9
            | u16::from(warnings != 0) << 7
            | u16::from(warnings & CRITICAL != 0) << 15
    }
}
