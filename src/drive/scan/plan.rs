//! What is to be searched, and how.

use super::Tuning;
use super::order::Unknown;
use crate::tick::Span;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::rc::Rc;

/// How long stations are waited for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Manner {
    /// One time around: who is late or garbled is missed. The first setting with a drive ends the search for settings.
    Fast,
    /// The next is asked after a short window, but everybody has the full time.
    #[default]
    Usual,
    /// By the book: the full time for each before the next is asked.
    Thorough,
}

/// What to search. The setting of the session is what is known, or guessed, of the line.
#[derive(Clone, Debug)]
pub struct ScanPlan {
    /// Addresses, in the order in which they are asked.
    pub addresses: Vec<u8>,
    /// What is to be found out of the line.
    pub unknown: Unknown,
    /// How long stations are waited for.
    pub manner: Manner,
    /// The first drive ends the search, whoever finds it.
    pub until_first: Option<First>,
    /// What earlier searches have asked already.
    pub before: Vec<Asked>,
    /// Goes on beside another master.
    pub force: bool,
    /// It ends then, whatever is left; whoever was just found is still asked what it is.
    pub within: Option<Span>,
}

impl ScanPlan {
    /// A search at the setting of the session.
    pub fn new(addresses: impl IntoIterator<Item = u8>) -> Self {
        ScanPlan {
            addresses: addresses.into_iter().collect(),
            unknown: Unknown::default(),
            manner: Manner::Usual,
            until_first: None,
            before: Vec::new(),
            force: false,
            within: None,
        }
    }
}

/// Whether any of several searches has found a drive.
#[derive(Clone, Debug, Default)]
pub struct First(Rc<Cell<bool>>);

impl First {
    pub(super) fn is_found(&self) -> bool {
        self.0.get()
    }

    pub(super) fn found(&self) {
        self.0.set(true);
    }
}

/// What was asked at one setting.
#[derive(Clone, Debug)]
pub struct Asked {
    /// The line setting as it is shown.
    pub line: String,
    /// Name of the protocol.
    pub protocol: String,
    /// Addresses.
    pub addresses: BTreeSet<u8>,
    /// A drive was found there.
    pub found: bool,
}

impl Asked {
    pub(super) fn is_at(&self, tuning: Tuning) -> bool {
        self.line == tuning.line.to_string() && self.protocol == tuning.protocol.name()
    }
}
