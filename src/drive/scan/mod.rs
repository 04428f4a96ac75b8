//! Who is there, and with what setting? Surveys of one line, in the order in which drives are likely to be found.

mod look;
mod on_bus;
mod order;
mod pace;
mod plan;
mod search;
mod stages;

use super::access::AccessError;
use super::route::{self, Inquiry};
use super::session::Session;
use super::trouble;
pub use crate::exchange::Talker;
use crate::failure::Failure;
use crate::outcome::{FoundDrive, Warning};
use crate::profile::{Registry, Type};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::text::both;
use crate::tick::Span;
pub use order::Unknown;
pub(super) use order::tunings;
pub use plan::{Asked, First, Manner, ScanPlan};
use search::Search;
use std::collections::BTreeSet;
use std::fmt;

/// Status word: every Modbus device says something when its register is read, and an ACTIVE drive answers it without
/// touching its error register.
const PROBE: u32 = 411;

/// What is spoken on a line, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tuning {
    /// What is spoken.
    pub protocol: Protocol,
    /// Speed and character format.
    pub line: LineSetting,
}

/// Prints as `19200 8E1 rtu`.
impl fmt::Display for Tuning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.line, self.protocol)
    }
}

/// What a search brought.
#[derive(Debug, Default)]
pub struct ScanResult {
    /// What answered.
    pub drives: Vec<FoundDrive>,
    /// What was asked at every setting that was to be tried, in the order of its likelihood.
    pub searched: Vec<Searched>,
    /// What is odd.
    pub warnings: Vec<Warning>,
    /// Somebody else speaks on this line, so that nothing more was sent.
    pub yielded: Option<Yielded>,
    /// The time that it was given was over before everybody was asked.
    pub is_over_time: bool,
    /// What is left would take about so long.
    pub left: Span,
    /// A bus has a master, so nobody was asked: what was heard is all that there is.
    pub unasked: Option<Failure>,
    /// Why it ended early.
    pub cut: Option<AccessError>,
}

impl ScanResult {
    /// The failure of a search that left addresses out because of what came over the line: who is there cannot be told. A
    /// setting at which nobody answers does not matter where drives answer at another one.
    pub fn left_out(&self) -> Option<Failure> {
        let elsewhere = !self.drives.is_empty();
        let matters = |row: &&Searched| !row.is_complete() && (row.found || !elsewhere);
        let never_silent = both!(
            "the line is never silent, so it was left alone",
            "die Leitung schweigt nie und wurde deshalb in Ruhe gelassen"
        );
        let disturbed = both!(
            "garbage kept coming, so not everybody had an undisturbed time to answer",
            "es kam immer wieder Unlesbares, deshalb hatten nicht alle ungestört Zeit zu antworten"
        );
        let mut rows = self.searched.iter().filter(matters);
        let (occupied, disturbed_at) = (rows.clone().any(|row| row.occupied), rows.any(|row| row.disturbed));
        let message = if occupied { Some(never_silent) } else { disturbed_at.then_some(disturbed) };
        message.map(trouble::never_silent)
    }
}

/// To whom a line was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Yielded {
    /// Who.
    pub to: Talker,
    /// How often he spoke before anything was sent, and in which time.
    pub bursts: u32,
    /// How long it was listened to.
    pub listened: Span,
    /// Nothing at all was sent.
    pub unasked: bool,
}

/// The search at one setting.
#[derive(Clone, Debug)]
pub struct Searched {
    /// The setting.
    pub tuning: Tuning,
    /// Addresses that were to be asked, in their order.
    pub wanted: Vec<u8>,
    /// Addresses that have had their time.
    pub asked: BTreeSet<u8>,
    /// Addresses that were asked at all.
    seen: BTreeSet<u8>,
    /// Addresses where only garbage came.
    pub garbled: BTreeSet<u8>,
    /// So many of the rounds are over here.
    rounds: usize,
    /// So many of the addresses had a quick look.
    looked: usize,
    /// Somebody was heard.
    hint: bool,
    /// A drive was found.
    found: bool,
    /// Somebody else has the line: it is left alone.
    occupied: bool,
    /// What came took so much time that not everybody could be asked.
    disturbed: bool,
}

impl Searched {
    /// Whether every address has had its time.
    pub fn is_complete(&self) -> bool {
        self.asked.len() == self.wanted.len()
    }

    /// Addresses that have not had their time.
    pub fn open(&self) -> BTreeSet<u8> {
        self.wanted.iter().filter(|address| !self.asked.contains(address)).copied().collect()
    }

    /// Addresses that have had their time.
    pub fn asked(&self) -> BTreeSet<u8> {
        self.asked.clone()
    }

    /// Addresses that were asked and have not had their time.
    pub fn glimpsed(&self) -> BTreeSet<u8> {
        self.seen.difference(&self.asked).copied().collect()
    }

    /// How many of the first addresses have not had their time.
    fn open_of(&self, first: usize) -> usize {
        self.wanted.iter().take(first).filter(|address| !self.asked.contains(address)).count()
    }
}

/// The question that every address is asked first.
pub fn probe_question() -> Inquiry {
    Inquiry::Read(route::Cell { number: PROBE, set: 0 }, Type::Uint)
}

/// Writes `1-10,17`.
pub fn ranges(addresses: &BTreeSet<u8>) -> String {
    let mut runs: Vec<(u8, u8)> = Vec::new();
    for &address in addresses {
        match runs.last_mut() {
            Some((_, last)) if last.checked_add(1) == Some(address) => *last = address,
            _ => runs.push((address, address)),
        }
    }
    let shown =
        runs.iter().map(|(first, last)| if first == last { first.to_string() } else { format!("{first}-{last}") });
    shown.collect::<Vec<_>>().join(",")
}

/// Searches a line. Tells progress and finds as they come; what was found stays when it is interrupted.
pub async fn scan(session: &mut Session<'_>, plan: &ScanPlan, registry: &Registry) -> ScanResult {
    if let Some(heard) = on_bus::only_listens(session, plan).await {
        return heard;
    }
    let mut search = Search::new(session, plan, registry);
    let cut = search.run().await.err();
    let mut result = search.ended(cut);
    result.warnings.extend(on_bus::about_master(session, &result.drives));
    result
}
