//! How long a search lasts: what its questions take on a silent line, times what they took longer so far.
//!
//! A setting costs, for each address, the question on the wire and the window of its [`Patience`](crate::exchange::survey::Patience),
//! and once what is waited for behind the last one. An adapter, a driver that sets another speed slowly, noise: all of that
//! shows in what has gone by, so the rest is stretched by it. The quick looks of the first rounds tell nothing of how many are
//! asked again later; the garbage that came tells it. A find moves a setting forward and adds the look at it.

use crate::tick::Span;

/// What was expected so far, and what it took.
#[derive(Clone, Copy, Debug, Default)]
struct Ratio {
    expected: Span,
    took: Span,
}

impl Ratio {
    fn note(&mut self, expected: Span, took: Span) {
        self.expected = self.expected + expected;
        self.took = self.took + took;
    }

    /// How much longer it took, against so much that went as it is thought to.
    fn per_mille(self, thought: u64) -> u64 {
        let presumed = Span::from_micros(FAITH.as_micros() * thought / 1_000);
        (self.took + presumed).as_micros() * 1_000 / (self.expected + FAITH).as_micros().max(1)
    }
}

/// The pace of a search so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pace {
    /// Of quick looks.
    quick: Ratio,
    /// Where who was garbled is asked again.
    whole: Ratio,
    questions: u64,
    garbage: u64,
    /// It was listened to so long, and nobody asked.
    listened: Span,
}

/// What is asked at one setting.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Work {
    /// Quick looks take so long on a silent line.
    pub quick: Span,
    /// The rest does.
    pub whole: Span,
}

impl Work {
    pub(super) fn sum(self) -> Span {
        self.quick + self.whole
    }

    pub(super) fn and(self, other: Work) -> Work {
        Work { quick: self.quick + other.quick, whole: self.whole + other.whole }
    }
}

/// A visit to a setting, as it was.
#[derive(Clone, Copy, Debug)]
pub(super) struct Visited {
    pub expected: Work,
    pub took: Span,
    pub questions: usize,
    pub garbage: u32,
}

/// The first few settings tell little: they are weighed against so much that went as it is thought to.
const FAITH: Span = Span::from_secs(2);
/// What garbage costs that is everywhere, in thousandths: telegrams that come in are waited for.
const FEW_AGAIN: u64 = 300;
/// A setting is left at the latest after so many times what it costs on a silent line: noise is no reason to stay.
const STRETCH: u64 = 2;
/// And this: a telegram that is coming in is waited for, and every driver takes its time.
const GRACE: Span = Span::from_millis(500);
/// Where a drive was found, whoever is garbled is asked again more often.
const SURE_STRETCH: u64 = 3;
/// And this.
const SURE_GRACE: Span = Span::from_secs(5);
/// What the last telegrams may take beyond the end of a search.
const SLACK: Span = Span::from_secs(5);

impl Pace {
    /// A setting was asked.
    pub(super) fn note(&mut self, visited: Visited) {
        let Visited { expected, took, questions, garbage } = visited;
        let ratio = if expected.whole == Span::ZERO { &mut self.quick } else { &mut self.whole };
        ratio.note(expected.sum(), took);
        self.questions += questions as u64;
        self.garbage += u64::from(garbage);
    }

    /// It was listened to so long.
    pub(super) fn overhears(&mut self, listened: Span, garbage: u32) {
        self.listened = self.listened + listened;
        self.garbage += u64::from(garbage);
    }

    /// What such a rest takes as it goes. A reply may come until `full` is over: so long before garbage everybody is suspected.
    pub(super) fn stretched(&self, rest: Work, full: Span) -> Span {
        let took = self.quick.took + self.whole.took + self.listened;
        let again = full.as_micros() * self.garbage * 1_000 / (took + FAITH).as_micros();
        // After garbage behind most questions nobody is asked again.
        let is_everywhere = self.questions > 0 && self.garbage * 2 > self.questions;
        let again = if is_everywhere { FEW_AGAIN } else { again.min(1_000 * (STRETCH - 1)) };
        let part = |rest: Span, per_mille: u64| Span::from_micros(rest.as_micros() / 1_000 * per_mille);
        part(rest.quick, self.quick.per_mille(1_000)) + part(rest.whole, self.whole.per_mille(1_000 + again))
    }
}

/// The longest that a setting gets.
pub(super) fn limit(expected: Span, is_sure: bool) -> Span {
    if is_sure { expected.times(SURE_STRETCH) + SURE_GRACE } else { expected.times(STRETCH) + GRACE }
}

/// The longest that a search takes, without the looks at its finds.
pub(super) fn at_most(expected: Span) -> Span {
    expected.times(STRETCH) + SLACK
}
