//! Telegrams of a master, one question at a time, and what is an answer to them.

use super::*;
use crate::protocol::line::Parity;

const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

fn fdl() -> Fdl {
    Fdl::new(0, LINE, Timing::of(LINE), Tick::ZERO)
}

/// The next telegram, and when it goes out.
fn sent(fdl: &mut Fdl, now: &mut Tick) -> Vec<u8> {
    loop {
        match fdl.step(*now) {
            Step::Send(bytes) => return bytes,
            Step::Wait(until) => *now = until,
            Step::Done(_) => {}
        }
    }
}

fn diag() -> Asked {
    Asked::service(Service::SlaveDiag, Vec::new())
}

/// The answer to it.
fn reply() -> Vec<u8> {
    let control = Control::Reply { station: Station::Slave, status: Status::DataLow };
    let (dsap, ssap, data) = (Some(62), Some(60), vec![0; 6]);
    Telegram::Frame(Frame { to: 0, from: 3, control, dsap, ssap, data, is_fixed: false }).encode()
}

/// Who interrupts leaves a question whose answer is on its way: it is none to the next one, which was not asked yet.
#[test]
fn an_answer_that_nobody_waits_for_is_none_to_the_question_behind_it() {
    let (mut fdl, mut now) = (fdl(), Tick::ZERO);
    fdl.ask(3, diag(), None, now);
    sent(&mut fdl, &mut now);
    let now = now + Span::from_millis(8);
    fdl.ask(3, Asked::service(Service::SlaveDiag, Vec::new()), None, now);
    let mut now = now + Span::from_millis(8);
    fdl.feed(now, &reply());
    assert!(matches!(fdl.step(now), Step::Wait(_)), "nothing was asked");
    let said = sent(&mut fdl, &mut now);
    assert_eq!(said, diag().telegram(3, 0), "counting begins again");
    fdl.feed(now + Span::from_millis(20), &reply());
    assert!(matches!(fdl.step(now), Step::Done(Ok(_))));
}

/// Who leads this line too is told by the next question, also where he spoke while nobody asked; what a slave says late is no sign of one.
#[test]
fn a_master_who_is_heard_between_two_questions_ends_the_next_one() {
    for (heard, is_told) in [(vec![0xDC, 9, 2], true), (Asked::STATUS.telegram(3, 2), true), (reply(), false)] {
        for insists in [false, true] {
            let (mut fdl, mut now) = (fdl(), Tick::ZERO);
            if insists {
                fdl.insist();
            }
            fdl.ask(3, diag(), None, now);
            sent(&mut fdl, &mut now);
            now += Span::from_millis(10);
            fdl.feed(now, &reply());
            assert!(matches!(fdl.step(now), Step::Done(Ok(_))));
            now += Span::from_millis(10);
            fdl.feed(now, &heard);
            now += Span::from_millis(10);
            fdl.ask(3, diag(), None, now);
            let ended = matches!(fdl.step(now), Step::Done(Err(Unanswered::OtherMaster(2))));
            assert_eq!(ended, is_told && !insists, "{heard:02X?}");
        }
    }
}

/// A token every 2 ms leaves no room on a line: who insists asks all the same, and is answered.
#[test]
fn the_stop_of_a_motor_goes_out_beside_another_master() {
    let token = [0xDC, 0x02, 0x02];
    let told = |insists: bool| {
        let mut fdl = fdl();
        if insists {
            fdl.insist();
        }
        fdl.ask(3, diag(), None, Tick::ZERO);
        let mut now = Tick::ZERO;
        while now < Tick::ZERO + Span::from_secs(2) {
            match fdl.step(now) {
                Step::Send(_) => {
                    fdl.feed(now + Span::from_millis(10), &token);
                    fdl.feed(now + Span::from_millis(20), &reply());
                }
                Step::Done(done) => return (done, now),
                Step::Wait(_) => fdl.feed(now, &token),
            }
            now += Span::from_millis(2);
        }
        panic!("no end");
    };
    assert_eq!(told(false).0, Err(Unanswered::OtherMaster(2)));
    let (done, at) = told(true);
    assert!(matches!(done, Ok(Reply::Frame { .. })) && at < Tick::ZERO + Span::from_millis(150), "{done:?} {at:?}");
}

/// A master whose first question was answered, when, and that question.
fn answered() -> (Fdl, Tick, Vec<u8>) {
    let (mut fdl, mut now) = (fdl(), Tick::ZERO);
    fdl.ask(3, diag(), None, now);
    let first = sent(&mut fdl, &mut now);
    fdl.feed(now + Span::from_millis(20), &reply());
    assert!(matches!(fdl.step(now), Step::Done(Ok(_))));
    (fdl, now, first)
}

/// Who interrupts before a repeat goes out has a question that was perhaps heard: the counting begins again.
#[test]
fn a_question_that_was_given_up_before_its_repeat_leaves_no_count() {
    let (mut fdl, mut now, first) = answered();
    fdl.ask(3, diag(), None, now);
    let second = sent(&mut fdl, &mut now);
    assert_ne!(first, second, "the bit has changed");
    // Its time is over, and its repeat waits for the line.
    while let Step::Wait(until) = fdl.step(now) {
        if fdl.open.as_ref().is_some_and(|open| open.sent.is_none()) {
            break;
        }
        now = until;
    }
    fdl.ask(3, diag(), None, now);
    assert_eq!(sent(&mut fdl, &mut now), first);
}

/// Who does not answer an FDL status has perhaps restarted: the next question to it is counted as its first.
#[test]
fn a_station_that_came_back_is_counted_anew() {
    let (mut fdl, mut now, first) = answered();
    fdl.ask(3, Asked::STATUS, Some(0), now);
    while !matches!(fdl.step(now), Step::Done(Err(Unanswered::Silence { .. }))) {
        now += Span::from_millis(1);
    }
    fdl.ask(3, diag(), None, now);
    assert_eq!(sent(&mut fdl, &mut now), first);
}

/// A byte of garbage.
const NOISE: u8 = 0x55;

fn frame(to: u8, from: u8, control: Control) -> Vec<u8> {
    let (dsap, ssap) = match control {
        Control::Request { .. } => (Some(60), Some(62)),
        Control::Reply { .. } => (Some(62), Some(60)),
    };
    Telegram::Frame(Frame { to, from, control, dsap, ssap, data: vec![0; 6], is_fixed: false }).encode()
}

/// A question that was sent, and when; the line is listened to.
fn asking(asked: Asked, retries: u8) -> (Fdl, Tick) {
    let (mut fdl, mut now) = (fdl(), Tick::ZERO);
    fdl.ask(3, asked, Some(retries), now);
    sent(&mut fdl, &mut now);
    (fdl, now + Span::from_millis(10))
}

/// What the end of a question is, whatever must be waited for.
fn end(fdl: &mut Fdl, now: &mut Tick) -> Result<Reply, Unanswered> {
    loop {
        match fdl.step(*now) {
            Step::Done(done) => return done,
            Step::Wait(until) => *now = until,
            Step::Send(_) => {}
        }
    }
}

/// SD3 has room for no access point (IEC 61158-4-3): only eight bytes that go without one are framed by it.
#[test]
fn eight_bytes_are_framed_as_such_only_where_they_name_no_access_point() {
    const FIXED: u8 = 0xA2;
    for (service, length, is_fixed) in [
        (Service::DataExchange, 8, true),
        (Service::DataExchange, 7, false),
        (Service::DataExchange, 9, false),
        (Service::SetPrm, 8, false),
    ] {
        let telegram = Asked::service(service, vec![0; length]).telegram(3, 0);
        assert_eq!(telegram[0] == FIXED, is_fixed, "{service:?}, {length} bytes: {telegram:02X?}");
    }
}

#[test]
fn a_short_acknowledgement_answers_only_what_can_be_acknowledged() {
    let (mut fdl, now) = asking(Asked::service(Service::SetPrm, vec![0; 7]), 0);
    fdl.feed(now, &[0xE5]);
    assert_eq!(fdl.step(now), Step::Done(Ok(Reply::Ack)));
    for service in [Service::SlaveDiag, Service::DataExchange] {
        let (mut fdl, now) = asking(Asked::service(service, Vec::new()), 0);
        fdl.feed(now, &[0xE5]);
        assert!(matches!(fdl.step(now), Step::Wait(_)), "{service:?} is answered by data");
    }
}

/// USB adapters hold bytes back for up to 16 ms at low rates (docs/measured.md).
#[test]
fn a_fast_line_is_waited_for_less() {
    let slot = |baud| Timing::of(LineSetting::rtu(baud, Parity::Even)).slot.as_micros();
    assert_eq!([45_450, 93_750, 500_000].map(slot), [30_000, 8_000, 8_000]);
}

/// What the line has come to is the sum of what each question has.
#[test]
fn what_answers_took_is_summed_up() {
    let mut fdl = Fdl::new(5, LINE, Timing::of(LINE), Tick::ZERO);
    assert_eq!(fdl.address(), 5);
    let mut now = Tick::ZERO;
    let answer = frame(5, 3, Control::Reply { station: Station::Slave, status: Status::DataLow });
    let mut waited = 0;
    for late in [10, 20] {
        fdl.ask(3, diag(), Some(1), now);
        sent(&mut fdl, &mut now);
        now += Span::from_millis(late);
        fdl.feed(now, &answer);
        assert!(matches!(fdl.step(now), Step::Done(Ok(_))));
        waited += fdl.answered_after().unwrap().as_micros();
    }
    assert_eq!((fdl.tally().replies, fdl.tally().waited.as_micros()), (2, waited));
    // Who had to be asked again may have answered either question.
    fdl.ask(3, diag(), Some(1), now);
    sent(&mut fdl, &mut now);
    sent(&mut fdl, &mut now);
    now += Span::from_millis(10);
    fdl.feed(now, &answer);
    assert!(matches!(fdl.step(now), Step::Done(Ok(_))));
    assert_eq!(fdl.answered_after(), None);
}

#[test]
fn how_often_each_station_was_asked_again_is_counted() {
    let (mut fdl, mut now) = (fdl(), Tick::ZERO);
    for _ in 0..2 {
        fdl.ask(3, diag(), Some(2), now);
        assert!(matches!(end(&mut fdl, &mut now), Err(Unanswered::Silence { asked: 3, .. })));
    }
    assert_eq!([3, 4].map(|station| fdl.repeats(station)), [4, 0]);
}

/// Two garbled tries: what came in both is told, and noted each time.
#[test]
fn garbage_in_place_of_an_answer_is_told_as_a_whole() {
    let (mut fdl, mut now) = asking(diag(), 1);
    fdl.feed(now, &[NOISE]);
    loop {
        match fdl.step(now) {
            Step::Wait(until) => now = until,
            Step::Send(_) => break,
            Step::Done(done) => panic!("{done:?}"),
        }
    }
    now += Span::from_millis(10);
    fdl.feed(now, &[NOISE, NOISE]);
    assert_eq!(end(&mut fdl, &mut now), Err(Unanswered::Garbled { asked: 2, bytes: vec![NOISE; 3] }));
    let noted = fdl.take_records().into_iter().filter(|record| record.verdict == Verdict::Garbage);
    assert_eq!(noted.map(|record| record.bytes.len()).collect::<Vec<_>>(), [1, 2]);
}

/// Noise before a telegram that is no answer counts as garbage; silence alone does not, and nothing is noted of it.
#[test]
fn noise_before_an_answer_is_noted_and_none_is_not() {
    let (mut fdl, mut now) = asking(diag(), 0);
    let noise_and_stray =
        [vec![NOISE], frame(0, 4, Control::Reply { station: Station::Slave, status: Status::DataLow })];
    fdl.feed(now, &noise_and_stray.concat());
    assert_eq!(end(&mut fdl, &mut now), Err(Unanswered::Garbled { asked: 1, bytes: vec![NOISE] }));

    for (before, noted) in [(vec![NOISE], 1), (Vec::new(), 0)] {
        let (mut fdl, now) = asking(diag(), 0);
        fdl.feed(now, &[before, reply()].concat());
        assert!(matches!(fdl.step(now), Step::Done(Ok(_))));
        let records = fdl.take_records();
        assert_eq!(records.iter().filter(|record| record.verdict == Verdict::Garbage).count(), noted);
    }
    let (mut fdl, mut now) = asking(diag(), 0);
    assert!(matches!(end(&mut fdl, &mut now), Err(Unanswered::Silence { asked: 1, .. })));
    assert!(fdl.take_records().iter().all(|record| record.verdict == Verdict::Request), "silence is no garbage");
}

/// Who is named by a telegram that is no answer.
#[test]
fn a_telegram_of_others_is_told_apart_by_whom_it_names() {
    let reply = Control::Reply { station: Station::Slave, status: Status::DataLow };
    let request = Control::Request { function: Function::SrdHigh, count: Count::First };
    for (to, from, control, ended) in
        [(0, 4, reply, None), (7, 3, reply, Some(7)), (4, 7, request, Some(7)), (4, 0, request, None)]
    {
        let (mut fdl, now) = asking(diag(), 0);
        fdl.feed(now, &frame(to, from, control));
        let master = match fdl.step(now) {
            Step::Done(Err(Unanswered::OtherMaster(master))) => Some(master),
            Step::Wait(_) => None,
            other => panic!("{to} <- {from}: {other:?}"),
        };
        assert_eq!((master, fdl.beside()), (ended, ended), "{to} <- {from}");
    }
}

/// Data that come from another access point than was asked are no answer; a short answer names none.
#[test]
fn an_answer_comes_from_the_access_point_that_was_asked() {
    let control = Control::Reply { station: Station::Slave, status: Status::NoService };
    let of = |dsap, ssap, data| Telegram::Frame(Frame { to: 0, from: 3, control, dsap, ssap, data, is_fixed: false });
    for (telegram, is_answer) in [
        (of(Some(62), Some(60), vec![0; 6]), true),
        (of(Some(62), Some(61), vec![0; 6]), false),
        (of(Some(61), Some(60), vec![0; 6]), false),
        (of(None, None, vec![0; 6]), false),
        (of(None, None, Vec::new()), true),
    ] {
        let (mut fdl, now) = asking(diag(), 0);
        fdl.feed(now, &telegram.encode());
        assert_eq!(matches!(fdl.step(now), Step::Done(Ok(_))), is_answer, "{telegram:?}");
    }
}

/// A line that is never silent has no room for a question: told behind a second, not before.
#[test]
fn a_line_that_is_never_silent_is_told_behind_a_second() {
    let (mut fdl, mut now) = (fdl(), Tick::ZERO);
    fdl.ask(3, diag(), Some(0), now);
    let done = loop {
        fdl.feed(now, &[NOISE]);
        match fdl.step(now) {
            Step::Done(done) => break done,
            Step::Wait(_) => now += Span::from_micros(500),
            Step::Send(_) => panic!("into a line that speaks"),
        }
    };
    assert!(matches!(done, Err(Unanswered::Garbled { asked: 0, .. })), "{done:?}");
    assert!((BABBLE..BABBLE + Span::from_millis(2)).contains(&now.since(Tick::ZERO)), "{now:?}");
}
