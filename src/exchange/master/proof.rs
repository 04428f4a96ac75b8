//! Answers that are proven by what comes behind them.
//!
//! A Modbus answer on a serial line names neither its question nor who gave it. On a line that brings more than was asked for
//! (a second drive at the address, a repeater) a question is therefore followed by a *sentinel*: a counter that has counted
//! every telegram, so that its answer tells which sentinel it belongs to.
//!
//! Why that proves the answer: every station answers in order. Whoever answers the sentinel has answered the question before
//! it, and after it was asked. If exactly one answer came between the question and the answer to the sentinel, and nothing
//! was lost or spoilt meanwhile, it is his, and so to this question: whoever else speaks, however late, however often.
//! No time needs to be waited for. What this cannot see is a line that loses the true answer without a trace and brings an
//! older one in its place, both within one such pair; or one that mixes telegrams up (`witness`).

use super::*;
use crate::exchange::limits::MOST_PROOFS;
use crate::protocol::modbus::Framing;
use crate::protocol::modbus::pdu::{Reply, Request};

/// The counter of all messages, which every family has (CM-485 manual 6.4.5; LXM05 manual, table 5.2).
const MESSAGES: u16 = 0x0B;
/// What a driver that switches direction leaves on the line before a telegram; more may be the rest of one.
const GLITCH: usize = 2;

/// An answer that waits for its proof.
#[derive(Clone, Debug)]
pub(in crate::exchange) struct Claim {
    said: Said,
    sent_end: Tick,
    at: Tick,
}

/// What came beside the answers since a question went out.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::exchange) struct Beside {
    /// Bytes of no telegram.
    garbage: usize,
    /// Further answers in the same words.
    copies: u8,
    /// An answer in other words.
    rival: bool,
}

/// A sentinel that was answered: the counter, and how many telegrams had been sent by then.
#[derive(Clone, Copy, Debug)]
pub(in crate::exchange) struct Counter {
    data: u16,
    sent: u64,
}

/// What keeps a question from going out right behind an answer: what follows an answer on this line would meet it.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::exchange) struct Ease {
    /// So long after an answer.
    span: Span,
    /// Until then, unless it is seen again.
    until: Tick,
    /// Nothing is sent before; what followed the last answer has come otherwise.
    pub(super) free_at: Tick,
}

/// What follows an answer later than this does not often meet a question.
const LONGEST_EASE: Span = Span::from_millis(100);
/// Where a question was lost behind an answer, and nobody knows what it met.
const FIRST_EASE: Span = Span::from_millis(25);

impl Ease {
    /// Something came so long after an answer that nobody had asked for.
    fn learn(&mut self, lag: Span, now: Tick) {
        if lag <= LONGEST_EASE {
            let held = if now < self.until { self.span } else { Span::ZERO };
            (self.span, self.until) = (held.longer(lag + MARGIN), now + LATEST_OF_ALL);
        }
        self.free_at = now;
    }

    pub(super) fn answers(&mut self, at: Tick) {
        self.free_at = if at < self.until { at + self.span } else { at };
    }
}

const MARGIN: Span = Span::from_millis(3);

impl Master {
    /// Whether the answer to such a question can be proven by a sentinel.
    pub(super) fn can_prove(&self, station: u8, question: &Question, limits: Limits, at: Tick) -> bool {
        let has_counter = self.counters.get(&station).is_none_or(|counters| counters.contains(&MESSAGES));
        matches!(self.protocol(), Protocol::Modbus(Framing::Rtu | Framing::Ascii))
            && has_counter
            && *question != sentinel()
            && self.is_told_apart(question, limits)
            && self.is_alone(at)
    }

    /// Whether the answer to what is asked now can be proven.
    pub(super) fn is_provable(&self, at: Tick) -> bool {
        self.job
            .as_ref()
            .is_some_and(|job| !job.is_fenced() && self.can_prove(job.station, &job.question, job.limits, at))
    }

    /// Whether the answer is to be proven: the line has brought something lately that nobody asked for.
    pub(super) fn must_prove(&self, at: Tick) -> bool {
        let doubts = |job: &Job| job.unsure || self.twins.is_wary(job.station, at);
        self.job.as_ref().is_some_and(doubts) && self.is_provable(at)
    }

    /// Keeps the answer, and asks the sentinel.
    pub(super) fn prove(&mut self, at: Tick, sent_end: Tick, said: Said) {
        self.ease.answers(at);
        let Some(job) = &mut self.job else { return };
        if self.twins.are_two(job.station, at) {
            job.phase = Phase::Done(Err(ExchangeError::TwoAnswers { station: job.station }));
            return;
        }
        self.answered = Some((job.station, job.question.clone(), at));
        job.claim = Some(Claim { said, sent_end, at });
        (job.parting, job.kept, job.phase) = (Parting::Fence(sentinel(), at), true, Phase::Gap(at));
        (job.asked, job.same_fence, job.patient, job.echoed, job.wanted) = (0, 0, false, false, at);
    }

    /// The question is asked once more, and its answer is proven.
    pub(super) fn prove_anew(&mut self, at: Tick) {
        let Some(job) = &mut self.job else { return };
        (job.claim, job.unsure, job.parting, job.wanted) = (None, true, Parting::None, at);
        (job.asked, job.same_fence, job.echoed, job.patient) = (0, 0, false, false);
        job.proofs += 1;
        job.phase = match job.proofs <= MOST_PROOFS {
            true => Phase::Gap(at),
            false => Phase::Done(Err(unproven(&self.twins, job.station, job.asked))),
        };
    }

    /// Notes what came beside the answers: what somebody said, or garbage.
    pub(super) fn note_beside(&mut self, told: Option<(u8, Option<&Said>)>, bytes: &[u8]) {
        let Some(job) = &mut self.job else { return };
        match told {
            None => job.beside.garbage += bytes.len(),
            Some((station, Some(said))) if station == job.station && job.question.is_answered_by(said) => {
                match job.claim.as_ref().is_some_and(|claim| claim.said == *said) {
                    true => job.beside.copies = job.beside.copies.saturating_add(1),
                    false => job.beside.rival = true,
                }
            }
            Some(_) => {}
        }
    }

    /// A sentinel was answered; whether its counter tells that it was this one, counted from the one before.
    pub(super) fn counts_on(&mut self, station: u8, said: &Said) -> bool {
        let Said::Modbus(Reply::Diagnostics { sub: MESSAGES, data }) = said else { return false };
        let counter = Counter { data: *data, sent: self.tally.sent };
        let before = self.counted.insert(station, counter);
        before.is_some_and(|before| u64::from(data.wrapping_sub(before.data)) == counter.sent - before.sent)
    }

    /// The sentinel behind a claim was answered: the claim holds, or the question is asked anew.
    pub(super) fn weigh_claim(&mut self, at: Tick, sent_end: Tick, claim: Claim, answer: Said, counts: bool) {
        let Some(job) = &mut self.job else { return };
        let beside = job.beside;
        let is_clean = !beside.rival && beside.garbage <= GLITCH && job.same_fence == 1;
        if is_clean && (counts || job.counted == Some(Count::Once)) {
            self.twins.counts(job.station, beside.copies > 0);
            if let Some(said) = self.witnessed(at, claim.said) {
                self.conclude(claim.at, claim.sent_end, said);
            }
            return;
        }
        if is_clean && job.proofs >= MOST_PROOFS && job.counted.is_none() {
            // A counter of another kind: whoever else answers is waited for.
            (job.claim, job.parting) = (Some(claim), Parting::Fence(sentinel(), at));
            return self.count(at, sent_end, answer);
        }
        self.prove_anew(at);
    }

    /// A sentinel was lost, and with it perhaps what it was to prove.
    pub(super) fn lose_claim(&mut self, now: Tick) -> bool {
        let Some(job) = self.job.as_mut().filter(|job| job.claim.is_some()) else { return false };
        let station = job.station;
        self.debts.owes(station, sentinel(), now + LATEST_REPLY, now);
        self.prove_anew(now);
        true
    }

    /// A sign that somebody else may answer for this station: its answers are proven for as long as his may be on their way.
    pub(super) fn grow_wary(&mut self, station: u8, at: Tick) {
        if self.is_alone(at) {
            self.twins.grows_wary(station, at + LATEST_OF_ALL);
        }
    }

    /// Something came behind an answer that nobody had asked for.
    pub(super) fn note_behind(&mut self, at: Tick) {
        let lag = self.answered.as_ref().map(|(_, _, then)| at.since(*then));
        self.ease.learn(lag.unwrap_or(LATEST_OF_ALL), at);
    }

    /// A question was lost that went out right behind an answer.
    pub(super) fn note_met(&mut self, now: Tick) {
        let free_at = self.ease.free_at;
        self.ease.learn(FIRST_EASE, now);
        self.ease.free_at = free_at;
    }
}

fn sentinel() -> Question {
    Request::Diagnostics { sub: MESSAGES, data: 0 }.into()
}
