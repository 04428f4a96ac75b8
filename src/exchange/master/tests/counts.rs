//! What is counted and measured on a line, and what is known of replies that are still owed.

use super::*;

fn once() -> Line {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    line
}

#[test]
fn bytes_that_may_be_the_echo_of_a_fence_do_not_make_an_older_answer_the_new_one() {
    let mut line = once();
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    // In the bytes of the fence, as late as an answer; what was asked first is answered only then.
    let echo = frame(1, &Reply::Diagnostics { sub: 0x0B, data: 0 });
    let outcome = line.ask(1, OTHER, &[&[(20, echo), (300, fence_reply())], &[(400, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn everything_on_a_line_is_counted_once() {
    let told = |line: &Line| {
        let tally = line.master.tally();
        [tally.sent, tally.replies, tally.repeats, tally.silences, tally.garbled, tally.strays, tally.fences]
    };
    let mut fine = once();
    for count in 1..=2 {
        taken(fine.ask(1, READ, &[&[(10, value(1390))]]));
        assert_eq!(told(&fine), [count, count, 0, 0, 0, 0, 0]);
        assert_eq!(fine.master.tally().waited, Span::from_millis(10).times(count));
    }
    let mut silent = Line::new(Framing::Rtu);
    assert!(silent.ask(1, READ, &[]).is_err());
    assert_eq!(told(&silent), [3, 0, 2, 3, 0, 0, 0]);
    let mut broken = once();
    let mut spoilt = value(1390);
    spoilt[4] ^= 0x10;
    assert!(broken.ask(1, READ, &[&[(10, spoilt)]]).is_err());
    assert_eq!(told(&broken), [1, 0, 0, 0, 1, 0, 0]);
    let mut fenced = once();
    assert!(fenced.ask(1, READ, &[]).is_err());
    taken(fenced.ask(1, OTHER, &[&[(10, fence_reply())], &[(10, value(7))], &[(10, value(7))]]));
    assert_eq!((fenced.master.tally().fences, fenced.master.tally().silences), (1, 1));
    let mut foreign = once();
    let other = frame(9, &Reply::Registers(vec![1]));
    assert!(foreign.ask(1, READ, &[&[(10, other)]]).is_err());
    assert_eq!((foreign.master.tally().sent, foreign.master.tally().strays), (1, 1));
}

#[test]
fn a_pause_is_measured_where_it_was_waited_for() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    assert_eq!(line.master.pauses().count, 0);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let pauses = line.master.pauses();
    assert_eq!((pauses.count, pauses.shortest, pauses.longest), (1, line.master.line.t35(), line.master.line.t35()));
    line.now += Span::from_secs(1);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    assert_eq!(line.master.pauses().count, 1, "nobody waited");
}

#[test]
fn a_reply_that_is_owed_to_somebody_else_on_our_side_is_kept_apart_too() {
    let mut line = once();
    line.master.expect(1, READ.into(), line.now);
    taken(line.ask(1, OTHER, &[&[(10, fence_reply())], &[(10, value(7))], &[(10, value(7))]]));
    assert_eq!(line.master.tally().fences, 1);
}

#[test]
fn the_line_is_owed_a_while_by_a_station_that_was_heard_and_no_longer() {
    let mut line = once();
    assert!(line.ask(1, READ, &[]).is_err());
    assert_eq!(line.master.owes_until(line.now), None, "nobody was ever heard there");
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    assert_eq!(line.master.owes_until(line.now), None);
    assert!(line.ask(1, READ, &[]).is_err());
    let until = line.master.owes_until(line.now).unwrap();
    assert_eq!(until, line.now + Span::from_secs(2));
    assert_eq!(line.master.owes_until(until), None);
    assert_eq!(line.master.owes_until(until + Span::from_secs(1)), None);
}

#[test]
fn a_question_is_over_when_its_time_is_and_not_if_its_answer_has_come() {
    for (came, late) in [(false, 0), (true, 0), (true, 1)] {
        let mut line = once();
        line.master.ask(1, READ, line.now);
        while !matches!(line.master.step(line.now), Step::Send(_)) {
            line.now += Span::from_micros(100);
        }
        let end = line.now + line.master.line.chars(8);
        assert_eq!(line.master.owes_until(line.now), Some(end + Span::from_millis(500)), "it is open");
        let until = line.master.job.as_ref().unwrap().until;
        if came {
            line.master.feed(end + Span::from_millis(10), &value(7));
        }
        let outcome = line.master.step(until + Span::from_micros(late));
        assert_eq!(matches!(outcome, Step::Done(Ok(_))), came, "{outcome:?}");
        assert!(came || outcome == Step::Done(Err(ExchangeError::Unproven { asked: 1 })), "{outcome:?}");
        assert_eq!(line.master.tally().garbled, u64::from(!came));
    }
}

#[test]
fn a_question_that_finds_the_line_free_has_waited_for_nothing() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    line.now = line.master.ready_at;
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    assert_eq!(line.master.pauses().count, 0);
}

/// Feeds an answer that begins so long after the question, in microseconds; tells whether it is taken.
fn taken_after(master: &mut Master, begins: u64) -> bool {
    let mut now = Tick::from_micros(1_000_000);
    master.ask(1, READ, now);
    while !matches!(master.step(now), Step::Send(_)) {
        now += Span::from_micros(100);
    }
    let at = now + master.line.chars(8) + Span::from_micros(begins) + master.line.chars(7);
    master.feed(at, &value(7));
    matches!(master.step(at), Step::Done(Ok(_)))
}

#[test]
fn what_ends_sooner_than_the_wires_allow_is_no_answer() {
    let least = LineSetting::rtu(19_200, Parity::Even).t35().as_micros();
    let rows = [
        (0, true, false),
        (least - 201, true, false),
        (least - 200, true, true),
        (least, true, true),
        (0, false, true),
    ];
    for (begins, wired, expected) in rows {
        let mut line = once();
        line.master.set_wired(wired);
        assert_eq!(taken_after(&mut line.master, begins), expected, "{begins} us, wired: {wired}");
    }
    // What was set stays so when the line is set anew, and so does what was counted.
    let mut line = once();
    line.master.set_wired(true);
    assert!(taken_after(&mut line.master, least));
    let (sent, rate) = (line.master.tally().sent, LineSetting::rtu(9_600, Parity::Even));
    line.master.retune(Framing::Rtu.into(), rate, Tick::from_micros(2_000_000));
    assert_eq!((line.master.line(), line.master.tally().sent), (rate, sent));
    assert!(!taken_after(&mut line.master, 0) && !line.master.take_records().is_empty());
}

/// The second answer is to the second asking: nothing speaks for two drives, and nobody is told of any.
#[test]
fn who_is_asked_twice_because_it_is_late_does_not_answer_twice() {
    let mut line = Line::vabus();
    for number in [372, 376, 372, 376, 372, 376] {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        let address = Address::drive(1).unwrap();
        let value = vabus::Reply::Value { address, header, data: Data::word(number) }.encode();
        let late: &[(u64, Vec<u8>)] = &[(600, value)];
        let outcome = line.ask(1, vabus::Request::Enquiry { address, header }, &[late; 9]);
        assert!(outcome.is_ok(), "{outcome:?}");
        assert!(!line.master.answers_twice(1));
    }
}
