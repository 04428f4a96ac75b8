//! Replies that stations still owe: after a time-out or garbage the missing reply may still come. A debt is paid by the
//! reply or settled by the answer to a fence, not by time alone.

use super::dialect::{Question, Said};
use super::limits::LATEST_OF_ALL;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// So long other programs are kept from the line for the sake of a reply that is missing, without a sign of it.
const HOLD: Span = Span::from_secs(2);

/// The longest that a drive takes to answer but under high load (CM-485 manual 6.8).
pub(super) const LATEST_REPLY: Span = Span::from_millis(500);

/// What one station owes.
#[derive(Clone, Debug, Default)]
struct Debt {
    missing: Vec<Question>,
    since: Tick,
    /// Nothing else can overtake the missing replies after this; a drive under load may still be late.
    due: Tick,
    /// How many replies may still come.
    owed: u32,
}

/// What every station owes, and who has answered anything yet.
#[derive(Debug, Default)]
pub(super) struct Debts {
    by_station: BTreeMap<u8, Debt>,
    heard: BTreeSet<u8>,
}

impl Debts {
    /// A station owes the reply to a question, which is due at a time.
    pub(super) fn owes(&mut self, station: u8, missing: Question, due: Tick, now: Tick) {
        let debt = self.by_station.entry(station).or_default();
        debt.since = now;
        debt.due = debt.due.max(due);
        debt.owed = debt.owed.saturating_add(1);
        if !debt.missing.contains(&missing) {
            debt.missing.push(missing);
        }
    }

    /// A station owes the reply to a fence too. That is none to be waited for.
    pub(super) fn owes_fence(&mut self, station: u8, fence: Question) {
        let Some(debt) = self.by_station.get_mut(&station) else { return };
        debt.owed = debt.owed.saturating_add(1);
        if !debt.missing.contains(&fence) {
            debt.missing.push(fence);
        }
    }

    /// A station sent something valid.
    pub(super) fn hears(&mut self, station: u8) {
        self.heard.insert(station);
    }

    /// A reply that nobody waited for: if it answers what its station was asked, that is one less that it owes.
    /// Tells whether it does.
    pub(super) fn pays(&mut self, station: u8, said: &Said) -> bool {
        let Some(debt) = self.by_station.get_mut(&station) else { return false };
        let pays = debt.missing.iter().any(|missing| missing.is_answered_by(said));
        if pays {
            debt.owed = debt.owed.saturating_sub(1);
        }
        if debt.owed == 0 {
            self.by_station.remove(&station);
        }
        pays
    }

    /// Everything that a station owed has come, or cannot come any more.
    pub(super) fn settle(&mut self, station: u8) {
        self.by_station.remove(&station);
    }

    /// Questions whose replies may still come from a station.
    pub(super) fn missing(&self, station: u8) -> &[Question] {
        self.by_station.get(&station).map_or(&[], |debt| &debt.missing)
    }

    /// When the replies are due that a station owes, and until when the latest of them may come.
    pub(super) fn due(&self, station: u8) -> Option<(Tick, Tick)> {
        self.by_station.get(&station).map(|debt| (debt.due, debt.since + LATEST_OF_ALL))
    }

    /// Until when a reply may still come from a station that has answered before and owes one.
    pub(super) fn until(&self) -> impl Iterator<Item = Tick> {
        let owing = self.by_station.iter().filter(|(station, _)| self.heard.contains(station));
        owing.map(|(_, debt)| debt.since + HOLD)
    }
}
