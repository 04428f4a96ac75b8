//! What nobody answers: where that must be said while it goes on being sent, and where nobody is asked again.

use super::Session;
use crate::exchange::{Answer, ExchangeError, Question};
use crate::outcome::Event;
use crate::text::Text;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// Without a valid answer for so long it is said.
const LONG: Span = Span::from_secs(2);

/// What is said where no answer comes.
#[derive(Debug)]
pub(super) struct Warns {
    told: bool,
    text: Text,
    /// The last valid answer, or the beginning.
    since: Tick,
}

/// What is known of the stations that are talked to.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// Behind a gateway: why the first value that was asked of each brought no answer; `None`: it has answered.
    ///
    /// A gateway waits for its station itself and says so if that does not answer (exception 0B, V1.1b3 7): who never said a word within
    /// the longest time that a question has will not say one to the next.
    mute: BTreeMap<u8, Option<ExchangeError>>,
    asks_on: bool,
    /// These have told what an earlier master left there, and take a write.
    unlocked: BTreeSet<u8>,
}

impl Session<'_> {
    /// From now on who has never answered is asked again all the same: for what counts that, or waits for it.
    pub(in crate::drive) fn asks_on(&mut self) {
        self.known.asks_on = true;
    }

    /// Why a station is not asked again. What must be sent is sent all the same.
    pub(in crate::drive) fn is_mute(&self, station: u8) -> Option<ExchangeError> {
        let asks = self.insists || self.known.asks_on;
        self.known.mute.get(&station).cloned().flatten().filter(|_| !asks)
    }

    /// What came of a question to a station.
    pub(super) fn notes_mute(&mut self, station: u8, question: &Question, outcome: &Result<Answer, ExchangeError>) {
        if !self.line.borrow().master.is_numbered() {
            return;
        }
        match outcome {
            // A function that a station does not know may be left without a word, against the standard.
            Err(ExchangeError::Silence { .. }) if !question.asks_for_a_value() => {}
            Err(silence @ ExchangeError::Silence { .. }) => {
                self.known.mute.entry(station).or_insert_with(|| Some(silence.clone()));
            }
            _ => {
                self.known.mute.insert(station, None);
            }
        }
    }

    /// How long a reply may still come that somebody owes. The line is kept for so long, whoever leaves.
    pub fn owes_for(&self) -> Option<Span> {
        let now = self.now();
        self.line.borrow().master.owes_until(now).map(|until| until.since(now))
    }

    /// Whether a station owes one.
    pub fn is_owed_by(&self, station: u8) -> bool {
        self.line.borrow().master.is_owed_by(station, self.now())
    }

    /// The longest that a station took for an answer so far.
    pub fn slowest_answer(&self, station: u8) -> Span {
        self.line.borrow().master.slowest_answer(station)
    }

    /// Whether a station was asked for what an earlier master left there.
    pub(in crate::drive) fn is_unlocked(&self, station: u8) -> bool {
        self.known.unlocked.contains(&station)
    }

    /// It has answered that.
    pub(in crate::drive) fn notes_unlocked(&mut self, station: u8) {
        self.known.unlocked.insert(station);
    }

    /// From now on this is told, once, where no valid answer comes for 2 s; what began to count before goes on.
    pub(in crate::drive) fn warns(&mut self, text: Text) {
        let since = self.now();
        self.warns.get_or_insert(Warns { told: false, text, since });
    }

    /// What is sent from now on may stay unanswered.
    pub(in crate::drive) fn warns_no_more(&mut self) {
        self.warns = None;
    }

    /// A question was answered, or not.
    pub(super) fn heeds(&mut self, is_answered: bool) {
        let now = self.now();
        let Some(warns) = &mut self.warns else { return };
        if is_answered {
            warns.since = now;
        } else if now.since(warns.since) >= LONG && !std::mem::replace(&mut warns.told, true) {
            let note = Event::Note(warns.text.clone());
            self.tell(note);
        }
    }
}
