//! Everything that makes a station before it is switched on.

use super::active::Contacts;
use super::script::Event;
use super::shaft::Ramps;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::tick::Span;
use std::collections::BTreeMap;

/// Earliest reply (CM-485 manual 6.8).
pub(super) const REPLY_DELAY: Span = Span::from_millis(10);
/// Slopes that P.420-423 would give; nothing in the store tells their factory setting: 5 Hz/s on this bench.
const RAMPS: Ramps = Ramps::all(500);
/// The load that this bench hangs at a shaft, percent of the rated torque.
const TORQUE: i64 = 30;
/// The wires of a drive that may run.
const CONTACTS: Contacts = Contacts { sto_a: true, sto_b: true, right: true, left: false, mains: true };

/// P.10 and what it means (CM-485 manual 5.2.1).
pub(super) const BAUD_RATES: [(i64, u32); 6] =
    [(1, 2_400), (2, 4_800), (3, 9_600), (4, 19_200), (5, 57_600), (6, 115_200)];
/// P.1375 and what it means (CM-485 manual 5.2.1).
pub(super) const PARITIES: [(i64, Parity); 3] = [(0, Parity::Even), (1, Parity::Odd), (2, Parity::None)];

/// What stands on the bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Model {
    Act,
    Acu,
    Foreign,
}

impl Model {
    pub(super) const NAMES: [(&'static str, Model); 3] =
        [("act", Model::Act), ("acu", Model::Acu), ("foreign", Model::Foreign)];

    pub(super) fn name(self) -> &'static str {
        Self::NAMES.iter().find(|row| row.1 == self).map_or("", |row| row.0)
    }
}

/// Everything that makes a station.
#[derive(Clone, Debug)]
pub(super) struct Setup {
    pub(super) model: Model,
    pub(super) address: u8,
    /// Framing, or `None` for the maker's own protocol: silent on Modbus.
    pub(super) framing: Option<Framing>,
    pub(super) line: LineSetting,
    pub(super) delay: Span,
    pub(super) jitter: Span,
    pub(super) strict_silence: bool,
    /// Without the Remote bit it obeys no command.
    pub(super) strict_remote: bool,
    pub(super) contacts: Contacts,
    /// Load at the shaft, percent of the rated torque.
    pub(super) torque: i64,
    pub(super) ramps: Ramps,
    pub(super) modules: Vec<String>,
    /// Number, data set (0 for all), raw value.
    pub(super) values: Vec<(u32, u8, i64)>,
    pub(super) registers: BTreeMap<u16, u16>,
    pub(super) script: Vec<Event>,
    pub(super) seed: u64,
}

impl Setup {
    /// A station with nothing special about it, RTU at 19200 8E1.
    pub(super) fn plain(model: Model, address: u8) -> Self {
        Setup {
            model,
            address,
            framing: Some(Framing::Rtu),
            line: LineSetting::rtu(19_200, Parity::Even),
            delay: REPLY_DELAY,
            jitter: Span::ZERO,
            strict_silence: false,
            strict_remote: false,
            contacts: CONTACTS,
            torque: TORQUE,
            ramps: RAMPS,
            modules: Vec::new(),
            values: Vec::new(),
            registers: BTreeMap::new(),
            script: Vec::new(),
            seed: address.into(),
        }
    }

    /// Values at power-on, with those that hold the settings of the line.
    pub(super) fn all_values(&self) -> Vec<(u32, u8, i64)> {
        let mut values = settings(self.framing, self.line, self.address);
        values.extend(&self.values);
        values
    }
}

/// The parameters that hold the settings of the line.
fn settings(framing: Option<Framing>, line: LineSetting, address: u8) -> Vec<(u32, u8, i64)> {
    let protocol = match framing {
        None => 0,
        Some(Framing::Rtu) => 2,
        Some(Framing::Ascii) => 3,
    };
    let baud = BAUD_RATES.iter().find(|row| row.1 == line.baud).map_or(4, |row| row.0);
    let parity = PARITIES.iter().find(|row| row.1 == line.parity).map_or(0, |row| row.0);
    vec![(10, 0, baud), (1375, 0, parity), (395, 0, protocol), (1376, 0, address.into())]
}
