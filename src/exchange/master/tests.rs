//! The master on a line on which bytes come at set times.

mod babble;
mod copied;
mod counts;
mod doubts;
mod fences;
mod others;
mod suspects;
mod weighed;

use super::*;
use crate::protocol::line::Parity;
use crate::protocol::modbus::pdu::{COUNTERS, Exception, Reply, Request};
use crate::protocol::modbus::{Framing, mbap, rtu};
use crate::protocol::vabus::{self, Address, Data, Header, ParamNumber};
use crate::tick::Span;

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
        let mut master = Master::new(framing.into(), line, Limits::default());
        master.has_counters(1, COUNTERS);
        Line { master, now: Tick::ZERO, coming: Vec::new(), sent: Vec::new() }
    }

    fn vabus() -> Self {
        let line = LineSetting::ascii(19_200, Parity::Even);
        let master = Master::new(Protocol::Vabus, line, Limits::default());
        Line { master, now: Tick::ZERO, coming: Vec::new(), sent: Vec::new() }
    }

    /// Asks; `replies` holds what comes after each telegram that we send, with milliseconds from its end.
    fn ask(&mut self, station: u8, request: impl Into<Question>, replies: &[&[(u64, Vec<u8>)]]) -> Outcome {
        let mut replies = replies.iter();
        self.ask_of(station, request, |sent| match sent {
            [vabus::EOT] => Vec::new(),
            _ => replies.next().map_or_else(Vec::new, |chunks| chunks.to_vec()),
        })
    }

    /// Asks; what comes after each telegram that we send, with milliseconds from its end.
    fn ask_of(
        &mut self,
        station: u8,
        request: impl Into<Question>,
        mut replies: impl FnMut(&[u8]) -> Vec<(u64, Vec<u8>)>,
    ) -> Outcome {
        self.master.ask(station, request, self.now);
        loop {
            match self.master.step(self.now) {
                Step::Done(outcome) => return outcome,
                Step::Send(bytes) => {
                    let end = self.now + self.master.line.chars(bytes.len() as u64);
                    let chunks = replies(&bytes).into_iter();
                    self.coming.extend(chunks.map(|(ms, bytes)| (end + Span::from_millis(ms), bytes)));
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

    /// Asks a station that answers everything after 10 ms; the words that were believed.
    fn answered(&mut self, station: u8, request: Request) -> Option<Vec<u16>> {
        self.answered_behind(&[], 7, station, request)
    }

    /// The same with a value of its own, and with this before it.
    fn answered_behind(&mut self, before: &[u8], value: u16, station: u8, request: Request) -> Option<Vec<u16>> {
        self.master.ask(station, request, self.now);
        loop {
            match self.master.step(self.now) {
                Step::Done(Ok(Answer::Reply { said: Said::Modbus(Reply::Registers(words)), .. })) => {
                    return Some(words);
                }
                Step::Done(_) => return None,
                Step::Wait(until) => self.now = until,
                Step::Send(bytes) => {
                    let end = self.now + self.master.line.chars(bytes.len() as u64);
                    let reply = match Request::decode(&rtu::decode(&bytes).unwrap().pdu).unwrap() {
                        Request::Diagnostics { sub, .. } => Reply::Diagnostics { sub, data: self.sent.len() as u16 },
                        _ => Reply::Registers(vec![value]),
                    };
                    let reply = [before, &frame(station, &reply)].concat();
                    self.sent.push(bytes);
                    self.now = end + Span::from_millis(20);
                    self.master.feed(self.now, &reply);
                }
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

/// The counter of telegrams on the bus, by which replies are parted.
fn fence_reply() -> Vec<u8> {
    frame(1, &Reply::Diagnostics { sub: 0x0B, data: 7 })
}

fn taken(outcome: Outcome) -> Reply {
    match outcome {
        Ok(Answer::Reply { said: Said::Modbus(reply), .. }) => reply,
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
fn an_echo_is_learnt_and_removed() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let write = Request::WriteRegister { address: 0x4178, value: 15 };
    let echo = |request: &Request| rtu::encode(1, &request.encode());
    assert!(line.master.needs_sounding(1, &write.clone().into()));
    let pieces = [(0, echo(&READ)), (10, value(1390))];
    assert_eq!(taken(line.ask(1, READ, &[&pieces])), Reply::Registers(vec![1390]));
    assert_eq!(line.master.echoes(), Some(true));
    // The drive is off: the echo alone is not its reply.
    let outcome = line.ask(1, write.clone(), &[&[(0, echo(&write))]]);
    assert!(matches!(outcome, Err(ExchangeError::Silence { .. })), "{outcome:?}");
    let pieces = [(0, echo(&write)), (10, echo(&write))];
    assert!(line.ask(1, write.clone(), &[&pieces]).is_ok());
    assert_eq!((line.master.tally().echoes, line.master.tally().strays), (3, 0));
}

#[test]
fn a_line_without_echo_is_learnt_too() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    assert_eq!(line.master.echoes(), Some(false));
    let write = Request::WriteRegister { address: 0x4178, value: 15 };
    let reply = rtu::encode(1, &write.encode());
    assert!(line.ask(1, write, &[&[(10, reply)]]).is_ok());
}

#[test]
fn behind_a_little_noise_the_reply_may_still_come() {
    let mut line = Line::new(Framing::Rtu);
    let outcome = line.ask(1, READ, &[&[(1, vec![0x00]), (300, value(1390))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![1390]));
    assert_eq!((line.sent.len(), line.master.echoes()), (1, Some(false)));
}

#[test]
fn a_doubled_reply_is_one_stray_telegram() {
    let mut line = Line::new(Framing::Rtu);
    let again: Vec<_> = value(1390).into_iter().enumerate().map(|(at, byte)| (11 + at as u64, vec![byte])).collect();
    let chunks: Vec<_> = [(10, value(1390))].into_iter().chain(again).collect();
    taken(line.ask(1, READ, &[&chunks]));
    // It may be a second drive's: how many answer is found out before a value is believed.
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(10, value(7))], &[(10, fence_reply())], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
    assert_eq!(line.master.tally().strays, 1);
    assert!(line.verdicts().contains(&Verdict::Stray { station: 1 }));
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
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
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
    let tally = line.master.tally();
    assert_eq!((tally.fences, tally.strays), (0, 1), "the reply came, so there is no doubt");
    // The same without a reply: nothing is sent before the time-out, and then a fence.
    let mut line = Line::new(Framing::Rtu);
    line.master.ask(1, READ, line.now);
    while !matches!(line.master.step(line.now), Step::Send(_)) {
        line.now += Span::from_micros(100);
    }
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&[(10, fence_reply())], &[(10, value(7))], &[(10, value(7))]]);
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

#[test]
fn an_echo_of_the_last_end_that_comes_late_costs_no_repeat() {
    let mut line = Line::vabus();
    let address = Address::drive(1).unwrap();
    for number in [30, 249, 250, 411] {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        let asked = vabus::Request::Enquiry { address, header };
        let echo = [&[vabus::EOT][..], &asked.encode()].concat();
        let reply = vabus::Reply::Value { address, header, data: Data::word(number) };
        let outcome = line.ask(1, asked, &[&[(1, echo), (80, reply.encode())]]);
        assert!(outcome.is_ok(), "{outcome:?}");
    }
    assert_eq!((line.master.tally().repeats, line.master.tally().garbled), (0, 0));
    assert!(!line.verdicts().contains(&Verdict::Garbage), "our own end is no garbage");
}
