//! What a survey counts: garbage of the line itself, and replies.

use super::*;

/// Garbage comes behind the questions to the first so many of some; how many questions it took, and whether it is the line's.
fn garbage_behind(first: u8, all: u8) -> (usize, bool) {
    let mut survey = survey(1..=all, brief());
    let (mut now, mut sent) = (Tick::ZERO, 0);
    loop {
        match survey.step(now) {
            Step::Done(News::Over) => return (sent, survey.is_noisy()),
            Step::Done(_) => {}
            Step::Send(bytes) => {
                sent += 1;
                now += LINE.chars(bytes.len() as u64) + Span::from_millis(3);
                if sent <= usize::from(all) && bytes.first().is_some_and(|&station| station <= first) {
                    survey.feed(now, &[0x55, 0xAA, 0x55]);
                }
            }
            Step::Wait(until) => now = until,
        }
    }
}

#[test]
fn garbage_behind_more_than_half_of_the_questions_is_the_lines_own() {
    assert_eq!(
        [7, 8, 12].map(|first| garbage_behind(first, 12)),
        [(12, true), (12, true), (12, true)],
        "nobody is asked again for it"
    );
    for first in [1, 4, 6] {
        let (sent, noisy) = garbage_behind(first, 12);
        assert!(sent > 12 && !noisy, "{first}: {sent}");
    }
    assert_eq!(garbage_behind(8, 8), (8, true), "eight questions are enough to tell");
    let (sent, noisy) = garbage_behind(7, 7);
    assert!(sent > 7 && !noisy, "seven are not: {sent}");
}

#[test]
fn replies_that_never_end_are_kept_up_to_a_number() {
    let mut survey = survey([1], brief());
    let mut now = Tick::ZERO;
    while !matches!(survey.step(now), Step::Send(_)) {
        now += Span::from_millis(1);
    }
    for turn in 0..100u16 {
        now += Span::from_millis(9);
        survey.feed(now, &rtu::encode(1, &Reply::Registers(vec![turn / 70]).encode()));
    }
    let known = &survey.attendance()[&1];
    assert_eq!((known.replies.len(), known.surplus(), known.owes(), known.differ()), (MOST_REPLIES, 63, false, false));
}

#[test]
fn replies_are_the_same_or_differ_and_are_more_or_fewer_than_the_questions() {
    let said = |value| Said::Modbus(Reply::Registers(vec![value]));
    let known = |asked, values: &[u16]| {
        let known =
            Attendance { asked, replies: values.iter().map(|&value| said(value)).collect(), ..Attendance::default() };
        (known.surplus(), known.owes(), known.differ())
    };
    assert_eq!(known(1, &[]), (0, true, false));
    assert_eq!(known(1, &[7]), (0, false, false));
    assert_eq!(known(1, &[7, 7]), (1, false, false));
    assert_eq!(known(3, &[7, 8]), (0, true, true));
}

#[test]
fn three_questions_of_somebody_else_are_another_master() {
    let ask = rtu::encode(9, &Request::ReadRegisters { start: 400, count: 1 }.encode());
    for (count, shared) in [(2, false), (3, true)] {
        let mut survey = survey(1..=3, brief());
        let mut now = Tick::ZERO;
        for _ in 0..count {
            now += Span::from_millis(100);
            survey.feed(now, &ask);
            let _sent_or_not = survey.step(now + Span::from_millis(50));
        }
        assert_eq!(survey.is_shared(), shared, "{count}");
    }
}
