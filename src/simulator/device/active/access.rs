//! The drive behind the line: parameters, data sets, actual values, faults and warnings of an ACT or ACU.
//!
//! Order of the checks of an access, where the manual names none: parameter (11), data set (2), width (10, 14),
//! direction (3, 4), running (8), value (1). On Modbus only a refusal with exception 4 leaves its cause in P.11
//! (CM-485 manual 6.6), on VABus every NAK (sources A2).
//!
//! All frequencies have two decimals, also those of which no source says it (217, 241): so do all that are printed
//! (CM-485 manual 10.2.3). Percentages likewise.
//!
//! What the drive makes of its parameters is in `values.rs`.

use super::cause::Cause;
use super::readings::Reading;
use super::spec::Spec;
use super::state::{Active, cells};
use super::store::Cell;
use crate::profile::Type;
use crate::profile::value::{from_wire, to_wire};
use crate::protocol::modbus::pdu::ParamAddress;
use crate::simulator::device::contract::Effect;
use crate::tick::Tick;

/// Width of an access: function codes 3 and 6, or 100 and 101.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Width {
    Word,
    Long,
}

/// Value of P.34 that restarts the software (CM-485 manual 5.2.1).
const RESTART: i64 = 123;

impl Active {
    /// Reads a parameter; the bits for the wire.
    pub(crate) fn read(&mut self, now: Tick, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        self.fetch(now, address, width).inspect_err(|&cause| self.register(cause))
    }

    /// Leaves the cause of a refusal of Modbus: only exception 4 leaves one (CM-485 manual 6.6).
    fn register(&mut self, cause: Cause) {
        if cause != Cause::Unknown || !self.has(Reading::UnknownIsException2) {
            self.blame(cause);
        }
    }

    /// Like [`Active::read`], but a refusal leaves nothing in P.11.
    pub(crate) fn fetch(&mut self, now: Tick, address: ParamAddress, width: Width) -> Result<u32, Cause> {
        self.catch_up(now);
        let bits = self.try_read(address, width)?;
        if address.number() == 11 {
            self.register = 0;
        }
        Ok(bits)
    }

    /// Leaves the cause of a refusal in P.11.
    pub(crate) fn blame(&mut self, cause: Cause) {
        self.register = cause as u16;
    }

    /// The type of a parameter.
    pub(crate) fn kind(&self, number: u16) -> Result<Type, Cause> {
        self.specs.get(&number.into()).map(|spec| spec.kind).ok_or(Cause::Unknown)
    }

    /// Reads a string parameter.
    pub(crate) fn read_text(&self, address: ParamAddress) -> Result<&[u8], Cause> {
        let spec = self.row(address)?;
        match self.texts.get(&address.number().into()) {
            None => Err(Cause::Unknown),
            Some(_) if !spec.access.reads() => Err(Cause::WriteOnly),
            Some(text) => Ok(text),
        }
    }

    /// Writes a string parameter.
    pub(crate) fn write_text(&mut self, address: ParamAddress, text: &[u8]) -> Result<Effect, Cause> {
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
            None if address.set() >= 5 && self.has(Reading::RamNotShown) => return Err(Cause::WriteOnly),
            None => {
                let in_force = if self.has(Reading::ReadsInForce) && address.set() < 5 { 5 } else { 0 };
                self.cell_value(number, spec, address.set() + in_force)?
            }
        };
        // What does not fit is cut off, as in the registers of a drive.
        Ok(to_wire(value, spec.kind).unwrap_or(value as u32))
    }

    /// Writes a parameter.
    pub(crate) fn write(&mut self, now: Tick, address: ParamAddress, width: Width, bits: u32) -> Result<Effect, Cause> {
        self.put(now, address, width, bits).inspect_err(|&cause| self.register(cause))
    }

    /// Like [`Active::write`], but a refusal leaves nothing in P.11.
    pub(crate) fn put(&mut self, now: Tick, address: ParamAddress, width: Width, bits: u32) -> Result<Effect, Cause> {
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
        if number == 568 {
            self.analog.adjust(value);
        }
        if !in_ram && cells(&spec, set % 5).any(|target| self.store.refuses((number, target))) {
            return Err(Cause::Eeprom);
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

    /// Somebody else sets a value, by the data set 0-9.
    pub(crate) fn set_by_hand(&mut self, now: Tick, number: u32, set: u8, value: i64) {
        self.catch_up(now);
        let Some(spec) = self.specs.get(&number).cloned() else { return };
        for target in cells(&spec, set % 5) {
            if set < 5 && !spec.volatile {
                self.store.equip((number, target), value);
            }
            self.store.write_ram((number, target), value);
        }
        self.react(now);
    }

    /// EEPROM cells written.
    pub(crate) fn eeprom_writes(&self) -> u64 {
        self.store.writes()
    }

    /// Raw value of the EEPROM copy; data set 0 of a switchable parameter only if all four are the same.
    pub(crate) fn eeprom(&self, number: u32, set: u8) -> Option<i64> {
        let spec = self.specs.get(&number).filter(|spec| !spec.volatile && set <= 4)?;
        self.cell_value(number, spec, set).ok()
    }

    /// Raw value of the RAM copy, by the data set 0-4 or by its RAM number 5-9.
    pub(crate) fn ram(&self, number: u32, set: u8) -> Option<i64> {
        let spec = self.specs.get(&number).filter(|_| set <= ParamAddress::LAST_SET)?;
        self.actual(number).or_else(|| self.cell_value(number, spec, set % 5 + 5).ok())
    }
}
