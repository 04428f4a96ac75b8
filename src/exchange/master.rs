//! The master of a line: asks, waits, repeats, and never takes a reply for the answer to another question.
//!
//! * The question says how its reply ends, so a reply is taken the moment it is complete and its check is right.
//! * Times of the CM-485 manual 6.8: 2 ms pause after a reply, 500 ms until a missing reply is given up.
//! * Serial telegrams have no numbers. After a time-out or garbage a station *owes* a reply that may still come.
//!   Repeating the same question is harmless; before another one that could be confused with it a *fence* is sent, a
//!   question whose answer cannot be taken for the missing one. Stations answer in order, so behind the fence's answer
//!   nothing old can come. Where no fence is known, the time until nothing can come any more is waited for.
//! * What the adapter gives back of our own telegrams is told from replies (`echo`).

use super::debt::{Debts, LATEST_REPLY};
use super::dialect::{Dialect, Old, Question, Said};
use super::ear::{self, Ear, Piece};
use super::echo::Echo;
use super::heard::{COPY_WITHIN, Heard, Sample, Weight};
use super::job::{Count, Doubted, Job, Orphan, Outcome, Parting, Phase, Waiting, keep};
use super::ledger::Ledger;
use super::limits::{LATEST_OF_ALL, UNREACHED_REPEATS};
use super::twins::Twins;
use super::{
    Answer, Conversation, ExchangeError, Limits, MOST_BYTES, MOST_RECORDS, Pauses, Record, Step, Tally, Verdict,
};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::BROADCAST;
use crate::tick::{Span, Tick};
use copied::Copied;
use std::collections::{BTreeMap, BTreeSet};

/// The master of one line.
#[derive(Debug)]
pub struct Master {
    dialect: Dialect,
    line: LineSetting,
    limits: Limits,
    /// The line is free for the next telegram from then on.
    ready_at: Tick,
    debts: Debts,
    /// Where nothing keeps replies in order, what they may be to.
    ledger: Ledger,
    echo: Echo,
    /// A question that cannot be taken for a reply came back: whatever the last reply tells, another echo may come.
    echoed: bool,
    /// A write of ours came back, and nobody knows whether that is its answer.
    copied: Option<Copied>,
    job: Option<Job>,
    /// A question that was given up before its time, and whose reply may be on its way.
    orphan: Option<Orphan>,
    /// The last harmless questions that a station answered without a refusal.
    known: BTreeMap<u8, Vec<Question>>,
    /// Stations that have answered.
    reached: BTreeSet<u8>,
    /// Counters (code 8) of stations whose family is known.
    counters: BTreeMap<u8, Vec<u16>>,
    /// What came lately, and how soon stations answer.
    heard: Heard,
    /// Addresses at which two drives may answer.
    twins: Twins,
    /// What came last behind the time of its question, and what it answers.
    late: Option<(u8, Question, Said)>,
    /// When somebody else asked something: the last time, and the one before.
    others: [Option<Tick>; 2],
    /// The last question that was answered, and when.
    answered: Option<(u8, Question, Tick)>,
    /// Characters take their time on this line, and nothing comes sooner than that allows.
    wired: bool,
    /// Bytes that nobody waits for, until they make a telegram or pause.
    loose: Ear,
    /// The last bytes that came, whoever waited for them, and the last telegrams that were sent.
    stream: Vec<u8>,
    sent: Vec<Vec<u8>>,
    /// When the last reply ended, until something is sent.
    replied_at: Option<Tick>,
    pauses: Pauses,
    tally: Tally,
    records: Vec<Record>,
}

impl Master {
    /// A master on a line with this setting.
    pub fn new(protocol: Protocol, line: LineSetting, limits: Limits) -> Self {
        let dialect = Dialect::new(protocol);
        Master {
            dialect,
            line,
            limits,
            ready_at: Tick::ZERO + dialect.silence(line),
            debts: Debts::default(),
            ledger: Ledger::default(),
            echo: Echo::default(),
            echoed: false,
            copied: None,
            job: None,
            orphan: None,
            known: BTreeMap::new(),
            reached: BTreeSet::new(),
            counters: BTreeMap::new(),
            heard: Heard::default(),
            twins: Twins::default(),
            late: None,
            others: [None; 2],
            answered: None,
            wired: false,
            loose: Ear::default(),
            stream: Vec::new(),
            sent: Vec::new(),
            replied_at: None,
            pauses: Pauses { required: dialect.gap(line, limits.pause), ..Pauses::default() },
            tally: Tally::default(),
            records: Vec::new(),
        }
    }

    /// The same line from now on with another protocol or setting. What was owed under the old one is no valid telegram
    /// under the new.
    pub fn retune(&mut self, protocol: Protocol, line: LineSetting, now: Tick) {
        let (tally, records, pause, wired) = (self.tally, std::mem::take(&mut self.records), self.ready_at, self.wired);
        *self = Master { tally, records, wired, ..Master::new(protocol, line, self.limits) };
        self.ready_at = pause.max(now + self.dialect.silence(line));
    }

    /// Whether the line is one of wires, on which every character takes its time: then a reply that ends sooner than
    /// question, reply and the silence between them allow is none. Not behind a network or a gateway, nor on a pty.
    pub fn set_wired(&mut self, wired: bool) {
        self.wired = wired;
    }

    /// What is spoken.
    pub fn protocol(&self) -> Protocol {
        self.dialect.protocol()
    }

    /// Setting of the line, which decides how long characters take.
    pub fn line(&self) -> LineSetting {
        self.line
    }

    /// Time limits.
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// Other time limits from the next question on.
    pub fn set_limits(&mut self, limits: Limits) {
        self.limits = limits;
    }

    /// What happened on the line so far.
    pub fn tally(&self) -> Tally {
        self.tally
    }

    /// Pauses that were kept between replies and the next questions.
    pub fn pauses(&self) -> Pauses {
        self.pauses
    }

    /// Whether the adapter gives back what we send; `None` as long as nothing was asked that tells.
    pub fn echoes(&self) -> Option<bool> {
        self.echo.is_known().then_some(self.echo == Echo::Present)
    }

    /// Whether telegrams carry numbers, so that nothing is asked twice.
    pub fn is_numbered(&self) -> bool {
        self.dialect.is_numbered()
    }

    /// Whether the echo of this question would pass for its answer, and nobody knows yet whether the line echoes: then
    /// something else must be asked first.
    pub fn needs_sounding(&self, station: u8, question: &Question) -> bool {
        station != BROADCAST && !self.echo.is_known() && question.resembles_its_reply()
    }

    /// Whether a station answers everything twice, in the same words: two drives with one address, or a repeater.
    pub fn answers_twice(&self, station: u8) -> bool {
        self.twins.answers_twice(station)
    }

    /// Whether a station has given two answers to one question that differ: most likely two drives with one address.
    pub fn differs(&self, station: u8) -> bool {
        self.twins.is_marked(station)
    }

    /// Whether a station has answered what was asked once in two ways, the second time unasked. Where nothing may wait for a second answer,
    /// this is how another drive shows itself.
    pub fn is_contradicted(&self, station: u8) -> bool {
        self.twins.is_contradicted(station)
    }

    /// The telegrams since the last call.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// Begins to ask. Ask [`Master::step`] what to do until it is done.
    ///
    /// A question that is still open is given up: its reply or its time-out is waited for before anything is sent.
    pub fn ask(&mut self, station: u8, question: impl Into<Question>, now: Tick) {
        self.ask_within(station, question, self.limits, now);
    }

    /// Like [`Master::ask`], with time limits of its own. It is done within [`Limits::longest`], whatever comes.
    pub fn ask_within(&mut self, station: u8, question: impl Into<Question>, limits: Limits, now: Tick) {
        let question = question.into();
        self.abandon(now);
        let phase = if station == BROADCAST && !question.is_write() {
            Phase::Done(Err(ExchangeError::BroadcastRead))
        } else if self.is_told_apart(&question, limits) && self.twins.are_two(station, now) {
            Phase::Done(Err(ExchangeError::TwoAnswers { station }))
        } else {
            Phase::Gap(now)
        };
        let parting = self.first_parting(station, &question, limits, now);
        self.job = Some(Job {
            kept: !matches!(parting, Parting::None) && self.debts.due(station).is_none(),
            parting,
            station,
            question,
            limits,
            wanted: now,
            until: now + limits.longest(self.protocol(), self.line),
            patience: limits.patience(self.protocol(), self.line),
            older: None,
            asked: 0,
            same_fence: 0,
            rounds: 0,
            witnesses: Vec::new(),
            doubted: false,
            noisy: false,
            again: false,
            first: None,
            echoed: false,
            heard: false,
            counted: None,
            patient: false,
            phase,
        });
    }

    /// A station was asked this by somebody else on our side, and its reply may still come.
    pub fn expect(&mut self, station: u8, question: Question, now: Tick) {
        self.debts.owes(station, question, now + LATEST_REPLY, now);
    }

    /// Gives the open question up, but does not forget that its reply may be on its way.
    fn abandon(&mut self, now: Tick) {
        let Some(job) = self.job.take() else { return };
        let (station, question) = (job.station, job.asks().clone());
        let Phase::Reply(Waiting { sent_end, deadline, came, .. }) = job.phase else { return };
        self.debts.owes(station, question.clone(), sent_end + LATEST_REPLY, now);
        self.orphan = Some(Orphan { station, question, deadline, came });
    }

    /// Until when a reply may still come: to a question that is open, or from a station that has answered before and owes
    /// one. Nothing must be closed before, or another program would take that reply for its own. `None` if nobody owes
    /// anything.
    pub fn owes_until(&self, now: Tick) -> Option<Tick> {
        self.owing(now).map(|(_, until)| until).max()
    }

    /// Whether a station is one of those that owe a reply.
    pub fn is_owed_by(&self, station: u8, now: Tick) -> bool {
        self.owing(now).any(|(owes, _)| owes == station)
    }

    fn owing(&self, now: Tick) -> impl Iterator<Item = (u8, Tick)> {
        let open = match &self.job {
            Some(Job { station, phase: Phase::Reply(waiting), .. }) => Some((*station, waiting.deadline)),
            _ => self.orphan.as_ref().map(|orphan| (orphan.station, orphan.deadline)),
        };
        self.debts.owing().chain(open).filter(move |&(_, until)| until > now)
    }

    /// The longest that a station took for an answer, of those that were believed without doubt, or was behind its time; zero where nothing
    /// tells that.
    pub fn slowest_answer(&self, station: u8) -> Span {
        self.heard.slowest(station)
    }

    /// From now on fences for this station use these counters (sub-functions of code 8); without it, what every family
    /// has.
    pub fn has_counters(&mut self, station: u8, counters: impl IntoIterator<Item = u16>) {
        self.counters.insert(station, counters.into_iter().collect());
    }

    /// What to do now. Call again after every step; after `Done` the question is over.
    pub fn step(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Done(Err(ExchangeError::BroadcastRead)) };
        let is_paid = self.debts.due(job.station).is_none() && job.asked == 0;
        if is_paid && !job.kept && !matches!(job.parting, Parting::Quiet(_)) {
            job.parting = Parting::None; // what was owed has come meanwhile
        }
        if now >= job.until && !matches!(job.phase, Phase::Done(_) | Phase::Farewell(..)) {
            return self.give_up(now);
        }
        if matches!(job.phase, Phase::Farewell(..)) {
            return self.advance(now);
        }
        let until = job.until;
        match self.advance(now) {
            Step::Wait(later) => Step::Wait(later.min(until)),
            step => step,
        }
    }

    fn advance(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &self.job else { return Step::Wait(now) };
        match &job.phase {
            Phase::Gap(since) => {
                // Alone, whoever is copied meets his own questions only, and late replies are no copies.
                let copied = self.heard.copy_due().filter(|_| job.limits.gives_way);
                let ready_at = copied.unwrap_or(now).max(self.ready_at);
                let (free, last) = job.slot(*since, ready_at, self.orphan.as_ref().map(|orphan| orphan.deadline));
                match now < free {
                    true if now < last => Step::Wait(free.min(last)),
                    true => self.give_up(now),
                    false => self.send(now),
                }
            }
            Phase::Farewell(_, by) if now < self.ready_at.min(*by) => Step::Wait(self.ready_at.min(*by)),
            Phase::Farewell(..) => self.bid_farewell(now),
            Phase::Turnaround(until) if now < *until => Step::Wait(*until),
            Phase::Turnaround(_) => self.finish(Ok(Answer::Broadcast)),
            Phase::Second(second) if now < second.until => Step::Wait(second.until),
            Phase::Second(_) => self.counted(now),
            Phase::Reply(waiting) => {
                let over = waiting.over(self.dialect.straggle(&waiting.came));
                if now < over { Step::Wait(over) } else { self.look(now) }
            }
            Phase::Done(outcome) => {
                let outcome = outcome.clone();
                self.finish(outcome)
            }
        }
    }

    /// The line is never silent, or nothing that came proves anything: the question is over.
    fn give_up(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &self.job else { return Step::Wait(now) };
        let error = match job.phase {
            Phase::Gap(_) => ExchangeError::NeverSilent { asked: job.asked },
            _ => unproven(&self.twins, job.station, job.asked),
        };
        self.tally.garbled += 1;
        self.abandon(now);
        Step::Done(Err(error))
    }

    fn send(&mut self, now: Tick) -> Step<Outcome> {
        self.orphan = None;
        self.flush_loose();
        let replied_at = self.replied_at.take();
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        if let Some(replied_at) = replied_at.filter(|_| job.wanted < self.ready_at) {
            self.pauses.note(now.since(replied_at));
        }
        let fence = job.is_fenced();
        if let Phase::Gap(since) = job.phase {
            let (_, last) = job.slot(since, self.ready_at, None);
            job.patience = job.patience.min(last.since(now));
        }
        if matches!(job.parting, Parting::Until(until) if now >= until) {
            self.debts.settle(job.station, now, now);
            job.parting = Parting::None;
        }
        if !self.wired && !self.dialect.is_numbered() {
            job.reckons(self.dialect, &mut self.ledger, now);
        }
        let verdict = if fence { Verdict::Fence } else { Verdict::Request };
        let bytes = self.dialect.encode(job.station, &job.asks().clone());
        let sent_end = now + self.dialect.duration(self.line, bytes.len());
        job.asked += 1;
        job.same_fence = if fence { job.same_fence + 1 } else { 0 };
        self.tally.sent += 1;
        self.tally.repeats += u64::from(job.asked > 1 && !fence);
        self.tally.fences += u64::from(fence);
        let silence = self.dialect.silence(self.line);
        let is_patient = job.limits.insist.is_none() && !job.limits.gives_way;
        let late = if is_patient { self.heard.patience(job.station) } else { Span::ZERO };
        let timeout = if job.patient { LATEST_OF_ALL } else { job.limits.reply_timeout + late };
        job.phase = if job.station == BROADCAST {
            Phase::Turnaround(sent_end + job.limits.turnaround.longer(silence))
        } else {
            Phase::Reply(Waiting::new(bytes.clone(), now, sent_end, timeout))
        };
        self.sent.truncate(1);
        self.sent.insert(0, bytes.clone());
        self.ready_at = if self.dialect.queues() { now } else { sent_end + silence };
        self.record(Record { at: now, verdict, bytes: bytes.clone() });
        Step::Send(bytes)
    }

    /// Ends the exchange, where the protocol wants that.
    fn bid_farewell(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let Phase::Farewell(outcome, _) = &job.phase else { return Step::Wait(now) };
        job.phase = Phase::Done(outcome.clone());
        let bytes = self.dialect.farewell().to_vec();
        self.ready_at = now + self.dialect.duration(self.line, bytes.len());
        self.record(Record { at: now, verdict: Verdict::Farewell, bytes: bytes.clone() });
        Step::Send(bytes)
    }

    /// Takes bytes that came in at `at`.
    pub fn feed(&mut self, at: Tick, bytes: &[u8]) {
        self.ready_at = self.ready_at.max(at + self.dialect.gap(self.line, self.limits.pause));
        self.overhear(at, bytes);
        if self.feed_orphan(at, bytes) {
            return;
        }
        match &mut self.job {
            Some(Job { phase: Phase::Reply(waiting), .. }) => {
                waiting.came.extend_from_slice(bytes);
                waiting.last = at;
            }
            Some(Job { phase: Phase::Second(_), .. }) => return self.feed_second(at, bytes),
            _ => return self.feed_loose(at, bytes),
        }
        if let Some((end, said)) = self.found(at) {
            return self.take(at, end, said);
        }
        if let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job {
            keep(&mut waiting.came, &[]);
        }
    }

    fn finish(&mut self, outcome: Outcome) -> Step<Outcome> {
        self.job = None;
        Step::Done(outcome)
    }
}

/// Nothing that came proves anything; where more came than was asked for, two drives are the cause.
fn unproven(twins: &Twins, station: u8, asked: u8) -> ExchangeError {
    match twins.are_likely(station) {
        true => ExchangeError::TwoAnswers { station },
        false => ExchangeError::Unproven { asked },
    }
}

impl Conversation for Master {
    type End = Outcome;

    fn step(&mut self, now: Tick) -> Step<Outcome> {
        Master::step(self, now)
    }

    fn feed(&mut self, at: Tick, bytes: &[u8]) {
        Master::feed(self, at, bytes);
    }
}

mod believe;
mod copied;
mod loose;
mod missed;
mod parting;
mod second;
mod taken;
#[cfg(test)]
mod tests;
mod witness;
