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
use super::echo::Echo;
use super::heard::{COPY_WITHIN, Heard, Sample, Weight};
use super::job::{Came, Count, Doubted, Job, Loose, Orphan, Outcome, Parting, Phase, Waiting, keep};
use super::limits::{LATEST_OF_ALL, ROUNDS};
use super::twins::Twins;
use super::{
    Answer, Conversation, ExchangeError, Limits, MOST_BYTES, MOST_RECORDS, Pauses, Record, Step, Tally, Verdict,
};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::BROADCAST;
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// Harmless questions that are remembered of every station, to part replies by.
const MOST_KNOWN: usize = 4;

/// A question that goes out so soon after an answer meets what follows it.
const RIGHT_BEHIND: Span = Span::from_millis(20);

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
    /// A question that cannot be taken for a reply came back: whatever the last reply tells, another echo may come.
    echoed: bool,
    job: Option<Job>,
    /// A question that was given up before its time, and whose reply may be on its way.
    orphan: Option<Orphan>,
    /// The last harmless questions that a station answered without a refusal.
    known: BTreeMap<u8, Vec<Question>>,
    /// Counters (code 8) of stations whose family is known.
    counters: BTreeMap<u8, Vec<u16>>,
    /// What came lately, and how soon stations answer.
    heard: Heard,
    /// Addresses at which two drives may answer.
    twins: Twins,
    /// When somebody else asked something: the last time, and the one before.
    others: [Option<Tick>; 2],
    /// The last question that was answered, and when.
    answered: Option<(u8, Question, Tick)>,
    /// Characters take their time on this line, and nothing comes sooner than that allows.
    wired: bool,
    /// Bytes that nobody waits for, until they make a telegram or pause.
    loose: Loose,
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
            echo: Echo::default(),
            echoed: false,
            job: None,
            orphan: None,
            known: BTreeMap::new(),
            counters: BTreeMap::new(),
            heard: Heard::default(),
            twins: Twins::default(),
            others: [None; 2],
            answered: None,
            wired: false,
            loose: Loose::default(),
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
        let open = match &self.job {
            Some(Job { phase: Phase::Reply(waiting), .. }) => Some(waiting.deadline),
            _ => self.orphan.as_ref().map(|orphan| orphan.deadline),
        };
        self.debts.until().chain(open).filter(|&until| until > now).max()
    }

    /// How the question is kept apart from replies that the station still owes.
    fn parting(&self, station: u8, question: &Question, since: Option<Tick>, now: Tick) -> Parting {
        let missing = self.debts.missing(station);
        let confused = missing.iter().any(|missing| self.dialect.confuses(missing, question))
            || since.is_some_and(|since| self.debts.is_missing(station, question, since, now));
        // A stop must go out at once. Writes set values, so one whose answer may be an old one is sent again.
        if question.is_write() || !confused { Parting::None } else { self.part(station, question) }
    }

    /// Keeps everything that the station still owes away from the question.
    fn part(&self, station: u8, question: &Question) -> Parting {
        let Some((due, end)) = self.debts.due(station) else { return Parting::None };
        self.fence(station, question).map_or(Parting::Until(end), |fence| Parting::Fence(fence, due))
    }

    /// A question whose answer can be taken for none that the station owes.
    fn fence(&self, station: u8, question: &Question) -> Option<Question> {
        let missing = self.debts.missing(station);
        let counters = self.counters.get(&station).map(Vec::as_slice);
        let known = self.known.get(&station).map_or(&[][..], Vec::as_slice);
        self.dialect.fence(&Old { missing: &missing, question, known, counters })
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
                let (free, last) = job.slot(*since, self.ready_at, self.orphan.as_ref().map(|orphan| orphan.deadline));
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
        let verdict = if fence { Verdict::Fence } else { Verdict::Request };
        let bytes = self.dialect.encode(job.station, &job.asks().clone());
        let sent_end = now + self.dialect.duration(self.line, bytes.len());
        job.asked += 1;
        job.same_fence = if fence { job.same_fence + 1 } else { 0 };
        self.tally.sent += 1;
        self.tally.repeats += u64::from(job.asked > 1 && !fence);
        self.tally.fences += u64::from(fence);
        let silence = self.dialect.silence(self.line);
        let timeout = if job.patient { LATEST_OF_ALL } else { job.limits.reply_timeout };
        job.phase = if job.station == BROADCAST {
            Phase::Turnaround(sent_end + job.limits.turnaround.longer(silence))
        } else {
            Phase::Reply(Waiting::new(bytes.clone(), now, sent_end, timeout))
        };
        self.sent.truncate(1);
        self.sent.insert(0, bytes.clone());
        self.ready_at = sent_end + silence;
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

    /// Whether what stands at `from` is what we sent, and may have been given back by the adapter.
    fn is_echo(&self, waiting: &Waiting, from: usize) -> bool {
        let seen = waiting.has_echoed(from);
        let same = waiting.came.get(from..).is_some_and(|rest| rest.starts_with(&waiting.sent));
        same && !seen && self.echo != Echo::Absent
    }

    /// Whether this answer can be no older one; that matters for a fence only. `behind_echo`: our own telegram stands before
    /// it, so it is not that.
    fn proves(&self, job: &Job, said: &Said, behind_echo: bool) -> bool {
        match &job.parting {
            Parting::Fence(fence, _) => {
                let may_echo = (self.echoed || self.echo != Echo::Absent) && !behind_echo;
                self.dialect.settles(fence, said, &self.debts.missing(job.station), may_echo)
            }
            _ => true,
        }
    }

    /// Whether this answer could be a late one to something else.
    fn may_be_old(&self, said: &Said, at: Tick) -> bool {
        let Some(job) = self.job.as_ref().filter(|job| !job.is_fenced()) else { return false };
        let since = job.limits.since.filter(|_| !job.question.is_write() && !self.dialect.is_numbered());
        if since.is_some_and(|since| self.debts.is_missing(job.station, &job.question, since, at)) {
            return true;
        }
        // What was answered by a value before is not refused.
        let refusable = |missing| !self.known.get(&job.station).is_some_and(|known| known.contains(missing));
        let missing = self.debts.missing(job.station);
        missing.iter().any(|missing| match said.is_refusal() {
            true => refusable(missing) && self.dialect.refuses_alike(missing, &job.question),
            false => self.dialect.confuses(missing, &job.question),
        })
    }

    /// Whether the answer came behind garbage as long as a telegram, and does not name what it answers.
    fn is_doubted(&self, said: &Said, at: Tick) -> bool {
        let names = self.dialect.names_its_question() && !said.is_refusal();
        let garbled = |job: &Job| job.doubted && !names && !job.question.is_write() && !self.is_vouched(job, at);
        let doubted = |job: &Job| !job.is_fenced() && (job.again || garbled(job));
        !self.dialect.is_numbered() && self.job.as_ref().is_some_and(doubted)
    }

    /// Whether garbage before an answer is known to be only garbage. Who may be two drives is not believed by that, but where
    /// what is asked must go on. Beside another master it may be his question, which met ours.
    pub(super) fn is_vouched(&self, job: &Job, at: Tick) -> bool {
        let is_vouched = match job.limits.insist {
            Some(_) => self.twins.has_vouched(job.station),
            None => self.twins.is_vouched(job.station),
        };
        is_vouched && !self.is_shared(at)
    }

    /// Whether an answer was doubted for how it came, and this is the same once more: then it is the answer, and so late does
    /// the station answer. Who asks the same again and again beside us is answered the same again and again.
    fn is_said_again(&mut self, said: &Said, at: Tick) -> bool {
        let is_shared = self.is_shared(at);
        let Some(job) = self.job.as_ref().filter(|job| !(job.is_fenced() || is_shared && job.doubted)) else {
            return false;
        };
        let Some(first) = job.first.as_ref().filter(|first| first.said == *said) else { return false };
        self.heard.learn(job.station, job.question.function(), first.after);
        if first.noisy {
            self.twins.vouches(job.station);
        }
        if first.again {
            self.heard.vouches(job.station);
        }
        true
    }

    /// Remembers an answer that is doubted for how it came, and how late that was.
    fn doubt(&mut self, said: Said, since: Tick) {
        let Some(job) = &mut self.job else { return };
        let Phase::Reply(Waiting { sent_end, last, .. }) = &job.phase else { return };
        let after = i64::try_from(last.since(*sent_end).as_micros()).unwrap_or(i64::MAX);
        job.first = Some(Doubted { said, since, after, noisy: job.noisy || job.doubted, again: job.again });
    }

    /// Asks once more, with everything old kept away: the answer that has come may be nobody's, and ours may be to come.
    fn ask_behind_fence(&mut self, at: Tick, due: Tick) {
        let Some((station, question)) = self.job.as_ref().map(|job| (job.station, job.question.clone())) else {
            return;
        };
        self.debts.owes(station, question.clone(), due, at);
        let parting = self.part(station, &question);
        let Some(job) = &mut self.job else { return };
        job.phase = match job.rounds {
            rounds if rounds >= ROUNDS || !job.limits.witness => {
                Phase::Done(Err(unproven(&self.twins, station, job.asked)))
            }
            _ => Phase::Gap(at),
        };
        (job.parting, job.rounds, job.wanted) = (parting, job.rounds.saturating_add(1), at);
        (job.asked, job.same_fence, job.echoed, job.patient) = (0, 0, false, false);
    }

    /// The answer has come: to the fence, then the question goes out; or to the question, then it is over.
    fn take(&mut self, at: Tick, sent_end: Tick, said: Said) {
        self.tally.replies += 1;
        self.tally.exceptions += u64::from(said.is_refusal());
        if let Some(job) = self.job.as_ref().filter(|job| job.doubted && !job.is_fenced()) {
            // Two telegrams came: the second may be another's who answered just now.
            let last = self.answered.as_ref().filter(|(_, _, then)| at.since(*then) < COPY_WITHIN);
            let stations = [Some(job.station), last.map(|last| last.0)];
            stations.into_iter().flatten().for_each(|station| self.suspect(station, at));
        }
        if self.may_be_old(&said, at) {
            return self.ask_behind_fence(at, sent_end + LATEST_REPLY);
        }
        let is_again = self.is_said_again(&said, at);
        if self.is_doubted(&said, at) && !is_again {
            self.doubt(said, at);
            let due = if self.is_suspected(at) { sent_end + LATEST_REPLY } else { at };
            return self.ask_behind_fence(at, due);
        }
        if let Some(job) = self.job.as_ref().filter(|job| !job.is_fenced())
            && let Some(first) = &job.first
        {
            // Behind the fence it was answered once: what was doubted is no reply that is still to come.
            self.debts.forgives(job.station, &job.question, first.since);
        }
        if self.is_suspected(at) {
            return self.count(at, sent_end, said);
        }
        if self.listens() {
            return self.await_second(at, sent_end, said);
        }
        self.settle(at, sent_end, said);
    }

    /// The answer is the only one that comes, or the second one has come as well.
    fn settle(&mut self, at: Tick, sent_end: Tick, said: Said) {
        let Some(said) = self.witnessed(at, said) else { return };
        let Some(job) = &mut self.job else { return };
        self.debts.hears(job.station);
        if let Parting::Fence(fence, _) = std::mem::replace(&mut job.parting, Parting::None) {
            let Phase::Reply(Waiting { sent_at, .. }) = job.phase else { return };
            job.kept = false;
            // Everything older has come; of a fence that was asked more than once further replies may.
            self.debts.settle(job.station, sent_at, at);
            for _ in 1..job.same_fence {
                self.debts.owes(job.station, fence.clone(), sent_end + LATEST_REPLY, at);
            }
            (job.asked, job.patient) = (0, false);
            job.phase = Phase::Gap(at);
            let (station, question, since) = (job.station, job.question.clone(), job.limits.since);
            // Somebody else may have asked it since.
            let parting = self.parting(station, &question, since, at);
            if let Some(job) = &mut self.job {
                job.parting = parting;
            }
            return;
        }
        if said.is_unreached() {
            self.tally.silences += 1;
            job.phase = Phase::Done(Err(ExchangeError::Unreached));
            return;
        }
        if !said.is_refusal() && job.question.is_harmless() {
            let known = self.known.entry(job.station).or_default();
            known.retain(|known| *known != job.question);
            known.truncate(MOST_KNOWN - 1);
            known.insert(0, job.question.clone());
        }
        self.answered = Some((job.station, job.question.clone(), at));
        let outcome = Ok(Answer::Reply { said, after: at.since(sent_end) });
        let by = at + self.dialect.gap(self.line, job.limits.pause).times(2);
        job.phase =
            if self.dialect.farewell().is_empty() { Phase::Done(outcome) } else { Phase::Farewell(outcome, by) };
    }

    /// The line has been silent for long enough, or the time is over: name what came, then wait on, repeat or end.
    fn look(&mut self, now: Tick) -> Step<Outcome> {
        if let Some(step) = self.decide(now) {
            return step;
        }
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return Step::Wait(now) };
        let (came, sent, deadline) = (std::mem::take(&mut waiting.came), waiting.sent.clone(), waiting.deadline);
        let restless = !came.is_empty() && now < waiting.last + self.dialect.straggle(&came);
        let (verdict, rest) = self.judge(now, &came, &sent);
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return Step::Wait(now) };
        waiting.echoed |= self.dialect.behind_echo(&came, &sent).len() < came.len();
        match verdict {
            Came::Nothing => {}
            Came::Stray(station) => waiting.stray = Some(station),
            Came::Noise | Came::Garbage => waiting.garbage = rest,
        }
        // Behind an echo, a stray telegram or a little noise the reply may still come.
        if now < deadline && (!matches!(verdict, Came::Garbage) || waiting.held.is_some()) {
            return Step::Wait(deadline);
        }
        let (stray, garbage, echoed) = (waiting.stray, std::mem::take(&mut waiting.garbage), waiting.echoed);
        // Garbage as long as a reply most likely was the reply.
        let due = (!matches!(verdict, Came::Garbage)).then_some(waiting.sent_end + LATEST_REPLY);
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        job.echoed |= echoed;
        let asked = job.asked;
        let error = match stray {
            _ if restless => ExchangeError::NeverSilent { asked },
            _ if !garbage.is_empty() => ExchangeError::Garbled { asked, bytes: garbage },
            Some(station) => ExchangeError::Stray { station },
            None => ExchangeError::Silence { timeout: job.limits.reply_timeout, asked },
        };
        self.miss(now, due, error)
    }

    /// Says what bytes are that hold no answer, and notes them.
    fn judge(&mut self, at: Tick, came: &[u8], sent: &[u8]) -> (Came, Vec<u8>) {
        let rest = self.dialect.behind_echo(came, sent);
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

    /// No answer came: repeat, or end. What came may have been it: then nothing is due.
    fn miss(&mut self, now: Tick, due: Option<Tick>, error: ExchangeError) -> Step<Outcome> {
        let Some(job) = &self.job else { return Step::Wait(now) };
        let station = job.station;
        let old = self.debts.due(station).map_or(now + LATEST_OF_ALL, |(_, end)| end);
        match job.is_fenced() {
            true => self.debts.owes_fence(station, job.asks().clone(), now),
            false => match due {
                Some(due) => self.debts.owes(station, job.asks().clone(), due, now),
                None => self.debts.may_owe(station, job.asks(), now),
            },
        }
        match error {
            ExchangeError::Silence { .. } => self.tally.silences += 1,
            _ => self.tally.garbled += 1,
        }
        self.note_lost(station, now);
        let Some(job) = &self.job else { return Step::Wait(now) };
        let another = job.is_fenced().then(|| self.fence(station, &job.question)).flatten();
        let another = another.filter(|fence| !self.dialect.may_stand_still(fence));
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        job.phase = Phase::Gap(now);
        if let Some(another) = another {
            // Another fence each time, where there is one: its answer is told from those that are late.
            let is_the_same = *job.asks() == another;
            job.same_fence = if is_the_same { job.same_fence } else { 0 };
            job.parting = Parting::Fence(another, now);
        }
        if job.asked <= job.limits.retries {
            return self.step(now);
        }
        if !job.is_fenced() {
            return self.finish(Err(error));
        }
        if job.heard && !job.echoed && !job.patient && job.limits.insist.is_none() {
            job.patient = true; // it is there, and late
            return self.step(now);
        }
        if job.echoed || now >= old {
            // A station that cannot be parted by fences; time does it.
            (job.parting, job.asked) = (Parting::Until(old), 0);
            return self.step(now);
        }
        self.finish(Err(error))
    }

    fn record(&mut self, record: Record) {
        if self.records.len() < MOST_RECORDS {
            self.records.push(record);
        }
    }

    fn finish(&mut self, outcome: Outcome) -> Step<Outcome> {
        self.job = None;
        Step::Done(outcome)
    }

    /// Takes bytes for the question that was given up; its reply settles what is owed.
    fn feed_orphan(&mut self, at: Tick, bytes: &[u8]) -> bool {
        let Some(orphan) = &mut self.orphan else { return false };
        orphan.came.extend_from_slice(bytes);
        let Some(found) = self.dialect.find(&orphan.came, orphan.station, &orphan.question) else {
            keep(&mut orphan.came, &[]);
            return true;
        };
        let (station, came) = (orphan.station, std::mem::take(&mut orphan.came));
        self.orphan = None;
        self.debts.pays(station, &found.said, at);
        self.debts.settle(station, at, at);
        if let Some(job) = self.job.as_mut().filter(|job| job.station == station) {
            job.parting = Parting::None;
        }
        self.heard.note(at, &came, None);
        self.tally.strays += 1;
        self.record(Record { at, verdict: Verdict::Stray { station }, bytes: came });
        true
    }

    /// Takes bytes that nobody waits for.
    fn feed_loose(&mut self, at: Tick, bytes: &[u8]) {
        if at.since(self.loose.last) > self.dialect.straggle(&self.loose.bytes) {
            self.flush_loose();
        }
        self.loose.last = at;
        self.loose.bytes.extend_from_slice(bytes);
        if self.loose.bytes.len() > MOST_BYTES || self.dialect.sender(&self.loose.bytes).is_some() {
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
        let is_ours = |noise: &&[u8]| noise.is_empty() || *noise == self.dialect.farewell();
        if let Some(noise) = noise.or(Some(before)).filter(|noise| !is_ours(noise)) {
            self.note_stray(at, noise);
        }
        if noise.is_some() {
            self.note_echo(at, sent);
        }
    }

    fn note_echo(&mut self, at: Tick, sent: &[u8]) {
        self.tally.echoes += 1;
        self.echoed |= self.job.as_ref().is_some_and(|job| !job.asks().resembles_its_reply());
        self.record(Record { at, verdict: Verdict::Echo, bytes: sent.to_vec() });
    }

    /// Counts bytes that are nobody's answer; each whole reply among them for itself.
    fn note_stray(&mut self, at: Tick, bytes: &[u8]) {
        let mut rest = bytes;
        while self.dialect.sender(rest).is_none() {
            let Some(reply) = self.dialect.reply_within(rest) else { break };
            let (before, from) = rest.split_at(reply.start.min(rest.len()));
            let (reply, behind) = from.split_at(reply.len().min(from.len()));
            if !before.is_empty() {
                self.note_one(at, before);
            }
            self.note_one(at, reply);
            rest = behind;
        }
        if !rest.is_empty() {
            self.note_one(at, rest);
        }
    }

    fn note_one(&mut self, at: Tick, bytes: &[u8]) {
        let verdict = match self.dialect.sender(bytes) {
            Some((station, said)) => {
                self.debts.hears(station);
                if let Some(job) = self.job.as_mut().filter(|job| job.station == station) {
                    job.heard = true;
                }
                self.explain(at, station, said, bytes);
                self.tally.strays += 1;
                Verdict::Stray { station }
            }
            None => {
                self.heard.sees_trouble();
                Verdict::Garbage
            }
        };
        self.record(Record { at, verdict, bytes: bytes.to_vec() });
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
mod second;
#[cfg(test)]
mod tests;
mod witness;
