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
