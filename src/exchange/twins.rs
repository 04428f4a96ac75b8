//! Whether one drive answers at an address, or two.
//!
//! A second drive shows itself by a second answer to one question. A repeater sends copies too, so at first that is only a
//! suspicion: from then on a question whose answer cannot be mistaken is asked before each other one, and so long is waited
//! as any copy takes. Answered twice, both drives have said all that is older; answered once, again and again, it is one
//! drive behind a repeater.

use super::heard::COPY_WITHIN;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// So often in a row a suspect must answer once until it is one drive; one that gave answers that differ, so much oftener.
const SINGLES: u8 = 2;
const SINGLES_OF_MARKED: u8 = 8;
/// So often in a row a suspect must answer twice until that is told.
const DOUBLES: u8 = 2;
/// So many questions must be lost right behind an answer until it is suspected.
const LOST: u8 = 2;
/// So many answers that differ make two drives; one may be a reply that another has overtaken.
const MARKS: u8 = 2;
/// So long two drives stay two; then somebody may have taken one away.
const TWO_FOR: Span = Span::from_secs(10);
/// A second answer comes within this time.
pub(super) const SECOND_WITHIN: Span = COPY_WITHIN;

/// What speaks for two drives at one address.
#[derive(Clone, Copy, Debug, Default)]
struct Standing {
    /// Answers that differ from the first to the same question.
    marks: u8,
    /// How often it answered once since it is suspected.
    singles: u8,
    /// How often it answered twice.
    doubles: u8,
    /// It was proven, at the latest then.
    two: Option<Tick>,
}

/// So often an answer behind garbage must have been said again in the same words until garbage is only garbage.
const VOUCHED: u8 = 2;

/// Addresses at which two drives may answer.
#[derive(Debug, Default)]
pub(super) struct Twins {
    by_station: BTreeMap<u8, Standing>,
    /// How often a question was lost right behind an answer.
    lost: BTreeMap<u8, u8>,
    /// How often an answer that was doubted for how it came was said again, and nothing spoke against it.
    vouched: BTreeMap<u8, u8>,
    /// Stations of which a second answer came in other words to what was asked once, answered, and owed by nobody.
    contradicted: BTreeSet<u8>,
}

impl Twins {
    /// An answer came once more, in the same words.
    pub(super) fn suspects(&mut self, station: u8) {
        self.by_station.entry(station).or_default();
    }

    /// A question was lost that went out right behind an answer: it may have met the second one. Whether that is often.
    pub(super) fn loses(&mut self, station: u8) -> bool {
        let lost = self.lost.entry(station).or_default();
        *lost = lost.saturating_add(1);
        *lost >= LOST
    }

    /// An answer that was doubted for how it came was said again in the same words.
    pub(super) fn vouches(&mut self, station: u8) {
        let vouched = self.vouched.entry(station).or_default();
        *vouched = vouched.saturating_add(1);
    }

    /// Whether what comes before its answers is garbage and nothing else.
    pub(super) fn is_vouched(&self, station: u8) -> bool {
        self.has_vouched(station) && !self.is_suspect(station)
    }

    /// The same, also of one that may be two drives.
    pub(super) fn has_vouched(&self, station: u8) -> bool {
        self.vouched.get(&station).is_some_and(|&vouched| vouched >= VOUCHED)
    }

    /// A second answer came in other words, but the first or the second may be to something older.
    pub(super) fn marks(&mut self, station: u8, now: Tick) {
        self.vouched.remove(&station);
        let standing = self.by_station.entry(station).or_default();
        (standing.marks, standing.singles) = (standing.marks.saturating_add(1), 0);
        if standing.marks >= MARKS {
            standing.two = Some(now);
        }
    }

    /// A second answer came in other words, and nothing was owed: no reply that is late can be that.
    pub(super) fn contradicts(&mut self, station: u8) {
        self.contradicted.insert(station);
    }

    /// Whether that was so since the line was opened.
    pub(super) fn is_contradicted(&self, station: u8) -> bool {
        self.contradicted.contains(&station)
    }

    /// Two answers to one question, and nothing older could come.
    pub(super) fn proves(&mut self, station: u8, now: Tick) {
        self.vouched.remove(&station);
        let standing = self.by_station.entry(station).or_default();
        (standing.marks, standing.two) = (standing.marks.saturating_add(1), Some(now));
    }

    /// What cannot be mistaken was answered so often.
    pub(super) fn counts(&mut self, station: u8, twice: bool) {
        if let Some(standing) = self.by_station.get_mut(&station) {
            standing.singles = if twice { 0 } else { standing.singles.saturating_add(1) };
            standing.doubles = if twice { standing.doubles.saturating_add(1) } else { 0 };
        }
    }

    /// Whether it answers everything twice, in the same words: two drives alike, or a repeater.
    pub(super) fn answers_twice(&self, station: u8) -> bool {
        self.by_station.get(&station).is_some_and(|standing| standing.marks == 0 && standing.doubles >= DOUBLES)
    }

    /// Whether more came from it than was asked for, and nothing speaks against two drives.
    pub(super) fn are_likely(&self, station: u8) -> bool {
        self.by_station.get(&station).is_some_and(|standing| standing.marks > 0 || standing.doubles > 0)
    }

    /// Whether it may be two drives.
    pub(super) fn is_suspect(&self, station: u8) -> bool {
        self.by_station
            .get(&station)
            .is_some_and(|standing| standing.singles < if standing.marks > 0 { SINGLES_OF_MARKED } else { SINGLES })
    }

    /// Whether it has ever given two answers that differ.
    pub(super) fn is_marked(&self, station: u8) -> bool {
        self.by_station.get(&station).is_some_and(|standing| standing.marks > 0)
    }

    /// Whether it is two drives.
    pub(super) fn are_two(&mut self, station: u8, now: Tick) -> bool {
        let Some(standing) = self.by_station.get_mut(&station) else { return false };
        if standing.two.is_some_and(|since| now.since(since) > TWO_FOR) {
            *standing = Standing { marks: 1, ..Standing::default() };
        }
        standing.two.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AT: u8 = 1;

    fn at(seconds: u64) -> Tick {
        Tick::ZERO + Span::from_secs(seconds)
    }

    /// Suspect, likely, marked, two.
    fn seen(twins: &mut Twins, now: Tick) -> [bool; 4] {
        let two = twins.are_two(AT, now);
        [twins.is_suspect(AT), twins.are_likely(AT), twins.is_marked(AT), two]
    }

    #[test]
    fn a_copy_is_a_suspicion_that_two_single_answers_take_away() {
        let mut twins = Twins::default();
        assert_eq!(seen(&mut twins, at(0)), [false; 4]);
        twins.suspects(AT);
        assert_eq!(seen(&mut twins, at(0)), [true, false, false, false]);
        twins.counts(AT, false);
        assert!(twins.is_suspect(AT));
        twins.counts(AT, false);
        assert_eq!(seen(&mut twins, at(0)), [false; 4]);
        twins.counts(2, true);
        assert!(!twins.are_likely(2), "of whom nobody suspects it nothing is counted");
    }

    #[test]
    fn a_contradiction_is_remembered_of_the_station_that_gave_it() {
        let mut twins = Twins::default();
        assert!(!twins.is_contradicted(AT));
        twins.contradicts(AT);
        assert_eq!([AT, 2].map(|station| twins.is_contradicted(station)), [true, false]);
    }

    #[test]
    fn what_answers_everything_twice_in_the_same_words_is_told_the_second_time() {
        let mut twins = Twins::default();
        twins.suspects(AT);
        let told: Vec<_> = [true, true, false, true]
            .map(|twice| {
                twins.counts(AT, twice);
                (twins.answers_twice(AT), twins.are_likely(AT), twins.is_suspect(AT))
            })
            .to_vec();
        assert_eq!(told, [(false, true, true), (true, true, true), (false, false, true), (false, true, true)]);
        twins.counts(AT, true);
        twins.marks(AT, at(0));
        assert!(!twins.answers_twice(AT) && twins.are_likely(AT), "its words differ");
    }

    #[test]
    fn one_answer_in_other_words_is_a_mark_and_two_are_two_drives() {
        let mut twins = Twins::default();
        twins.marks(AT, at(1));
        assert_eq!(seen(&mut twins, at(1)), [true, true, true, false]);
        for singles in 1..=8 {
            twins.counts(AT, false);
            assert_eq!(twins.is_suspect(AT), singles < 8, "{singles}");
        }
        twins.marks(AT, at(2));
        assert_eq!(seen(&mut twins, at(2)), [true; 4], "a mark begins the count anew");
    }

    #[test]
    fn two_drives_stay_two_for_a_while_and_marked_after_it() {
        let mut twins = Twins::default();
        twins.proves(AT, at(5));
        assert_eq!([5, 14, 15].map(|second| twins.are_two(AT, at(second))), [true; 3]);
        assert_eq!(seen(&mut twins, at(16)), [true, true, true, false], "somebody may have taken one away");
        twins.marks(AT, at(17));
        assert!(twins.are_two(AT, at(17)), "the mark of then still counts");
    }

    #[test]
    fn answers_said_again_vouch_for_one_that_is_no_suspect_until_it_says_something_else() {
        let mut twins = Twins::default();
        let vouched = |twins: &mut Twins| {
            twins.vouches(AT);
            twins.is_vouched(AT)
        };
        assert_eq!([vouched(&mut twins), vouched(&mut twins)], [false, true]);
        assert!(!twins.is_vouched(2));
        twins.suspects(AT);
        assert!(!twins.is_vouched(AT), "two may say the same");
        twins.counts(AT, false);
        twins.counts(AT, false);
        assert!(twins.is_vouched(AT));
        twins.marks(AT, at(1));
        (0..8).for_each(|_| twins.counts(AT, false));
        assert!(!twins.is_suspect(AT) && !twins.is_vouched(AT), "it begins anew");
        assert_eq!([vouched(&mut twins), vouched(&mut twins)], [false, true]);
        twins.proves(AT, at(2));
        assert!(!twins.vouched.contains_key(&AT));
    }

    #[test]
    fn a_second_question_that_is_lost_behind_an_answer_is_often() {
        let mut twins = Twins::default();
        assert_eq!([AT, 2, AT, AT].map(|station| twins.loses(station)), [false, false, true, true]);
    }
}
