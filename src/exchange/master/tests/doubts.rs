//! Answers that are believed only when they are said again, or never.

use super::*;

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
    assert_eq!(taken(line.ask(1, READ, &[&[(310, value(5))]])), Reply::Registers(vec![5]));
    assert_eq!(taken(line.ask(1, OTHER, &[&[(10, value(7))]])), Reply::Registers(vec![7]));
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
fn the_first_copy_of_all_is_no_value() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let copy = [(10, value(1390))];
    let outcome = line.ask(1, OTHER, &[&copy, &[(10, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_station_that_says_the_same_of_everything_is_soon_believed() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    let sent: Vec<_> = (1..8)
        .map(|start| {
            let before = line.sent.len();
            assert_eq!(line.answered(1, Request::ReadRegisters { start, count: 1 }), Some(vec![7]));
            line.sent.len() - before
        })
        .collect();
    assert_eq!(sent, [3, 1, 1, 1, 1, 1, 1]);
}

#[test]
fn an_answer_behind_garbage_as_long_as_a_telegram_is_asked_for_behind_a_fence() {
    let mut line = Line::new(Framing::Rtu);
    assert_eq!(taken(line.ask(1, READ, &[&[(11, value(1390))]])), Reply::Registers(vec![1390]));
    let met = vec![0, 0, 0, 0x12, 0x66, 0x42, 0x10, 0x40];
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(15, met), (36, value(1391))], &[(11, fence_reply())], &[(11, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
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
