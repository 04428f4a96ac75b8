//! Answers that are weighed: said again, sooner than ever, behind noise, two at once; and what is noted of all the rest.

use super::*;

fn once() -> Line {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    line
}

fn counted(sub: u16, data: u16) -> Vec<u8> {
    frame(1, &Reply::Diagnostics { sub, data })
}

/// How many telegrams this took.
fn sent(line: &mut Line, ask: impl FnOnce(&mut Line)) -> usize {
    let before = line.sent.len();
    ask(line);
    line.sent.len() - before
}

#[test]
fn words_of_a_moment_ago_behind_noise_leave_the_true_answer_owed() {
    for (noise, telegrams) in [(vec![], 1), (vec![0x00], 3)] {
        let mut line = once();
        taken(line.ask(1, READ, &[&[(10, value(7))]]));
        assert_eq!(taken(line.ask(1, READ, &[&[(10, [noise, value(7)].concat())]])), Reply::Registers(vec![7]));
        let replies: [&[(u64, Vec<u8>)]; 3] = [&[(10, fence_reply())], &[(10, value(8))], &[(10, value(8))]];
        assert_eq!(
            sent(&mut line, |line| drop(line.ask(1, OTHER, if telegrams == 1 { &replies[1..] } else { &replies }))),
            telegrams
        );
    }
}

#[test]
fn so_late_as_it_was_believed_once_an_answer_is_the_usual_one() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    taken(line.ask(1, READ, &[&[(60, value(7))]]));
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(10, fence_reply())], &[(10, value(8))], &[(10, value(8))]];
    taken(line.ask(1, READ, &[&[(60, value(7))]]));
    assert_eq!(sent(&mut line, |line| drop(line.ask(1, OTHER, &replies))), 3, "one of the two may have been a copy");
    // Of what a fence has overtaken nothing comes any more.
    line.now += Span::from_secs(8);
    taken(line.ask(1, READ, &[&[(60, value(9))]]));
    taken(line.ask(1, READ, &[&[(60, value(9))]]));
    assert_eq!(sent(&mut line, |line| drop(line.ask(1, OTHER, &replies[1..]))), 1);
}

#[test]
fn two_answers_in_other_words_are_two_drives_and_the_question_is_asked_anew() {
    let one_piece: &[(u64, Vec<u8>)] = &[(10, [value(8), value(9)].concat())];
    let two: &[(u64, Vec<u8>)] = &[(6, value(8)), (20, value(9))];
    let sooner: &[(u64, Vec<u8>)] = &[(3, value(8)), (9, value(9))];
    for first in [one_piece, two, sooner] {
        let mut line = once();
        taken(line.ask(1, READ, &[&[(20, value(1390))]]));
        let begun = line.now;
        let replies: [&[(u64, Vec<u8>)]; 4] = [first, &[(20, fence_reply())], &[(20, value(9))], &[(20, value(9))]];
        _ = line.ask(1, OTHER, &replies);
        assert!(line.master.differs(1), "{:?}", line.verdicts());
        assert!(
            line.now.since(begun) > Span::from_millis(600),
            "no copy of either is believed: {}",
            line.now.since(begun)
        );
        assert!(line.master.tally().strays >= 2 && line.master.tally().garbled >= 1, "{:?}", line.master.tally());
    }
    // Said twice in one piece it is one answer; how many give it is found out.
    let mut line = once();
    let replies: [&[(u64, Vec<u8>)]; 3] =
        [&[(10, [value(7), value(7)].concat())], &[(10, fence_reply())], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, READ, &replies)), Reply::Registers(vec![7]));
    assert!(!line.master.differs(1) && line.master.tally().garbled == 0, "{:?}", line.master.tally());
}

#[test]
fn sooner_than_ever_is_doubted_once_where_more_comes_than_was_asked_for() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(20, value(1390))]]));
    line.master.heard.sees_surplus(1);
    let soon: &[(u64, Vec<u8>)] = &[(6, value(8))];
    assert_eq!(
        sent(&mut line, |line| assert_eq!(taken(line.ask(1, OTHER, &[soon, soon])), Reply::Registers(vec![8]))),
        2
    );
    assert_eq!((line.master.tally().strays, line.master.tally().garbled), (1, 1));
    assert!(line.verdicts().contains(&Verdict::Stray { station: 1 }));
}

#[test]
fn a_line_that_echoed_once_may_echo_the_fence() {
    let mut line = once();
    let echo = rtu::encode(1, &READ.encode());
    taken(line.ask(1, READ, &[&[(10, [echo, value(1390)].concat())]]));
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    assert_eq!(line.master.echoes(), Some(false));
    assert!(line.ask(1, READ, &[&[(620, value(1390))]]).is_err());
    let replies: [&[(u64, Vec<u8>)]; 2] = [&[(1, counted(0x0B, 0)), (300, fence_reply())], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn the_end_of_the_last_exchange_before_an_echo_is_ours() {
    let mut line = Line::vabus();
    let address = Address::drive(1).unwrap();
    let header = Header { number: ParamNumber::new(411).unwrap(), ..Header::default() };
    let asked = vabus::Request::Enquiry { address, header };
    let reply = vabus::Reply::Value { address, header, data: Data::word(7) }.encode();
    let came = [&[vabus::EOT][..], &asked.encode(), &reply].concat();
    assert!(line.ask(1, asked.clone(), &[&[(10, came)]]).is_ok());
    let records = line.master.take_records();
    let at = |verdict| records.iter().find(|record| record.verdict == verdict).map(|record| record.at);
    let gap = line.master.dialect.gap(line.master.line, Limits::default().pause);
    assert_eq!(at(Verdict::Garbage), None);
    assert_eq!(at(Verdict::Farewell), at(Verdict::Reply).map(|at| at + gap), "it ends behind the pause of the manual");
    // A value names what it answers, so it is not asked for again behind noise.
    let begun = line.sent.len();
    assert!(line.ask(1, asked, &[&[(10, [&[0x55; 3][..], &reply].concat())]]).is_ok());
    assert_eq!(line.sent.len() - begun, 2);
}

#[test]
fn a_fence_is_waited_for_as_long_as_any_answer_takes_if_somebody_is_there() {
    let mut line = once();
    assert!(line.ask(1, READ, &[]).is_err());
    // The late answer to READ tells that the station is there.
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[(100, value(1390))], &[(2_000, counted(0x0E, 5))], &[(10, value(7))]];
    let outcome = line.ask(1, OTHER, &[replies[0], replies[1], replies[2], replies[2], replies[2]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    let mut line = once();
    assert!(line.ask(1, READ, &[]).is_err());
    let begun = line.now;
    assert!(line.ask(1, OTHER, &[]).is_err());
    assert!(line.now.since(begun) < Span::from_secs(2), "a silent one is not: {}", line.now.since(begun));
}

#[test]
fn garbage_as_long_as_the_shortest_reply_was_the_reply() {
    for (bytes, soon) in [(4, false), (5, true)] {
        let mut line = once();
        assert!(line.ask(1, READ, &[&[(10, vec![0x55; bytes])]]).is_err());
        assert_eq!(line.now < Tick::from_micros(100_000), soon, "{bytes}");
    }
    // What was spoilt is not owed: the same words of a moment ago are a copy too many.
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    assert!(line.ask(1, READ, &[&[(10, vec![0x55; 7])]]).is_err());
    line.master.feed(line.now, &value(7));
    assert!(line.master.heard.has_surplus(1));
}

#[test]
fn a_late_answer_is_known_as_the_one_to_what_was_asked() {
    let mut line = once();
    assert!(line.ask(2, READ, &[&[(10, vec![0x55; 9])]]).is_err());
    assert!(line.ask(1, READ, &[]).is_err());
    line.master.feed(line.now, &value(1390));
    let again = sent(&mut line, |line| {
        assert_eq!(taken(line.ask(1, READ, &[&[(10, value(1390))]])), Reply::Registers(vec![1390]))
    });
    assert_eq!(again, 1, "the same of the same is no sign of a copy");
}

#[test]
fn another_answer_within_a_second_is_a_second_drives() {
    for (ms, differs) in [(1, true), (999, true), (1_000, false), (1_001, false)] {
        let mut line = once();
        taken(line.ask(1, READ, &[&[(10, value(7))]]));
        line.master.feed(line.now + Span::from_millis(ms), &value(8));
        assert_eq!(line.master.differs(1), differs, "{ms}");
    }
    // While somebody else is asked, and while something is asked that it does not answer.
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    taken(line.ask(2, OTHER, &[&[(10, value(8)), (20, frame(2, &Reply::Registers(vec![5])))]]));
    assert!(line.master.differs(1));
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    assert!(line.ask(1, Request::ReadLong { address: 210 }, &[]).is_err());
    _ = line.ask(1, Request::ReadLong { address: 211 }, &[&[(10, value(8)), (30, fence_reply())]]);
    assert!(line.master.differs(1));
}

#[test]
fn what_nobody_waits_for_is_noted_piece_by_piece_and_not_without_end() {
    for (gap, pieces) in [(50_000, 1), (50_001, 2), (80_000, 2)] {
        let mut line = once();
        line.master.feed(line.now, &[0x55]);
        line.master.feed(line.now + Span::from_micros(gap), &[0xAA]);
        line.now += Span::from_secs(1);
        assert!(line.ask(1, READ, &[]).is_err());
        let garbage = line.verdicts().into_iter().filter(|verdict| *verdict == Verdict::Garbage).count();
        assert_eq!(garbage, pieces, "{gap}");
    }
    let mut line = once();
    line.master.feed(line.now, &[0x55; MOST_BYTES]);
    assert!(line.verdicts().is_empty());
    line.master.feed(line.now, &[0x55]);
    assert_eq!(line.verdicts(), [Verdict::Garbage]);
    for _ in 0..MOST_RECORDS + 5 {
        line.master.record(Record { at: line.now, verdict: Verdict::Garbage, bytes: vec![0x55] });
    }
    assert_eq!(line.verdicts().len(), MOST_RECORDS);
}

#[test]
fn what_may_not_be_asked_again_is_believed_in_words_of_a_moment_ago() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    let write = |value| Request::WriteRegisters { start: 6914, values: vec![0, value] };
    let written: &[(u64, Vec<u8>)] = &[(10, frame(1, &Reply::RegistersWritten { start: 6914, count: 2 }))];
    assert!(line.ask(1, write(1), &[written]).is_ok());
    assert_eq!(sent(&mut line, |line| assert!(line.ask(1, write(2), &[written]).is_ok())), 1);
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    line.master.set_limits(Limits { retries: 0, witness: false, ..Limits::default() });
    assert_eq!(sent(&mut line, |line| drop(taken(line.ask(1, OTHER, &[&[(10, value(7))]])))), 1);
}

#[test]
fn long_after_the_last_answer_a_late_one_is_no_other_to_it() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    line.now += Span::from_secs(1);
    assert_eq!(sent(&mut line, |line| drop(taken(line.ask(1, OTHER, &[&[(60, value(8))]])))), 1);
}

#[test]
fn two_answers_in_one_piece_are_not_believed_under_a_stop_either() {
    let mut line = once();
    line.master.set_limits(Limits { retries: 0, insist: Some(crate::exchange::INSIST), ..Limits::default() });
    let both: &[(u64, Vec<u8>)] = &[(10, [value(8), value(9)].concat())];
    let again: &[(u64, Vec<u8>)] = &[(10, value(9))];
    assert_eq!(taken(line.ask(1, READ, &[both, again, again, again])), Reply::Registers(vec![9]));
}

#[test]
fn how_soon_a_fence_is_answered_says_nothing_of_questions() {
    let mut line = once();
    assert!(line.ask(1, READ, &[]).is_err());
    taken(line.ask(1, OTHER, &[&[(30, fence_reply())], &[(10, value(7))], &[(10, value(7))]]));
    let begun = line.now;
    taken(line.ask(1, Request::Diagnostics { sub: 0x0C, data: 0 }, &[&[(6, counted(0x0C, 1))]]));
    assert!(line.now.since(begun) < Span::from_millis(15), "{}", line.now.since(begun));
}

#[test]
fn an_echo_before_an_answer_that_is_waited_upon_is_one() {
    let mut line = once();
    let echo = |request: &Request| rtu::encode(1, &request.encode());
    taken(line.ask(1, READ, &[&[(20, [echo(&READ), value(1390)].concat())]]));
    let fence = Request::Diagnostics { sub: 0x0B, data: 0 };
    let replies: [&[(u64, Vec<u8>)]; 3] = [
        &[(6, [echo(&OTHER), value(8)].concat()), (20, value(8))],
        &[(20, [echo(&fence), fence_reply()].concat())],
        &[(20, [echo(&OTHER), value(9)].concat())],
    ];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![9]));
    assert_eq!((line.master.echoes(), line.master.tally().echoes), (Some(true), 4));
}

#[test]
fn what_is_new_takes_the_place_of_a_copy_and_is_decided_upon_when_its_time_comes() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(20, value(1390))]]));
    line.master.heard.sees_surplus(1);
    let begun = line.now;
    let copy_first = [(3, value(1390)), (8, value(9))];
    let replies: [&[(u64, Vec<u8>)]; 4] = [&copy_first, &[(20, value(9))], &[(20, fence_reply())], &[(20, value(9))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![9]));
    assert!(line.now.since(begun) < Span::from_secs(2), "{}", line.now.since(begun));
}

#[test]
fn what_stands_behind_an_answer_that_came_too_soon_may_be_the_true_one() {
    for (bytes, telegrams) in [(4, 1), (5, 3)] {
        let mut line = once();
        taken(line.ask(1, READ, &[&[(20, value(1390))]]));
        let replies: [&[(u64, Vec<u8>)]; 3] =
            [&[(6, value(8)), (15, vec![0x12; bytes])], &[(10, fence_reply())], &[(10, value(7))]];
        let said = if telegrams == 1 { 8 } else { 7 };
        let asked =
            sent(&mut line, |line| assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![said])));
        assert_eq!(asked, telegrams, "{bytes}");
        line.now += Span::from_secs(1);
        assert!(line.answered(1, READ).is_some());
        assert!(line.verdicts().contains(&Verdict::Garbage));
    }
}

#[test]
fn of_two_answers_none_is_believed_because_it_is_said_again_or_because_it_is_the_second_round() {
    // Sooner than ever, where more comes than was asked for: a single one is asked for again, and then believed.
    let soon: &[(u64, Vec<u8>)] = &[(6, value(8))];
    let one: &[(u64, Vec<u8>)] = &[(3, value(9))];
    let two: &[(u64, Vec<u8>)] = &[(3, value(9)), (6, value(10))];
    for (second, differs) in [(one, false), (two, true)] {
        let mut line = once();
        taken(line.ask(1, READ, &[&[(20, value(1390))]]));
        line.master.heard.sees_surplus(1);
        _ = line.ask(1, OTHER, &[soon, second]);
        assert_eq!((line.master.differs(1), line.master.tally().replies), (differs, if differs { 1 } else { 2 }));
    }
    // The second of the two, which was thrown away, once more: it is none the truer for that.
    let mut line = once();
    let both = [value(8), value(9)].concat();
    assert!(line.ask(1, READ, &[&[(3, both), (6, value(9))]]).is_err());
    assert_eq!((line.master.tally().replies, line.sent.len()), (0, 2));
}

#[test]
fn nothing_is_asked_anew_as_long_as_a_copy_of_the_last_answer_may_come() {
    let mut line = once();
    let both = [value(8), value(9)].concat();
    assert!(line.ask(1, READ, &[&[(7, both), (36, value(9))]]).is_err());
    let asked = line.master.take_records();
    let asked: Vec<_> = asked.iter().filter(|record| record.verdict == Verdict::Request).collect();
    let last = asked[0].at + line.master.line.chars(asked[0].bytes.len() as u64) + Span::from_millis(36);
    assert_eq!(asked[1].at, last + COPY_WITHIN);
}

#[test]
fn an_adapter_gives_a_telegram_back_once_and_the_same_once_more_is_an_answer() {
    let mut line = once();
    line.master.twins.suspects(1);
    let echo = counted(0x0B, 0);
    _ = line.ask(1, OTHER, &[&[(6, echo.clone()), (12, [counted(0x0B, 6), echo].concat())]]);
    assert!(line.master.differs(1) && line.master.tally().replies == 0, "{:?}", line.verdicts());
}

#[test]
fn what_may_answer_one_of_two_questions_is_no_other_answer_to_the_first() {
    let spoilt = [&[0x55; 6][..], &value(7)].concat();
    // Somebody else asks the same station meanwhile, and is answered.
    let foreign = (30, rtu::encode(1, &OTHER.encode()));
    for (between, differs) in [(vec![], true), (vec![foreign], false)] {
        let mut line = once();
        let replies = [vec![(10, spoilt.clone())], [between, vec![(90, value(9))]].concat()];
        _ = line.ask(1, READ, &[&replies[0], &replies[1]]);
        assert_eq!(line.master.differs(1), differs, "{:?}", line.verdicts());
    }
}
