//! How often a station has said the words of one answer as another one: by this it is known to repeat itself, and no copy of it
//! is feared where none has ever come.

use std::collections::BTreeMap;

/// So often no other answer must have come behind words of another one, until none is waited for any more: a station that was slow once
/// would cost that for each value.
const ALONE: u8 = 6;
/// So many words must have been the answer to two things until no others of this station are asked for again: each costs a fence and a
/// question, and the first is most often 0, which tells nothing of the others.
const WORDS: usize = 2;
/// Words that are remembered of a station.
const MOST: usize = 64;

/// What stations have said twice.
#[derive(Debug, Default)]
pub(super) struct Alike {
    /// How often a station said what had been another answer, and then said it again.
    words: BTreeMap<u8, BTreeMap<Vec<u8>, u8>>,
    /// How often nothing came behind words of another answer.
    alone: BTreeMap<u8, u8>,
}

impl Alike {
    /// An answer in the words of another one was said again.
    pub(super) fn vouches(&mut self, station: u8, bytes: &[u8]) {
        let words = self.words.entry(station).or_default();
        if words.contains_key(bytes) || words.len() < MOST {
            let often = words.entry(bytes.to_vec()).or_default();
            *often = often.saturating_add(1);
        }
    }

    /// Whether these words were vouched for so often, or enough others were.
    pub(super) fn vouched(&self, station: u8, bytes: &[u8], wanted: u8) -> bool {
        let words = self.words.get(&station);
        let known = |words: &BTreeMap<_, _>| words.values().filter(|&&often| often >= wanted).count() >= WORDS;
        words.is_some_and(|words| words.get(bytes).is_some_and(|&often| often >= wanted) || known(words))
    }

    /// Behind words of another answer nothing came in its usual time.
    pub(super) fn comes_alone(&mut self, station: u8) {
        let alone = self.alone.entry(station).or_default();
        *alone = alone.saturating_add(1);
    }

    /// Whether nothing ever came behind them, often enough.
    pub(super) fn is_trusted(&self, station: u8) -> bool {
        self.alone.get(&station).is_some_and(|&alone| alone >= ALONE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_tells_nothing_of_others_until_there_were_two() {
        let mut alike = Alike::default();
        alike.vouches(1, &[0]);
        let vouched = |alike: &Alike, wanted| [0, 1, 9].map(|word| alike.vouched(1, &[word], wanted));
        assert_eq!([vouched(&alike, 1), vouched(&alike, 2)], [[true, false, false], [false; 3]]);
        assert!(!alike.vouched(2, &[0], 1), "of another station");
        alike.vouches(1, &[1]);
        assert_eq!([vouched(&alike, 1), vouched(&alike, 2)], [[true; 3], [false; 3]]);
        (0..400).for_each(|_| alike.vouches(1, &[0]));
        assert_eq!(vouched(&alike, 2), [true, false, false]);
    }

    #[test]
    fn nothing_is_waited_for_behind_who_came_alone_so_often() {
        let mut alike = Alike::default();
        (1..ALONE).for_each(|_| alike.comes_alone(1));
        assert!(!alike.is_trusted(1));
        alike.comes_alone(1);
        assert!(alike.is_trusted(1) && !alike.is_trusted(2));
    }
}
