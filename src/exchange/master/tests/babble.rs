//! A line that is never silent: the end that no byte can put off.

use super::*;
use crate::protocol::can::sdo::{Multiplexer, Request::Upload};

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
                Protocol::Sdo(_) => Upload(Multiplexer { index: 411, sub: 0 }).into(),
                Protocol::Pkw => unreachable!("a block of a slave goes over no line of characters"),
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
fn no_flood_makes_a_buffer_grow() {
    for protocol in [Framing::Rtu.into(), Framing::Ascii.into(), Framing::Tcp.into(), Protocol::Vabus] {
        let mut master = Master::new(protocol, LineSetting::rtu(19_200, Parity::Even), Limits::default());
        let largest = |master: &Master| {
            let came = master.job.as_ref().map_or(0, |job| match &job.phase {
                Phase::Reply(waiting) => waiting.came.len().max(waiting.garbage.len()),
                _ => 0,
            });
            let orphan = master.orphan.as_ref().map_or(0, |orphan| orphan.came.len());
            came.max(orphan).max(master.loose.bytes().len())
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
