//! What was heard on the line lately, and how soon stations answer: by this a copy of an older reply, or the reply of somebody
//! else, is told from the answer, although both may have the right form.
//!
//! * A repeater, a radio link or a second drive at one address may send a reply once more, up to 500 ms later
//!   (facts/readings.md). So bytes that were heard within that time prove nothing on a line that is known to do so.
//! * On a line that has shown nothing of the kind, an answer that comes sooner than this station has ever answered is waited
//!   upon for as long as the true one may take. On a quiet line this costs nothing.

use super::dialect::Question;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, VecDeque};

/// A copy comes within this time (facts/readings.md: 500 ms), and a little for the telegram itself.
pub(super) const COPY_WITHIN: Span = Span::from_millis(600);
/// Clocks and adapters are not more exact than this, on the bench too.
const TOLERANCE_US: i64 = 100;
/// An answer that comes so much later than ever is not the usual one (USB adapters hold bytes back for up to 16 ms,
/// facts/engineering.md).
const DAWDLE_US: i64 = 20_000;
/// An answer that came sooner than ever is waited upon for no longer than this, and so long beyond the slowest one.
const LONGEST_HOLD: Span = Span::from_millis(150);
const MARGIN: Span = Span::from_millis(5);
/// Telegrams that are remembered: more than fit into the time.
const MOST: usize = 512;

#[derive(Debug)]
struct Telegram {
    at: Tick,
    bytes: Vec<u8>,
    answered: Option<Question>,
}

/// How soon a station answers one kind of question, in microseconds from the end of the question to the start of the reply;
/// below zero where the line is none of wires.
#[derive(Clone, Copy, Debug)]
struct Pace {
    fastest: i64,
    slowest: i64,
}

/// What is remembered of a line.
#[derive(Debug, Default)]
pub(super) struct Heard {
    telegrams: VecDeque<Telegram>,
    paces: BTreeMap<(u8, u8), Pace>,
    /// A reply came twice, or one that nobody had asked for.
    surplus: bool,
}

/// An answer, as far as time and bytes tell of it.
#[derive(Clone, Debug)]
pub(super) struct Sample<'a> {
    pub(super) station: u8,
    pub(super) function: u8,
    pub(super) question: &'a Question,
    pub(super) bytes: &'a [u8],
    pub(super) at: Tick,
    /// From the end of the question to the start of the reply, microseconds.
    pub(super) after: i64,
}

/// Whether it is the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Weight {
    /// It is.
    Answer,
    /// It is, unless another comes so much longer after the end of the question.
    Wait(Span),
    /// It answers the question, but the true reply may still come.
    Stale(Span),
    /// It may be a copy of the answer to another question.
    Copy,
}

impl Heard {
    /// Remembers a telegram; `answered` is the question that it was taken for the answer to.
    pub(super) fn note(&mut self, at: Tick, bytes: &[u8], answered: Option<&Question>) {
        while self.telegrams.front().is_some_and(|old| at.since(old.at) > COPY_WITHIN || self.telegrams.len() >= MOST) {
            self.telegrams.pop_front();
        }
        self.telegrams.push_back(Telegram { at, bytes: bytes.to_vec(), answered: answered.cloned() });
    }

    /// Telegrams with these bytes that may be copied now.
    fn like(&self, at: Tick, bytes: &[u8]) -> impl Iterator<Item = &Telegram> {
        self.telegrams.iter().filter(move |old| old.bytes == bytes && at.since(old.at) <= COPY_WITHIN)
    }

    /// Whether the same bytes were heard a moment ago.
    pub(super) fn is_copy(&self, at: Tick, bytes: &[u8]) -> bool {
        self.like(at, bytes).next().is_some()
    }

    /// From when on nothing that was heard by now is copied any more.
    pub(super) fn quiet_at(&self, now: Tick) -> Tick {
        self.telegrams.back().map_or(now, |last| last.at + COPY_WITHIN).max(now)
    }

    /// Whether the line has brought more than was asked for.
    pub(super) fn has_surplus(&self) -> bool {
        self.surplus
    }

    /// The line brings more than was asked for.
    pub(super) fn sees_surplus(&mut self) {
        self.surplus = true;
    }

    /// Weighs an answer. `doubtful`: garbage came before it.
    pub(super) fn weigh(&self, sample: &Sample<'_>, doubtful: bool) -> Weight {
        let pace = self.paces.get(&(sample.station, sample.function));
        let soon = pace.is_some_and(|pace| sample.after + TOLERANCE_US < pace.fastest);
        let slowest = pace.map_or(0, |pace| pace.slowest);
        let slowest = Span::from_micros(u64::try_from(slowest).unwrap_or(0)).min(LONGEST_HOLD) + MARGIN;
        let mut alike = self.like(sample.at, sample.bytes).peekable();
        let is_new = alike.peek().is_none();
        let other = alike.any(|old| old.answered.as_ref() != Some(sample.question));
        let late = pace.is_some_and(|pace| sample.after > pace.slowest + DAWDLE_US);
        match (is_new, self.surplus || doubtful || late) {
            (false, true) if other => Weight::Copy,
            (false, true) => Weight::Stale(slowest),
            _ if soon => Weight::Wait(slowest),
            _ => Weight::Answer,
        }
    }

    /// An answer was believed without doubt: so soon does the station answer.
    pub(super) fn learn(&mut self, sample: &Sample<'_>) {
        let pace = Pace { fastest: sample.after, slowest: sample.after };
        let pace = self.paces.entry((sample.station, sample.function)).or_insert(pace);
        pace.fastest = pace.fastest.min(sample.after);
        pace.slowest = pace.slowest.max(sample.after);
    }
}
