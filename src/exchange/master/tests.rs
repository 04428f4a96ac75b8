//! The master on a line on which bytes come at set times.

mod counts;

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
        self.master.ask(station, request, self.now);
        let mut replies = replies.iter();
        loop {
            match self.master.step(self.now) {
                Step::Done(outcome) => return outcome,
                Step::Send(bytes) => {
                    let end = self.now + self.master.line.chars(bytes.len() as u64);
                    let farewell = bytes == [vabus::EOT];
                    let chunks = if farewell { &[] } else { replies.next().copied().unwrap_or_default() };
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
fn a_late_reply_is_never_credited_to_the_next_question() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    // The reply to READ comes 700 ms after it was asked, in the middle of the next question.
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let outcome = line.ask(1, OTHER, &[&[(210, fence_reply())], &[(10, value(7))]]);
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
    let counter = |sub| Request::Diagnostics { sub, data: 0 };
    let counted = |sub, data| frame(1, &Reply::Diagnostics { sub, data });
    assert!(line.ask(1, counter(0x0B), &[]).is_err());
    assert!(line.ask(1, READ, &[]).is_err());
    let late = counted(0x0B, 99);
    let outcome = line.ask(1, OTHER, &[&[(10, late), (60, counted(0x0E, 5))], &[(10, value(7))], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_question_that_cannot_be_confused_needs_no_fence() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let long = Request::ReadLong { address: 210 };
    let outcome = line.ask(1, long, &[&[(300, frame(1, &Reply::Long(5000)))]]);
    assert_eq!(taken(outcome), Reply::Long(5000));
    assert_eq!((line.master.tally().fences, line.master.tally().strays), (0, 1));
}

#[test]
fn a_refusal_that_may_be_old_is_nobodys() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let refused = Reply::Exception { function: 3, code: Exception::DeviceFailure };
    assert!(line.ask(1, READ, &[&[(650, frame(1, &refused))]]).is_err());
    let outcome = line.ask(1, OTHER, &[&[(300, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_write_is_told_from_an_older_one_by_its_echo_and_needs_no_fence() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let write = |value| Request::WriteRegister { address: 410, value };
    let echo = |value| rtu::encode(1, &write(value).encode());
    assert!(line.ask(1, write(15), &[&[(700, echo(15))]]).is_err());
    // The stop goes out at once, and the late echo of the start is not its own.
    let begun = line.now;
    assert!(line.ask(1, write(2), &[&[(300, echo(2))]]).is_ok());
    assert!(line.now.since(begun) < Span::from_millis(320));
    assert_eq!((line.master.tally().fences, line.master.tally().strays), (0, 1));
}

#[test]
fn a_write_goes_out_at_once_and_an_answer_that_may_be_old_does_not_prove_it() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    // Code 16 answers with start and count only: the late answer to the start looks like that to the stop.
    let write = |value| Request::WriteRegisters { start: 6914, values: vec![0, value] };
    let written = || frame(1, &Reply::RegistersWritten { start: 6914, count: 2 });
    assert!(line.ask(1, write(15), &[&[(700, written())]]).is_err());
    let begun = (line.now, line.sent.len());
    let outcome = line.ask(1, write(7), &[&[(400, written())], &[(10, fence_reply())], &[(10, written())]]);
    assert!(outcome.is_ok(), "{outcome:?}");
    let stop = rtu::encode(1, &write(7).encode());
    assert_eq!(line.sent[begun.1], stop, "the first telegram is the stop itself");
    assert_eq!((line.sent.last(), line.master.tally().fences), (Some(&stop), 1));
}

#[test]
fn a_refusal_that_may_be_an_older_one_is_asked_about_again() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let write = |value| Request::WriteRegister { address: 410, value };
    let echo = rtu::encode(1, &write(2).encode());
    let refused = frame(1, &Reply::Exception { function: 6, code: Exception::DeviceFailure });
    assert!(line.ask(1, write(15), &[&[(700, refused)]]).is_err());
    let outcome = line.ask(1, write(2), &[&[(300, echo.clone())], &[(10, fence_reply())], &[(10, echo)]]);
    assert_eq!(taken(outcome), Reply::RegisterWritten { address: 410, value: 2 });
    assert_eq!(line.master.tally().fences, 1);
}

#[test]
fn the_echo_of_a_fence_settles_nothing() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let echo = frame(1, &Reply::Diagnostics { sub: 0x0B, data: 0 });
    let outcome = line.ask(1, OTHER, &[&[(1, echo), (300, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_late_refusal_of_another_counter_settles_nothing() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let counter = |sub| Request::Diagnostics { sub, data: 0 };
    assert!(line.ask(1, counter(0x0B), &[]).is_err());
    assert!(line.ask(1, READ, &[]).is_err());
    // The refusal is of the first counter; the value is the late one of READ, and comes behind it.
    let refused = frame(1, &Reply::Exception { function: 8, code: Exception::IllegalFunction });
    let counted = frame(1, &Reply::Diagnostics { sub: 0x0E, data: 5 });
    let outcome = line.ask(1, OTHER, &[&[(10, refused), (40, value(1390)), (60, counted)], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn garbage_is_only_garbage_once_answers_behind_it_were_said_again() {
    let mut line = Line::new(Framing::Rtu);
    assert_eq!(line.answered(1, READ), Some(vec![7]));
    let sent = [100, 101, 102, 103, 104].map(|value| {
        let before = line.sent.len();
        assert_eq!(line.answered_behind(&[0x55; 7], value, 1, READ), Some(vec![value]));
        line.sent.len() - before
    });
    assert!(sent[0] > 1, "the first is asked for again: {sent:?}");
    assert_eq!(sent[3..], [1, 1], "and what is settled stays settled: {sent:?}");
}

#[test]
fn a_late_answer_in_words_of_a_moment_ago_is_asked_for_again_at_once() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(0))]]));
    let begun = line.now;
    let late = [(310, value(0))];
    let outcome = line.ask(1, OTHER, &[&late, &[(10, fence_reply())], &[(10, value(0))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![0]));
    assert!(line.now.since(begun) < Span::from_millis(400), "{}", line.now.since(begun));
    // So late it answers now and then: that is known, and nothing is owed.
    let begun = (line.now, line.sent.len());
    assert_eq!(taken(line.ask(1, READ, &[&[(310, value(0))]])), Reply::Registers(vec![0]));
    assert_eq!(taken(line.ask(1, OTHER, &[&[(10, value(0))]])), Reply::Registers(vec![0]));
    assert_eq!(line.sent.len() - begun.1, 2);
    assert_eq!(line.master.tally().strays, 0, "a doubt of ours is no telegram too many");
}

#[test]
fn a_copy_in_place_of_a_lost_answer_is_not_said_again() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let copy = [(310, value(1390))];
    let outcome = line.ask(1, OTHER, &[&copy, &[(10, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn where_garbage_comes_the_first_copy_of_all_is_no_value() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(2, READ, &[&[(10, vec![0x55; 9])]]).is_err());
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let copy = [(10, value(1390))];
    let outcome = line.ask(1, OTHER, &[&copy, &[(10, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn where_garbage_comes_a_station_that_says_the_same_of_everything_is_soon_believed() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(2, READ, &[&[(10, vec![0x55; 9])]]).is_err());
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    let sent: Vec<_> = (1..8)
        .map(|start| {
            let before = line.sent.len();
            assert_eq!(line.answered(1, Request::ReadRegisters { start, count: 1 }), Some(vec![7]));
            line.sent.len() - before
        })
        .collect();
    assert_eq!(sent, [3, 3, 1, 1, 1, 1, 1]);
}

#[test]
fn a_station_of_unknown_family_is_asked_only_for_counters_that_all_have() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let counter = Request::Diagnostics { sub: 0x0B, data: 0 };
    assert!(line.ask(2, READ, &[]).is_err());
    assert!(line.ask(2, counter, &[]).is_err());
    assert!(line.ask(2, OTHER, &[]).is_err());
    let reserved =
        |sent: &Vec<u8>| sent.get(1..4).is_some_and(|pdu| [[8, 0, 14], [8, 0, 15]].contains(&[pdu[0], pdu[1], pdu[2]]));
    assert!(!line.sent.iter().any(reserved), "{:?}", line.sent);
}

#[test]
fn a_station_that_counts_nothing_is_parted_by_time() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[]).is_err());
    let zero = |sub| [(10, frame(1, &Reply::Diagnostics { sub, data: 0 }))];
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&zero(0x0B), &zero(0x0E), &zero(0x0E), &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert!(line.now.since(begun) > Span::from_secs(6));
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
    assert_eq!(line.sent.len(), 1);
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

/// Asked again in the same words, both answers would come at once, and their counts would differ like those of two drives.
#[test]
fn a_suspects_lost_fence_is_owed_and_another_one_is_asked() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390)), (11, value(1390))]]));
    taken(line.ask(1, OTHER, &[&[(10, value(7))], &[(10, fence_reply())], &[(10, value(7))]]));
    // Once was counted; before the next value it is counted again.
    let begun = line.sent.len();
    assert!(line.ask(1, READ, &[]).is_err());
    let fences: Vec<_> = line.sent[begun..].iter().filter(|sent| sent.get(1) == Some(&8)).take(2).collect();
    assert!(fences.len() == 2 && fences.first() != fences.last(), "{fences:?}");
}

#[test]
fn numbered_transactions_need_no_fences() {
    let mut line = Line::new(Framing::Tcp);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let reply = |number, value| mbap::encode(number, 1, &Reply::Registers(vec![value]).encode());
    assert!(line.ask(1, READ, &[&[(700, reply(1, 1390))]]).is_err());
    let outcome = line.ask(1, OTHER, &[&[(400, reply(2, 7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert_eq!((line.master.tally().fences, line.master.tally().strays), (0, 1));
}

#[test]
fn vabus_ends_its_exchanges_and_parts_replies_by_what_was_answered_before() {
    let mut line = Line::vabus();
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let enquiry = |number| {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        vabus::Request::Enquiry { address: Address::drive(1).unwrap(), header }
    };
    let told = |number, bits| {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        vabus::Reply::Value { address: Address::drive(1).unwrap(), header, data: Data::word(bits) }.encode()
    };
    let nak = vabus::Reply::Nak { address: Address::drive(1).unwrap() }.encode();
    assert!(line.ask(1, enquiry(411), &[&[(10, told(411, 0x40))]]).is_ok());
    assert_eq!(line.sent.last(), Some(&vec![vabus::EOT]));
    // The NAK to the second question comes while the third is asked: it is not the third one's.
    assert!(line.ask(1, enquiry(484), &[&[(650, nak)]]).is_err());
    let outcome = line.ask(1, enquiry(372), &[&[], &[(10, told(411, 0x40))], &[(10, told(372, 1390))]]);
    let Ok(Answer::Reply { said: Said::Vabus(reply), .. }) = outcome else { panic!("{outcome:?}") };
    assert_eq!(reply.encode(), told(372, 1390));
    assert_eq!(line.master.tally().fences, 1);
}

#[test]
fn another_fence_each_time_tells_its_answer_from_a_late_one() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 1, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    // The first fence is answered only after the second was sent; the reply to the second comes later still.
    let second = frame(1, &Reply::Diagnostics { sub: 0x0E, data: 9 });
    let outcome = line.ask(
        1,
        OTHER,
        &[&[(700, fence_reply())], &[(400, second)], &[(10, value(7))], &[(10, value(7))], &[(10, value(7))]],
    );
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert_eq!(line.master.owes_until(line.now), None);
}

/// What an adversary sends: the next bytes, so long after the last ones.
type Babble = fn(u64) -> (u64, Vec<u8>);

/// Asks while somebody speaks all the time; tells how it ends, and when.
fn beside(master: &mut Master, mut now: Tick, question: impl Into<Question>, babble: Babble) -> (Outcome, Span) {
    let (begun, mut count) = (now, 0);
    let mut next = babble(0);
    let mut at = now + Span::from_micros(next.0);
    master.ask(1, question, now);
    loop {
        match master.step(now) {
            Step::Done(outcome) => return (outcome, now.since(begun)),
            Step::Send(_) => {}
            Step::Wait(until) if at <= until => {
                now = at.max(now);
                master.feed(now, &next.1);
                count += 1;
                next = babble(count);
                at = now + Span::from_micros(next.0);
            }
            Step::Wait(until) => now = until,
        }
        assert!(now.since(begun) < Span::from_secs(120), "no end");
    }
}

#[test]
fn a_line_that_is_never_silent_fails_in_time_whatever_is_spoken_on_it() {
    let drip: Babble = |_| (20_000, vec![0x55]);
    let flood: Babble = |_| (500, vec![0x55]);
    let poll: Babble = |n| (if n % 2 == 0 { 12_000 } else { 25_000 }, rtu::encode(7, &[3, 0, n as u8, 0, 1]));
    let replies: Babble = |n| (1_000, value(n as u16));
    let digits: Babble = |_| (900, b"4".to_vec());
    let babbles: [Babble; 5] = [drip, flood, poll, replies, digits];
    for protocol in Protocol::ALL {
        for (index, babble) in babbles.into_iter().enumerate() {
            let line = protocol.line(19_200, Parity::Even);
            let mut master = Master::new(protocol, line, Limits::default());
            let question = match protocol {
                Protocol::Vabus => {
                    let header = Header { number: ParamNumber::new(411).unwrap(), ..Header::default() };
                    vabus::Request::Enquiry { address: Address::drive(1).unwrap(), header }.into()
                }
                Protocol::Modbus(_) => Question::from(Request::ReadLong { address: 210 }),
            };
            let (outcome, took) = beside(&mut master, Tick::ZERO, question, babble);
            assert!(took <= master.limits().longest(protocol, line), "{protocol}, {index}: {took}");
            assert!(took < Span::from_secs(6), "{protocol}, {index}: {took}");
            let never = matches!(outcome, Err(ExchangeError::NeverSilent { .. }));
            let spaced = protocol == Protocol::Modbus(Framing::Tcp) || index == 2;
            assert!(never || spaced && outcome.is_err(), "{protocol}, {index}: {outcome:?}");
        }
    }
}

#[test]
fn what_insists_goes_out_into_a_busy_line() {
    let mut master = Master::new(Framing::Rtu.into(), LineSetting::rtu(19_200, Parity::Even), Limits::default());
    let limits = Limits { insist: Some(crate::exchange::INSIST), ..Limits::default() };
    let stop = Request::WriteRegister { address: 410, value: 2 };
    master.ask_within(1, stop, limits, Tick::ZERO);
    let (mut now, mut sent) = (Tick::ZERO, Vec::new());
    let outcome = loop {
        match master.step(now) {
            Step::Done(outcome) => break outcome,
            Step::Send(_) => sent.push(now),
            Step::Wait(until) => {
                now = until.min(now + Span::from_micros(500));
                master.feed(now, &[0x55]);
            }
        }
    };
    assert_eq!(outcome, Err(ExchangeError::NeverSilent { asked: 3 }));
    assert!(sent.first().is_some_and(|at| at.since(Tick::ZERO) <= Span::from_millis(100)), "{sent:?}");
    assert_eq!(sent.len(), 3);
}

#[test]
fn a_vabus_drive_that_always_answers_after_600_ms_is_understood() {
    let mut line = Line::vabus();
    let address = Address::drive(1).unwrap();
    let header = |number| Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
    let enquiry = |number| vabus::Request::Enquiry { address, header: header(number) };
    let told = |number| vabus::Reply::Value { address, header: header(number), data: Data::word(7) }.encode();
    let nak = || vabus::Reply::Nak { address }.encode();
    let late = |bytes: Vec<u8>| [(600, bytes)];
    let rows = [(411, false), (484, true), (412, true), (372, false), (484, true)];
    for (number, refused) in rows {
        let begun = (line.now, line.sent.len());
        line.master.ask(1, enquiry(number), line.now);
        let outcome = loop {
            match line.master.step(line.now) {
                Step::Done(outcome) => break outcome,
                Step::Send(bytes) => {
                    let end = line.now + line.master.line.chars(bytes.len() as u64);
                    if let Ok(vabus::Request::Enquiry { header, .. }) = vabus::Request::decode(&bytes) {
                        let number = header.number.get();
                        let reply = if rows.contains(&(number, true)) { nak() } else { told(number) };
                        line.coming.extend(late(reply).map(|(ms, bytes)| (end + Span::from_millis(ms), bytes)));
                    }
                    line.sent.push(bytes);
                }
                Step::Wait(until) => match line.coming.first() {
                    Some((at, _)) if *at <= until => {
                        let (at, bytes) = line.coming.remove(0);
                        line.now = at.max(line.now);
                        line.master.feed(line.now, &bytes);
                    }
                    _ => line.now = until,
                },
            }
        };
        let Ok(Answer::Reply { said, .. }) = outcome else { panic!("{number}: {outcome:?}") };
        assert_eq!(said.is_refusal(), refused, "{number}: {said:?}");
        assert!(line.now.since(begun.0) < Span::from_secs(10), "{number}: {}", line.now.since(begun.0));
        assert!(line.sent.len() - begun.1 < 14, "{number}: {}", line.sent.len() - begun.1);
    }
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
    assert_eq!(line.master.tally().fences, 0, "the reply came, so there is no doubt");
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
fn a_reply_that_a_fence_has_overtaken_is_never_a_value() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    // The reply to READ comes 700 ms after it was asked, behind the fence's, and the answer to OTHER later still.
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let replies: [&[(u64, Vec<u8>)]; 6] = [
        &[(10, fence_reply())],
        &[(300, value(7))],
        &[(10, value(7))],
        &[(10, fence_reply())],
        &[(10, value(7))],
        &[(10, value(7))],
    ];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn a_value_that_changes_is_read_behind_a_lost_reply_all_the_same() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[]).is_err());
    let replies: [&[(u64, Vec<u8>)]; 6] = [
        &[(10, fence_reply())],
        &[(10, value(1))],
        &[(10, value(2))],
        &[(10, value(3))],
        &[(10, value(4))],
        &[(10, value(5))],
    ];
    assert!(matches!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(_)));
    assert!(line.now < Tick::from_micros(1_800_000), "nothing waits for what never comes");
}

#[test]
fn the_answer_to_another_master_is_not_ours() {
    let mut line = Line::new(Framing::Rtu);
    line.master.feed(line.now, &rtu::encode(1, &OTHER.encode()));
    let outcome = line.ask(1, READ, &[&[(6, value(7)), (17, value(1390))]]);
    assert!(
        !matches!(&outcome, Ok(Answer::Reply { said: Said::Modbus(Reply::Registers(words)), .. }) if *words == [7])
    );
}

/// It was kept back as a copy, and came before the other master asked.
#[test]
fn what_came_before_another_master_asked_does_not_pay_what_he_is_owed() {
    let mut line = Line::new(Framing::Rtu);
    line.master.heard.sees_surplus();
    line.master.feed(line.now, &[rtu::encode(1, &READ.encode()), value(1390)].concat());
    line.now += Span::from_millis(450);
    let his = [rtu::encode(1, &OTHER.encode()), value(7)].concat();
    let outcome = line.ask(1, READ, &[&[(10, value(1390)), (190, his)]]);
    assert!(
        !matches!(&outcome, Ok(Answer::Reply { said: Said::Modbus(Reply::Registers(words)), .. }) if *words == [7]),
        "{outcome:?}"
    );
}

#[test]
fn an_answer_behind_garbage_as_long_as_a_telegram_is_asked_for_behind_a_fence() {
    let mut line = Line::new(Framing::Rtu);
    assert_eq!(taken(line.ask(1, READ, &[&[(11, value(1390))]])), Reply::Registers(vec![1390]));
    let met = vec![0, 0, 0, 0x12, 0x66, 0x42, 0x10, 0x40];
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(15, met), (36, value(1391))], &[(11, fence_reply())], &[(11, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

/// His question met ours, and the station heard his: twice, because he asks the same again and again.
#[test]
fn what_another_master_is_told_twice_behind_garbage_is_not_ours() {
    let mut line = Line::new(Framing::Rtu);
    for _ in 0..2 {
        line.master.feed(line.now, &rtu::encode(9, &OTHER.encode()));
        line.now += Span::from_millis(60);
    }
    let his: [(u64, Vec<u8>); 2] = [(1, vec![0, 0, 0, 0x12, 0x66, 0x42, 0x10, 0x40]), (10, value(7))];
    let fence = |data| [(10, frame(1, &Reply::Diagnostics { sub: 0x0B, data }))];
    let replies: [&[(u64, Vec<u8>)]; 5] = [&his, &fence(5), &his, &fence(6), &his];
    let outcome = line.ask(1, READ, &replies);
    assert!(matches!(outcome, Err(ExchangeError::Unproven { .. })), "{outcome:?}");
}

#[test]
fn what_stands_behind_the_question_of_another_master_is_his() {
    let mut line = Line::new(Framing::Rtu);
    let his = [rtu::encode(1, &OTHER.encode()), value(7)].concat();
    let replies: [&[(u64, Vec<u8>)]; 2] = [&[(5, his.clone()), (30, value(1390))], &[(5, his)]];
    let outcome = line.ask(1, READ, &replies);
    assert!(
        !matches!(&outcome, Ok(Answer::Reply { said: Said::Modbus(Reply::Registers(words)), .. }) if *words == [7])
    );
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
}

#[test]
fn a_counter_that_stands_at_0_is_a_fence_on_a_line_without_echo() {
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x12]);
    assert!(line.ask(1, READ, &[&[(10, value(1390))]]).is_ok());
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    let stands = frame(1, &Reply::Diagnostics { sub: 0x12, data: 0 });
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&[(10, stands)], &[(10, value(7))], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert!(line.now.since(begun) < Span::from_millis(700), "an answered fence is not waited for again");
}

#[test]
fn a_counter_that_stands_at_0_is_a_fence_behind_its_echo_too() {
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x12]);
    let echo = |request: &Request| rtu::encode(1, &request.encode());
    assert!(line.ask(1, READ, &[&[(0, echo(&READ)), (10, value(1390))]]).is_ok());
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(0, echo(&READ))]]).is_err());
    let stands = frame(1, &Reply::Diagnostics { sub: 0x12, data: 0 });
    let answer = [(0, echo(&OTHER)), (10, value(7))];
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&[(0, stands.clone()), (10, stands)], &answer, &answer]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert!(line.now.since(begun) < Span::from_millis(700), "an answered fence is not waited for again");
}

#[test]
fn behind_a_silence_that_took_every_fence_a_value_is_believed_within_seconds() {
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x0B, 0x0C, 0x12]);
    let insist = Some(crate::exchange::INSIST);
    line.master.set_limits(Limits { insist, reply_timeout: Span::from_millis(250), ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(10, value(1390))]]).is_ok());
    for _ in 0..6 {
        assert!(line.ask(1, OTHER, &[]).is_err());
        assert!(line.ask(1, READ, &[]).is_err());
        assert!(line.ask(1, Request::WriteRegister { address: 410, value: 2 }, &[]).is_err());
    }
    let begun = line.now;
    // From now on the station answers everything.
    let believed = (0..60).find_map(|_| line.answered(1, if line.sent.len().is_multiple_of(2) { OTHER } else { READ }));
    assert!(believed.is_some() && line.now.since(begun) < Span::from_secs(5), "{believed:?} {}", line.now.since(begun));
}

#[test]
fn a_late_answer_from_before_a_write_proves_nothing_of_it() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[&[(10, value(1))]]).is_ok());
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    // Its reply comes when the same is asked again.
    assert!(line.ask(1, READ, &[&[(620, value(1))]]).is_err());
    let write = Request::WriteRegister { address: 0x4178, value: 15 };
    assert!(line.ask(1, write.clone(), &[&[(10, rtu::encode(1, &write.encode()))]]).is_ok());
    let since = Some(line.now);
    line.master.set_limits(Limits { retries: 0, since, ..Limits::default() });
    let answers: [&[(u64, Vec<u8>)]; 4] =
        [&[(110, fence_reply())], &[(10, value(2))], &[(10, value(2))], &[(10, value(2))]];
    assert_eq!(taken(line.ask(1, READ, &answers)), Reply::Registers(vec![2]));
    // Without a word of it an older answer will do. (Right behind an answer a loss would be a sign of a second drive.)
    line.now += Span::from_secs(2);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(620, value(2))]]).is_err());
    assert_eq!(taken(line.ask(1, READ, &[&[(200, value(3))]])), Reply::Registers(vec![2]));
}

#[test]
fn no_flood_makes_a_buffer_grow() {
    for protocol in [Framing::Rtu.into(), Framing::Ascii.into(), Framing::Tcp.into(), Protocol::Vabus] {
        let mut master = Master::new(protocol, LineSetting::rtu(19_200, Parity::Even), Limits::default());
        let largest = |master: &Master| {
            let came = master.job.as_ref().map_or(0, |job| match &job.phase {
                Phase::Reply(waiting) => waiting.came.len().max(waiting.garbage.len()),
                _ => 0,
            });
            let orphan = master.orphan.as_ref().map_or(0, |orphan| orphan.came.len());
            came.max(orphan).max(master.loose.bytes.len())
        };
        let mut now = Tick::ZERO;
        let flood: Vec<u8> = (0..700u32).map(|index| (index * 7 % 251) as u8).collect();
        for round in 0..200u32 {
            if round % 20 == 3 {
                // Given up twice as often as answered.
                master.ask(1, READ, now);
            }
            for _ in 0..4 {
                if let Step::Wait(until) = master.step(now) {
                    now = until.min(now + Span::from_millis(30));
                }
            }
            master.feed(now, &flood);
            now += Span::from_millis(5);
            assert!(largest(&master) <= 2 * MOST_BYTES, "{protocol}: {} bytes", largest(&master));
            assert!(master.records.len() <= MOST_RECORDS);
        }
    }
}

#[test]
fn what_is_cleared_by_reading_is_asked_once_whatever_is_doubtful() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[&[(10, value(7))]]).is_ok());
    line.master.set_limits(Limits { witness: false, ..Limits::default() });
    let met = vec![0, 0, 0, 0x12, 0x66, 0x42, 0x10, 0x40];
    assert!(matches!(
        line.ask(1, OTHER, &[&[(15, met), (36, value(1391))], &[(10, value(0))]]),
        Err(ExchangeError::Unproven { asked: 1 })
    ));
}

/// Behind the greeting of a drive that somebody named: its answer is no value, so a second one is listened for.
#[test]
fn a_second_answer_is_listened_for_where_somebody_wants_to() {
    let counter = Request::Diagnostics { sub: 0x0B, data: 0 };
    let counted = |data| frame(1, &Reply::Diagnostics { sub: 0x0B, data });
    let listen = Span::from_millis(60);
    for (second, two) in [(5, true), (55, true), (900, false)] {
        for count in [4, 8] {
            let mut line = Line::new(Framing::Rtu);
            line.master.set_limits(Limits { listen, ..Limits::default() });
            let outcome = line.ask(1, counter.clone(), &[&[(10, counted(7)), (10 + second, counted(count))]]);
            let told = matches!(outcome, Err(ExchangeError::TwoAnswers { station: 1 }));
            assert_eq!(told, two, "{second} ms: {outcome:?}");
            assert!(line.now < Tick::from_micros(110_000), "{:?}", line.now);
        }
    }
    // What an adapter gives back late is our own.
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { listen, ..Limits::default() });
    let echo = rtu::encode(1, &counter.encode());
    assert!(line.ask(1, counter, &[&[(10, counted(7)), (30, echo)]]).is_ok());
    assert!(!line.master.differs(1));
}

#[test]
fn two_drives_that_answer_differently_are_named_and_none_of_them_is_believed() {
    let mut line = Line::new(Framing::Rtu);
    let described = frame(1, &Reply::Exception { function: 0x2B, code: Exception::IllegalFunction });
    let who = Request::ReadIdentification { category: 1, object: 0 };
    assert!(line.ask(1, who, &[&[(10, described.clone()), (22, described)]]).is_ok());
    // The answer of the second drive to the first question comes while the next is asked.
    let counted = |count| frame(1, &Reply::Diagnostics { sub: 0x0B, data: count });
    let replies: [&[(u64, Vec<u8>)]; 3] =
        [&[(11, value(7)), (30, value(8))], &[(10, counted(5)), (30, counted(5))], &[(10, value(7)), (30, value(8))]];
    assert_eq!(line.ask(1, READ, &replies), Err(ExchangeError::TwoAnswers { station: 1 }));
    let sent = line.sent.len();
    assert_eq!(line.ask(1, OTHER, &[]), Err(ExchangeError::TwoAnswers { station: 1 }));
    assert_eq!(line.sent.len(), sent, "for a while nothing more is asked");
}

/// The answer of the second drive to the question before comes in place of the answer to this one, in words of its own.
#[test]
fn a_late_answer_that_may_be_another_to_the_question_before_is_asked_for_again() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(60, value(8))], &[(10, fence_reply())], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn an_answer_sooner_than_ever_with_garbage_behind_it_is_asked_for_again() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(20, value(1390))]]));
    let met = vec![0, 0, 0, 0x12, 0x66, 0x42, 0x10];
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(6, value(8)), (15, met)], &[(10, fence_reply())], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn another_answer_to_a_question_whose_first_was_doubted_is_a_sign_of_two_drives() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let noise = vec![0x12; 8];
    let replies: [&[(u64, Vec<u8>)]; 5] = [
        &[(5, noise), (20, value(8))],
        &[(10, value(9)), (15, fence_reply())],
        &[(10, value(9))],
        &[(10, fence_reply())],
        &[(10, value(9))],
    ];
    _ = line.ask(1, OTHER, &replies);
    assert!(line.master.differs(1), "{:?}", line.verdicts());
}

#[test]
fn a_question_of_somebody_else_is_heard_across_our_own() {
    let mut line = Line::new(Framing::Rtu);
    let his = rtu::encode(1, &OTHER.encode());
    let (head, tail) = his.split_at(6);
    line.master.feed(line.now, head);
    // The rest of his question, his answer, then the fence's and ours.
    let replies: [&[(u64, Vec<u8>)]; 4] =
        [&[(1, [tail, &value(7)[..]].concat())], &[(10, fence_reply())], &[(10, value(1390))], &[(10, value(1390))]];
    assert_eq!(taken(line.ask(1, READ, &replies)), Reply::Registers(vec![1390]));
}

#[test]
fn what_somebody_else_asks_behind_our_fence_is_not_settled_by_it() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    let his = rtu::encode(1, &Request::ReadRegisters { start: 0x1111, count: 1 }.encode());
    let replies: [&[(u64, Vec<u8>)]; 4] = [
        &[(4, his), (20, fence_reply()), (400, value(9))],
        &[(10, frame(1, &Reply::Diagnostics { sub: 0x0B, data: 6 }))],
        &[(10, value(7))],
        &[(10, value(7))],
    ];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn a_copy_of_a_reply_that_came_as_garbage_is_no_value() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let mut spoilt = value(1390);
    spoilt[4] ^= 1;
    assert!(line.ask(1, READ, &[&[(10, spoilt), (120, value(1390))]]).is_err());
    let replies: [&[(u64, Vec<u8>)]; 5] =
        [&[(10, fence_reply())], &[], &[(10, value(7))], &[(10, fence_reply())], &[(10, value(7))]];
    line.master.set_limits(Limits::default());
    let said = line.ask(1, OTHER, &replies);
    assert!(
        !matches!(&said, Ok(Answer::Reply { said: Said::Modbus(Reply::Registers(words)), .. }) if *words == [1390]),
        "{said:?}"
    );
}
