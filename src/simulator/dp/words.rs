//! Control and status word of ProfiDrive mode (manual 4.1.2).

use super::inverter::Order;
use super::readings::{Reading, Readings};

/// Bits of STW (4.1.2.1).
const ON1: u16 = 1;
const ON2: u16 = 1 << 1;
const ON3: u16 = 1 << 2;
const ENABLE: u16 = 1 << 3;
const RAMP: u16 = 1 << 4;
const RAMP_GOES: u16 = 1 << 5;
const SETPOINT: u16 = 1 << 6;
const ACKNOWLEDGE: u16 = 1 << 7;
const JOG: u16 = 3 << 8;
pub(crate) const CONTROL: u16 = 1 << 10;
const REVERSE: u16 = 1 << 11;
pub(crate) const TERMINALS_START: u16 = 1 << 12;
pub(crate) const TERMINALS_SETPOINT: u16 = 1 << 13;

/// What of the words outlives a cycle.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Machine {
    pub(crate) stw: u16,
    pub(crate) hsw: i16,
    /// A word with bits 1 and 2 and without bit 0 was there: an edge of bit 0 may start.
    armed: bool,
    runs: bool,
    /// Any bit was set since power-on.
    is_awake: bool,
}

/// What the status word is made of besides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub(crate) trip: bool,
    /// Output frequency and setpoint, 0.01 Hz.
    pub(crate) frequency: i64,
    pub(crate) setpoint: i64,
    /// P.928 is 1.
    pub(crate) right: bool,
}

impl Machine {
    /// Takes new words; whether a trip is acknowledged by them.
    pub(crate) fn take(&mut self, stw: u16, hsw: i16, right: bool, readings: Readings) -> bool {
        let before = std::mem::replace(&mut self.stw, stw);
        self.hsw = hsw;
        self.is_awake |= stw != 0;
        let has = |bits: u16| stw & bits == bits;
        let edge = has(CONTROL | ACKNOWLEDGE) && before & ACKNOWLEDGE == 0;
        if !has(CONTROL) {
            return false;
        }
        let begins = self.armed || readings.has(Reading::RunsFromRest);
        self.armed = has(ON2 | ON3) && !has(ON1) || self.armed && has(ON2 | ON3 | ON1) && !self.runs;
        if !has(ON1 | ON2 | ON3) {
            self.runs = false;
        } else if begins && right && stw & TERMINALS_START == 0 {
            self.runs = true;
        } else if !right && !readings.has(Reading::RightStarts) {
            // A start word without the right to control wears its edge out.
            self.armed = false;
        }
        edge
    }

    /// A trip takes the run away, and a new edge is needed.
    pub(crate) fn trips(&mut self) {
        self.runs = false;
        self.armed = false;
    }

    /// Setpoint, 0.01 Hz: 4000h is 100 % (4.1.2.3).
    pub(crate) fn setpoint(&self, full: i64, readings: Readings) -> i64 {
        let word = i64::from(self.hsw).clamp(-0x4000, 0x4000);
        let word = if readings.has(Reading::UnsignedSetpoint) { word.max(0) } else { word };
        let frequency = word * full / 0x4000;
        if self.stw & REVERSE == 0 { frequency } else { -frequency }
    }

    /// What the words want of the motor (4.1.2.1).
    pub(crate) fn order(&self, full: i64, jog: i64, readings: Readings) -> Order {
        let has = |bits: u16| self.stw & bits == bits;
        let (off2, off3) = match readings.has(Reading::ProfidriveOff) {
            true => (Order::Coast, Order::Brake),
            false => (Order::Stop, Order::Coast),
        };
        match () {
            () if !has(ON3) => off3,
            () if !has(ON2) => off2,
            () if !self.runs && self.stw & JOG != 0 => Order::Run(if has(REVERSE) { -jog } else { jog }),
            () if !self.runs || !has(ENABLE | SETPOINT) => Order::Stop,
            () if !has(RAMP) => Order::Run(0),
            () if !has(RAMP_GOES) => Order::Hold,
            () => Order::Run(self.setpoint(full, readings)),
        }
    }

    /// The status word (4.1.2.2).
    pub(crate) fn status(&self, seen: Seen, readings: Readings) -> u16 {
        if self.stw & CONTROL == 0 {
            return 0;
        }
        let has = |bits: u16| self.stw & bits == bits;
        let terminals = has(TERMINALS_START);
        let reached = seen.frequency == seen.setpoint
            && (seen.setpoint != 0 || seen.frequency != 0 || self.runs || readings.has(Reading::AtRestIsReached));
        let bits = [
            has(ON2 | ON3) || terminals,
            (has(ON1 | ON2 | ON3) || terminals) && !seen.trip,
            has(ON1 | ON2 | ON3 | ENABLE) && !terminals && !seen.trip,
            seen.trip,
            has(ON2) || terminals,
            has(ON3) || terminals,
            !self.is_awake,
            false,
            reached,
            seen.right && !terminals && self.stw & TERMINALS_SETPOINT == 0,
            reached,
        ];
        bits.iter().enumerate().filter(|(_, set)| **set).fold(0, |word, (bit, _)| word | 1 << bit)
    }
}
