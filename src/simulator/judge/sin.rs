//! What a master may not do, and how it is told.

use crate::tick::Tick;
use std::fmt;

/// What the judge noted about the master.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// When it happened.
    pub at: Tick,
    /// Which rule was broken.
    pub kind: Sin,
    /// What happened, with figures.
    pub text: String,
}

/// Rules that a master can break.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sin {
    /// A request less than 2 ms, or t3.5 on RTU, after the last bit of a reply (CM-485 manual 6.8, 6.7.1.3).
    TooEarly,
    /// A request while a drive answers, or while a drive that took the last one has not yet answered and 500 ms are
    /// not over (CM-485 manual 6.8); two telegrams at once.
    WhileBusy,
    /// A request less than 500 ms after one that no drive has taken (CM-485 manual 6.8): no drive is disturbed, but
    /// the master could not know that.
    Impatient,
    /// A pause of more than 1.5 characters inside an RTU telegram, or of more than 1 s inside an ASCII one
    /// (CM-485 manual 6.7.1.3, 6.7.2.2).
    GapInside,
    /// Less than 3.5 characters between two RTU telegrams of the master (CM-485 manual 6.7.1.3).
    GapBefore,
    /// A broadcast that is no write (CM-485 manual 6.1).
    BroadcastRead,
    /// VABus: a SELECT to a drive that sent NAK and whose P.11 has not been read since (sources A2).
    Locked,
    /// VABus: more than three transmissions of one telegram without a good reply or an EOT between them (sources A2).
    TooOften,
    /// Bytes that are no telegram: check value, length, digits, address, character format.
    Malformed,
}

impl Sin {
    /// A stable word for it: `too-early`.
    pub fn name(self) -> &'static str {
        match self {
            Sin::TooEarly => "too-early",
            Sin::WhileBusy => "while-busy",
            Sin::Impatient => "impatient",
            Sin::GapInside => "gap-inside",
            Sin::GapBefore => "gap-before",
            Sin::BroadcastRead => "broadcast-read",
            Sin::Locked => "locked",
            Sin::TooOften => "too-often",
            Sin::Malformed => "malformed",
        }
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} ({})", self.at.since(Tick::ZERO), self.text, self.kind.name())
    }
}
