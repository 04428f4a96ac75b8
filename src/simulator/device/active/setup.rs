//! Everything that makes an ACT or ACU before it is switched on.

use super::analog::Analog;
use super::readings::Readings;
use super::resolver::Resolver;
use crate::simulator::device::contract::CellFault;
use crate::simulator::device::shaft::Ramps;
use std::collections::BTreeMap;

/// Slopes that P.420-423 would give; nothing in the store tells their factory setting: 5 Hz/s on this bench.
const RAMPS: Ramps = Ramps::all(500);
/// The load that this bench hangs at a shaft, percent of the rated torque.
const TORQUE: i64 = 30;
/// The wires of a drive that may run.
const CONTACTS: Contacts = Contacts { sto_a: true, sto_b: true, right: true, left: false, mains: true };

/// Everything that makes an ACT or ACU.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    /// An ACU; else an ACT.
    pub(crate) acu: bool,
    /// What it makes of questions that the manuals leave open.
    pub(crate) readings: Readings,
    /// Without the Remote bit it obeys no command.
    pub(crate) strict_remote: bool,
    pub(crate) contacts: Contacts,
    /// Load at the shaft, percent of the rated torque.
    pub(crate) torque: i64,
    /// A motor that is led by its resolver.
    pub(crate) resolver: Option<Resolver>,
    /// The analog input of an EM-RES-03.
    pub(crate) analog: Analog,
    pub(crate) ramps: Ramps,
    pub(crate) modules: Vec<String>,
    /// Number, data set (0 for all), raw value.
    pub(crate) values: Vec<(u32, u8, i64)>,
    /// Parameters that exist in four data sets, where no source says so.
    pub(crate) four: Vec<u32>,
    /// Parameters with 16 bits where the catalogue says 32, and 32 where it says 16.
    pub(crate) other_width: Vec<u32>,
    /// Number, data set (0 for all), and how its EEPROM takes a write.
    pub(crate) faulty: Vec<(u32, u8, Option<CellFault>)>,
    /// What sources tell that this bench does not work out.
    pub(crate) sources: BTreeMap<u16, i64>,
    /// Texts of string parameters.
    pub(crate) texts: BTreeMap<u32, Vec<u8>>,
}

impl Setup {
    /// A drive with nothing special about it.
    pub(crate) fn plain(acu: bool) -> Self {
        Setup {
            acu,
            readings: Readings::default(),
            strict_remote: false,
            contacts: CONTACTS,
            torque: TORQUE,
            resolver: None,
            analog: Analog::default(),
            ramps: RAMPS,
            modules: Vec::new(),
            values: Vec::new(),
            four: Vec::new(),
            other_width: Vec::new(),
            faulty: Vec::new(),
            sources: BTreeMap::new(),
            texts: BTreeMap::new(),
        }
    }
}

/// Wires at the terminals of the drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Contacts {
    /// S1IND: the external enable of an ACT, STOA of an ACU (CM-485 manual 9, 10).
    pub(crate) sto_a: bool,
    /// S7IND: STOB of an ACU; always there on an ACT, which has none.
    pub(crate) sto_b: bool,
    /// S2IND.
    pub(crate) right: bool,
    /// S3IND.
    pub(crate) left: bool,
    pub(crate) mains: bool,
}

impl Contacts {
    /// The external enable: both STO inputs of an ACU. An ACT has one.
    pub(crate) fn enable(self) -> bool {
        self.sto_a && self.sto_b
    }
}
