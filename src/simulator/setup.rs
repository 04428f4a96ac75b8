//! Everything that makes a station before it is switched on.

use super::active::Contacts;
use super::lexium::Fittings;
use super::readings::Readings;
use super::script::Event;
use super::shaft::Ramps;
use super::vabus::Node;
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

/// What a station speaks on its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spoken {
    Modbus(Framing),
    Vabus,
    /// P-Bus, for special applications (CM-485 manual 6); nobody on this bench understands it.
    PBus,
}

impl Spoken {
    pub(super) const RTU: Spoken = Spoken::Modbus(Framing::Rtu);
    pub(super) const ASCII: Spoken = Spoken::Modbus(Framing::Ascii);
    /// P.395, what it means, and the word for it (CM-485 manual 6).
    const ROWS: [(i64, Spoken, &'static str); 4] =
        [(0, Spoken::Vabus, "vabus"), (1, Spoken::PBus, "p-bus"), (2, Spoken::RTU, "rtu"), (3, Spoken::ASCII, "ascii")];

    pub(super) fn of(protocol: i64) -> Self {
        Self::ROWS.iter().find(|row| row.0 == protocol).map_or(Spoken::PBus, |row| row.1)
    }

    pub(super) fn name(self) -> &'static str {
        Self::ROWS.iter().find(|row| row.1 == self).map_or("", |row| row.2)
    }
}

/// What stands on the bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Model {
    Act,
    Acu,
    Lxm05,
    Foreign,
}

impl Model {
    pub(super) const NAMES: [(&'static str, Model); 4] =
        [("act", Model::Act), ("acu", Model::Acu), ("lxm05", Model::Lxm05), ("foreign", Model::Foreign)];

    pub(super) fn name(self) -> &'static str {
        Self::NAMES.iter().find(|row| row.1 == self).map_or("", |row| row.0)
    }
}

/// Everything that makes a station.
#[derive(Clone, Debug)]
pub(super) struct Setup {
    pub(super) model: Model,
    pub(super) address: u8,
    pub(super) spoken: Spoken,
    pub(super) line: LineSetting,
    pub(super) delay: Span,
    pub(super) jitter: Span,
    pub(super) strict_silence: bool,
    /// What it makes of questions that the manuals leave open.
    pub(super) readings: Readings,
    /// Without the Remote bit it obeys no command.
    pub(super) strict_remote: bool,
    pub(super) contacts: Contacts,
    /// Load at the shaft, percent of the rated torque.
    pub(super) torque: i64,
    pub(super) ramps: Ramps,
    pub(super) modules: Vec<String>,
    /// Number, data set (0 for all), raw value.
    pub(super) values: Vec<(u32, u8, i64)>,
    /// Texts of string parameters.
    pub(super) texts: BTreeMap<u32, Vec<u8>>,
    /// Drives behind it, on the system bus.
    pub(super) nodes: Vec<Node>,
    pub(super) registers: BTreeMap<u16, u16>,
    /// Of an LXM05.
    pub(super) fittings: Fittings,
    pub(super) script: Vec<Event>,
    pub(super) seed: u64,
}

impl Setup {
    /// A station with nothing special about it, RTU at 19200 8E1.
    pub(super) fn plain(model: Model, address: u8) -> Self {
        Setup {
            model,
            address,
            spoken: Spoken::RTU,
            line: LineSetting::rtu(19_200, Parity::Even),
            delay: REPLY_DELAY,
            jitter: Span::ZERO,
            strict_silence: false,
            readings: Readings::default(),
            strict_remote: false,
            contacts: CONTACTS,
            torque: TORQUE,
            ramps: RAMPS,
            modules: Vec::new(),
            values: Vec::new(),
            texts: BTreeMap::new(),
            nodes: Vec::new(),
            registers: BTreeMap::new(),
            fittings: Fittings::default(),
            script: Vec::new(),
            seed: address.into(),
        }
    }

    /// Values at power-on, with those that hold the settings of the line.
    pub(super) fn all_values(&self) -> Vec<(u32, u8, i64)> {
        let mut values = settings(self.spoken, self.line, self.address);
        values.extend(&self.values);
        values
    }
}

/// The parameters that hold the settings of the line. VABus has an address of its own, P.394, and no use for the
/// "Modbus parity" P.1375.
fn settings(spoken: Spoken, line: LineSetting, address: u8) -> Vec<(u32, u8, i64)> {
    let protocol = Spoken::ROWS.iter().find(|row| row.1 == spoken).map_or(0, |row| row.0);
    let baud = BAUD_RATES.iter().find(|row| row.1 == line.baud).map_or(4, |row| row.0);
    let parity = PARITIES.iter().find(|row| row.1 == line.parity).map_or(0, |row| row.0);
    let own = match spoken {
        Spoken::Vabus => [(394, 0, address.into()), (1376, 0, 1), (1375, 0, 0)],
        Spoken::Modbus(_) | Spoken::PBus => [(394, 0, 1), (1376, 0, address.into()), (1375, 0, parity)],
    };
    [vec![(10, 0, baud), (395, 0, protocol)], own.to_vec()].concat()
}
