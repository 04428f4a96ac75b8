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
use std::collections::BTreeMap;

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
    /// A valid telegram of somebody else came in place of the reply.
    #[error("station {station} answered in place of the one that was asked")]
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
    tally: Tally,
    records: Vec<Record>,
}

#[derive(Clone, Debug, Default)]
struct Doubt {
    missing: Vec<Request>,
    since: Tick,
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
    pub fn ask(&mut self, station: u8, request: Request, now: Tick) {
        let phase = if station == BROADCAST && !request.is_write() {
            Phase::Done(Err(ExchangeError::BroadcastRead))
        } else {
            Phase::Gap
        };
        let fence = self.fence_for(station, &request, now);
        self.job = Some(Job { station, request, fence, asked: 0, phase });
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
            Phase::Gap if now < self.ready_at => Step::Wait(self.ready_at),
            Phase::Gap => self.send(now),
            Phase::Turnaround { until } if now < *until => Step::Wait(*until),
            Phase::Turnaround { .. } => self.finish(Ok(Answer::Broadcast)),
            Phase::Reply { deadline, buffer, last, .. } => {
                let until = if buffer.is_empty() { *deadline } else { *last + STRAGGLE };
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
        self.tally.exceptions += u64::from(matches!(found.reply, Reply::Exception { .. }));
        let Some(job) = &mut self.job else { return };
        if job.fence.take().is_some() {
            self.doubts.remove(&job.station);
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
        let doubt = self.doubts.entry(job.station).or_default();
        doubt.since = now;
        if !doubt.missing.contains(&missing) {
            doubt.missing.push(missing);
        }
        let asked = job.asked;
        let error = match stray {
            _ if !bytes.is_empty() && self.framing.decode(&bytes).is_err() => ExchangeError::Garbled { asked, bytes },
            Some(station) if station != job.station => ExchangeError::Stray { station },
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
            Ok(adu) => Verdict::Stray { station: adu.station },
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
