//! Beside another master, and where two drives have one address.

use super::*;

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
    line.master.heard.sees_surplus(1);
    line.master.feed(line.now, &[rtu::encode(1, &READ.encode()), value(1390)].concat());
    line.now += Span::from_millis(450);
    let his = [rtu::encode(1, &OTHER.encode()), value(7)].concat();
    let outcome = line.ask(1, READ, &[&[(10, value(1390)), (190, his)]]);
    assert!(
        !matches!(&outcome, Ok(Answer::Reply { said: Said::Modbus(Reply::Registers(words)), .. }) if *words == [7]),
        "{outcome:?}"
    );
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
    line.master.set_wired(true);
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
