//! The data link layer of a single master, one question at a time.

use super::cut::first;
use crate::exchange::{Conversation, Record, Step, Tally, Verdict};
use crate::protocol::dp::control::{Count, Function, Station, Status};
use crate::protocol::dp::{Control, EVERYBODY, Frame, Service, Telegram};
use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// Idle bits before every question (IEC 61158-4-3: T_SYN), and some for the rounding of clocks.
const SYN_BITS: u64 = 33 + 2;
/// At least so long between two telegrams of ours that nobody answers, or a USB adapter puts them back to back (docs/measured.md).
const UNANSWERED: Span = Span::from_millis(2);
/// A line that is never silent for so long has no room for a question.
const BABBLE: Span = Span::from_secs(1);
/// What insists goes out into a line that was not silent for so long.
const BUSY: Span = Span::from_millis(100);
/// Bytes of one reply: SD2 has at most 255 (IEC 61158-4-3).
const LONGEST: u64 = 255;
/// Bytes that are looked through for a telegram.
const MOST_BYTES: usize = 1_024;
/// Where a master asks from (IEC 61158-6-3: MS0).
const SSAP: u8 = 62;

/// Times and repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timing {
    /// From the end of a question to the first byte of its answer, adapters included.
    pub slot: Span,
    /// How often an unanswered question is repeated.
    pub retries: u8,
}

impl Timing {
    /// What a USB adapter needs: 30 ms up to 45.45 kBd, 8 ms from 93.75 kBd on, and 3 repeats (measured, docs/measured.md).
    pub fn of(line: LineSetting) -> Self {
        Timing { slot: if line.baud < 93_750 { Span::from_millis(30) } else { Span::from_millis(8) }, retries: 3 }
    }
}

/// A question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asked {
    service: Service,
    data: Vec<u8>,
}

impl Asked {
    /// Is anybody there, and what?
    pub const STATUS: Asked = Asked { service: Service::Link, data: Vec::new() };

    /// A service with its data.
    pub fn service(service: Service, data: Vec<u8>) -> Self {
        Asked { service, data }
    }

    /// The service that it asks for.
    pub fn asks(&self) -> Service {
        self.service
    }

    /// The telegram that asks it for the first time, for showing it.
    pub fn telegram(&self, to: u8, from: u8) -> Vec<u8> {
        let count = if self.is_counted(to) { Count::First } else { Count::Unused };
        Telegram::Frame(self.frame(to, from, count)).encode()
    }

    fn frame(&self, to: u8, from: u8, count: Count) -> Frame {
        let function = match self.service {
            Service::Link => Function::FdlStatus,
            _ if to == EVERYBODY => Function::SdnHigh,
            _ => Function::SrdHigh,
        };
        let dsap = self.service.sap();
        let control = Control::Request { function, count };
        // SD3 carries eight bytes and no access point.
        let is_fixed = dsap.is_none();
        Frame { to, from, control, dsap, ssap: dsap.map(|_| SSAP), data: self.data.clone(), is_fixed }
    }

    /// Whether SC is an answer to it.
    fn takes_ack(&self) -> bool {
        matches!(self.service, Service::SetPrm | Service::ChkCfg)
    }

    /// Whether the telegram is counted.
    fn is_counted(&self, to: u8) -> bool {
        self.service != Service::Link && to != EVERYBODY
    }
}

/// What came of a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// SC.
    Ack,
    /// A telegram of the station.
    Frame {
        /// What the station is.
        station: Station,
        /// What came of the question.
        status: Status,
        /// What it carries.
        data: Vec<u8>,
    },
    /// Nobody answers what goes to everybody.
    Sent,
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unanswered {
    /// No byte came, however often it was asked.
    #[error("no answer within {slot}, asked {asked} times")]
    Silence {
        /// How long each try waited.
        slot: Span,
        /// How often it was asked.
        asked: u8,
    },
    /// Bytes came, but no answer.
    #[error("no valid answer, asked {asked} times; {} bytes of garbage came", .bytes.len())]
    Garbled {
        /// How often it was asked.
        asked: u8,
        /// What came at last.
        bytes: Vec<u8>,
    },
    /// Somebody else asks on this line.
    #[error("another master is active on this line, at address {0}")]
    OtherMaster(u8),
}

/// A question under way.
#[derive(Debug)]
struct Open {
    station: u8,
    asked: Asked,
    bytes: Vec<u8>,
    tries: u8,
    asked_times: u8,
    /// When it is on the wire as a whole; `None` before it is sent.
    sent: Option<Tick>,
    /// The end of the wait, and of any wait.
    until: Tick,
    limit: Tick,
    /// Garbage that came for it.
    garbage: Vec<u8>,
}

/// The data link layer of a single master.
///
/// [`Fdl::ask`], then [`Conversation::step`] until it is done.
#[derive(Debug)]
pub struct Fdl {
    me: u8,
    line: LineSetting,
    timing: Timing,
    /// Frame count bit of the next question to each station that has answered.
    counts: BTreeMap<u8, bool>,
    open: Option<Open>,
    /// Bytes that came and are no telegram yet.
    heard: Vec<u8>,
    /// Nothing may be sent before.
    ready: Tick,
    done: Option<Result<Reply, Unanswered>>,
    records: Vec<Record>,
    /// From the end of the last question to its answer.
    after: Option<Span>,
    /// Repeats so far, by station.
    repeats: BTreeMap<u8, u64>,
    tally: Tally,
    /// What is asked goes out whoever else speaks: it is the stop of a motor.
    insists: bool,
    /// Another master who was heard while nothing was asked.
    stranger: Option<u8>,
    /// Another master who was ever heard.
    beside: Option<u8>,
}

impl Fdl {
    /// A master at an address; the line is silent since `now`.
    pub fn new(me: u8, line: LineSetting, timing: Timing, now: Tick) -> Self {
        Fdl {
            me,
            line,
            timing,
            counts: BTreeMap::new(),
            open: None,
            heard: Vec::new(),
            ready: now + syn(line),
            done: None,
            records: Vec::new(),
            after: None,
            repeats: BTreeMap::new(),
            tally: Tally::default(),
            insists: false,
            stranger: None,
            beside: None,
        }
    }

    /// From now on nobody else on the line keeps a question from going out, nor ends it.
    pub fn insist(&mut self) {
        self.insists = true;
    }

    /// Another master who was heard on this line since it was opened.
    pub fn beside(&self) -> Option<u8> {
        self.beside
    }

    /// How long a question waits for the line.
    fn patience(&self) -> Span {
        if self.insists { BUSY } else { BABBLE }
    }

    /// Our address.
    pub fn address(&self) -> u8 {
        self.me
    }

    /// From the end of the last question to the end of its answer; `None` if it had to be asked again, because nobody knows which
    /// of them was answered.
    pub fn answered_after(&self) -> Option<Span> {
        self.after
    }

    /// How often a station was asked again.
    pub fn repeats(&self, station: u8) -> u64 {
        self.repeats.get(&station).copied().unwrap_or(0)
    }

    /// What the line has come to.
    pub fn tally(&self) -> Tally {
        self.tally
    }

    /// What went over the line since the last call.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// A question that nobody waits for any more may still be answered: not into that, and whether it was counted nobody knows.
    fn leave_alone(&mut self) {
        let Some(open) = self.open.take().filter(|open| open.asked_times > 0) else { return };
        self.ready = self.ready.max(open.until + syn(self.line));
        self.counts.remove(&open.station);
    }

    /// Puts a question to a station; what was asked before is forgotten, once its answer has had its time. `retries` in place of the usual number.
    pub fn ask(&mut self, station: u8, asked: Asked, retries: Option<u8>, now: Tick) {
        self.leave_alone();
        let count = match (asked.is_counted(station), self.counts.get(&station)) {
            (false, _) => Count::Unused,
            (true, None) => Count::First,
            (true, Some(bit)) => Count::Bit(*bit),
        };
        let bytes = Telegram::Frame(asked.frame(station, self.me, count)).encode();
        let tries = retries.unwrap_or(self.timing.retries).saturating_add(1);
        let tries = if station == EVERYBODY { 1 } else { tries };
        self.heard.clear();
        self.done = None;
        self.ready = self.ready.max(now);
        let (until, limit) = (now, now + self.patience());
        let (asked_times, garbage) = (0, Vec::new());
        self.open = Some(Open { station, asked, bytes, tries, asked_times, sent: None, until, limit, garbage });
        if let Some(other) = self.stranger.take().filter(|_| !self.insists) {
            self.ends(now, Err(Unanswered::OtherMaster(other)));
        }
    }

    fn note(&mut self, at: Tick, verdict: Verdict, bytes: Vec<u8>) {
        if self.records.len() < crate::exchange::MOST_RECORDS {
            self.records.push(Record { at, verdict, bytes });
        }
    }

    fn ends(&mut self, now: Tick, result: Result<Reply, Unanswered>) {
        let Some(open) = self.open.take() else { return };
        self.after = open.sent.filter(|_| open.asked_times == 1).map(|sent| now.since(sent));
        self.counts_in(&result, open.sent.map_or(Span::ZERO, |sent| now.since(sent)));
        // What was answered has been taken by the adapter, and the line is free behind T_SYN.
        let is_answered = matches!(result, Ok(Reply::Ack | Reply::Frame { .. }));
        self.ready = if is_answered { now } else { self.ready.max(now) } + syn(self.line);
        // The first question counts as bit 1. Behind silence, to whatever question, the counting begins again: the station may have restarted.
        match &result {
            Err(_) => drop(self.counts.remove(&open.station)),
            Ok(_) if open.asked.is_counted(open.station) => {
                let bit = self.counts.entry(open.station).or_insert(true);
                *bit = !*bit;
            }
            Ok(_) => {}
        }
        self.done = Some(result);
    }

    fn counts_in(&mut self, result: &Result<Reply, Unanswered>, waited: Span) {
        let tally = &mut self.tally;
        match result {
            Ok(Reply::Sent) => {}
            Ok(Reply::Ack | Reply::Frame { .. }) => {
                (tally.replies, tally.waited) = (tally.replies + 1, tally.waited + waited);
            }
            Err(Unanswered::Silence { .. }) => tally.silences += 1,
            Err(Unanswered::Garbled { .. }) => tally.garbled += 1,
            Err(Unanswered::OtherMaster(_)) => tally.strays += 1,
        }
    }

    /// Sends the question, or says until when to wait first.
    fn send(&mut self, now: Tick) -> Step<Result<Reply, Unanswered>> {
        let (ready, line, slot, insists) = (self.ready, self.line, self.timing.slot, self.insists);
        let Some(open) = &mut self.open else { return Step::Wait(ready) };
        let ready = if insists { ready.min(open.limit) } else { ready };
        if now < ready {
            return Step::Wait(ready);
        }
        let out = now + line.chars(open.bytes.len() as u64);
        open.sent = Some(out);
        open.until = out + slot;
        open.limit = out + slot.times(2) + line.chars(LONGEST);
        open.tries -= 1;
        open.asked_times += 1;
        self.tally.sent += 1;
        let (bytes, is_broadcast) = (open.bytes.clone(), open.station == EVERYBODY);
        self.heard.clear();
        self.ready = out + syn(line).longer(UNANSWERED);
        self.note(now, Verdict::Request, bytes.clone());
        if is_broadcast {
            self.ends(out, Ok(Reply::Sent));
        }
        Step::Send(bytes)
    }

    /// The time of a try is over: again, or the end.
    fn expires(&mut self, now: Tick) {
        let rest = std::mem::take(&mut self.heard);
        if !rest.is_empty() {
            self.note(now, Verdict::Garbage, rest.clone());
        }
        let (slot, patience) = (self.timing.slot, self.patience());
        let Some(open) = &mut self.open else { return };
        open.garbage.extend(rest);
        if open.tries > 0 && open.sent.is_some() {
            (open.sent, open.limit) = (None, now + patience);
            *self.repeats.entry(open.station).or_default() += 1;
            self.tally.repeats += 1;
            self.ready = self.ready.max(now + syn(self.line).longer(UNANSWERED));
            return;
        }
        let asked = open.asked_times;
        let garbage = std::mem::take(&mut open.garbage);
        let why = match garbage.is_empty() {
            true => Unanswered::Silence { slot, asked },
            false => Unanswered::Garbled { asked, bytes: garbage },
        };
        self.ends(now, Err(why));
    }

    /// Takes telegrams out of what was heard.
    fn look(&mut self, now: Tick) {
        while let Some((before, telegram, bytes)) = first(&mut self.heard) {
            if !before.is_empty() {
                self.note(now, Verdict::Garbage, before.clone());
                self.open.iter_mut().for_each(|open| open.garbage.extend(&before));
            }
            if let Some(result) = self.weigh(now, telegram, bytes) {
                self.ends(now, result);
            }
        }
    }

    /// What a telegram is to the question that is open; its end, if it is one.
    fn weigh(&mut self, now: Tick, telegram: Telegram, bytes: Vec<u8>) -> Option<Result<Reply, Unanswered>> {
        let Some(open) = &self.open else {
            self.stranger = self.stranger.or(self.other_master(&telegram));
            self.beside = self.beside.or(self.stranger);
            return None;
        };
        let (verdict, result) = match telegram {
            Telegram::Ack if open.asked.takes_ack() => (Verdict::Reply, Some(Ok(Reply::Ack))),
            Telegram::Ack => (Verdict::Garbage, None),
            Telegram::Token { from, .. } => {
                (Verdict::Stray { station: from }, Some(Err(Unanswered::OtherMaster(from))))
            }
            Telegram::Frame(frame) => self.frame(open, frame),
        };
        let other = match result {
            Some(Err(Unanswered::OtherMaster(master))) => Some(master),
            _ => None,
        };
        self.beside = self.beside.or(other);
        // What comes before the question went out answers the one before it, which nobody waits for any more.
        let (verdict, result) = match result {
            Some(_) if other.is_some() && self.insists => (verdict, None),
            Some(Ok(_)) if open.asked_times == 0 => (Verdict::Stray { station: open.station }, None),
            result => (verdict, result),
        };
        self.note(now, verdict, bytes);
        result
    }

    /// Who else leads this line, if a telegram shows it.
    fn other_master(&self, telegram: &Telegram) -> Option<u8> {
        let master = match telegram {
            Telegram::Token { from, .. } => *from,
            Telegram::Frame(frame) if matches!(frame.control, Control::Request { .. }) => frame.from,
            Telegram::Frame(frame) => frame.to,
            Telegram::Ack => return None,
        };
        (master != self.me).then_some(master)
    }

    fn frame(&self, open: &Open, frame: Frame) -> (Verdict, Option<Result<Reply, Unanswered>>) {
        let station = frame.from;
        let stray = Verdict::Stray { station };
        match frame.control {
            // An echo that an adapter held back.
            Control::Request { .. } if station == self.me => (Verdict::Echo, None),
            Control::Request { .. } => (stray, Some(Err(Unanswered::OtherMaster(station)))),
            // Somebody was asked by somebody else.
            Control::Reply { .. } if frame.to != self.me => (stray, Some(Err(Unanswered::OtherMaster(frame.to)))),
            Control::Reply { station: kind, status } => {
                let sap = open.asked.service.sap();
                // A short answer names no access point.
                let fits = frame.data.is_empty() || (frame.ssap, frame.dsap) == (sap, sap.map(|_| SSAP));
                if station != open.station || !fits {
                    return (stray, None);
                }
                (Verdict::Reply, Some(Ok(Reply::Frame { station: kind, status, data: frame.data })))
            }
        }
    }
}

impl Conversation for Fdl {
    type End = Result<Reply, Unanswered>;

    fn step(&mut self, now: Tick) -> Step<Self::End> {
        let is_over = |open: &Open| match open.sent {
            Some(_) => now >= open.until,
            None => now >= open.limit && !self.insists,
        };
        if self.open.as_ref().is_some_and(is_over) {
            self.expires(now);
        }
        if let Some(done) = self.done.take() {
            return Step::Done(done);
        }
        match &self.open {
            Some(Open { sent: Some(_), until, .. }) => Step::Wait(*until),
            Some(Open { sent: None, limit, .. }) if self.ready > *limit && !self.insists => Step::Wait(*limit),
            _ => self.send(now),
        }
    }

    fn feed(&mut self, at: Tick, bytes: &[u8]) {
        self.heard.extend(bytes);
        let surplus = self.heard.len().saturating_sub(MOST_BYTES);
        self.heard.drain(..surplus);
        self.ready = self.ready.max(at + syn(self.line));
        // What has begun may come in pieces, but not for ever.
        let slot = self.timing.slot;
        if let Some(open) = &mut self.open
            && open.sent.is_some()
        {
            open.until = (at.max(open.sent.unwrap_or(at)) + slot).min(open.limit);
        }
        self.look(at);
    }
}

/// T_SYN on a line.
pub(super) fn syn(line: LineSetting) -> Span {
    Span::from_micros((SYN_BITS * 1_000_000).div_ceil(u64::from(line.baud.max(1))))
}

#[cfg(test)]
mod tests;
