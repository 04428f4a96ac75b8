//! The survey on a line on which bytes come at set times.

mod counted;

use super::*;
use crate::protocol::line::Parity;
use crate::protocol::modbus::pdu::{Reply, Request};
use crate::protocol::modbus::{Framing, rtu};

const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);
const RTU: Protocol = Protocol::Modbus(Framing::Rtu);
const FULL: Span = Span::from_millis(500);

/// Two wires on which who speaks at once with somebody is not understood. The master does not hear what comes while
/// it sends, as behind an adapter that switches its receiver off.
struct Bus {
    survey: Survey,
    now: Tick,
    /// Station, delay of its reply, value that it replies with.
    drives: Vec<(u8, u64, u16)>,
    /// Bytes on the wire: from, to, what the master hears when they are over.
    slots: Vec<(Tick, Tick, u8)>,
    /// The adapter holds bytes back until then.
    latency: Span,
    sent: Vec<(Tick, Vec<u8>)>,
    told: Vec<News>,
}

fn question() -> Question {
    Question::Modbus(Request::ReadRegisters { start: 411, count: 1 })
}

fn survey(stations: impl IntoIterator<Item = u8>, patience: Patience) -> Survey {
    let questions = stations.into_iter().map(|station| (station, question()));
    Survey::new(RTU, LINE, questions, patience, Tick::ZERO)
}

fn brief() -> Patience {
    Patience::brief(RTU, LINE, &question(), FULL)
}

impl Bus {
    fn new(drives: &[(u8, u64, u16)], stations: impl IntoIterator<Item = u8>, patience: Patience) -> Self {
        let survey = survey(stations, patience);
        let drives = drives.to_vec();
        Bus {
            survey,
            now: Tick::ZERO,
            drives,
            slots: Vec::new(),
            latency: Span::ZERO,
            sent: Vec::new(),
            told: Vec::new(),
        }
    }

    /// Puts bytes on the wire; whatever is there at the same time is spoilt.
    fn put(&mut self, at: Tick, bytes: &[u8]) {
        for (count, &byte) in (0..).zip(bytes) {
            let (from, to) = (at + LINE.chars(count), at + LINE.chars(count + 1));
            match self.slots.iter_mut().find(|slot| slot.0 < to && from < slot.1) {
                Some(slot) => slot.2 &= byte.rotate_left(1),
                None => self.slots.push((from, to, byte)),
            }
        }
        self.slots.sort();
    }

    fn send(&mut self, bytes: Vec<u8>) {
        let end = self.now + LINE.chars(bytes.len() as u64);
        let (now, before) = (self.now, self.slots.len());
        self.slots.retain(|slot| slot.1 <= now || slot.0 >= end);
        let clean = before == self.slots.len();
        let asked = *bytes.first().unwrap();
        for (station, delay, value) in self.drives.clone() {
            if clean && station == asked {
                let reply = rtu::encode(station, &Reply::Registers(vec![value]).encode());
                self.put(end + Span::from_millis(delay), &reply);
            }
        }
        self.sent.push((now, bytes));
    }

    fn run(mut self) -> Self {
        loop {
            match self.survey.step(self.now) {
                Step::Done(News::Over) => return self,
                Step::Done(news) => self.told.push(news),
                Step::Send(bytes) => self.send(bytes),
                Step::Wait(until) => self.wait(until),
            }
            assert!(self.now < Tick::ZERO + Span::from_secs(1_000), "it ends");
        }
    }

    fn wait(&mut self, until: Tick) {
        let Some(&(_, end, _)) = self.slots.first().filter(|slot| slot.1 + self.latency <= until) else {
            self.now = self.now.max(until);
            return;
        };
        // The adapter hands on what has come when its time is over.
        self.now = self.now.max(end + self.latency);
        let due = self.slots.iter().take_while(|slot| slot.1 <= self.now).count();
        let bytes: Vec<u8> = self.slots.drain(..due).map(|slot| slot.2).collect();
        self.survey.feed(self.now, &bytes);
    }

    fn found(&self) -> Vec<u8> {
        let heard = self.told.iter().filter_map(|news| match news {
            News::Heard(sign) => Some(sign.station),
            _ => None,
        });
        let mut heard: Vec<u8> = heard.collect();
        heard.sort_unstable();
        heard
    }
}

const THREE: [(u8, u64, u16); 3] = [(1, 10, 7), (17, 11, 8), (42, 12, 9)];

#[test]
fn the_whole_line_takes_six_seconds_and_asks_everybody_once() {
    let bus = Bus::new(&THREE, 1..=247, brief()).run();
    assert_eq!(bus.found(), [1, 17, 42]);
    assert_eq!(bus.sent.len(), 247);
    let took = bus.now.since(Tick::ZERO);
    assert!(took < Span::from_millis(6_500), "{took}");
    // The last one has had its full time.
    assert!(bus.now.since(bus.sent.last().unwrap().0) >= FULL);
}

#[test]
fn an_adapter_that_holds_bytes_back_costs_nothing_but_time() {
    let mut bus = Bus::new(&THREE, 1..=60, brief());
    bus.latency = ADAPTER;
    let bus = bus.run();
    assert_eq!(bus.found(), [1, 17, 42]);
    assert_eq!(bus.sent.len(), 60, "nobody is asked twice");
}

#[test]
fn a_late_reply_is_credited_to_the_address_that_it_names() {
    let bus = Bus::new(&[(1, 10, 7), (17, 304, 8)], 1..=60, brief()).run();
    let said = Some(Said::Modbus(Reply::Registers(vec![8])));
    let late = bus.told.iter().find_map(|news| match news {
        News::Heard(sign) if sign.station == 17 => Some(sign.clone()),
        _ => None,
    });
    assert_eq!(late, Some(Sign { station: 17, said, after: Span::from_millis(304) + LINE.chars(7) }));
    assert_eq!(bus.survey.attendance()[&17].replies.len(), 1);
}

#[test]
fn late_replies_that_meet_a_question_are_asked_for_again() {
    // What comes while the master sends is lost: only a reply that is over before its questions are is never seen.
    let count = |patience: Patience| {
        let found = |delay: &u64| Bus::new(&[(17, *delay, 8)], 1..=60, patience).run().found() == [17];
        (10..=490).filter(found).count()
    };
    assert!(count(brief()) >= 481 * 92 / 100, "{}", count(brief()));
    assert_eq!(count(Patience::by_the_book(FULL)), 481);
}

#[test]
fn a_question_that_was_spoilt_by_a_late_reply_is_repeated() {
    // 17 answers into the questions to those who are asked 300 ms later: every one of them is found all the same.
    for victim in 28..=33 {
        for delay in 296..320 {
            let bus = Bus::new(&[(17, delay, 8), (victim, 10, 9)], 1..=60, brief()).run();
            assert!(bus.found().contains(&victim) || !bus.found().contains(&17), "{victim} {delay}");
        }
    }
}

#[test]
fn two_with_one_address_are_told_from_silence() {
    let same = Bus::new(&[(1, 10, 7), (17, 10, 8), (17, 10, 9)], 1..=247, brief()).run();
    assert_eq!(same.found(), [1]);
    assert_eq!(same.survey.attendance()[&17].garbled, rounds::TRIES);
    let others = same.survey.attendance().iter().filter(|(station, _)| **station != 17);
    assert_eq!(others.map(|(_, known)| known.garbled).max(), Some(0));
    let took = same.now.since(Tick::ZERO);
    assert!(took < Span::from_secs(10), "{took}");
    let apart = Bus::new(&[(17, 10, 8), (17, 30, 9)], 15..=20, brief()).run();
    let known = &apart.survey.attendance()[&17];
    assert_eq!((apart.found(), known.asked, known.replies.len()), (vec![17], 1, 2));
}

#[test]
fn nothing_is_sent_into_a_telegram_that_comes_in() {
    // The first byte of the reply comes in the last moment of the window.
    let patience = Patience { window: Span::from_millis(20), ..brief() };
    let bus = Bus::new(&[(1, 19, 7)], 1..=3, patience).run();
    let (first, second) = (bus.sent[0].0, bus.sent[1].0);
    let reply = LINE.chars(8) + Span::from_millis(19) + LINE.chars(7);
    assert_eq!(second.since(first), reply + LINE.t35());
    assert_eq!((bus.found(), bus.sent.len()), (vec![1], 3));
}

/// As a server of ports in a network does, or an adapter on a slow hub.
#[test]
fn our_own_telegrams_that_come_back_late_are_no_other_master() {
    for delay in [4, 16, 25, 40, 60, 250] {
        let mut survey = survey(1..=12, brief());
        let (mut now, mut coming, mut heard) = (Tick::ZERO, Vec::new(), Vec::new());
        loop {
            match survey.step(now) {
                Step::Done(News::Over) => break,
                Step::Done(News::Heard(sign)) => heard.push(sign.station),
                Step::Done(_) => {}
                Step::Send(bytes) => {
                    let end = now + LINE.chars(bytes.len() as u64);
                    if bytes.first() == Some(&7) {
                        let reply = rtu::encode(7, &Reply::Registers(vec![0x23]).encode());
                        coming.push((end + Span::from_millis(14), reply));
                    }
                    coming.push((end + Span::from_millis(delay), bytes));
                    coming.sort();
                }
                Step::Wait(until) => match coming.first() {
                    Some((at, _)) if *at <= until => {
                        let (at, bytes) = coming.remove(0);
                        now = at.max(now);
                        survey.feed(now, &bytes);
                    }
                    _ => now = until,
                },
            }
        }
        assert!(!survey.is_shared() && heard == [7], "{delay} ms: {heard:?}, shared {}", survey.is_shared());
    }
}

#[test]
fn echo_and_noise_are_nobody() {
    let mut survey = survey(1..=2, brief());
    let mut now = Tick::ZERO;
    let mut asked = 0;
    loop {
        match survey.step(now) {
            Step::Done(News::Over) => break,
            Step::Done(News::Asked(_)) => asked += 1,
            Step::Done(News::Heard(sign)) => assert_eq!(sign.station, 2),
            Step::Send(mut bytes) => {
                now += LINE.chars(bytes.len() as u64);
                let to = bytes[0];
                bytes.insert(0, 0x00);
                survey.feed(now, &bytes);
                if to == 2 {
                    now += Span::from_millis(10);
                    survey.feed(now, &[0xFF]);
                    survey.feed(now, &rtu::encode(2, &Reply::Registers(vec![1]).encode()));
                }
            }
            Step::Wait(until) => now = until,
        }
    }
    assert_eq!(survey.attendance()[&2].replies.len(), 1);
    assert!(survey.attendance()[&1].garbled > 0 && asked > 2, "a byte of noise may be the rest of a reply");
}

#[test]
fn a_line_that_is_never_silent_is_left_alone() {
    let mut survey = survey(1..=247, brief());
    let mut now = Tick::ZERO;
    let mut sent = 0;
    loop {
        match survey.step(now) {
            Step::Done(News::Over) => break,
            Step::Done(_) => {}
            Step::Send(_) => sent += 1,
            Step::Wait(_) => {
                now += Span::from_millis(3);
                survey.feed(now, &[0x55]);
            }
        }
    }
    assert!(survey.is_occupied());
    assert!(sent <= 1 && now < Tick::ZERO + Span::from_secs(2));
}

#[test]
fn telegrams_of_somebody_else_are_told_apart() {
    let mut survey = survey([1], brief());
    let mut now = Tick::ZERO;
    loop {
        match survey.step(now) {
            Step::Done(News::Over) => break,
            Step::Done(_) => {}
            Step::Send(_) => {
                now += Span::from_millis(20);
                survey.feed(now, &rtu::encode(9, &[3, 0, 0, 0, 1]));
            }
            Step::Wait(until) => now = until,
        }
    }
    assert_eq!(survey.strangers().iter().collect::<Vec<_>>(), [&9]);
    assert!(!survey.attendance()[&1].heard);
}

#[test]
fn what_others_overhear_is_credited_too() {
    let mut survey = survey([1, 2], brief());
    let mut now = Tick::ZERO;
    while !matches!(survey.step(now), Step::Send(_)) {
        now += Span::from_millis(1);
    }
    now += Span::from_millis(30);
    let reply = rtu::encode(1, &Reply::Registers(vec![1]).encode());
    survey.overhear(&Record { at: now, verdict: Verdict::Stray { station: 1 }, bytes: reply });
    assert_eq!(survey.step(now), Step::Done(News::Asked(1)));
    let Step::Wait(free) = survey.step(now) else { panic!("the pause after a reply") };
    assert!(matches!(survey.step(free), Step::Done(News::Heard(Sign { station: 1, .. }))));
}

/// Another master asks drive 9 every 100 ms, and is answered.
fn beside_another_master(patience: Patience) -> Bus {
    let mut bus = Bus::new(&THREE, 1..=247, patience);
    let ask = rtu::encode(9, &Request::ReadRegisters { start: 400, count: 1 }.encode());
    let reply = rtu::encode(9, &Reply::Registers(vec![5]).encode());
    for turn in 0..200 {
        let at = Tick::ZERO + Span::from_millis(33 + 100 * turn);
        bus.put(at, &ask);
        bus.put(at + LINE.chars(ask.len() as u64) + Span::from_millis(10), &reply);
    }
    bus.run()
}

#[test]
fn a_line_on_which_another_master_asks_is_left_alone() {
    for latency in [brief(), Patience::by_the_book(FULL)] {
        let bus = beside_another_master(latency);
        assert!(bus.survey.is_shared());
        let last = bus.sent.last().unwrap().0;
        assert!(last < Tick::ZERO + Span::from_secs(2), "{last:?}");
    }
    let forced = beside_another_master(Patience { yields: false, ..brief() });
    assert!(forced.survey.is_shared() && forced.sent.len() >= 247);
}

#[test]
fn doubled_late_and_strange_replies_are_no_other_master() {
    let mut bus = Bus::new(&[(1, 10, 7), (1, 40, 7), (17, 304, 8), (17, 350, 8)], 1..=60, brief());
    let strange = rtu::encode(99, &Reply::Registers(vec![5]).encode());
    for turn in 0..10 {
        bus.put(Tick::ZERO + Span::from_millis(51 + 97 * turn), &strange);
    }
    let bus = bus.run();
    assert!(!bus.survey.is_shared() && bus.sent.len() >= 60);
}

/// Somebody who owns the line: a byte, or some, every so many microseconds, for ever.
#[test]
fn a_survey_ends_whatever_comes() {
    let question = rtu::encode(9, &Request::ReadRegisters { start: 400, count: 1 }.encode());
    let noise: [&[u8]; 2] = [&[0x55], &question];
    for bytes in noise {
        for every in [5_000, 16_900, 20_000] {
            for (patience, yields) in [(brief(), true), (Patience::by_the_book(FULL), false)] {
                let mut survey = survey(1..=5, Patience { yields, ..patience });
                let (mut now, mut due) = (Tick::ZERO, Tick::from_micros(every));
                loop {
                    match survey.step(now) {
                        Step::Done(News::Over) => break,
                        Step::Done(_) => survey.resume(now),
                        Step::Send(bytes) => now += LINE.chars(bytes.len() as u64),
                        Step::Wait(until) if due <= until => {
                            now = now.max(due);
                            survey.feed(now, bytes);
                            due = now + Span::from_micros(every);
                        }
                        Step::Wait(until) => now = now.max(until),
                    }
                    // Five addresses by the book, each at most three times and once more.
                    assert!(now < Tick::ZERO + Span::from_secs(20), "{bytes:?} every {every} us, {patience:?}");
                }
            }
        }
    }
}

#[test]
fn a_quick_look_waits_behind_the_last_one_for_the_first_byte_of_a_typical_drive() {
    let line = LineSetting::rtu(19_200, Parity::Even);
    let quick = |protocol, full| Patience::quick(protocol, line, &question(), Span::from_millis(full));
    let tail = |protocol, full| quick(protocol, full).tail.as_micros();
    // 10 ms of a drive and 2 of slack, 16 of the adapter, 20 beside; 573 us for a character of 11 bits.
    assert_eq!(tail(Framing::Tcp.into(), 500), 48_000);
    assert_eq!(tail(Framing::Rtu.into(), 500).abs_diff(48_573), 0);
    assert_eq!(tail(Framing::Tcp.into(), 30), 30_000);
    let latest = Bus { latency: ADAPTER, ..Bus::new(&[(3, 12, 7)], 1..=3, quick(RTU, 500)) }.run();
    assert_eq!(latest.found(), [3], "the last one, behind an adapter that holds bytes back");
    let late = Bus::new(&[(3, 60, 7)], 1..=3, quick(RTU, 500)).run();
    assert_eq!(late.found(), [0; 0], "nobody who is late");
}

#[test]
fn how_long_a_silent_line_takes_is_known_beforehand() {
    let book = Patience::by_the_book(FULL);
    let all = [brief(), brief().once(), book, Patience::quick(RTU, LINE, &question(), FULL)];
    for patience in all.into_iter().chain([Patience { twice: 20, ..brief() }]) {
        for stations in [1, 9, 100] {
            let took = Bus::new(&[], 1..=stations, patience).run().now.since(Tick::ZERO);
            let expected = patience.lasts(RTU, LINE, &question(), usize::from(stations));
            let off = took.as_micros().abs_diff(expected.as_micros());
            assert!(off * 20 <= expected.as_micros() || off <= 25_000, "{patience:?}: {took}, expected {expected}");
        }
    }
    assert_eq!(brief().lasts(RTU, LINE, &question(), 0), Span::ZERO);
    for twice in [0, 1, 2, 5, 20] {
        let patience = Patience { twice, ..brief() };
        for stations in [1, 2, 3, 9, 21, 22, 23, 24, 25, 26, 40, 41, 42, 43, 44, 60] {
            let took = Bus::new(&[], 1..=stations, patience).run().now.since(Tick::ZERO).as_micros();
            let expected = patience.lasts(RTU, LINE, &question(), usize::from(stations)).as_micros();
            assert!(took.abs_diff(expected) < 100, "{twice} of {stations}: {took}, expected {expected}");
        }
    }
}

#[test]
fn a_survey_with_a_limit_ends_then_and_says_that_it_was_cut() {
    let limit = Some(Span::from_millis(1_000));
    let bus = Bus::new(&[(1, 10, 7)], 1..=247, Patience { limit, ..brief() }).run();
    let took = bus.now.since(Tick::ZERO);
    assert!(bus.survey.is_cut() && took < Span::from_millis(1_100), "{took}");
    let settled = bus.survey.settled(bus.now).count();
    assert!((15..40).contains(&settled), "only who had his time: {settled}");
    let whole = Bus::new(&[(1, 10, 7)], 1..=5, Patience { limit, ..brief() }).run();
    assert!(!whole.survey.is_cut() && whole.survey.settled(whole.now).count() == 5);
    // Who has the line meanwhile costs it nothing.
    let mut survey = survey(1..=3, Patience { limit, ..brief() });
    let mut now = Tick::ZERO;
    loop {
        match survey.step(now) {
            Step::Done(News::Over) => break,
            Step::Done(News::Heard(_)) => {
                now += Span::from_secs(5);
                survey.resume(now);
            }
            Step::Done(News::Asked(_)) => {}
            Step::Send(bytes) if bytes.first() == Some(&1) => {
                now += Span::from_millis(30);
                survey.feed(now, &rtu::encode(1, &Reply::Registers(vec![8]).encode()));
            }
            Step::Send(_) => {}
            Step::Wait(until) => now = until,
        }
    }
    assert!(!survey.is_cut() && survey.attendance().len() == 3);
}
