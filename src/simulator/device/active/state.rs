//! What an ACT or ACU holds: parameters, wires, the state machine. What is made of it stands in the files beside this one.

use super::analog::Analog;
use super::cause::Cause;
use super::links::Links;
use super::machine::Automaton;
use super::readings::{Reading, Readings};
use super::resolver::Resolver;
use super::setup::{Contacts, Setup};
use super::spec::{Spec, specs};
use super::store::{Cell, Store};
use crate::profile::{Family, Type};
use crate::simulator::device::shaft::Ramps;
use crate::tick::Tick;
use std::collections::{BTreeMap, BTreeSet};

/// An ACT or ACU without its line.
#[derive(Clone, Debug)]
pub(crate) struct Active {
    pub(crate) acu: bool,
    pub(crate) specs: BTreeMap<u32, Spec>,
    pub(crate) store: Store,
    /// String parameters, as far as the bench file gives them a text.
    pub(crate) texts: BTreeMap<u32, Vec<u8>>,
    /// Actual values that the bench file holds still.
    pub(crate) pinned: BTreeSet<u32>,
    pub(crate) contacts: Contacts,
    pub(crate) torque: i64,
    /// The motor has one, and its manual's physics.
    pub(crate) resolver: Option<Resolver>,
    /// A hand turns the shaft so fast, 0.01 Hz.
    pub(crate) hand: i64,
    /// EM-S1INA.
    pub(crate) analog: Analog,
    pub(crate) ramps: Ramps,
    pub(crate) strict_remote: bool,
    pub(crate) readings: Readings,
    pub(crate) machine: Automaton,
    pub(crate) register: u16,
    pub(crate) warnings: u16,
    /// Last correct exchange that the watchdog counts from.
    pub(crate) heard: Option<Tick>,
    /// The last line setpoint that was not 0 was negative (CM-485 manual 9.2.1).
    pub(crate) backwards: bool,
    /// What comes over the system bus.
    pub(crate) links: Links,
}

impl Active {
    /// A drive with its factory settings and the bench's own values on top, not switched on yet.
    pub(crate) fn equipped(setup: &Setup, stored: &[(u32, u8, i64)], family: Option<&Family>) -> Self {
        let mut active = Active {
            acu: setup.acu,
            specs: family.map(|family| specs(family, &setup.modules)).unwrap_or_default(),
            store: Store::default(),
            texts: setup.texts.clone(),
            pinned: BTreeSet::new(),
            contacts: setup.contacts,
            torque: setup.torque,
            resolver: setup.resolver,
            hand: 0,
            analog: setup.analog,
            ramps: setup.ramps,
            strict_remote: setup.strict_remote,
            readings: setup.readings,
            machine: Automaton::new(Tick::ZERO),
            register: 0,
            warnings: 0,
            heard: None,
            backwards: false,
            links: Links::new(&setup.sources),
        };
        for (number, spec) in &mut active.specs {
            spec.four |= setup.four.contains(number);
            if setup.other_width.contains(number) {
                spec.kind = if spec.kind.bits() == Some(32) { Type::Word } else { Type::Long };
            }
        }
        for (&number, spec) in &active.specs {
            for set in cells(spec, 0) {
                equip(&mut active.store, spec, (number, set), spec.factory);
            }
        }
        for &(number, set, value) in stored {
            let Some(spec) = active.specs.get(&number) else { continue };
            for set in cells(spec, set) {
                equip(&mut active.store, spec, (number, set), value);
            }
            active.pinned.insert(number);
        }
        active
    }

    /// What it makes of a question that the manual leaves open.
    pub(crate) fn has(&self, reading: Reading) -> bool {
        self.readings.has(reading)
    }

    /// P.249: P.414 if it is 1-4, else data set 1, because no input of the bench switches sets (CM-485 manual 9).
    pub(crate) fn active_set(&self) -> u8 {
        match self.store.ram((414, 0)) {
            Some(set @ 1..=4) => set as u8,
            _ => 1,
        }
    }

    /// DC braking only where the configuration is a V/f one (CM-485 manual 9.1.2.2).
    pub(crate) fn brakes(&self) -> bool {
        self.value(30) / 100 == 1
    }

    /// The value of the copy that a data set stands for: 0-4 EEPROM, 5-9 RAM (CM-485 manual 7).
    pub(crate) fn cell_value(&self, number: u32, spec: &Spec, set: u8) -> Result<i64, Cause> {
        let from_ram = spec.volatile || set >= 5;
        let mut values = cells(spec, set % 5).map(|set| match from_ram {
            true => self.store.ram((number, set)),
            false => self.store.eeprom((number, set)),
        });
        let first = values.next().flatten().ok_or(Cause::Set)?;
        if values.any(|value| value != Some(first)) { Err(Cause::SetsDiffer) } else { Ok(first) }
    }

    /// The value that the drive works with: RAM copy of the active data set; 0 for what it has not.
    pub(crate) fn value(&self, number: u32) -> i64 {
        let set = match self.specs.get(&number) {
            Some(spec) if spec.four => self.active_set(),
            _ => 0,
        };
        self.store.ram((number, set)).unwrap_or(0)
    }
}

/// Cells behind a data set 0-4 of a parameter: 0 means all four, if it has four.
pub(crate) fn cells(spec: &Spec, set: u8) -> std::ops::RangeInclusive<u8> {
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
