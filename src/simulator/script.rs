//! The script of a station: what happens to it, and when.

use crate::tick::{Span, Tick};

/// Something that the script lets happen, once.
#[derive(Clone, Debug)]
pub(super) struct Event {
    pub(super) trigger: Trigger,
    pub(super) action: Action,
    /// The opposite follows after this time.
    pub(super) lasts: Option<Span>,
}

/// What it waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Trigger {
    /// A time.
    At(Tick),
    /// The output stage works.
    Running,
    /// The turning field is faster than this, in either direction; 0.01 Hz.
    Above(i64),
    /// So many writes have come to it, broadcasts included, obeyed or refused. The last of them is obeyed first; its
    /// reply comes after the event.
    Writes(u64),
    /// So many telegrams have come to it. The last of them is obeyed first; its reply comes after the event.
    Telegrams(u64),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// A fault: the value of P.260.
    Fault(u16),
    /// An asynchronous error of an LXM05.
    Error(super::lexium::Fault),
    /// The warning word P.270.
    Warning(u16),
    PowerCycle,
    /// Off the bus for so long.
    Silent(Span),
    Mains(bool),
    /// S1IND: STOA of an ACU.
    StoA(bool),
    /// STOB of an ACU.
    StoB(bool),
    StartRight(bool),
    StartLeft(bool),
    /// Load at the shaft, percent of the rated torque.
    Torque(i64),
}

impl Action {
    /// What undoes it, if that is a thing to do.
    pub(super) fn opposite(self) -> Option<Action> {
        Some(match self {
            Action::Mains(on) => Action::Mains(!on),
            Action::StoA(on) => Action::StoA(!on),
            Action::StoB(on) => Action::StoB(!on),
            Action::StartRight(on) => Action::StartRight(!on),
            Action::StartLeft(on) => Action::StartLeft(!on),
            _ => return None,
        })
    }
}
