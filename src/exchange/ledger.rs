//! What was asked of a station lately, and how many replies are still on their way, where nothing keeps them in order.
//!
//! Stations answer in the order in which they are asked, and wires keep it. Behind a gateway or a network a reply may come after
//! younger ones, by up to 7 s. A reply tells its form only, so of those of one form nobody knows which is still to come; but how many
//! there are is known, and which words they can bring.

use super::dialect::{Dialect, Question, Said};
use super::limits::LATEST_OF_ALL;
use crate::tick::Tick;
use std::collections::{BTreeMap, VecDeque};

/// Questions that are remembered of a station: more than are asked in the time.
const MOST: usize = 512;

#[derive(Debug)]
struct Asking {
    question: Question,
    at: Tick,
    /// No reply came that could have been to this.
    is_open: bool,
}

/// What one station was asked lately, and what it said to each question last.
#[derive(Debug, Default)]
struct Page {
    askings: VecDeque<Asking>,
    told: Vec<(Question, Said)>,
}

/// What every station was asked lately.
#[derive(Debug, Default)]
pub(super) struct Ledger(BTreeMap<u8, Page>);

impl Ledger {
    /// A question goes out.
    pub(super) fn asks(&mut self, station: u8, question: Question, at: Tick) {
        let page = self.0.entry(station).or_default();
        while page.askings.front().is_some_and(|old| at >= old.at + LATEST_OF_ALL || page.askings.len() >= MOST) {
            page.askings.pop_front();
        }
        page.told.retain(|(told, _)| page.askings.iter().any(|asking| asking.question == *told));
        page.askings.push_back(Asking { question, at, is_open: true });
    }

    /// A reply came, whoever waited for it. Of those that it can be to, the youngest stay open: they may come longest.
    pub(super) fn hears(&mut self, station: u8, said: &Said) {
        let askings = self.0.get_mut(&station).into_iter().flat_map(|page| &mut page.askings);
        if let Some(oldest) = askings.filter(|old| old.is_open).find(|old| old.question.is_answered_by(said)) {
            oldest.is_open = false;
        }
    }

    /// A question was answered so.
    pub(super) fn is_told(&mut self, station: u8, question: &Question, said: &Said) {
        let Some(page) = self.0.get_mut(&station) else { return };
        page.told.retain(|(told, _)| told != question);
        page.told.push((question.clone(), said.clone()));
    }

    /// How many replies may come in place of the answer to this question; none, if nothing else was asked that has such replies.
    pub(super) fn open(&self, dialect: Dialect, station: u8, question: &Question, now: Tick) -> usize {
        let alike = |old: &Asking| dialect.confuses(&old.question, question);
        let is_open = |old: &&Asking| old.is_open && (old.question == *question || alike(old));
        if self.lately(station, now).any(alike) { self.lately(station, now).filter(is_open).count() } else { 0 }
    }

    /// How many of them may come in these words: of what was asked, as far as nobody knows that its station says something else.
    pub(super) fn in_words(&self, dialect: Dialect, station: u8, question: &Question, said: &Said, now: Tick) -> usize {
        let told = self.0.get(&station).map_or(&[][..], |page| &page.told);
        let may_say =
            |asked: &Question| told.iter().find(|(told, _)| told == asked).is_none_or(|(_, told)| told == said);
        let alike = |old: &&Asking| dialect.confuses(&old.question, question) && may_say(&old.question);
        self.lately(station, now).filter(alike).count()
    }

    fn lately(&self, station: u8, now: Tick) -> impl Iterator<Item = &Asking> {
        let page = self.0.get(&station);
        page.into_iter().flat_map(|page| &page.askings).filter(move |old| now < old.at + LATEST_OF_ALL)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::modbus::Framing;
    use crate::protocol::modbus::pdu::{Reply, Request};
    use crate::tick::Span;

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    fn read(start: u16) -> Question {
        Request::ReadRegisters { start, count: 1 }.into()
    }

    fn words(words: &[u16]) -> Said {
        Said::Modbus(Reply::Registers(words.to_vec()))
    }

    fn open(ledger: &Ledger, start: u16, ms: u64) -> usize {
        ledger.open(Dialect::new(Framing::Rtu.into()), 1, &read(start), at(ms))
    }

    fn in_words(ledger: &Ledger, start: u16, said: u16) -> usize {
        ledger.in_words(Dialect::new(Framing::Rtu.into()), 1, &read(start), &words(&[said]), at(100))
    }

    #[test]
    fn every_question_brings_one_reply_within_seven_seconds() {
        let mut ledger = Ledger::default();
        ledger.asks(1, read(1), at(0));
        assert_eq!([open(&ledger, 1, 10), open(&ledger, 2, 10)], [0, 1], "to itself nothing is another's");
        ledger.asks(1, read(2), at(10));
        assert_eq!([open(&ledger, 1, 20), open(&ledger, 2, 20)], [2, 2], "nobody knows which comes first");
        ledger.hears(2, &words(&[7]));
        ledger.hears(1, &words(&[7, 8]));
        assert_eq!(open(&ledger, 1, 20), 2, "of somebody else, or no answer to them");
        ledger.hears(1, &words(&[7]));
        assert_eq!([open(&ledger, 1, 6_999), open(&ledger, 1, 7_009), open(&ledger, 1, 7_010)], [1, 1, 0]);
        ledger.hears(1, &words(&[7]));
        ledger.hears(1, &words(&[7]));
        assert_eq!(open(&ledger, 1, 20), 0);
    }

    #[test]
    fn a_reply_comes_in_no_words_but_those_that_its_station_says() {
        let mut ledger = Ledger::default();
        for (start, ms) in [(1, 0), (1, 10), (2, 20)] {
            ledger.asks(1, read(start), at(ms));
        }
        assert_eq!(in_words(&ledger, 3, 7), 3, "nobody knows what it says");
        ledger.is_told(1, &read(1), &words(&[7]));
        assert_eq!([in_words(&ledger, 3, 7), in_words(&ledger, 3, 8)], [3, 1]);
        ledger.is_told(1, &read(1), &words(&[8]));
        ledger.is_told(1, &read(2), &words(&[9]));
        assert_eq!([7, 8, 9].map(|said| in_words(&ledger, 3, said)), [0, 2, 1]);
        // What was asked long ago says nothing any more.
        ledger.asks(1, read(3), at(8_000));
        assert_eq!(ledger.0[&1].askings.len(), 1);
        assert!(ledger.0[&1].told.is_empty());
    }
}
