//! What the settings of a drive come to on the bus: identifiers by the predefined connection set where a 0 stands, functions by their
//! words, and sources at their bytes (EM-RES-03 manual 5.4 to 5.12). What was not told is `None`.

use super::ends;
use super::load::Rate;
use super::plan::Numbering;
use super::settings::SYNC;
use crate::protocol::can::pdo::Place;
use crate::protocol::can::{Identifier, PdoNumber, SdoChannel, Service};
use std::collections::BTreeMap;

/// The settings of a drive, by parameter.
#[derive(Clone, Copy, Debug)]
pub struct Standing<'v> {
    values: &'v BTreeMap<u32, i64>,
}

/// When a PDO goes out, or is handed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Never.
    Off,
    /// By its own time.
    Time,
    /// With SYNC.
    Sync,
}

/// A PDO of a drive, sent or received.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Which of its PDOs.
    pub number: PdoNumber,
    /// Its identifier.
    pub identifier: Option<u16>,
    /// The code of its function as it stands there.
    pub code: Option<i64>,
    /// What the code means; `None` too where the manual prints two meanings and nothing tells which one holds.
    pub function: Option<Function>,
    /// How often it is sent, or how long it may be missing; 0 is for ever.
    pub ms: Option<u32>,
    /// What fills it, or takes from it.
    pub ends: Vec<End>,
}

/// A parameter that fills a place of a PDO, or takes from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// Where.
    pub place: Place,
    /// The parameter.
    pub param: u32,
    /// The source that it is set to.
    pub source: u16,
}

impl<'v> Standing<'v> {
    /// Of values without their decimal points.
    pub fn new(values: &'v BTreeMap<u32, i64>) -> Self {
        Standing { values }
    }

    /// P.900: -1 is off the bus, 0 the master.
    pub fn node(self) -> Option<i64> {
        self.values.get(&ends::NODE).copied()
    }

    fn place(self) -> Option<u8> {
        self.node().and_then(|node| u8::try_from(node).ok())
    }

    /// P.903, if it is one of the printed codes.
    pub fn rate(self) -> Option<Rate> {
        Rate::of_code(*self.values.get(&ends::RATE)?)
    }

    /// P.918; 0 stands for 128.
    pub fn sync_identifier(self) -> Option<u16> {
        self.identifier(ends::SYNC_IDENTIFIER, || Some(SYNC))
    }

    /// P.919, 939, 904 in milliseconds: time between SYNCs and boot-up delay of a master, how long SYNC may be missing.
    pub fn times(self) -> [Option<u32>; 3] {
        [ends::SYNC_TIME, ends::SYNC_TIMEOUT, ends::BOOT_UP_DELAY].map(|param| self.number(param))
    }

    /// P.921 and 922: under which it is asked over SDO1, and answers.
    pub fn sdo1(self) -> [Option<u16>; 2] {
        let of = |service: fn(SdoChannel, u8) -> Service| move || service(SdoChannel::One, self.place()?).identifier();
        [self.identifier(ends::RX_SDO1, of(Service::SdoRequest)), self.identifier(ends::TX_SDO1, of(Service::SdoReply))]
    }

    /// P.923.
    pub fn sdo2(self) -> Option<bool> {
        self.values.get(&ends::SDO2).map(|value| *value != 0)
    }

    /// How the drive counts the functions of its RxPDOs: a 2 is printed in one of the two numberings alone, whereas 0 and 1 stand in
    /// both.
    pub fn numbering(self) -> Option<Numbering> {
        let code = |pdo: PdoNumber| self.values.get(&ends::rx_function(pdo));
        PdoNumber::ALL.into_iter().any(|pdo| code(pdo) == Some(&2)).then_some(Numbering::FromOff)
    }

    /// The PDOs that it sends.
    pub fn all_sent(self) -> Vec<Channel> {
        PdoNumber::ALL.map(|number| self.sent(number)).into()
    }

    /// The PDOs that it receives. Their functions are known where the drive shows how it counts.
    pub fn all_received(self) -> Vec<Channel> {
        PdoNumber::ALL.map(|number| self.received(number)).into()
    }

    fn sent(self, number: PdoNumber) -> Channel {
        let code = self.values.get(&ends::tx_function(number)).copied();
        let filled = |place: Place| {
            let param = ends::input(number, place);
            let source = u16::try_from(*self.values.get(&param)?).ok()?;
            (source != ends::unused(place.kind())).then_some(End { place, param, source })
        };
        Channel {
            number,
            identifier: self
                .identifier(ends::tx_identifier(number), || Service::TxPdo(number, self.place()?).identifier()),
            code,
            function: code.and_then(|code| function(code, Numbering::FromOff)),
            ms: self.number(ends::tx_time(number)),
            ends: Place::all().filter_map(filled).collect(),
        }
    }

    fn received(self, number: PdoNumber) -> Channel {
        let code = self.values.get(&ends::rx_function(number)).copied();
        let function = code.zip(self.numbering()).and_then(|(code, numbering)| function(code, numbering));
        let taking = |place: Place| {
            let source = ends::source(number, place);
            let is_own = |param: &u32| (ends::NODE..=ends::EMERGENCY_REACTION).contains(param);
            let rows = self.values.iter().filter(move |row| *row.1 == i64::from(source) && !is_own(row.0));
            rows.map(move |row| End { place, param: *row.0, source })
        };
        Channel {
            number,
            identifier: self
                .identifier(ends::rx_identifier(number), || Service::RxPdo(number, self.place()?).identifier()),
            code,
            function,
            ms: self.number(ends::rx_timeout(number)),
            ends: Place::all().flat_map(taking).collect(),
        }
    }

    /// A value that is none below zero.
    pub(super) fn number(self, param: u32) -> Option<u32> {
        self.values.get(&param).and_then(|value| u32::try_from(*value).ok())
    }

    /// An identifier of its own; `None` for 0 too, which is that of the predefined connection set.
    pub(super) fn own_identifier(self, param: u32) -> Option<u16> {
        match Identifier::standard(self.number(param)?)? {
            Identifier::Standard(number) if number > 0 => Some(number),
            _ => None,
        }
    }

    fn identifier(self, param: u32, preset: impl FnOnce() -> Option<u16>) -> Option<u16> {
        match self.number(param)? {
            0 => preset(),
            _ => self.own_identifier(param),
        }
    }
}

/// What a code of a function means; the TxPDOs count from off.
fn function(code: i64, numbering: Numbering) -> Option<Function> {
    match (numbering, code) {
        (Numbering::FromOff, 0) => Some(Function::Off),
        (Numbering::FromOff, 1) | (Numbering::FromTime, 0) => Some(Function::Time),
        (Numbering::FromOff, 2) | (Numbering::FromTime, 1) => Some(Function::Sync),
        _ => None,
    }
}

impl Function {
    /// Stable word.
    pub fn name(self) -> &'static str {
        match self {
            Function::Off => "off",
            Function::Time => "time",
            Function::Sync => "sync",
        }
    }
}
