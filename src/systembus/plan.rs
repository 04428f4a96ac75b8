//! A plan: drives, and what each of them sends and receives.

use super::load::{Budget, Rate};
use crate::protocol::can::pdo::Place;
use crate::protocol::can::{PdoNumber, station};

/// The whole bus.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Bit rate of everybody.
    pub rate: Rate,
    /// Identifier of SYNC, of everybody (P.918).
    pub sync_identifier: u16,
    /// How often SYNC is sent, by whoever is the master (P.919 of a drive); `None` where nobody says.
    pub sync_every_ms: Option<u32>,
    /// The master is no drive but a controller.
    pub has_external_master: bool,
    /// The drives, in the order of the file.
    pub drives: Vec<Drive>,
    /// PDOs that no drive sends.
    pub foreign: Vec<Foreign>,
}

/// A drive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drive {
    /// What the user calls it.
    pub name: String,
    /// P.900; 0 is the master.
    pub node: u8,
    /// P.939; 0 is none.
    pub sync_timeout_ms: u32,
    /// P.904, of the master.
    pub boot_up_delay_ms: Option<u32>,
    /// P.989, of the master.
    pub emergency_reaction: Option<EmergencyReaction>,
    /// P.923.
    pub sdo2: Option<bool>,
    /// P.921, where it is not by the predefined connection set.
    pub rx_sdo1: Option<u16>,
    /// P.922, where it is not by the predefined connection set.
    pub tx_sdo1: Option<u16>,
    /// How it counts the functions of its RxPDOs, if that is known.
    pub numbering: Option<Numbering>,
    /// What it sends.
    pub tx: Vec<Tx>,
    /// What it receives.
    pub rx: Vec<Rx>,
}

/// What a master does when a slave trips (P.989).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EmergencyReaction {
    /// It trips too.
    Fault,
    /// It warns.
    Warning,
}

/// How the functions of RxPDOs are counted (P.936 to P.938). The manual prints both, and 1 means opposite things.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbering {
    /// 0 by time, 1 by SYNC (manual 5.11.2).
    FromTime,
    /// 0 off, 1 by time, 2 by SYNC (manual 5.7.2).
    FromOff,
}

/// When a PDO is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trigger {
    /// Once in so many milliseconds.
    Time(u32),
    /// Behind each SYNC.
    Sync,
}

/// A PDO that a drive sends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tx {
    /// Which of its PDOs.
    pub number: PdoNumber,
    /// Its identifier.
    pub identifier: u16,
    /// When it is sent.
    pub trigger: Trigger,
    /// Which source stands where.
    pub inputs: Vec<(Place, u16)>,
}

/// A PDO that a drive receives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rx {
    /// Which of its PDOs.
    pub number: PdoNumber,
    /// The identifier that it listens to.
    pub identifier: u16,
    /// Its data are handed on with SYNC, not at once.
    pub on_sync: bool,
    /// How long it may be missing; 0 is for ever.
    pub timeout_ms: u32,
    /// Which parameters take what stands where.
    pub outputs: Vec<(Place, u32)>,
}

/// A PDO that somebody sends who is none of the drives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Foreign {
    /// Who.
    pub name: String,
    /// Its identifier.
    pub identifier: u16,
    /// When it is sent.
    pub trigger: Trigger,
}

impl Plan {
    /// The drive that is the master.
    pub fn master(&self) -> Option<&Drive> {
        self.drives.iter().find(|drive| drive.node == 0)
    }

    /// How often a PDO is sent in milliseconds, if somebody says.
    pub fn every_ms(&self, trigger: Trigger) -> Option<u32> {
        match trigger {
            Trigger::Time(ms) => Some(ms),
            Trigger::Sync => self.sync_every_ms,
        }
        .filter(|ms| *ms > 0)
    }

    /// Every PDO that is sent: by whom, its identifier, when; drives first.
    pub fn sent(&self) -> impl Iterator<Item = (&str, Option<&Tx>, u16, Trigger)> {
        let drives = self.drives.iter().flat_map(|drive| {
            drive.tx.iter().map(move |tx| (drive.name.as_str(), Some(tx), tx.identifier, tx.trigger))
        });
        let foreign = self.foreign.iter();
        drives.chain(foreign.map(|one| (one.name.as_str(), None, one.identifier, one.trigger)))
    }

    /// What all PDOs cost together, in the order of [`Plan::sent`].
    pub fn budget(&self) -> Budget {
        Budget::new(self.rate, self.sent().map(|(.., trigger)| self.every_ms(trigger)))
    }

    /// Whether anything waits for SYNC.
    pub fn uses_sync(&self) -> bool {
        self.drives.iter().any(Drive::uses_sync) || self.foreign.iter().any(|one| one.trigger == Trigger::Sync)
    }
}

impl Drive {
    /// The station under which it is reached on the bus itself.
    pub fn station(&self) -> u8 {
        station(self.node)
    }

    /// Whether any of its PDOs waits for SYNC.
    pub fn uses_sync(&self) -> bool {
        self.tx.iter().any(|tx| tx.trigger == Trigger::Sync) || self.rx.iter().any(|rx| rx.on_sync)
    }
}

impl Numbering {
    /// As plans name it.
    pub fn name(self) -> &'static str {
        match self {
            Numbering::FromTime => "0-1",
            Numbering::FromOff => "0-2",
        }
    }
}
