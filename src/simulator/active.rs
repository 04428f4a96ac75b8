//! The drive behind the line: parameters, data sets, actual values, faults and warnings of an ACT or ACU.
//!
//! Order of the checks of an access, where the manual names none: parameter (11), data set (2), width (10, 14),
//! direction (3, 4), running (8), value (1). Only a refusal with exception 4 leaves its cause in P.11
//! (CM-485 manual 6.6).
//!
//! All frequencies have two decimals, also those of which no source says it (217, 241): so do all that are printed
//! (CM-485 manual 10.2.3). Percentages likewise.

use super::machine::{Control, Inputs, Machine, State};
use super::shaft::Ramps;
use super::spec::{Spec, specs};
use super::store::Store;
use crate::profile::value::{from_wire, to_wire};
use crate::profile::{Family, Type};
use crate::protocol::modbus::pdu::ParamAddress;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// Causes that P.11 tells (CM-485 manual 6.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    Value = 1,
    Set = 2,
    WriteOnly = 3,
    ReadOnly = 4,
    Running = 8,
    SetsDiffer = 9,
    Type = 10,
    Unknown = 11,
    Width = 14,
}

/// Width of an access: function codes 3 and 6, or 100 and 101.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Width {
    Word,
    Long,
}

/// What follows a write once the reply is out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    None,
    /// Software reset.
    Reset,
}

/// Wires at the terminals of the drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Contacts {
    /// S1IND on an ACT; STOA and STOB on an ACU (CM-485 manual 9, 10).
    pub(super) enable: bool,
    /// S2IND.
    pub(super) right: bool,
    /// S3IND.
    pub(super) left: bool,
    pub(super) mains: bool,
}

/// Watchdog RS232/RS485 (CM-485 manual 6.9).
const WATCHDOG: u16 = 0x2010;
/// Value of P.34 that restarts the software (CM-485 manual 5.2.1).
const RESTART: i64 = 123;
/// Slopes that P.420-423 would give; nothing in the store tells their factory setting: 5 Hz/s on this bench.
const RAMPS: Ramps = Ramps::all(500);
/// Warnings that also set bit 15: Ixt, heat sink, inside, motor temperature, mains phase (CM-485 manual 9.1.1).
const CRITICAL: u16 = 0x0001 | 0x0002 | 0x0004 | 0x0008 | 0x0010 | 0x0080 | 0x0100;

/// An ACT or ACU without its line.
#[derive(Clone, Debug)]
pub(super) struct Active {
    acu: bool,
    specs: BTreeMap<u32, Spec>,
    store: Store,
    /// Actual values that the bench file holds still.
    pinned: BTreeSet<u32>,
    contacts: Contacts,
    machine: Machine,
    register: u16,
    warnings: u16,
    /// Last correct exchange that the watchdog counts from.
    heard: Option<Tick>,
    /// The last line setpoint that was not 0 was negative (CM-485 manual 9.2.1).
    backwards: bool,
}

impl Active {
    /// A drive with its factory settings and the bench's own values on top: number, data set (0 for all), raw value.
    pub(super) fn new(
        acu: bool,
        family: Option<&Family>,
        modules: &[String],
        contacts: Contacts,
        values: &[(u32, u8, i64)],
    ) -> Self {
        let specs = family.map(|family| specs(family, modules)).unwrap_or_default();
        let mut active = Active {
            acu,
            store: Store::default(),
            pinned: BTreeSet::new(),
            contacts,
            machine: Machine::new(Tick::ZERO),
            register: 0,
            warnings: 0,
            heard: None,
            backwards: false,
            specs,
        };
        for (&number, spec) in &active.specs {
            for set in cells(spec, 0) {
                match spec.volatile {
                    true => active.store.equip_volatile((number, set), spec.factory),
                    false => active.store.equip((number, set), spec.factory),
                }
            }
        }
        for &(number, set, value) in values {
            let Some(spec) = active.specs.get(&number) else { continue };
            for set in cells(spec, set) {
                active.store.equip((number, set), value);
            }
            active.pinned.insert(number);
        }
        active.power_up(Tick::ZERO);
        active
    }

    /// Power-on or software reset: RAM from EEPROM, no fault, no warning, shaft at rest. The watchdog waits for the
    /// first telegram.
    pub(super) fn power_up(&mut self, now: Tick) {
        self.store.power_up();
        self.machine = Machine::new(now);
        self.register = 0;
        self.warnings = 0;
        self.heard = None;
        self.backwards = false;
        self.react(now);
    }

    /// Reads a parameter; the bits for the wire.
    pub(super) fn read(&mut self, now: Tick, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        self.catch_up(now);
        let result = self.try_read(address, width);
        match result {
            Ok(_) if address.number() == 11 => self.register = 0,
            Ok(_) => {}
            Err(cause) => self.register = cause as u16,
        }
        result
    }

    fn try_read(&self, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        let number = u32::from(address.number());
        let spec = self.spec(address, width)?;
        if !spec.access.reads() {
            return Err(Cause::WriteOnly);
        }
        let value = match self.actual(number) {
            Some(value) => value,
            None => self.cell_value(number, spec, address.set())?,
        };
        // What does not fit is cut off, as in the registers of a drive.
        Ok(to_wire(value, spec.kind).unwrap_or(value as u32))
    }

    /// The value of the copy that a data set stands for: 0-4 EEPROM, 5-9 RAM (CM-485 manual 7).
    fn cell_value(&self, number: u32, spec: &Spec, set: u8) -> Result<i64, Cause> {
        let from_ram = spec.volatile || set >= 5;
        let mut values = cells(spec, set % 5).map(|set| match from_ram {
            true => self.store.ram((number, set)),
            false => self.store.eeprom((number, set)),
        });
        let first = values.next().flatten().ok_or(Cause::Set)?;
        if values.any(|value| value != Some(first)) { Err(Cause::SetsDiffer) } else { Ok(first) }
    }

    /// Writes a parameter.
    pub(super) fn write(&mut self, now: Tick, address: ParamAddress, width: Width, bits: u32) -> Result<Effect, Cause> {
        self.catch_up(now);
        let result = self.try_write(address, width, bits);
        match result {
            Ok(_) => self.react(now),
            Err(cause) => self.register = cause as u16,
        }
        result
    }

    fn try_write(&mut self, address: ParamAddress, width: Width, bits: u32) -> Result<Effect, Cause> {
        let (number, set) = (u32::from(address.number()), address.set());
        let spec = self.spec(address, width)?.clone();
        if !spec.access.writes() {
            return Err(Cause::ReadOnly);
        }
        if spec.locked && self.machine.runs() {
            return Err(Cause::Running);
        }
        let value = from_wire(bits, spec.kind, spec.min);
        let no_brake = number == 392 && value == 1 && !self.brakes();
        if !spec.takes(value) || no_brake {
            return Err(Cause::Value);
        }
        if number == 34 && value == RESTART {
            return Ok(Effect::Reset);
        }
        if number == 484 && value != 0 {
            self.backwards = value < 0;
        }
        let (in_ram, targets) = (spec.volatile || set >= 5, cells(&spec, set % 5));
        for target in targets {
            match in_ram {
                true => self.store.write_ram((number, target), value),
                false => self.store.write_eeprom((number, target), value),
            }
        }
        Ok(Effect::None)
    }

    /// The row that an access concerns, if number, data set and width are right.
    fn spec(&self, address: ParamAddress, width: Width) -> Result<&Spec, Cause> {
        let number = address.number();
        let known = self.specs.get(&u32::from(number)).filter(|_| number <= ParamAddress::LAST_NUMBER);
        let spec = known.ok_or(Cause::Unknown)?;
        if address.set() > ParamAddress::LAST_SET || (!spec.four && !address.set().is_multiple_of(5)) {
            return Err(Cause::Set);
        }
        match (spec.kind, width) {
            (Type::String, _) => Err(Cause::Type),
            (Type::Long, Width::Long) => Ok(spec),
            (Type::Long, Width::Word) | (_, Width::Long) => Err(Cause::Width),
            (_, Width::Word) => Ok(spec),
        }
    }

    /// DC braking only where the configuration is a V/f one (CM-485 manual 9.1.2.2).
    fn brakes(&self) -> bool {
        self.value(30) / 100 == 1
    }

    /// A correct exchange with this drive has taken place.
    pub(super) fn heard(&mut self, at: Tick) {
        self.heard = Some(at);
    }

    /// When something will happen by itself: the watchdog, or the end of a stop.
    pub(super) fn next(&self) -> Option<Tick> {
        [self.watchdog(), self.machine.next()].into_iter().flatten().min()
    }

    fn watchdog(&self) -> Option<Tick> {
        let seconds = u64::try_from(self.value(413)).ok().filter(|&seconds| seconds > 0)?;
        Some(self.heard? + Span::from_secs(seconds))
    }

    /// Lets the time pass.
    pub(super) fn catch_up(&mut self, now: Tick) {
        if let Some(at) = self.watchdog().filter(|&at| at <= now) {
            self.machine.settle(at, &self.inputs());
            self.machine.trip(at, WATCHDOG);
            self.heard = None;
        }
        let inputs = self.inputs();
        self.machine.settle(now, &inputs);
    }

    fn react(&mut self, now: Tick) {
        let inputs = self.inputs();
        self.machine.react(now, &inputs);
    }

    pub(super) fn trip(&mut self, now: Tick, code: u16) {
        self.catch_up(now);
        self.machine.trip(now, code);
    }

    /// Sets the warning word; bit 0 goes with bit 1 or 2 (CM-485 manual 12.1).
    pub(super) fn warn(&mut self, word: u16) {
        self.warnings = if word & 0x0006 != 0 { word | 1 } else { word };
    }

    /// Changes wires at the terminals.
    pub(super) fn wire(&mut self, now: Tick, change: impl FnOnce(&mut Contacts)) {
        self.catch_up(now);
        change(&mut self.contacts);
        self.react(now);
    }

    /// EEPROM cells written.
    pub(super) fn eeprom_writes(&self) -> u64 {
        self.store.writes()
    }

    /// Raw value of the EEPROM copy; data set 0 of a switchable parameter only if all four are the same.
    pub(super) fn eeprom(&self, number: u32, set: u8) -> Option<i64> {
        let spec = self.specs.get(&number).filter(|spec| !spec.volatile && set <= 4)?;
        self.cell_value(number, spec, set).ok()
    }

    /// Raw value of the RAM copy, by the data set 0-4 or by its RAM number 5-9.
    pub(super) fn ram(&self, number: u32, set: u8) -> Option<i64> {
        let spec = self.specs.get(&number).filter(|_| set <= ParamAddress::LAST_SET)?;
        self.actual(number).or_else(|| self.cell_value(number, spec, set % 5 + 5).ok())
    }

    /// The value that the drive works with: RAM copy of the active data set; 0 for what it has not.
    pub(super) fn value(&self, number: u32) -> i64 {
        let set = match self.specs.get(&number) {
            Some(spec) if spec.four => self.active_set(),
            _ => 0,
        };
        self.store.ram((number, set)).unwrap_or(0)
    }

    /// P.249: P.414 if it is 1-4, else data set 1, because no input of the bench switches sets (CM-485 manual 9).
    fn active_set(&self) -> u8 {
        match self.store.ram((414, 0)) {
            Some(set @ 1..=4) => set as u8,
            _ => 1,
        }
    }

    /// The internal reference channel stands still at what the bench file says for P.228.
    fn reference(&self) -> i64 {
        let (internal, line) = (self.value(228), self.value(484));
        let sum = match self.value(434) {
            1 => internal,
            2 if self.backwards => line.min(-self.value(418)),
            2 => line.max(self.value(418)),
            _ => internal.saturating_add(line),
        };
        let contacts = self.inputs_of_contacts();
        if contacts.0 == Control::Contacts && contacts.3 && !contacts.2 { sum.saturating_neg() } else { sum }
    }

    /// Who commands, and enable, right, left as they reach the state machine.
    fn inputs_of_contacts(&self) -> (Control, bool, bool, bool) {
        let Contacts { enable, right, left, .. } = self.contacts;
        let bit = |number: u8| self.value(410) >> number & 1 == 1;
        match self.value(412) {
            0 => (Control::Contacts, enable, right, left),
            1 => (Control::StateMachine, enable, right, left),
            2 => (Control::Contacts, enable && bit(0), bit(1), bit(2)),
            _ => (Control::Keypad, enable, right, left),
        }
    }

    fn inputs(&self) -> Inputs {
        let (control, enable, right, left) = self.inputs_of_contacts();
        let limit = self.value(419).max(0);
        let tenths = |number| Span::from_millis(u64::try_from(self.value(number)).unwrap_or(0) * 100);
        Inputs {
            acu: self.acu,
            control,
            word: self.value(410) as u16,
            enable,
            right,
            left,
            mains: self.contacts.mains,
            positioning: self.acu && self.value(30) % 100 == 40,
            goal: self.reference().clamp(-limit, limit),
            ramps: RAMPS,
            quick_ramps: Ramps { down_right: self.value(424), down_left: self.value(425), ..RAMPS },
            transition5: self.value(392),
            threshold: limit * self.value(637) / 1_000,
            holding: tenths(638),
            braking: tenths(632),
        }
    }

    /// Values that the drive works out; `None` for everything that is simply stored.
    fn actual(&self, number: u32) -> Option<i64> {
        if self.pinned.contains(&number) {
            return None;
        }
        let shaft = &self.machine.shaft;
        let pole_pairs = self.value(373).max(1);
        let rated = self.value(375).max(1);
        let load = shaft.output().abs() * 100 / rated;
        Some(match number {
            11 => i64::from(self.register),
            210 => shaft.output(),
            // A bench motor: 1.5 A without load, 2 A more and 60 % of the rated power at rated frequency.
            211 if shaft.powered() => 15 + load * 20 / 100,
            211 => 0,
            213 => self.value(376) * load * 6 / 1_000,
            217 | 241 => shaft.speed(),
            218 => shaft.speed() * 60 / (100 * pole_pairs),
            219 => shaft.speed().abs(),
            220 => shaft.speed().abs() * 60 / (100 * pole_pairs),
            229 => self.value(524),
            249 => i64::from(self.active_set()),
            250 => self.digital_inputs(),
            260 => i64::from(self.machine.fault),
            270 => i64::from(self.warnings),
            282 => self.value(484),
            283 => shaft.output(),
            411 => i64::from(self.status()),
            _ => return None,
        })
    }

    fn digital_inputs(&self) -> i64 {
        let Contacts { enable, right, left, .. } = self.contacts;
        let hardware = i64::from(enable) | i64::from(right) << 1 | i64::from(left) << 2;
        match self.value(412) {
            // CM-485 manual 9.1.3: the bits of the control word, if enabled by hardware and bit 0.
            2 if enable && self.value(410) & 1 == 1 => self.value(410) & 0x3FF,
            2 => 0,
            _ => hardware,
        }
    }

    fn status(&self) -> u16 {
        let inputs = self.inputs();
        let reference = self.reference();
        // P.549 in percent of P.419 - P.418 (facts B).
        let band = (self.value(419) - self.value(418)).abs().saturating_mul(self.value(549)) / 10_000;
        let reached = (reference - self.machine.shaft.speed()).abs() <= band;
        let remote_contacts = self.value(412) == 2 && self.contacts.enable;
        self.machine.status(&inputs, reached, reference != inputs.goal)
            | u16::from(remote_contacts) << 9
            | u16::from(self.warnings != 0) << 7
            | u16::from(self.warnings & CRITICAL != 0) << 15
    }

    /// Whether a fault stands.
    pub(super) fn in_fault(&self) -> bool {
        self.machine.state == State::Fault
    }
}

/// Cells behind a data set 0-4 of a parameter: 0 means all four, if it has four.
fn cells(spec: &Spec, set: u8) -> std::ops::RangeInclusive<u8> {
    match (spec.four, set) {
        (true, 0) => 1..=4,
        (_, set) => set..=set,
    }
}
