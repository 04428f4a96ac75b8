//! A `[[drive]]` of a bench file: which device stands at which place.

use super::reader::{BenchFile, Model, own_seed};
use super::tables::DriveTable;
use crate::profile::{Broken, INPUTS};
use crate::protocol::vabus::Address;
use crate::simulator::device::active;
use crate::simulator::device::contract::{Device, NodeSetting};
use crate::simulator::device::foreign::Foreign;
use crate::simulator::line::speech::Spoken;
use crate::simulator::station::Drive;
use crate::simulator::station::setup::Setup;
use crate::text::both;
use crate::tick::Span;
use std::collections::BTreeMap;
use toml::Spanned;

impl BenchFile<'_> {
    /// What stands there.
    pub(crate) fn drive(&self, table: &Spanned<DriveTable>, seed: u64) -> Result<Drive, Broken> {
        let row = table.get_ref();
        let model = self.word("model", &row.model, &Model::NAMES)?;
        let address = row.address.as_ref().map_or(Ok(1), |got| self.station(got))?;
        let seed = own_seed(seed, address);
        match model {
            Model::Lxm05 => self.servo(table, address, seed),
            Model::Act | Model::Acu | Model::Foreign => self.inverter(table, model, address, seed),
        }
    }

    /// An ACT, an ACU, or a foreign slave, for which the keys of those two may stand and mean nothing.
    fn inverter(&self, table: &Spanned<DriveTable>, model: Model, address: u8, seed: u64) -> Result<Drive, Broken> {
        let row = table.get_ref();
        if row.servo.is_some() || row.stop_bits.is_some() {
            let message =
                both!("servo and stop_bits are for model lxm05", "servo und stop_bits gehören zu model lxm05");
            return Err(self.error(table.span(), message));
        }
        if !row.sources.is_empty() || row.event.iter().any(|event| event.get_ref().bus_off.is_some()) {
            let message =
                both!("sources and bus_off are for a CAN bus", "sources und bus_off gehören zu einem CAN-Bus");
            return Err(self.error(table.span(), message));
        }
        let spoken = self.spoken(row, address)?;
        let family = self.registry.family(model.name());
        if family.is_none() && model != Model::Foreign {
            let message = both!(
                "no catalogue describes model '{model}'",
                "kein Katalog beschreibt model '{model}'",
                model = model.name()
            );
            return Err(self.error(row.model.span(), message));
        }
        if model != Model::Foreign && (row.busy || !row.registers.is_empty()) {
            let message = both!(
                "registers and busy are for model foreign; expected set",
                "registers und busy gehören zu model foreign; erwartet: set"
            );
            return Err(self.error(table.span(), message));
        }
        let place = NodeSetting { address, spoken, line: self.line(row, spoken)? };
        let mut station = Setup::plain(place);
        station.delay = self.delay(row)?;
        station.jitter = self.time_or("jitter", row.jitter.as_ref(), Span::ZERO)?;
        station.strict_silence = row.strict_silence;
        station.seed = seed;
        let setup = self.active(row, model, family.as_deref())?;
        let nodes = self.nodes(row, model)?;
        let registers = self.registers(row)?;
        for event in &row.event {
            station.script.extend(self.active_events(event, model, family.as_deref(), &setup)?);
        }
        let device: Box<dyn Device> = match model {
            Model::Foreign => Box::new(Foreign::new(&registers, row.busy)),
            _ => Box::new(active::Drive::new(&setup, place, nodes, family.as_deref())),
        };
        Ok(Drive::new(station, device))
    }

    fn spoken(&self, row: &DriveTable, address: u8) -> Result<Spoken, Broken> {
        let protocols = [Spoken::RTU, Spoken::ASCII, Spoken::Vabus].map(|spoken| (spoken.name(), spoken));
        let spoken = row.protocol.as_ref().map_or(Ok(Spoken::RTU), |got| self.word("protocol", got, &protocols))?;
        let out_of_range = spoken == Spoken::Vabus && Address::drive(address).is_none();
        if let Some(got) = row.address.as_ref().filter(|_| out_of_range) {
            let expected =
                both!("1 to {last} with protocol vabus", "1 bis {last} mit protocol vabus", last = Address::LAST);
            return Err(self.unfit("address", got.span(), &address, &expected));
        }
        Ok(spoken)
    }

    fn registers(&self, row: &DriveTable) -> Result<BTreeMap<u32, u16>, Broken> {
        let mut registers = BTreeMap::new();
        for (key, value) in &row.registers {
            let known = |number: &u32| *number <= u16::MAX.into() || INPUTS.contains(number);
            let register = key.parse().ok().filter(known).zip(u16::try_from(*value.get_ref()).ok());
            let message = || {
                both!(
                    "register \"{key}\" = {value}; both expected 0 to 65535, an input register is 300001 to 365536",
                    "Register \"{key}\" = {value}; für beides wird 0 bis 65535 erwartet, ein Eingangsregister ist 300001 bis 365536",
                    value = value.get_ref()
                )
            };
            let (number, value) = register.ok_or_else(|| self.error(value.span(), message()))?;
            registers.insert(number, value);
        }
        Ok(registers)
    }
}
