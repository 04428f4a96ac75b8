//! Where a manual leaves a question open: the readings that a drive of the bench can be built with.
//!
//! Each row of a maker's table names a question and its readings; the first is the one of the standard bench. What decides
//! something has a [`Reading`] of its own, and the drive asks [`Readings::has`]. `bench.toml` tells them.

use std::marker::PhantomData;

/// The readings of a maker's manuals that differ from the standard bench.
pub(crate) trait Reading: Copy + 'static {
    /// All questions.
    const QUESTIONS: &'static [OpenQuestion<Self>];

    /// A number of its own, below 64.
    fn bit(self) -> u32;

    /// The question with this key.
    fn question(key: &str) -> Option<&'static OpenQuestion<Self>> {
        Self::QUESTIONS.iter().find(|row| row.key == key)
    }
}

/// An open question.
#[derive(Debug)]
pub(crate) struct OpenQuestion<R: 'static> {
    pub(crate) key: &'static str,
    /// Word, and what it changes; the first is the standard bench.
    pub(crate) words: &'static [(&'static str, Option<R>)],
}

/// A row of a table of questions.
pub(crate) const fn row<R>(key: &'static str, words: &'static [(&'static str, Option<R>)]) -> OpenQuestion<R> {
    OpenQuestion { key, words }
}

/// The readings of one drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Readings<R> {
    bits: u64,
    of: PhantomData<R>,
}

impl<R> Default for Readings<R> {
    fn default() -> Self {
        Readings { bits: 0, of: PhantomData }
    }
}

impl<R: Reading> Readings<R> {
    pub(crate) fn has(self, reading: R) -> bool {
        self.bits >> reading.bit() & 1 == 1
    }

    pub(crate) fn add(&mut self, reading: R) {
        self.bits |= 1 << reading.bit();
    }
}

/// Every question stands in the example, with all its words; the first is the standard.
#[cfg(test)]
pub(crate) fn are_told<R: Reading>(example: &str) {
    for row in R::QUESTIONS {
        assert!(row.words.len() > 1 && row.words[0].1.is_none(), "{}", row.key);
        let begins = format!("{} = \"{}\"", row.key, row.words[0].0);
        let line =
            example.lines().find(|line| line.starts_with(&begins)).unwrap_or_else(|| panic!("{begins} is not told"));
        assert!(row.words.iter().all(|word| line.contains(word.0)), "{line}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulator::device::{active, lexium};

    #[test]
    fn every_reading_is_told_by_the_help_and_the_first_is_the_standard() {
        let help = include_str!("../bench.toml");
        are_told::<active::readings::Reading>(help);
        are_told::<lexium::readings::Reading>(help);
    }
}
