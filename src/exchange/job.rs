//! A question on its way: what is asked now, what it waits for, and when it is over at the latest.

use super::dialect::{Dialect, Question, Said};
use super::heard::Weight;
use super::ledger::Ledger;
use super::limits::{ROUNDS, WITNESSES};
use super::{Answer, ExchangeError, Limits, MOST_BYTES};
use crate::tick::{Span, Tick};

/// How a question ends.
pub(super) type Outcome = Result<Answer, ExchangeError>;

/// A question that was given up before its time, and whose reply may be on its way.
#[derive(Debug)]
pub(super) struct Orphan {
    pub(super) station: u8,
    pub(super) question: Question,
    pub(super) deadline: Tick,
    pub(super) came: Vec<u8>,
}

/// A question, from the moment at which somebody wanted to know until he is told.
#[derive(Debug)]
pub(super) struct Job {
    pub(super) station: u8,
    pub(super) question: Question,
    pub(super) parting: Parting,
    /// It is parted although the station owes nothing.
    pub(super) kept: bool,
    pub(super) limits: Limits,
    /// When somebody wanted to know.
    pub(super) wanted: Tick,
    /// It is over then, whatever comes.
    pub(super) until: Tick,
    /// How long its telegrams may still wait for a silent line.
    pub(super) patience: Span,
    /// So many replies were on their way when it was asked that could be taken for its answer, where nothing keeps them in order.
    pub(super) older: Option<usize>,
    /// How often what is asked now was asked.
    pub(super) asked: u8,
    /// How often the same fence was asked; others are told apart by their answers.
    pub(super) same_fence: u8,
    /// How often it was asked anew because its answer may have been an older one.
    pub(super) rounds: u8,
    /// Answers that may be overtaken ones to something else, until others agree with them.
    pub(super) witnesses: Vec<Said>,
    /// The answer came behind garbage as long as a telegram.
    pub(super) doubted: bool,
    /// The answer came behind a little noise at least.
    pub(super) noisy: bool,
    /// The answer came in words that were heard a moment ago, and later than ever.
    pub(super) again: bool,
    /// What was said first, when it was doubted only for how it came.
    pub(super) first: Option<Doubted>,
    /// Echoes, or what may be one, came in place of the fence's answer: somebody is there.
    pub(super) echoed: bool,
    /// The station sent something valid meanwhile: it is there, and late.
    pub(super) heard: bool,
    /// A suspect has answered the fence so often.
    pub(super) counted: Option<Count>,
    /// The last fence is waited for as long as any reply may take.
    pub(super) patient: bool,
    pub(super) phase: Phase,
}

/// An answer that is doubted for how it came.
#[derive(Debug)]
pub(super) struct Doubted {
    pub(super) said: Said,
    /// When it was doubted.
    pub(super) since: Tick,
    /// How long after the question, in microseconds.
    pub(super) after: i64,
    /// It came behind noise.
    pub(super) noisy: bool,
    /// It came in words of a moment ago.
    pub(super) again: bool,
}

/// What keeps old replies from the question.
#[derive(Clone, Debug)]
pub(super) enum Parting {
    /// Nothing old can come that could be confused.
    None,
    /// This is asked first, but not before the time.
    Fence(Question, Tick),
    /// Nothing is sent before the time, and then nothing is owed any more.
    Until(Tick),
    /// Nothing is sent before the time: copies of what was heard may come until then.
    Quiet(Tick),
}

#[derive(Debug)]
pub(super) enum Phase {
    /// Waiting for a silent line, since then.
    Gap(Tick),
    Reply(Waiting),
    /// The answer has come, and a second one may.
    Second(Second),
    Turnaround(Tick),
    /// The exchange is to be ended on the line, at the latest by then.
    Farewell(Outcome, Tick),
    Done(Outcome),
}

/// Waiting for the reply to a telegram.
#[derive(Debug)]
pub(super) struct Waiting {
    pub(super) sent: Vec<u8>,
    pub(super) sent_at: Tick,
    pub(super) sent_end: Tick,
    pub(super) deadline: Tick,
    pub(super) came: Vec<u8>,
    pub(super) last: Tick,
    /// The echo of the telegram has been taken away already.
    pub(super) echoed: bool,
    pub(super) stray: Option<u8>,
    /// Bytes of an answer that was too short for one.
    pub(super) short: Option<u8>,
    pub(super) garbage: Vec<u8>,
    /// An answer that is believed only if no other comes.
    pub(super) held: Option<Held>,
}

/// An answer that may be somebody else's, or to something else.
#[derive(Clone, Debug)]
pub(super) struct Held {
    pub(super) said: Said,
    pub(super) bytes: Vec<u8>,
    pub(super) at: Tick,
    pub(super) weight: Weight,
    /// It came behind garbage as long as a telegram.
    pub(super) doubted: bool,
    /// When it is decided upon.
    pub(super) until: Tick,
}

/// An answer behind which a second one may come.
#[derive(Debug)]
pub(super) struct Second {
    pub(super) said: Said,
    /// When its question went out and was over, and when it came.
    pub(super) sent: (Tick, Tick),
    pub(super) at: Tick,
    pub(super) until: Tick,
    pub(super) came: Vec<u8>,
    /// The second one.
    pub(super) second: Option<Said>,
}

/// How often what cannot be mistaken was answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Count {
    Once,
    Twice,
}

impl Job {
    /// What is asked now: the fence, if there is one, then the question.
    pub(super) fn asks(&self) -> &Question {
        match &self.parting {
            Parting::Fence(fence, _) => fence,
            Parting::None | Parting::Until(_) | Parting::Quiet(_) => &self.question,
        }
    }

    pub(super) fn is_fenced(&self) -> bool {
        matches!(self.parting, Parting::Fence(..))
    }

    /// Whether it may be asked once more because its answer may have been an older one.
    pub(super) fn may_ask_anew(&self) -> bool {
        self.rounds < ROUNDS && self.limits.witness
    }

    /// It goes out now where nothing keeps replies in order: what may come in place of its answer was asked before.
    pub(super) fn reckons(&mut self, dialect: Dialect, ledger: &mut Ledger, now: Tick) {
        if matches!(self.parting, Parting::Quiet(_)) && self.witnesses.len() >= WITNESSES {
            self.witnesses.clear(); // what was said before may have been any of them
        }
        if !self.is_fenced() && self.witnesses.is_empty() {
            let open = ledger.open(dialect, self.station, &self.question, now);
            self.older = Some(self.older.map_or(open, |older| older.min(open)));
        }
        ledger.asks(self.station, self.asks().clone(), now);
    }

    /// In how many different words it was answered, with these.
    pub(super) fn in_how_many_words(&self, said: &Said) -> usize {
        let first = |(place, witness): &(usize, &Said)| {
            *witness != said && !self.witnesses.iter().take(*place).any(|earlier| earlier == *witness)
        };
        1 + self.witnesses.iter().enumerate().filter(first).count()
    }

    /// It is asked as if it had not been asked yet.
    pub(super) fn begins_anew(&mut self, parting: Parting, phase: Phase) {
        (self.parting, self.phase) = (parting, phase);
        (self.asked, self.same_fence, self.echoed, self.patient) = (0, 0, false, false);
    }

    /// The times between which its next telegram may go out: not before the first, which bytes put off; at the second it
    /// goes out nevertheless, or never.
    pub(super) fn slot(&self, since: Tick, ready_at: Tick, orphan: Option<Tick>) -> (Tick, Tick) {
        let parted = match self.parting {
            Parting::Fence(_, until) | Parting::Until(until) | Parting::Quiet(until) => until,
            Parting::None => since,
        };
        let due = parted.max(orphan.unwrap_or(since)).max(since);
        match self.limits.insist {
            Some(insist) => (ready_at.max(due).min(since + insist), since + insist),
            None => (ready_at.max(due), due + self.patience),
        }
    }
}

impl Waiting {
    pub(super) fn new(sent: Vec<u8>, sent_at: Tick, sent_end: Tick, timeout: Span) -> Self {
        Waiting {
            sent,
            sent_at,
            sent_end,
            deadline: sent_end + timeout,
            came: Vec::new(),
            last: sent_end,
            echoed: false,
            stray: None,
            short: None,
            garbage: Vec::new(),
            held: None,
        }
    }

    /// Whether our telegram came back before this place.
    pub(super) fn has_echoed(&self, place: usize) -> bool {
        let before = self.came.get(..place).unwrap_or_default();
        self.echoed || before.windows(self.sent.len()).any(|window| window == self.sent)
    }

    /// When what has come is looked at, if a telegram straggles for so long: when the line falls silent, but soon after the
    /// deadline in any case.
    pub(super) fn over(&self, straggle: Span) -> Tick {
        let over = if self.came.is_empty() { self.deadline } else { self.last.min(self.deadline) + straggle };
        self.held.as_ref().map_or(over, |held| held.until.min(over))
    }
}

/// Adds bytes of which the last are kept.
pub(super) fn keep(came: &mut Vec<u8>, bytes: &[u8]) {
    came.extend_from_slice(bytes);
    let surplus = came.len().saturating_sub(MOST_BYTES);
    came.drain(..surplus);
}
