//! The master's side of Modbus over a serial line, RTU or ASCII.
//!
//! * The request says how its reply ends, so a reply is taken the moment it is complete and its check is right.
//! * Times of the CM-485 manual 6.8: 2 ms pause after a reply, 500 ms until a missing reply is given up.
//! * RTU has no transaction number. After a time-out or garbage a station is *in doubt*: its missing reply may still
//!   come. Repeating the same question is harmless; before another question a fence is sent, a question whose reply
//!   cannot be taken for the missing one. Stations answer in order, so behind the fence's reply nothing old can come.

use super::{Record, Step, Tally, Verdict};
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::{COUNTERS, Reply, Request};
use crate::protocol::modbus::{BROADCAST, Framing, ascii, rtu};
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// Time limits of a conversation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// From the end of the request until its reply is given up.
    pub reply_timeout: Span,
    /// How often a question is repeated.
    pub retries: u8,
    /// Pause after a reply, so that the drive can switch off its transmitter.
    pub pause: Span,
    /// Pause after a broadcast, so that everybody can obey.
    pub turnaround: Span,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            reply_timeout: Span::from_millis(500), // CM-485 manual 6.8
            retries: 2,
            pause: Span::from_millis(2),        // CM-485 manual 6.8
            turnaround: Span::from_millis(100), // MODBUS over Serial Line V1.02, 2.4.1: typically 100-200 ms
        }
    }
}

/// Bytes of one telegram may come in pieces with pauses between them: USB adapters hold them for up to 16 ms.
const STRAGGLE: Span = Span::from_millis(50);

/// After this time without a sign a missing reply is not expected any more, even from a drive under load.
const FORGET: Span = Span::from_secs(2);

/// How a question ended well.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The station answered; an exception is an answer too.
    Reply {
        /// What it said.
        reply: Reply,
        /// From the end of the request to the last byte of the reply.
        after: Span,
    },
    /// A broadcast was sent; nobody answers.
    Broadcast,
}

/// How a question ended badly.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExchangeError {
    /// No byte came.
    #[error("no reply within {timeout}, asked {asked} times")]
    Silence {
        /// How long each try waited.
        timeout: Span,
        /// How often it was asked.
        asked: u8,
    },
    /// Bytes came, but no valid reply.
    #[error("no valid reply, asked {asked} times; {} bytes of garbage came", .bytes.len())]
    Garbled {
        /// How often it was asked.
        asked: u8,
        /// What came at last.
        bytes: Vec<u8>,
    },
    /// A valid telegram came that is not the answer: from somebody else, or to something else.
    #[error("a telegram of station {station} came that does not answer the question")]
    Stray {
        /// The station that answered.
        station: u8,
    },
    /// A broadcast that asks for a reply.
    #[error("a broadcast can only write")]
    BroadcastRead,
}

type Outcome = Result<Answer, ExchangeError>;

/// The master of one line.
#[derive(Debug)]
pub struct Master {
    framing: Framing,
    line: LineSetting,
    limits: Limits,
    /// The line is free for the next telegram from then on.
    ready_at: Tick,
    /// Stations that owe replies: function codes (and sub-functions of code 8) that may still come, and since when.
    doubts: BTreeMap<u8, Doubt>,
    job: Option<Job>,
    /// Stations that have sent anything valid.
    heard: BTreeSet<u8>,
    /// A question that was given up before its time, and whose reply may be on its way.
    orphan: Option<Orphan>,
    tally: Tally,
    records: Vec<Record>,
}

#[derive(Debug)]
struct Orphan {
    station: u8,
    request: Request,
    deadline: Tick,
    buffer: Vec<u8>,
}

#[derive(Clone, Debug, Default)]
struct Doubt {
    missing: Vec<Request>,
    since: Tick,
    /// How many replies may still come.
    owed: u32,
}

#[derive(Debug)]
struct Job {
    station: u8,
    request: Request,
    /// Sent before the request if the station is in doubt.
    fence: Option<Request>,
    asked: u8,
    phase: Phase,
}

#[derive(Debug)]
enum Phase {
    Gap,
    Reply { sent_end: Tick, deadline: Tick, buffer: Vec<u8>, last: Tick, stray: Option<u8> },
    Turnaround { until: Tick },
    Done(Outcome),
}

impl Master {
    /// A master on a line with this setting.
    pub fn new(framing: Framing, line: LineSetting, limits: Limits) -> Self {
        Master {
            framing,
            line,
            limits,
            ready_at: Tick::ZERO + line.t35(),
            doubts: BTreeMap::new(),
            job: None,
            heard: BTreeSet::new(),
            orphan: None,
            tally: Tally::default(),
            records: Vec::new(),
        }
    }

    /// How telegrams are framed.
    pub fn framing(&self) -> Framing {
        self.framing
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

    /// The telegrams since the last call.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// Begins to ask. Ask [`Master::step`] what to do until it is done.
    ///
    /// A question that is still open is given up: its reply or its time-out is waited for before anything is sent.
    pub fn ask(&mut self, station: u8, request: Request, now: Tick) {
        self.abandon(now);
        let phase = if station == BROADCAST && !request.is_write() {
            Phase::Done(Err(ExchangeError::BroadcastRead))
        } else {
            Phase::Gap
        };
        let fence = self.fence_for(station, &request, now);
        self.job = Some(Job { station, request, fence, asked: 0, phase });
    }

    /// Gives the open question up, but does not forget that its reply may be on its way.
    fn abandon(&mut self, now: Tick) {
        let Some(Job { station, request, fence, phase: Phase::Reply { deadline, buffer, .. }, .. }) = self.job.take()
        else {
            return;
        };
        let request = fence.unwrap_or(request);
        self.doubt(station, request.clone(), now);
        self.orphan = Some(Orphan { station, request, deadline, buffer });
    }

    /// Notes that a station owes the reply to a question.
    fn doubt(&mut self, station: u8, missing: Request, now: Tick) {
        let doubt = self.doubts.entry(station).or_default();
        doubt.since = now;
        doubt.owed += 1;
        if !doubt.missing.contains(&missing) {
            doubt.missing.push(missing);
        }
    }

    /// Until when a reply may still come: to a question that is open, or from a station that has answered before and owes
    /// one. Nothing must be closed before, or another program would take that reply for its own. `None` if nobody owes
    /// anything.
    pub fn owes_until(&self, now: Tick) -> Option<Tick> {
        let owing = self.doubts.iter().filter(|(station, doubt)| doubt.owed > 0 && self.heard.contains(station));
        let open = match &self.job {
            Some(Job { phase: Phase::Reply { deadline, .. }, .. }) => Some(*deadline),
            _ => self.orphan.as_ref().map(|orphan| orphan.deadline),
        };
        owing.map(|(_, doubt)| doubt.since + FORGET).chain(open).filter(|&until| until > now).max()
    }

    /// A valid telegram that nobody waited for. If it answers what its station was asked, that is one reply less that
    /// it owes.
    fn paid(&mut self, station: u8, pdu: &[u8]) {
        self.heard.insert(station);
        let Ok(reply) = Reply::decode(pdu) else { return };
        if let Some(doubt) = self.doubts.get_mut(&station)
            && doubt.missing.iter().any(|missing| missing.is_answered_by(&reply))
        {
            doubt.owed = doubt.owed.saturating_sub(1);
        }
    }

    /// Takes bytes for the question that was given up; its reply settles the doubt.
    fn feed_orphan(&mut self, at: Tick, bytes: &[u8]) -> bool {
        let Some(orphan) = &mut self.orphan else { return false };
        orphan.buffer.extend_from_slice(bytes);
        if find_reply(self.framing, &orphan.buffer, orphan.station, &orphan.request).is_none() {
            return true;
        }
        let (station, bytes) = (orphan.station, std::mem::take(&mut orphan.buffer));
        self.orphan = None;
        self.doubts.remove(&station);
        if let Some(job) = self.job.as_mut().filter(|job| job.station == station) {
            job.fence = None;
        }
        self.note_stray(at, &bytes);
        true
    }

    /// A question that parts old replies from new ones, if the station owes a reply to another question.
    fn fence_for(&mut self, station: u8, request: &Request, now: Tick) -> Option<Request> {
        let doubt = self.doubts.get(&station)?;
        if now.since(doubt.since) > FORGET {
            self.doubts.remove(&station);
            return None;
        }
        if doubt.missing.iter().all(|missing| missing == request) {
            return None;
        }
        let owed = |sub| doubt.missing.contains(&Request::Diagnostics { sub, data: 0 });
        let own = |sub| *request == Request::Diagnostics { sub, data: 0 };
        COUNTERS.rev().find(|&sub| !owed(sub) && !own(sub)).map(|sub| Request::Diagnostics { sub, data: 0 })
    }

    /// What to do now. Call again after every step; after `Done` the question is over.
    pub fn step(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Done(Err(ExchangeError::BroadcastRead)) };
        match &mut job.phase {
            Phase::Gap if self.orphan.as_ref().is_some_and(|orphan| now < orphan.deadline) => {
                Step::Wait(self.orphan.as_ref().map_or(now, |orphan| orphan.deadline))
            }
            Phase::Gap if now < self.ready_at => Step::Wait(self.ready_at),
            Phase::Gap => self.send(now),
            Phase::Turnaround { until } if now < *until => Step::Wait(*until),
            Phase::Turnaround { .. } => self.finish(Ok(Answer::Broadcast)),
            Phase::Reply { deadline, buffer, last, .. } => {
                let dawdles = self.framing == Framing::Ascii && !buffer.ends_with(ascii::END);
                let pause = if dawdles { ascii::MAX_PAUSE } else { STRAGGLE };
                let until = if buffer.is_empty() { *deadline } else { *last + pause };
                if now < until { Step::Wait(until) } else { self.give_up(now) }
            }
            Phase::Done(outcome) => {
                let outcome = outcome.clone();
                self.job = None;
                Step::Done(outcome)
            }
        }
    }

    fn send(&mut self, now: Tick) -> Step<Outcome> {
        self.orphan = None;
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let request = job.fence.as_ref().unwrap_or(&job.request);
        let verdict = if job.fence.is_some() { Verdict::Fence } else { Verdict::Request };
        let bytes = self.framing.encode(job.station, &request.encode());
        let sent_end = now + self.line.chars(bytes.len() as u64);
        job.asked += 1;
        self.tally.sent += 1;
        self.tally.repeats += u64::from(job.asked > 1 && verdict == Verdict::Request);
        self.tally.fences += u64::from(verdict == Verdict::Fence);
        job.phase = if job.station == BROADCAST {
            Phase::Turnaround { until: sent_end + self.limits.turnaround.longer(self.line.t35()) }
        } else {
            let deadline = sent_end + self.limits.reply_timeout;
            Phase::Reply { sent_end, deadline, buffer: Vec::new(), last: sent_end, stray: None }
        };
        self.ready_at = sent_end + self.line.t35();
        self.records.push(Record { at: now, verdict, bytes: bytes.clone() });
        Step::Send(bytes)
    }

    /// Takes bytes that came in at `at`.
    pub fn feed(&mut self, at: Tick, bytes: &[u8]) {
        self.ready_at = self.ready_at.max(at + self.gap());
        if self.feed_orphan(at, bytes) {
            return;
        }
        let Some(job) = &mut self.job else { return self.note_stray(at, bytes) };
        let Phase::Reply { sent_end, buffer, last, .. } = &mut job.phase else { return self.note_stray(at, bytes) };
        buffer.extend_from_slice(bytes);
        *last = at;
        let asked = job.fence.as_ref().unwrap_or(&job.request);
        let Some(found) = find_reply(self.framing, buffer, job.station, asked) else { return };
        let (sent_end, before) = (*sent_end, buffer.get(..found.start).unwrap_or_default().to_vec());
        let taken = buffer.get(found.start..).unwrap_or_default().to_vec();
        if !before.is_empty() {
            self.note_stray(at, &before);
        }
        self.records.push(Record { at, verdict: Verdict::Reply, bytes: taken });
        self.tally.replies += 1;
        if let Some(job) = &self.job {
            self.heard.insert(job.station);
        }
        self.tally.exceptions += u64::from(matches!(found.reply, Reply::Exception { .. }));
        let Some(job) = &mut self.job else { return };
        if let Some(fence) = job.fence.take() {
            // Everything older has come; of a fence that was asked more than once further replies may.
            let owed = u32::from(job.asked.saturating_sub(1));
            self.doubts.remove(&job.station);
            if owed > 0 {
                self.doubts.insert(job.station, Doubt { missing: vec![fence], since: at, owed });
            }
            job.asked = 0;
            job.phase = Phase::Gap;
        } else {
            job.phase = Phase::Done(Ok(Answer::Reply { reply: found.reply, after: at.since(sent_end) }));
        }
    }

    /// The line has been silent for long enough: name what came, then repeat or end.
    fn give_up(&mut self, now: Tick) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let Phase::Reply { deadline, buffer, stray, .. } = &mut job.phase else { return Step::Wait(now) };
        let (bytes, deadline) = (std::mem::take(buffer), *deadline);
        if let Ok(adu) = self.framing.decode(&bytes) {
            *stray = Some(adu.station);
            self.note_stray(now, &bytes);
            if now < deadline {
                return Step::Wait(deadline); // the reply may still come behind the stray telegram
            }
        } else if !bytes.is_empty() {
            self.note_stray(now, &bytes);
        }
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let Phase::Reply { stray, .. } = job.phase else { return Step::Wait(now) };
        let missing = job.fence.clone().unwrap_or_else(|| job.request.clone());
        let station = job.station;
        self.doubt(station, missing, now);
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let asked = job.asked;
        let error = match stray {
            _ if !bytes.is_empty() && self.framing.decode(&bytes).is_err() => ExchangeError::Garbled { asked, bytes },
            Some(station) => ExchangeError::Stray { station },
            _ => ExchangeError::Silence { timeout: self.limits.reply_timeout, asked },
        };
        match error {
            ExchangeError::Silence { .. } => self.tally.silences += 1,
            _ => self.tally.garbled += 1,
        }
        if asked <= self.limits.retries {
            job.phase = Phase::Gap;
            return self.step(now);
        }
        self.finish(Err(error))
    }

    fn finish(&mut self, outcome: Outcome) -> Step<Outcome> {
        self.job = None;
        Step::Done(outcome)
    }

    fn gap(&self) -> Span {
        self.limits.pause.longer(self.line.t35())
    }

    /// Counts bytes that nobody waits for.
    fn note_stray(&mut self, at: Tick, bytes: &[u8]) {
        let verdict = match self.framing.decode(bytes) {
            Ok(adu) => {
                self.paid(adu.station, &adu.pdu);
                Verdict::Stray { station: adu.station }
            }
            Err(_) => Verdict::Garbage,
        };
        self.tally.strays += u64::from(verdict != Verdict::Garbage);
        self.records.push(Record { at, verdict, bytes: bytes.to_vec() });
    }
}

/// A reply inside what has come so far.
struct Found {
    start: usize,
    reply: Reply,
}

/// Looks for the complete reply to `request`; bytes of noise before it do not cost it.
fn find_reply(framing: Framing, buffer: &[u8], station: u8, request: &Request) -> Option<Found> {
    (0..buffer.len()).find_map(|start| {
        let rest = buffer.get(start..)?;
        let adu = match framing {
            Framing::Rtu => rtu_frame(rest, station, request)?,
            Framing::Ascii => ascii_frame(rest)?,
        };
        let reply = Reply::decode(&adu.pdu).ok()?;
        let fits = adu.station == station && request.is_answered_by(&reply);
        fits.then_some(Found { start, reply })
    })
}

fn rtu_frame(rest: &[u8], station: u8, request: &Request) -> Option<crate::protocol::modbus::Adu> {
    let (&first, pdu) = rest.split_first()?;
    if first != station {
        return None;
    }
    let length = request.reply_end().length(pdu)?;
    rtu::decode(rest.get(..length + rtu::OVERHEAD)?).ok()
}

fn ascii_frame(rest: &[u8]) -> Option<crate::protocol::modbus::Adu> {
    let masked: Vec<u8> = rest.iter().map(|byte| byte & 0x7F).collect();
    if masked.first() != Some(&ascii::START) {
        return None;
    }
    let end = masked.windows(2).position(|pair| pair == ascii::END)? + ascii::END.len();
    ascii::decode(masked.get(..end)?).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use crate::protocol::modbus::pdu::Exception;

    /// A line on which bytes come at set times after the end of each request.
    struct Line {
        master: Master,
        now: Tick,
        /// Still to come.
        coming: Vec<(Tick, Vec<u8>)>,
        sent: Vec<Vec<u8>>,
    }

    impl Line {
        fn new(framing: Framing) -> Self {
            let line = LineSetting::rtu(19_200, Parity::Even);
            let master = Master::new(framing, line, Limits::default());
            Line { master, now: Tick::ZERO, coming: Vec::new(), sent: Vec::new() }
        }

        /// Asks; `replies` holds what comes after each telegram that we send, with milliseconds from its end.
        fn ask(&mut self, station: u8, request: Request, replies: &[&[(u64, Vec<u8>)]]) -> Outcome {
            self.master.ask(station, request, self.now);
            let mut replies = replies.iter();
            loop {
                match self.master.step(self.now) {
                    Step::Done(outcome) => return outcome,
                    Step::Send(bytes) => {
                        let end = self.now + self.master.line.chars(bytes.len() as u64);
                        let chunks = replies.next().copied().unwrap_or_default();
                        self.coming.extend(chunks.iter().map(|(ms, b)| (end + Span::from_millis(*ms), b.clone())));
                        self.coming.sort_by_key(|chunk| chunk.0);
                        self.sent.push(bytes);
                    }
                    Step::Wait(until) => match self.coming.first() {
                        Some((at, _)) if *at <= until => {
                            let (at, bytes) = self.coming.remove(0);
                            self.now = at.max(self.now);
                            self.master.feed(self.now, &bytes);
                        }
                        _ => self.now = until,
                    },
                }
            }
        }

        fn verdicts(&mut self) -> Vec<Verdict> {
            self.master.take_records().into_iter().map(|record| record.verdict).collect()
        }
    }

    const READ: Request = Request::ReadRegisters { start: 0x2174, count: 1 };
    const OTHER: Request = Request::ReadRegisters { start: 0x0101, count: 1 };

    fn frame(station: u8, reply: &Reply) -> Vec<u8> {
        rtu::encode(station, &reply.encode())
    }

    fn value(value: u16) -> Vec<u8> {
        frame(1, &Reply::Registers(vec![value]))
    }

    fn fence_reply(sub: u16) -> Vec<u8> {
        frame(1, &Reply::Diagnostics { sub, data: 0 })
    }

    fn taken(outcome: Outcome) -> Reply {
        match outcome {
            Ok(Answer::Reply { reply, .. }) => reply,
            other => panic!("no reply: {other:?}"),
        }
    }

    #[test]
    fn a_reply_is_taken_the_moment_it_is_complete() {
        let mut line = Line::new(Framing::Rtu);
        let outcome = line.ask(1, READ, &[&[(10, value(1390))]]);
        assert!(matches!(outcome, Ok(Answer::Reply { after, .. }) if after == Span::from_millis(10)), "{outcome:?}");
        assert_eq!(line.sent, [[0x01, 0x03, 0x21, 0x74, 0x00, 0x01, 0xCE, 0x2C]]);
    }

    #[test]
    fn a_reply_in_pieces_is_put_together() {
        let bytes = value(1390);
        for split in 1..bytes.len() {
            let mut line = Line::new(Framing::Rtu);
            let (head, tail) = bytes.split_at(split);
            let pieces = [(10, head.to_vec()), (26, tail.to_vec())];
            assert_eq!(taken(line.ask(1, READ, &[&pieces])), Reply::Registers(vec![1390]));
        }
    }

    #[test]
    fn silence_is_given_up_after_the_time_of_the_manual_and_repeated() {
        let mut line = Line::new(Framing::Rtu);
        let outcome = line.ask(1, READ, &[]);
        assert_eq!(outcome, Err(ExchangeError::Silence { timeout: Span::from_millis(500), asked: 3 }));
        assert_eq!(line.sent.len(), 3);
        assert!(line.now >= Tick::from_micros(3 * 500_000));
    }

    #[test]
    fn a_late_reply_is_never_credited_to_the_next_question() {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        // The reply to READ comes 700 ms after it was asked, in the middle of the next question.
        assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
        let outcome = line.ask(1, OTHER, &[&[(210, fence_reply(0x12))], &[(10, value(7))]]);
        assert_eq!(taken(outcome), Reply::Registers(vec![7]));
        let verdicts = line.verdicts();
        assert!(verdicts.contains(&Verdict::Fence), "{verdicts:?}");
        assert!(verdicts.contains(&Verdict::Stray { station: 1 }), "{verdicts:?}");
        // Behind the fence there is no doubt any more.
        assert_eq!(taken(line.ask(1, READ, &[&[(10, value(1390))]])), Reply::Registers(vec![1390]));
        assert_eq!(line.master.tally().fences, 1);
    }

    #[test]
    fn a_fence_is_never_one_of_the_missing_questions() {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        let counter = Request::Diagnostics { sub: 0x12, data: 0 };
        assert!(line.ask(1, counter, &[]).is_err());
        let late = frame(1, &Reply::Diagnostics { sub: 0x12, data: 99 });
        let outcome = line.ask(1, OTHER, &[&[(10, late), (60, fence_reply(0x11))], &[(10, value(7))]]);
        assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    }

    #[test]
    fn a_fence_that_was_asked_twice_is_itself_in_doubt() {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 1, ..Limits::default() });
        assert!(line.ask(1, READ, &[]).is_err());
        // The first fence is answered only after it was repeated; the reply to the repeat comes later still.
        let outcome =
            line.ask(1, OTHER, &[&[(700, fence_reply(0x12))], &[(400, fence_reply(0x12))], &[(10, value(7))]]);
        assert_eq!(taken(outcome), Reply::Registers(vec![7]));
        assert!(line.master.owes_until(line.now).is_some(), "the second fence's reply is still to come");
        let (at, late) = line.coming.remove(0);
        line.master.feed(at, &late);
        assert_eq!(line.master.owes_until(at), None);
    }

    #[test]
    fn another_station_is_asked_without_a_fence() {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        assert!(line.ask(1, READ, &[]).is_err());
        let own = frame(2, &Reply::Registers(vec![5]));
        let outcome = line.ask(2, OTHER, &[&[(5, value(1390)), (30, own)]]);
        assert_eq!(taken(outcome), Reply::Registers(vec![5]));
        assert_eq!(line.master.tally().fences, 0);
    }

    #[test]
    fn garbage_noise_and_foreign_telegrams_are_named() {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        let mut broken = value(1390);
        broken[4] ^= 0x10;
        let outcome = line.ask(1, READ, &[&[(10, broken)]]);
        assert!(matches!(outcome, Err(ExchangeError::Garbled { asked: 1, .. })), "{outcome:?}");
        let mut noisy = vec![0x00, 0xFF];
        noisy.extend(value(1390));
        assert_eq!(taken(line.ask(1, READ, &[&[(10, noisy)]])), Reply::Registers(vec![1390]));
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        let foreign = frame(9, &Reply::Registers(vec![1]));
        assert_eq!(line.ask(1, READ, &[&[(10, foreign)]]), Err(ExchangeError::Stray { station: 9 }));
    }

    #[test]
    fn truncated_replies_are_never_believed() {
        let whole = value(1390);
        for length in 1..whole.len() {
            let mut line = Line::new(Framing::Rtu);
            line.master.set_limits(Limits { retries: 0, ..Limits::default() });
            assert!(line.ask(1, READ, &[&[(10, whole[..length].to_vec())]]).is_err(), "{length}");
        }
    }

    #[test]
    fn single_flipped_bits_are_never_believed() {
        let whole = value(1390);
        for bit in 0..whole.len() * 8 {
            let mut line = Line::new(Framing::Rtu);
            line.master.set_limits(Limits { retries: 0, ..Limits::default() });
            let mut flipped = whole.clone();
            flipped[bit / 8] ^= 1 << (bit % 8);
            assert!(line.ask(1, READ, &[&[(10, flipped)]]).is_err(), "{bit}");
        }
    }

    #[test]
    fn an_exception_is_an_answer() {
        let mut line = Line::new(Framing::Rtu);
        let refused = Reply::Exception { function: 3, code: Exception::DeviceFailure };
        assert_eq!(taken(line.ask(1, READ, &[&[(10, frame(1, &refused))]])), refused);
        assert_eq!(line.master.tally().exceptions, 1);
    }

    #[test]
    fn a_write_is_answered_by_its_own_echo_only() {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        let write = Request::WriteRegister { address: 0x4178, value: 15 };
        let other = Reply::RegisterWritten { address: 0x4178, value: 16 };
        let echo = Reply::RegisterWritten { address: 0x4178, value: 15 };
        let outcome = line.ask(1, write, &[&[(10, frame(1, &other)), (40, frame(1, &echo))]]);
        assert_eq!(taken(outcome), echo);
    }

    #[test]
    fn broadcasts_write_and_wait_for_nobody() {
        let mut line = Line::new(Framing::Rtu);
        assert_eq!(line.ask(0, READ, &[]), Err(ExchangeError::BroadcastRead));
        let write = Request::WriteRegister { address: 0x019A, value: 0 };
        assert_eq!(line.ask(0, write, &[]), Ok(Answer::Broadcast));
        assert!(line.now > Tick::from_micros(100_000));
    }

    #[test]
    fn the_next_telegram_waits_for_the_pause_of_the_manual() {
        let mut line = Line::new(Framing::Rtu);
        taken(line.ask(1, READ, &[&[(10, value(1390))]]));
        let replied = line.now;
        line.master.ask(1, OTHER, line.now);
        let Step::Wait(until) = line.master.step(line.now) else { panic!("sends at once") };
        assert_eq!(until.since(replied), line.master.line.t35());
        assert!(until.since(replied) >= Span::from_millis(2));
    }

    #[test]
    fn a_question_given_up_is_waited_for_before_the_next_is_sent() {
        let mut line = Line::new(Framing::Rtu);
        // Asked, sent, and given up 5 ms later; its reply comes 10 ms after its end.
        line.master.ask(1, READ, line.now);
        while !matches!(line.master.step(line.now), Step::Send(_)) {
            line.now += Span::from_micros(100);
        }
        let end = line.now + line.master.line.chars(8);
        line.now += Span::from_millis(5);
        line.coming.push((end + Span::from_millis(10), value(1390)));
        let outcome = line.ask(1, OTHER, &[&[(10, value(7))]]);
        assert_eq!(taken(outcome), Reply::Registers(vec![7]));
        let telegrams: Vec<_> = line.master.take_records();
        let times: Vec<_> = telegrams.iter().map(|record| (record.at, record.verdict)).collect();
        let second = times.iter().filter(|row| row.1 == Verdict::Request).nth(1).unwrap().0;
        assert_eq!(second, end + Span::from_millis(10) + line.master.line.t35());
        assert_eq!(line.master.tally().fences, 0, "the reply came, so there is no doubt");
        // The same without a reply: nothing is sent before the time-out, and then a fence.
        let mut line = Line::new(Framing::Rtu);
        line.master.ask(1, READ, line.now);
        while !matches!(line.master.step(line.now), Step::Send(_)) {
            line.now += Span::from_micros(100);
        }
        let begun = line.now;
        let outcome = line.ask(1, OTHER, &[&[(10, fence_reply(0x12))], &[(10, value(7))]]);
        assert_eq!(taken(outcome), Reply::Registers(vec![7]));
        assert!(line.now.since(begun) > Span::from_millis(500));
        assert_eq!(line.master.tally().fences, 1);
    }

    #[test]
    fn ascii_replies_may_dawdle() {
        let mut line = Line::new(Framing::Ascii);
        let reply = b":010302056E87\r\n";
        let (head, tail) = reply.split_at(5);
        let pieces = [(10, head.to_vec()), (40, tail.to_vec())];
        assert_eq!(taken(line.ask(1, READ, &[&pieces])), Reply::Registers(vec![1390]));
        assert_eq!(line.sent, [b":010321740001 66\r\n".iter().copied().filter(|&b| b != b' ').collect::<Vec<_>>()]);
    }
}
