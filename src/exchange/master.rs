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
use super::dialect::{Dialect, Question, Said};
use super::echo::Echo;
use super::{Answer, Conversation, ExchangeError, Limits, Pauses, Record, Step, Tally, Verdict};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::BROADCAST;
use crate::tick::Tick;
use std::collections::BTreeMap;

type Outcome = Result<Answer, ExchangeError>;

/// The master of one line.
#[derive(Debug)]
pub struct Master {
    dialect: Dialect,
    line: LineSetting,
    limits: Limits,
    /// The line is free for the next telegram from then on.
    ready_at: Tick,
    debts: Debts,
    echo: Echo,
    job: Option<Job>,
    /// A question that was given up before its time, and whose reply may be on its way.
    orphan: Option<Orphan>,
    /// The last harmless question that a station answered without a refusal.
    known: BTreeMap<u8, Question>,
    /// The last reply that was taken.
    last_reply: Option<Record>,
    /// Bytes that nobody waits for, until they make a telegram or pause.
    loose: Loose,
    /// When the last reply ended, until something is sent.
    replied_at: Option<Tick>,
    pauses: Pauses,
    tally: Tally,
    records: Vec<Record>,
}

#[derive(Debug)]
struct Orphan {
    station: u8,
    question: Question,
    deadline: Tick,
    came: Vec<u8>,
}

#[derive(Debug, Default)]
struct Loose {
    last: Tick,
    bytes: Vec<u8>,
}

#[derive(Debug)]
struct Job {
    station: u8,
    question: Question,
    parting: Parting,
    /// When somebody wanted to know.
    wanted: Tick,
    asked: u8,
    /// Echoes, or what may be one, came in place of the fence's answer: somebody is there.
    echoed: bool,
    phase: Phase,
}

/// What keeps old replies from the question.
#[derive(Clone, Debug)]
enum Parting {
    /// Nothing old can come that could be confused.
    None,
    /// This is asked first, but not before the time.
    Fence(Question, Tick),
    /// Nothing is sent before the time.
    Until(Tick),
}

#[derive(Debug)]
enum Phase {
    Gap,
    Reply(Waiting),
    Turnaround { until: Tick },
    Farewell(Outcome),
    Done(Outcome),
}

/// Waiting for the reply to a telegram.
#[derive(Debug)]
struct Waiting {
    sent: Vec<u8>,
    sent_end: Tick,
    deadline: Tick,
    came: Vec<u8>,
    last: Tick,
    /// The echo of the telegram has been taken away already.
    echoed: bool,
    stray: Option<u8>,
    garbage: Vec<u8>,
}

/// What has come when the line fell silent.
enum Came {
    Nothing,
    Stray(u8),
    /// Too little for a reply, which may still come.
    Noise,
    Garbage,
}

impl Job {
    /// What is asked now: the fence, if there is one, then the question.
    fn asks(&self) -> &Question {
        match &self.parting {
            Parting::Fence(fence, _) => fence,
            Parting::None | Parting::Until(_) => &self.question,
        }
    }
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
            echo: Echo::default(),
            job: None,
            orphan: None,
            known: BTreeMap::new(),
            last_reply: None,
            loose: Loose::default(),
            replied_at: None,
            pauses: Pauses { required: dialect.gap(line, limits.pause), ..Pauses::default() },
            tally: Tally::default(),
            records: Vec::new(),
        }
    }

    /// The same line from now on with another protocol or setting. What was owed under the old one is no valid telegram
    /// under the new.
    pub fn retune(&mut self, protocol: Protocol, line: LineSetting, now: Tick) {
        let (tally, records, pause) = (self.tally, std::mem::take(&mut self.records), self.ready_at);
        *self = Master { tally, records, ..Master::new(protocol, line, self.limits) };
        self.ready_at = pause.max(now + self.dialect.silence(line));
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
        (self.echo != Echo::Unknown).then_some(self.echo == Echo::Present)
    }

    /// Whether the echo of this question would pass for its answer, and nobody knows yet whether the line echoes: then
    /// something else must be asked first.
    pub fn needs_sounding(&self, station: u8, question: &Question) -> bool {
        station != BROADCAST && self.echo == Echo::Unknown && question.resembles_its_reply()
    }

    /// The telegrams since the last call.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// Begins to ask. Ask [`Master::step`] what to do until it is done.
    ///
    /// A question that is still open is given up: its reply or its time-out is waited for before anything is sent.
    pub fn ask(&mut self, station: u8, question: impl Into<Question>, now: Tick) {
        let question = question.into();
        self.abandon(now);
        let phase = if station == BROADCAST && !question.is_write() {
            Phase::Done(Err(ExchangeError::BroadcastRead))
        } else {
            Phase::Gap
        };
        let parting = self.parting(station, &question, now);
        self.job = Some(Job { station, question, parting, wanted: now, asked: 0, echoed: false, phase });
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
        let open = match &self.job {
            Some(Job { phase: Phase::Reply(waiting), .. }) => Some(waiting.deadline),
            _ => self.orphan.as_ref().map(|orphan| orphan.deadline),
        };
        self.debts.until().chain(open).filter(|&until| until > now).max()
    }

    /// How the question is kept apart from replies that the station still owes.
    fn parting(&mut self, station: u8, question: &Question, now: Tick) -> Parting {
        self.debts.forget(now);
        let missing = self.debts.missing(station, now);
        let confused = missing.iter().any(|missing| self.dialect.confuses(missing, question));
        // A stop must go out at once. Writes set values, so one whose answer may be an old one is sent again.
        if question.is_write() || !confused { Parting::None } else { self.part(station, question, now) }
    }

    /// Keeps everything that the station still owes away from the question.
    fn part(&self, station: u8, question: &Question, now: Tick) -> Parting {
        let Some((due, end)) = self.debts.due(station) else { return Parting::None };
        let fence = self.dialect.fence(self.debts.missing(station, now), question, self.known.get(&station));
        fence.map_or(Parting::Until(end), |fence| Parting::Fence(fence, due))
    }

    /// What to do now. Call again after every step; after `Done` the question is over.
    pub fn step(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Done(Err(ExchangeError::BroadcastRead)) };
        let orphan = self.orphan.as_ref().map(|orphan| orphan.deadline);
        if self.debts.due(job.station).is_none() && job.asked == 0 {
            job.parting = Parting::None; // what was owed has come meanwhile
        }
        let parted = match job.parting {
            Parting::Fence(_, until) | Parting::Until(until) => until,
            Parting::None => now,
        };
        let free = self.ready_at.max(parted).max(orphan.unwrap_or(now));
        match &job.phase {
            Phase::Gap if now < free => Step::Wait(free),
            Phase::Farewell(_) if now < self.ready_at => Step::Wait(self.ready_at),
            Phase::Gap => self.send(now),
            Phase::Farewell(_) => self.bid_farewell(now),
            Phase::Turnaround { until } if now < *until => Step::Wait(*until),
            Phase::Turnaround { .. } => self.finish(Ok(Answer::Broadcast)),
            Phase::Reply(waiting) => {
                let pause = self.dialect.straggle(&waiting.came);
                let until = if waiting.came.is_empty() { waiting.deadline } else { waiting.last + pause };
                if now < until { Step::Wait(until) } else { self.look(now) }
            }
            Phase::Done(outcome) => {
                let outcome = outcome.clone();
                self.finish(outcome)
            }
        }
    }

    fn send(&mut self, now: Tick) -> Step<Outcome> {
        self.orphan = None;
        self.flush_loose();
        let replied_at = self.replied_at.take();
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        if let Some(replied_at) = replied_at.filter(|_| job.wanted < self.ready_at) {
            self.pauses.note(now.since(replied_at));
        }
        let fence = matches!(job.parting, Parting::Fence(..));
        let verdict = if fence { Verdict::Fence } else { Verdict::Request };
        let bytes = self.dialect.encode(job.station, &job.asks().clone());
        let sent_end = now + self.dialect.duration(self.line, bytes.len());
        job.asked += 1;
        self.tally.sent += 1;
        self.tally.repeats += u64::from(job.asked > 1 && !fence);
        self.tally.fences += u64::from(fence);
        let silence = self.dialect.silence(self.line);
        job.phase = if job.station == BROADCAST {
            Phase::Turnaround { until: sent_end + self.limits.turnaround.longer(silence) }
        } else {
            Phase::Reply(Waiting {
                sent: bytes.clone(),
                sent_end,
                deadline: sent_end + self.limits.reply_timeout,
                came: Vec::new(),
                last: sent_end,
                echoed: false,
                stray: None,
                garbage: Vec::new(),
            })
        };
        self.ready_at = sent_end + silence;
        self.records.push(Record { at: now, verdict, bytes: bytes.clone() });
        Step::Send(bytes)
    }

    /// Ends the exchange, where the protocol wants that.
    fn bid_farewell(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let Phase::Farewell(outcome) = &job.phase else { return Step::Wait(now) };
        job.phase = Phase::Done(outcome.clone());
        let bytes = self.dialect.farewell().to_vec();
        self.ready_at = now + self.dialect.duration(self.line, bytes.len());
        self.records.push(Record { at: now, verdict: Verdict::Farewell, bytes: bytes.clone() });
        Step::Send(bytes)
    }

    /// Takes bytes that came in at `at`.
    pub fn feed(&mut self, at: Tick, bytes: &[u8]) {
        self.ready_at = self.ready_at.max(at + self.dialect.gap(self.line, self.limits.pause));
        if self.feed_orphan(at, bytes) {
            return;
        }
        match &mut self.job {
            Some(Job { phase: Phase::Reply(waiting), .. }) => {
                waiting.came.extend_from_slice(bytes);
                waiting.last = at;
            }
            _ => return self.feed_loose(at, bytes),
        }
        if let Some((end, said)) = self.found(at) {
            self.take(at, end, said);
        }
    }

    /// The answer to what was asked, if it has come, with what came before it and when the question was out.
    fn found(&mut self, at: Tick) -> Option<(Tick, Said)> {
        let Some(Job { phase: Phase::Reply(waiting), station, .. }) = &self.job else { return None };
        let job = self.job.as_ref()?;
        let mut from = 0;
        let found = loop {
            let found = self.dialect.find(waiting.came.get(from..)?, *station, job.asks())?;
            from += found.start;
            if !self.is_echo(waiting, from) && self.proves(job, &found.said, at) {
                break found;
            }
            from += 1;
        };
        let (before, reply) = waiting.came.split_at_checked(from)?;
        let (before, reply, sent, sent_end) = (before.to_vec(), reply.to_vec(), waiting.sent.clone(), waiting.sent_end);
        if !waiting.echoed {
            self.echo.learn(&sent, &before);
        }
        self.note_before(at, &before, &sent);
        let record = Record { at, verdict: Verdict::Reply, bytes: reply };
        self.last_reply = Some(record.clone());
        self.replied_at = Some(at);
        self.records.push(record);
        Some((sent_end, found.said))
    }

    /// Whether what stands at `from` is what we sent, and may have been given back by the adapter.
    fn is_echo(&self, waiting: &Waiting, from: usize) -> bool {
        let before = waiting.came.get(..from).unwrap_or_default();
        let seen = waiting.echoed || before.windows(waiting.sent.len()).any(|window| window == waiting.sent);
        let same = waiting.came.get(from..).is_some_and(|rest| rest.starts_with(&waiting.sent));
        same && !seen && self.echo != Echo::Absent
    }

    /// Whether this answer can be no older one; that matters for a fence only.
    fn proves(&self, job: &Job, said: &Said, at: Tick) -> bool {
        match &job.parting {
            Parting::Fence(fence, _) => self.dialect.settles(fence, said, self.debts.missing(job.station, at)),
            Parting::None | Parting::Until(_) => true,
        }
    }

    /// Whether this answer could be a late one to something else.
    fn may_be_old(&self, said: &Said, at: Tick) -> bool {
        let Some(job) = self.job.as_ref().filter(|job| !matches!(job.parting, Parting::Fence(..))) else {
            return false;
        };
        let missing = self.debts.missing(job.station, at);
        missing.iter().any(|missing| match said.is_refusal() {
            true => self.dialect.refuses_alike(missing, &job.question),
            false => self.dialect.confuses(missing, &job.question),
        })
    }

    /// Asks once more, with everything old kept away: the answer that has come may be nobody's, and ours may be to come.
    fn ask_behind_fence(&mut self, at: Tick, sent_end: Tick) {
        let Some((station, question)) = self.job.as_ref().map(|job| (job.station, job.question.clone())) else {
            return;
        };
        self.debts.owes(station, question.clone(), sent_end + LATEST_REPLY, at);
        let parting = self.part(station, &question, at);
        if let Some(job) = &mut self.job {
            *job = Job { station, question, parting, wanted: at, asked: 0, echoed: false, phase: Phase::Gap };
        }
    }

    /// The answer has come: to the fence, then the question goes out; or to the question, then it is over.
    fn take(&mut self, at: Tick, sent_end: Tick, said: Said) {
        self.tally.replies += 1;
        self.tally.exceptions += u64::from(said.is_refusal());
        if self.may_be_old(&said, at) {
            return self.ask_behind_fence(at, sent_end);
        }
        let Some(job) = &mut self.job else { return };
        self.debts.hears(job.station);
        if let Parting::Fence(fence, _) = std::mem::replace(&mut job.parting, Parting::None) {
            // Everything older has come; of a fence that was asked more than once further replies may.
            self.debts.settle(job.station);
            for _ in 1..job.asked {
                self.debts.owes(job.station, fence.clone(), sent_end + LATEST_REPLY, at);
            }
            job.asked = 0;
            job.phase = Phase::Gap;
            return;
        }
        if said.is_unreached() {
            self.tally.silences += 1;
            job.phase = Phase::Done(Err(ExchangeError::Unreached));
            return;
        }
        if !said.is_refusal() && job.question.is_harmless() {
            self.known.insert(job.station, job.question.clone());
        }
        let outcome = Ok(Answer::Reply { said, after: at.since(sent_end) });
        job.phase = if self.dialect.farewell().is_empty() { Phase::Done(outcome) } else { Phase::Farewell(outcome) };
    }

    /// The line has been silent for long enough: name what came, then wait on, repeat or end.
    fn look(&mut self, now: Tick) -> Step<Outcome> {
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return Step::Wait(now) };
        let (came, sent, deadline) = (std::mem::take(&mut waiting.came), waiting.sent.clone(), waiting.deadline);
        let (verdict, rest) = self.judge(now, &came, &sent);
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return Step::Wait(now) };
        waiting.echoed |= came.starts_with(&sent);
        match verdict {
            Came::Nothing => {}
            Came::Stray(station) => waiting.stray = Some(station),
            Came::Noise | Came::Garbage => waiting.garbage = rest,
        }
        // Behind an echo, a stray telegram or a little noise the reply may still come.
        if now < deadline && !matches!(verdict, Came::Garbage) {
            return Step::Wait(deadline);
        }
        let (stray, garbage, echoed) = (waiting.stray, std::mem::take(&mut waiting.garbage), waiting.echoed);
        // Garbage as long as a reply most likely was the reply.
        let due = if matches!(verdict, Came::Garbage) { now } else { waiting.sent_end + LATEST_REPLY };
        if let Some(job) = &mut self.job {
            job.echoed |= echoed;
        }
        self.miss(now, due, stray, garbage)
    }

    /// Says what bytes are that hold no answer, and notes them.
    fn judge(&mut self, at: Tick, came: &[u8], sent: &[u8]) -> (Came, Vec<u8>) {
        let rest = came.strip_prefix(sent).unwrap_or(came);
        if rest.len() < came.len() {
            self.echo = Echo::Present;
            self.note_echo(at, sent);
        }
        if rest.is_empty() {
            return (Came::Nothing, Vec::new());
        }
        self.note_stray(at, rest);
        let verdict = match self.dialect.sender(rest) {
            Some((station, _)) => Came::Stray(station),
            None if rest.len() < self.dialect.shortest_reply() => Came::Noise,
            None => Came::Garbage,
        };
        (verdict, rest.to_vec())
    }

    /// No answer came: repeat, or end.
    fn miss(&mut self, now: Tick, due: Tick, stray: Option<u8>, garbage: Vec<u8>) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let (station, missing, asked) = (job.station, job.asks().clone(), job.asked);
        self.debts.owes(station, missing, due, now);
        let error = match stray {
            _ if !garbage.is_empty() => ExchangeError::Garbled { asked, bytes: garbage },
            Some(station) => ExchangeError::Stray { station },
            None => ExchangeError::Silence { timeout: self.limits.reply_timeout, asked },
        };
        match error {
            ExchangeError::Silence { .. } => self.tally.silences += 1,
            _ => self.tally.garbled += 1,
        }
        if asked <= self.limits.retries {
            job.phase = Phase::Gap;
            return self.step(now);
        }
        if matches!(job.parting, Parting::Fence(..)) && job.echoed {
            // A station whose counters do not count cannot be parted by them; time does it.
            job.parting = Parting::Until(self.debts.due(station).map_or(now, |(_, end)| end));
            (job.asked, job.phase) = (0, Phase::Gap);
            return self.step(now);
        }
        self.finish(Err(error))
    }

    fn finish(&mut self, outcome: Outcome) -> Step<Outcome> {
        self.job = None;
        Step::Done(outcome)
    }

    /// Takes bytes for the question that was given up; its reply settles what is owed.
    fn feed_orphan(&mut self, at: Tick, bytes: &[u8]) -> bool {
        let Some(orphan) = &mut self.orphan else { return false };
        orphan.came.extend_from_slice(bytes);
        if self.dialect.find(&orphan.came, orphan.station, &orphan.question).is_none() {
            return true;
        }
        let (station, came) = (orphan.station, std::mem::take(&mut orphan.came));
        self.orphan = None;
        self.debts.settle(station);
        if let Some(job) = self.job.as_mut().filter(|job| job.station == station) {
            job.parting = Parting::None;
        }
        self.note_stray(at, &came);
        true
    }

    /// Takes bytes that nobody waits for.
    fn feed_loose(&mut self, at: Tick, bytes: &[u8]) {
        if at.since(self.loose.last) > self.dialect.straggle(&self.loose.bytes) {
            self.flush_loose();
        }
        self.loose.last = at;
        self.loose.bytes.extend_from_slice(bytes);
        if self.dialect.sender(&self.loose.bytes).is_some() {
            self.flush_loose();
        }
    }

    fn flush_loose(&mut self) {
        let bytes = std::mem::take(&mut self.loose.bytes);
        if !bytes.is_empty() {
            self.note_stray(self.loose.last, &bytes);
        }
    }

    /// Notes what came before an answer: an echo, noise, strays.
    fn note_before(&mut self, at: Tick, before: &[u8], sent: &[u8]) {
        let noise = before.strip_suffix(sent);
        if let Some(noise) = noise.or((!before.is_empty()).then_some(before)).filter(|noise| !noise.is_empty()) {
            self.note_stray(at, noise);
        }
        if noise.is_some() {
            self.note_echo(at, sent);
        }
    }

    fn note_echo(&mut self, at: Tick, sent: &[u8]) {
        self.tally.echoes += 1;
        self.records.push(Record { at, verdict: Verdict::Echo, bytes: sent.to_vec() });
    }

    /// Counts bytes that are nobody's answer.
    fn note_stray(&mut self, at: Tick, bytes: &[u8]) {
        let verdict = match self.dialect.sender(bytes) {
            Some((station, said)) => {
                self.debts.hears(station);
                let doubled = self.last_reply.as_ref().is_some_and(|last| last.is_doubled_by(at, bytes));
                if let Some(said) = said.filter(|_| !doubled) {
                    self.debts.pays(station, &said);
                }
                self.tally.strays += 1;
                Verdict::Stray { station }
            }
            None => Verdict::Garbage,
        };
        self.records.push(Record { at, verdict, bytes: bytes.to_vec() });
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

#[cfg(test)]
mod tests;
