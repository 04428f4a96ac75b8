//! The drive behind the line: parameters, data sets, actual values, faults and warnings of an ACT or ACU.
//!
//! Order of the checks of an access, where the manual names none: parameter (11), data set (2), width (10, 14),
//! direction (3, 4), running (8), value (1). On Modbus only a refusal with exception 4 leaves its cause in P.11
//! (CM-485 manual 6.6), on VABus every NAK (facts A2).
//!
//! All frequencies have two decimals, also those of which no source says it (217, 241): so do all that are printed
//! (CM-485 manual 10.2.3). Percentages likewise.
//!
//! The parameters are here; what the drive makes of them is in `values.rs`.

mod values;

use super::machine::Machine;
use super::readings::{Reading, Readings};
use super::setup::{Model, Setup};
use super::shaft::Ramps;
use super::spec::{Spec, specs};
use super::store::{Cell, Store};
use crate::profile::value::{from_wire, to_wire};
use crate::profile::{Family, Type};
use crate::protocol::modbus::pdu::ParamAddress;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// Causes that P.11 tells (CM-485 manual 6.6; 20 and 21: EM-RES-03 manual 5.10.1).
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
    Check = 12,
    Syntax = 13,
    Width = 14,
    Other = 15,
    NotReachable = 20,
    StringOnBus = 21,
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
    /// S1IND: the external enable of an ACT, STOA of an ACU (CM-485 manual 9, 10).
    pub(super) sto_a: bool,
    /// S7IND: STOB of an ACU; always there on an ACT, which has none.
    pub(super) sto_b: bool,
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

/// An ACT or ACU without its line.
#[derive(Clone, Debug)]
pub(super) struct Active {
    acu: bool,
    specs: BTreeMap<u32, Spec>,
    store: Store,
    /// String parameters, as far as the bench file gives them a text.
    texts: BTreeMap<u32, Vec<u8>>,
    /// Actual values that the bench file holds still.
    pinned: BTreeSet<u32>,
    contacts: Contacts,
    torque: i64,
    ramps: Ramps,
    strict_remote: bool,
    readings: Readings,
    machine: Machine,
    register: u16,
    warnings: u16,
    /// Last correct exchange that the watchdog counts from.
    heard: Option<Tick>,
    /// The last line setpoint that was not 0 was negative (CM-485 manual 9.2.1).
    backwards: bool,
}

impl Active {
    /// A drive with its factory settings and the bench's own values on top, switched on if there is power.
    pub(super) fn new(setup: &Setup, family: Option<&Family>) -> Self {
        let mut active = Active {
            acu: setup.model == Model::Acu,
            specs: family.map(|family| specs(family, &setup.modules)).unwrap_or_default(),
            store: Store::default(),
            texts: setup.texts.clone(),
            pinned: BTreeSet::new(),
            contacts: setup.contacts,
            torque: setup.torque,
            ramps: setup.ramps,
            strict_remote: setup.strict_remote,
            readings: setup.readings,
            machine: Machine::new(Tick::ZERO),
            register: 0,
            warnings: 0,
            heard: None,
            backwards: false,
        };
        for (&number, spec) in &active.specs {
            for set in cells(spec, 0) {
                equip(&mut active.store, spec, (number, set), spec.factory);
            }
        }
        let (stored, in_ram): (Vec<_>, Vec<_>) = setup.all_values().into_iter().partition(|(_, set, _)| *set < 5);
        for (number, set, value) in stored {
            let Some(spec) = active.specs.get(&number) else { continue };
            for set in cells(spec, set) {
                equip(&mut active.store, spec, (number, set), value);
            }
            active.pinned.insert(number);
        }
        match active.acu || active.contacts.mains {
            true => active.power_up(Tick::ZERO, Tick::ZERO),
            false => active.power_down(Tick::ZERO),
        }
        // What somebody has written to RAM since power-on (CM-485 manual 7).
        in_ram.iter().for_each(|(number, set, value)| active.store.write_ram((*number, set - 5), *value));
        active
    }

    /// Power-on or software reset: RAM from EEPROM, no fault, no warning; not ready before `up`. The watchdog waits for
    /// the first telegram. A shaft that turns coasts on.
    pub(super) fn power_up(&mut self, now: Tick, up: Tick) {
        self.restart(now, Some(up));
    }

    /// The power is gone until the next power-on.
    pub(super) fn power_down(&mut self, now: Tick) {
        self.restart(now, None);
    }

    fn restart(&mut self, now: Tick, up: Option<Tick>) {
        self.catch_up(now);
        self.store.power_up();
        self.machine.restart(now, up);
        self.register = 0;
        self.warnings = 0;
        self.heard = None;
        self.backwards = false;
        self.catch_up(now);
    }

    /// What it makes of a question that the manual leaves open.
    pub(super) fn has(&self, reading: Reading) -> bool {
        self.readings.has(reading)
    }

    /// Reads a parameter; the bits for the wire.
    pub(super) fn read(&mut self, now: Tick, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        self.fetch(now, address, width).inspect_err(|&cause| self.register(cause))
    }

    /// Leaves the cause of a refusal of Modbus: only exception 4 leaves one (CM-485 manual 6.6).
    fn register(&mut self, cause: Cause) {
        if cause != Cause::Unknown || !self.has(Reading::UnknownIsException2) {
            self.blame(cause);
        }
    }

    /// Like [`Active::read`], but a refusal leaves nothing in P.11.
    pub(super) fn fetch(&mut self, now: Tick, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        self.catch_up(now);
        let bits = self.try_read(address, width)?;
        if address.number() == 11 {
            self.register = 0;
        }
        Ok(bits)
    }

    /// Leaves the cause of a refusal in P.11.
    pub(super) fn blame(&mut self, cause: Cause) {
        self.register = cause as u16;
    }

    /// The type of a parameter.
    pub(super) fn kind(&self, number: u16) -> Result<Type, Cause> {
        self.specs.get(&number.into()).map(|spec| spec.kind).ok_or(Cause::Unknown)
    }

    /// Reads a string parameter.
    pub(super) fn read_text(&self, address: ParamAddress) -> Result<&[u8], Cause> {
        let spec = self.row(address)?;
        match self.texts.get(&address.number().into()) {
            None => Err(Cause::Unknown),
            Some(_) if !spec.access.reads() => Err(Cause::WriteOnly),
            Some(text) => Ok(text),
        }
    }

    /// Writes a string parameter.
    pub(super) fn write_text(&mut self, address: ParamAddress, text: &[u8]) -> Result<Effect, Cause> {
        let writes = self.row(address)?.access.writes();
        match self.texts.get_mut(&address.number().into()) {
            None => Err(Cause::Unknown),
            Some(_) if !writes => Err(Cause::ReadOnly),
            Some(old) => {
                *old = text.to_vec();
                Ok(Effect::None)
            }
        }
    }

    fn try_read(&self, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        let number = u32::from(address.number());
        let spec = self.spec(address, width)?;
        if !spec.access.reads() {
            return Err(Cause::WriteOnly);
        }
        let value = match self.actual(number) {
            Some(value) => value,
            None => {
                let in_force = if self.has(Reading::ReadsInForce) && address.set() < 5 { 5 } else { 0 };
                self.cell_value(number, spec, address.set() + in_force)?
            }
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
        self.put(now, address, width, bits).inspect_err(|&cause| self.register(cause))
    }

    /// Like [`Active::write`], but a refusal leaves nothing in P.11.
    pub(super) fn put(&mut self, now: Tick, address: ParamAddress, width: Width, bits: u32) -> Result<Effect, Cause> {
        self.catch_up(now);
        let effect = self.try_write(address, width, bits)?;
        self.react(now);
        Ok(effect)
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
        self.machine.fresh |= number == 410;
        if number == 484 && value != 0 {
            self.backwards = value < 0;
        }
        let in_ram = spec.volatile || set >= 5;
        for target in cells(&spec, set % 5) {
            self.keep((number, target), value, in_ram);
        }
        if number == 30 {
            self.drop_dc_brake(in_ram);
        }
        Ok(Effect::None)
    }

    fn keep(&mut self, cell: Cell, value: i64, in_ram: bool) {
        match in_ram {
            true => self.store.write_ram(cell, value),
            false => self.store.write_eeprom(cell, value),
        }
    }

    /// A configuration that knows no DC braking takes it out of P.392 and puts the ramp in its place: the setting
    /// changes "where need be" (CM-485 manual 9.1.2.2).
    fn drop_dc_brake(&mut self, in_ram: bool) {
        let Some(spec) = self.specs.get(&392).filter(|_| !self.brakes()) else { return };
        for set in cells(spec, 0) {
            if self.store.ram((392, set)) == Some(1) {
                self.keep((392, set), 2, in_ram);
            }
        }
    }

    /// The row that an access concerns, if number, data set and width are right.
    fn spec(&self, address: ParamAddress, width: Width) -> Result<&Spec, Cause> {
        let spec = self.row(address)?;
        match (spec.kind, width) {
            (Type::String, _) => Err(Cause::Type),
            (Type::Long, Width::Long) => Ok(spec),
            (Type::Long, Width::Word) | (_, Width::Long) => Err(Cause::Width),
            (_, Width::Word) => Ok(spec),
        }
    }

    /// The row that an access concerns, if number and data set are right.
    fn row(&self, address: ParamAddress) -> Result<&Spec, Cause> {
        let number = address.number();
        let known = self.specs.get(&u32::from(number)).filter(|_| number <= ParamAddress::LAST_NUMBER);
        let spec = known.ok_or(Cause::Unknown)?;
        if address.set() > ParamAddress::LAST_SET || (!spec.four && !address.set().is_multiple_of(5)) {
            return Err(Cause::Set);
        }
        Ok(spec)
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
        if self.next().is_none_or(|at| at > now) {
            return self.machine.shaft.advance(now);
        }
        let tripped = self.watchdog().is_some_and(|at| at <= now);
        self.machine = self.machine_at(now);
        if tripped {
            self.heard = None;
        }
    }

    /// State machine and shaft as they will be if nobody does anything. The watchdog makes a fault of the silence
    /// (CM-485 manual 6.9), and a fault switches the output stage off: the shaft coasts.
    fn machine_at(&self, now: Tick) -> Machine {
        let (mut machine, inputs) = (self.machine.clone(), self.inputs());
        if let Some(at) = self.watchdog().filter(|&at| at <= now) {
            machine.settle(at, &inputs);
            machine.trip(at, WATCHDOG);
        }
        machine.settle(now, &inputs);
        machine
    }

    fn react(&mut self, now: Tick) {
        let inputs = self.inputs();
        self.machine.react(now, &inputs);
    }

    /// Lets a fault happen.
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

    /// Changes the load at the shaft, percent of the rated torque.
    pub(super) fn burden(&mut self, now: Tick, torque: i64) {
        self.catch_up(now);
        self.torque = torque;
        self.react(now);
    }

    /// State machine and shaft.
    pub(super) fn machine(&self) -> &Machine {
        &self.machine
    }

    /// Frequency of the rotor at `now`, 0.01 Hz, positive clockwise.
    pub(super) fn shaft_speed(&self, now: Tick) -> i64 {
        self.machine_at(now).shaft.speed()
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
}

/// Cells behind a data set 0-4 of a parameter: 0 means all four, if it has four.
fn cells(spec: &Spec, set: u8) -> std::ops::RangeInclusive<u8> {
    match (spec.four, set) {
        (true, 0) => 1..=4,
        (_, set) => set..=set,
    }
}

/// Puts a value where it is at power-on.
fn equip(store: &mut Store, spec: &Spec, cell: Cell, value: i64) {
    match spec.volatile {
        true => store.equip_volatile(cell, value),
        false => store.equip(cell, value),
    }
}
