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

/// Steps until the next question is out; when its last byte is.
fn asks(survey: &mut Survey, now: &mut Tick) -> Tick {
    loop {
        match survey.step(*now) {
            Step::Send(bytes) => return *now + LINE.chars(bytes.len() as u64),
            Step::Wait(until) => *now = until,
            Step::Done(_) => {}
        }
    }
}

#[test]
fn a_line_is_somebody_elses_after_a_second_without_a_silence_and_not_before() {
    let second = Tick::ZERO + Span::from_secs(1);
    for (over, ends) in [(Tick::from_micros(999_999), false), (second, true)] {
        // Bytes that are no telegram, and telegrams without a pause between them.
        let mut drip = survey([1], brief());
        (0..=100).for_each(|turn| drip.feed(Tick::ZERO + Span::from_millis(10).times(turn), &[0x55]));
        let mut telegrams = survey([1], brief());
        telegrams.ready_at = Tick::ZERO + Span::from_secs(5);
        assert_eq!(telegrams.step(Tick::ZERO), Step::Wait(second));
        for survey in [&mut drip, &mut telegrams] {
            assert_eq!((survey.step(over) == Step::Done(News::Over), survey.is_occupied()), (ends, ends), "{over:?}");
        }
    }
}

#[test]
fn it_ends_when_its_time_is_over_and_nobody_is_asked_any_more() {
    let mut survey = survey([1, 2], brief());
    let at = Tick::ZERO + Span::from_millis(100);
    survey.end_by(at);
    assert_eq!((survey.step(at), survey.is_cut()), (Step::Done(News::Over), true));
}

#[test]
fn a_reply_to_the_question_of_now_is_one_and_a_late_one_is_a_stray() {
    let reply = |station| rtu::encode(station, &Reply::Registers(vec![7]).encode());
    let mut survey = survey([1, 2], brief());
    let mut now = Tick::ZERO;
    asks(&mut survey, &mut now);
    now = asks(&mut survey, &mut now) + Span::from_millis(12);
    survey.feed(now, &reply(1));
    survey.feed(now + Span::from_millis(10), &reply(2));
    let verdicts: Vec<Verdict> = survey.take_records().into_iter().map(|record| record.verdict).collect();
    assert_eq!(verdicts, [Verdict::Request, Verdict::Request, Verdict::Stray { station: 1 }, Verdict::Reply]);
}

#[test]
fn what_others_overhear_is_taken_at_once() {
    let mut survey = survey([1], brief());
    let mut now = Tick::ZERO;
    now = asks(&mut survey, &mut now);
    let mut overhear = |bytes: Vec<u8>| {
        survey.overhear(&Record { at: now, verdict: Verdict::Garbage, bytes });
        (survey.garbage(), survey.attendance()[&1].replies.len())
    };
    assert_eq!(overhear(vec![0x55, 0xAA]), (1, 0));
    assert_eq!(overhear(rtu::encode(1, &Reply::Registers(vec![7]).encode())), (1, 1), "a reply leaves nothing behind");
}

#[test]
fn no_more_is_recorded_than_anybody_can_read() {
    let mut survey = survey([1], brief());
    for turn in 0..MOST_RECORDS + 10 {
        let record = Record { at: Tick::ZERO, verdict: Verdict::Garbage, bytes: vec![turn as u8] };
        survey.record(record);
    }
    assert_eq!(survey.take_records().len(), MOST_RECORDS);
}

#[test]
fn questions_of_somebody_else_are_remembered_from_one_setting_to_the_next() {
    let ask = rtu::encode(9, &Request::ReadRegisters { start: 400, count: 1 }.encode());
    let mut survey = survey([1], brief());
    survey.remembers(2);
    assert!(!survey.is_shared());
    survey.feed(Tick::ZERO, &ask);
    let _sent_or_not = survey.step(Tick::ZERO + Span::from_millis(50));
    assert_eq!((survey.foreign(), survey.is_shared()), (3, true));
}

/// A survey of one station that was asked, with what was seen of it.
fn with(patience: Patience, garbled: u32, delay: Span) -> Survey {
    let mut survey = survey([1], patience);
    survey.stations.insert(1, Attendance { asked: 1, garbled, ..Attendance::default() });
    survey.suspects.insert(1, delay);
    survey
}

#[test]
fn a_station_is_garbled_that_was_so_three_times_or_right_behind_the_only_question() {
    let garbled = |survey: Survey| survey.garbled().count() == 1;
    let (again, once) = (brief(), brief().once());
    let more = Span::from_micros(1);
    for (garbles, delay, expected) in [
        (0, once.window, [false, true]),
        (0, once.window + more, [false, false]),
        (2, once.window + more, [false, false]),
        (3, once.window + more, [true, true]),
    ] {
        assert_eq!(
            [again, once].map(|patience| garbled(with(patience, garbles, delay))),
            expected,
            "{garbles} {delay}"
        );
    }
}

/// Who is left: who was not asked yet, and who is asked again.
#[test]
fn what_is_pending_and_what_is_settled_is_told() {
    let settled = |survey: &Survey| survey.settled(Tick::ZERO + Span::from_secs(60)).collect::<Vec<_>>();
    let mut survey = with(brief(), 0, Span::ZERO);
    assert_eq!((survey.pending(), settled(&survey)), (2, vec![]), "in the queue, and suspected");
    survey.queue.clear();
    assert_eq!((survey.pending(), settled(&survey)), (1, vec![]), "suspected alone");
    (survey.round.asked, survey.round.garbage) = (8, 8);
    assert_eq!(survey.pending(), 0, "nobody is asked again for garbage that is the line's own");
    survey.suspects.clear();
    assert_eq!((survey.pending(), settled(&survey)), (0, vec![1]));
    survey.queue.push_back(1);
    assert_eq!((survey.pending(), settled(&survey)), (1, vec![]), "in the queue alone");
    assert_eq!(with(brief().once(), 0, Span::ZERO).pending(), 1, "nobody is asked again");
    assert!(!survey.is_occupied());
    survey.occupied = true;
    assert!(survey.is_occupied());
}

/// A single suspect has all the time that a reply may take; of several, less in the first rounds. By the book a telegram may straggle.
#[test]
fn one_alone_is_waited_for_by_the_book() {
    let mut one = with(brief(), 0, Span::ZERO);
    let brief_straggle = one.straggle();
    assert!(one.next_round() && one.round.window == FULL);
    assert_eq!(one.straggle(), one.dialect.straggle(&[]));
    assert!(brief_straggle > LINE.chars(2) && brief_straggle < one.straggle(), "{brief_straggle}");
    assert_eq!(brief_straggle, ADAPTER + LINE.chars(2));
    let mut two = survey([1, 2], brief());
    for station in [1, 2] {
        two.stations.insert(station, Attendance { asked: 1, garbled: 0, ..Attendance::default() });
        two.suspects.insert(station, Span::ZERO);
    }
    assert!(two.next_round() && two.round.window == brief().second_window());
}

#[test]
fn rounds_end_at_a_number_and_garbage_is_the_lines_where_nobody_is_asked_again_as_well() {
    for (number, goes_on) in [(15, true), (16, false)] {
        let mut survey = with(brief(), 0, Span::ZERO);
        survey.round.number = number;
        assert_eq!(survey.next_round(), goes_on, "{number}");
    }
    for (garbage, noisy) in [(6, false), (7, true)] {
        let mut survey = with(brief().once(), 0, Span::ZERO);
        (survey.round.asked, survey.round.garbage) = (12, garbage);
        assert_eq!((survey.next_round(), survey.is_noisy()), (false, noisy));
    }
}

#[test]
fn garbage_that_begins_when_a_station_has_had_its_time_is_not_its_own() {
    for (late, suspected) in [(0, false), (1, true)] {
        let mut survey = survey([1], brief());
        let mut now = Tick::ZERO;
        let end = asks(&mut survey, &mut now);
        survey.ear.hears(end + (FULL - Span::from_micros(late)), &[0x55]);
        survey.suspect();
        assert_eq!(survey.suspects.contains_key(&1), suspected);
    }
}
