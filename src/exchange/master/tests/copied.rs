//! A write that comes back once, first of all: its answer or its echo.

use super::*;
use crate::exchange::INSIST;

fn stop() -> Request {
    Request::WriteRegister { address: 410, value: 2 }
}

/// A line on which nothing was said yet, of somebody who must not wait for a busy one; the stop came back once.
fn came_back(after: u64) -> Line {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, insist: Some(INSIST), ..Limits::default() });
    let outcome = line.ask(1, stop(), &[&[(after, rtu::encode(1, &stop().encode()))]]);
    assert!(matches!(outcome, Err(ExchangeError::Silence { .. })), "{outcome:?}");
    line
}

#[test]
fn a_word_that_came_back_is_acknowledged_where_the_next_answer_shows_no_echo() {
    let mut line = came_back(15);
    assert_eq!((line.now.as_micros() / 1_000, line.master.echoes()), (71, None), "no longer than a telegram straggles");
    assert_eq!(line.verdicts(), [Verdict::Request, Verdict::Copy]);
    assert!(line.master.may_be_answered(1, &stop().into()) && !line.master.may_be_answered(2, &stop().into()));
    assert!(line.ask(1, READ, &[&[(15, value(7))]]).is_ok());
    let answer = line.master.answered_after_all(line.now);
    assert_eq!(taken(answer.clone().ok_or(ExchangeError::BroadcastRead)), Reply::decode(&stop().encode()).unwrap());
    assert!(matches!(answer, Some(Answer::Reply { after, .. }) if after == Span::from_millis(15)), "{answer:?}");
    let tally = line.master.tally();
    assert_eq!((tally.replies, tally.echoes, tally.silences, tally.strays), (2, 0, 0, 0));
    assert_eq!(line.master.owes_until(line.now), None);
    assert_eq!(line.master.answered_after_all(line.now), None, "once");
}

#[test]
fn a_word_that_came_back_is_none_where_the_next_answer_has_an_echo_or_does_not_come() {
    let echo = || rtu::encode(1, &READ.encode());
    for replies in [vec![(0, echo()), (15, value(7))], vec![(0, echo())], vec![]] {
        let mut line = came_back(0);
        let _told = line.ask(1, READ, &[&replies]);
        assert_eq!(line.master.answered_after_all(line.now), None, "{replies:?}");
        assert_eq!(line.master.echoes(), (!replies.is_empty()).then_some(true), "{replies:?}");
        assert_eq!(line.master.tally().silences, 1 + u64::from(replies.len() < 2), "{replies:?}");
    }
}

#[test]
fn behind_an_echo_the_answer_is_waited_for_on_wires_where_nothing_else_comes_so_soon() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_wired(true);
    line.master.set_limits(Limits { retries: 0, insist: Some(INSIST), ..Limits::default() });
    let copy = || rtu::encode(1, &stop().encode());
    assert!(line.ask(1, stop(), &[&[(1, copy()), (200, copy())]]).is_ok());
    assert_eq!((line.master.echoes(), line.master.tally().echoes), (Some(true), 1));
}

#[test]
fn who_may_wait_waits_behind_what_may_be_an_echo() {
    let mut line = Line::new(Framing::Rtu);
    let copy = || rtu::encode(1, &stop().encode());
    assert!(line.ask(1, stop(), &[&[(0, copy()), (300, copy())]]).is_ok());
    assert_eq!(line.sent.len(), 1);
}
