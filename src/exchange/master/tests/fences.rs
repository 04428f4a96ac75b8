//! How a question is kept apart from replies that its station still owes.

use super::*;

#[test]
fn a_late_reply_is_never_credited_to_the_next_question() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    // The reply to READ comes 700 ms after it was asked, in the middle of the next question.
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let outcome = line.ask(1, OTHER, &[&[(210, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    let verdicts = line.verdicts();
    assert!(verdicts.contains(&Verdict::Fence), "{verdicts:?}");
    assert!(verdicts.contains(&Verdict::Stray { station: 1 }), "{verdicts:?}");
    // Behind the fence there is no doubt any more.
    assert_eq!(taken(line.ask(1, READ, &[&[(10, value(1390))]])), Reply::Registers(vec![1390]));
    assert_eq!(line.master.tally().fences, 1);
}

#[test]
fn a_fence_is_never_one_of_the_missing_questions() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let counter = |sub| Request::Diagnostics { sub, data: 0 };
    let counted = |sub, data| frame(1, &Reply::Diagnostics { sub, data });
    assert!(line.ask(1, counter(0x0B), &[]).is_err());
    assert!(line.ask(1, READ, &[]).is_err());
    let late = counted(0x0B, 99);
    let outcome = line.ask(1, OTHER, &[&[(10, late), (60, counted(0x0E, 5))], &[(10, value(7))], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_question_that_cannot_be_confused_needs_no_fence() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let long = Request::ReadLong { address: 210 };
    let outcome = line.ask(1, long, &[&[(300, frame(1, &Reply::Long(5000)))]]);
    assert_eq!(taken(outcome), Reply::Long(5000));
    assert_eq!((line.master.tally().fences, line.master.tally().strays), (0, 1));
}

#[test]
fn a_refusal_that_may_be_old_is_nobodys() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let refused = Reply::Exception { function: 3, code: Exception::DeviceFailure };
    assert!(line.ask(1, READ, &[&[(650, frame(1, &refused))]]).is_err());
    let outcome = line.ask(1, OTHER, &[&[(300, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn what_was_answered_by_a_value_before_may_be_refused_late_all_the_same() {
    let mut line = Line::new(Framing::Rtu);
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    let refusal = frame(1, &Reply::Exception { function: 3, code: Exception::DeviceFailure });
    let replies: [&[(u64, Vec<u8>)]; 2] = [&[(10, refusal), (20, fence_reply())], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn a_write_is_told_from_an_older_one_by_its_echo_and_needs_no_fence() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let write = |value| Request::WriteRegister { address: 410, value };
    let echo = |value| rtu::encode(1, &write(value).encode());
    assert!(line.ask(1, write(15), &[&[(700, echo(15))]]).is_err());
    // The stop goes out at once, and the late echo of the start is not its own.
    let begun = line.now;
    assert!(line.ask(1, write(2), &[&[(300, echo(2))]]).is_ok());
    assert!(line.now.since(begun) < Span::from_millis(320));
    assert_eq!((line.master.tally().fences, line.master.tally().strays), (0, 1));
}

#[test]
fn a_write_goes_out_at_once_and_an_answer_that_may_be_old_does_not_prove_it() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    // Code 16 answers with start and count only: the late answer to the start looks like that to the stop.
    let write = |value| Request::WriteRegisters { start: 6914, values: vec![0, value] };
    let written = || frame(1, &Reply::RegistersWritten { start: 6914, count: 2 });
    assert!(line.ask(1, write(15), &[&[(700, written())]]).is_err());
    let begun = (line.now, line.sent.len());
    let outcome = line.ask(1, write(7), &[&[(400, written())], &[(10, fence_reply())], &[(10, written())]]);
    assert!(outcome.is_ok(), "{outcome:?}");
    let stop = rtu::encode(1, &write(7).encode());
    assert_eq!(line.sent[begun.1], stop, "the first telegram is the stop itself");
    assert_eq!((line.sent.last(), line.master.tally().fences), (Some(&stop), 1));
}

#[test]
fn a_refusal_that_may_be_an_older_one_is_asked_about_again() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    taken(line.ask(1, READ, &[&[(10, value(1390))]]));
    let write = |value| Request::WriteRegister { address: 410, value };
    let echo = rtu::encode(1, &write(2).encode());
    let refused = frame(1, &Reply::Exception { function: 6, code: Exception::DeviceFailure });
    assert!(line.ask(1, write(15), &[&[(700, refused)]]).is_err());
    let outcome = line.ask(1, write(2), &[&[(300, echo.clone())], &[(10, fence_reply())], &[(10, echo)]]);
    assert_eq!(taken(outcome), Reply::RegisterWritten { address: 410, value: 2 });
    assert_eq!(line.master.tally().fences, 1);
}

#[test]
fn the_echo_of_a_fence_settles_nothing() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let echo = frame(1, &Reply::Diagnostics { sub: 0x0B, data: 0 });
    let outcome = line.ask(1, OTHER, &[&[(1, echo), (300, fence_reply())], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_late_refusal_of_another_counter_settles_nothing() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let counter = |sub| Request::Diagnostics { sub, data: 0 };
    assert!(line.ask(1, counter(0x0B), &[]).is_err());
    assert!(line.ask(1, READ, &[]).is_err());
    // The refusal is of the first counter; the value is the late one of READ, and comes behind it.
    let refused = frame(1, &Reply::Exception { function: 8, code: Exception::IllegalFunction });
    let counted = frame(1, &Reply::Diagnostics { sub: 0x0E, data: 5 });
    let outcome = line.ask(1, OTHER, &[&[(10, refused), (40, value(1390)), (60, counted)], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
}

#[test]
fn a_station_of_unknown_family_is_asked_only_for_counters_that_all_have() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let counter = Request::Diagnostics { sub: 0x0B, data: 0 };
    assert!(line.ask(2, READ, &[]).is_err());
    assert!(line.ask(2, counter, &[]).is_err());
    assert!(line.ask(2, OTHER, &[]).is_err());
    let reserved =
        |sent: &Vec<u8>| sent.get(1..4).is_some_and(|pdu| [[8, 0, 14], [8, 0, 15]].contains(&[pdu[0], pdu[1], pdu[2]]));
    assert!(!line.sent.iter().any(reserved), "{:?}", line.sent);
}

#[test]
fn a_station_that_counts_nothing_is_parted_by_time() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[]).is_err());
    let zero = |sub| [(10, frame(1, &Reply::Diagnostics { sub, data: 0 }))];
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&zero(0x0B), &zero(0x0E), &zero(0x0E), &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert!(line.now.since(begun) > Span::from_secs(6));
}

#[test]
fn numbered_transactions_need_no_fences() {
    let mut line = Line::new(Framing::Tcp);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let reply = |number, value| mbap::encode(number, 1, &Reply::Registers(vec![value]).encode());
    assert!(line.ask(1, READ, &[&[(700, reply(1, 1390))]]).is_err());
    let outcome = line.ask(1, OTHER, &[&[(400, reply(2, 7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert_eq!((line.master.tally().fences, line.master.tally().strays), (0, 1));
}

/// One telegram lost on the line behind a gateway spoils no reading of a station that is there; a write is never repeated, and
/// a station that was never reached is asked once.
#[test]
fn a_gateway_that_lost_a_reply_is_asked_once_more() {
    let mut line = Line::new(Framing::Tcp);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let reply = |number, value| [(10, mbap::encode(number, 1, &Reply::Registers(vec![value]).encode()))];
    let unreached = |number, function| {
        let said = Reply::Exception { function, code: Exception::GatewayTarget };
        [(10, mbap::encode(number, 1, &said.encode()))]
    };
    assert_eq!(line.ask(1, READ, &[&unreached(1, 3), &reply(2, 1)]), Err(ExchangeError::Unreached));
    assert_eq!(line.master.tally().silences, 1);
    assert!(line.ask(1, READ, &[&reply(2, 1390)]).is_ok());
    assert_eq!(taken(line.ask(1, READ, &[&unreached(3, 3), &reply(4, 1391)])), Reply::Registers(vec![1391]));
    assert_eq!(line.ask(1, READ, &[&unreached(5, 3), &unreached(6, 3), &reply(7, 7)]), Err(ExchangeError::Unreached));
    let write = Request::WriteRegister { address: 0x2174, value: 1 };
    assert_eq!(line.ask(1, write, &[&unreached(7, 6), &reply(8, 7)]), Err(ExchangeError::Unreached));
}

#[test]
fn vabus_ends_its_exchanges_and_parts_replies_by_what_was_answered_before() {
    let mut line = Line::vabus();
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let enquiry = |number| {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        vabus::Request::Enquiry { address: Address::drive(1).unwrap(), header }
    };
    let told = |number, bits| {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        vabus::Reply::Value { address: Address::drive(1).unwrap(), header, data: Data::word(bits) }.encode()
    };
    let nak = vabus::Reply::Nak { address: Address::drive(1).unwrap() }.encode();
    assert!(line.ask(1, enquiry(411), &[&[(10, told(411, 0x40))]]).is_ok());
    assert_eq!(line.sent.last(), Some(&vec![vabus::EOT]));
    // The NAK to the second question comes while the third is asked: it is not the third one's.
    assert!(line.ask(1, enquiry(484), &[&[(650, nak)]]).is_err());
    let outcome = line.ask(1, enquiry(372), &[&[], &[(10, told(411, 0x40))], &[(10, told(372, 1390))]]);
    let Ok(Answer::Reply { said: Said::Vabus(reply), .. }) = outcome else { panic!("{outcome:?}") };
    assert_eq!(reply.encode(), told(372, 1390));
    assert_eq!(line.master.tally().fences, 1);
}

#[test]
fn another_fence_each_time_tells_its_answer_from_a_late_one() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 1, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    // The first fence is answered only after the second was sent; the reply to the second comes later still.
    let second = frame(1, &Reply::Diagnostics { sub: 0x0E, data: 9 });
    let outcome = line.ask(
        1,
        OTHER,
        &[&[(700, fence_reply())], &[(400, second)], &[(10, value(7))], &[(10, value(7))], &[(10, value(7))]],
    );
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert_eq!(line.master.owes_until(line.now), None);
}

#[test]
fn a_vabus_drive_that_always_answers_after_600_ms_is_understood() {
    let mut line = Line::vabus();
    let address = Address::drive(1).unwrap();
    let header = |number| Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
    let enquiry = |number| vabus::Request::Enquiry { address, header: header(number) };
    let told = |number| vabus::Reply::Value { address, header: header(number), data: Data::word(7) }.encode();
    let nak = || vabus::Reply::Nak { address }.encode();
    let rows = [(411, false), (484, true), (412, true), (372, false), (484, true)];
    for (number, refused) in rows {
        let begun = (line.now, line.sent.len());
        let outcome = line.ask_of(1, enquiry(number), |sent| match vabus::Request::decode(sent) {
            Ok(vabus::Request::Enquiry { header, .. }) => {
                let number = header.number.get();
                vec![(600, if rows.contains(&(number, true)) { nak() } else { told(number) })]
            }
            _ => Vec::new(),
        });
        let Ok(Answer::Reply { said, .. }) = outcome else { panic!("{number}: {outcome:?}") };
        assert_eq!(said.is_refusal(), refused, "{number}: {said:?}");
        assert!(line.now.since(begun.0) < Span::from_secs(10), "{number}: {}", line.now.since(begun.0));
        assert!(line.sent.len() - begun.1 < 14, "{number}: {}", line.sent.len() - begun.1);
    }
}

/// Its replies meet the questions to another one, and tell how late it is.
#[test]
fn a_station_that_is_late_again_and_again_is_waited_for() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let answers = |line: &mut Line, station, after| {
        let outcome = line.ask_of(station, READ, |sent| {
            let reply = match Request::decode(&rtu::decode(sent).unwrap().pdu).unwrap() {
                Request::Diagnostics { sub, data } => Reply::Diagnostics { sub, data },
                _ => Reply::Registers(vec![station.into()]),
            };
            vec![(after, frame(station, &reply))]
        });
        outcome.is_ok()
    };
    let rounds = [(); 4].map(|()| [answers(&mut line, 1, 700), answers(&mut line, 2, 300)]);
    assert_eq!(rounds, [[false, true], [false, true], [true, true], [true, true]]);
}

#[test]
fn another_station_is_asked_without_a_fence() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    let own = frame(2, &Reply::Registers(vec![5]));
    let outcome = line.ask(2, OTHER, &[&[(5, value(1390)), (30, own)]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![5]));
    assert_eq!(line.master.tally().fences, 0);
}

#[test]
fn a_reply_that_a_fence_has_overtaken_is_never_a_value() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    // The reply to READ comes 700 ms after it was asked, behind the fence's, and the answer to OTHER later still.
    assert!(line.ask(1, READ, &[&[(700, value(1390))]]).is_err());
    let replies: [&[(u64, Vec<u8>)]; 6] = [
        &[(10, fence_reply())],
        &[(300, value(7))],
        &[(10, value(7))],
        &[(10, fence_reply())],
        &[(10, value(7))],
        &[(10, value(7))],
    ];
    assert_eq!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(vec![7]));
}

#[test]
fn a_value_that_changes_is_read_behind_a_lost_reply_all_the_same() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[]).is_err());
    let replies: [&[(u64, Vec<u8>)]; 6] = [
        &[(10, fence_reply())],
        &[(10, value(1))],
        &[(10, value(2))],
        &[(10, value(3))],
        &[(10, value(4))],
        &[(10, value(5))],
    ];
    assert!(matches!(taken(line.ask(1, OTHER, &replies)), Reply::Registers(_)));
    assert!(line.now < Tick::from_micros(1_800_000), "nothing waits for what never comes");
}

/// Behind a gateway a fence proves nothing: the replies to two questions that were lost come behind it, in place of the answer.
#[test]
fn where_nothing_keeps_replies_in_order_none_of_three_is_believed() {
    let replies: [&[(u64, Vec<u8>)]; 5] =
        [&[(10, fence_reply())], &[(10, value(7))], &[(10, value(1))], &[(10, value(2))], &[(10, value(7))]];
    let outcome = |wired| {
        let mut line = Line::new(Framing::Rtu);
        line.master.set_wired(wired);
        line.master.set_limits(Limits { retries: 0, ..Limits::default() });
        let read = |start| Request::ReadRegisters { start, count: 1 };
        assert!(line.ask(1, read(1), &[]).is_err());
        assert!(line.ask(1, read(2), &[&[(10, fence_reply())], &[]]).is_err());
        line.now += Span::from_secs(1);
        line.ask(1, OTHER, &replies)
    };
    assert!(matches!(outcome(false), Err(ExchangeError::Unproven { .. })));
    // Wires keep the order: this is a value that changes.
    assert_eq!(taken(outcome(true)), Reply::Registers(vec![2]));
}

/// Two whole telegrams of another station in one piece are no spoilt reply: that is still to come.
#[test]
fn what_others_say_in_one_piece_is_not_the_answer_spoilt() {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    let others = [frame(3, &Reply::Registers(vec![1])), frame(3, &Reply::Registers(vec![2]))].concat();
    assert!(matches!(line.ask(1, READ, &[&[(20, others)]]), Err(ExchangeError::Stray { station: 3 })));
    assert!(line.master.debts.is_late(1, Some(&Said::Modbus(Reply::Registers(vec![7])))));
}

#[test]
fn a_counter_that_stands_at_0_is_a_fence_on_a_line_without_echo() {
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x12]);
    assert!(line.ask(1, READ, &[&[(10, value(1390))]]).is_ok());
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    let stands = frame(1, &Reply::Diagnostics { sub: 0x12, data: 0 });
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&[(10, stands)], &[(10, value(7))], &[(10, value(7))]]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert!(line.now.since(begun) < Span::from_millis(700), "an answered fence is not waited for again");
}

#[test]
fn a_counter_that_stands_at_0_is_a_fence_behind_its_echo_too() {
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x12]);
    let echo = |request: &Request| rtu::encode(1, &request.encode());
    assert!(line.ask(1, READ, &[&[(0, echo(&READ)), (10, value(1390))]]).is_ok());
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(0, echo(&READ))]]).is_err());
    let stands = frame(1, &Reply::Diagnostics { sub: 0x12, data: 0 });
    let answer = [(0, echo(&OTHER)), (10, value(7))];
    let begun = line.now;
    let outcome = line.ask(1, OTHER, &[&[(0, stands.clone()), (10, stands)], &answer, &answer]);
    assert_eq!(taken(outcome), Reply::Registers(vec![7]));
    assert!(line.now.since(begun) < Span::from_millis(700), "an answered fence is not waited for again");
}

#[test]
fn behind_a_silence_that_took_every_fence_a_value_is_believed_within_seconds() {
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x0B, 0x0C, 0x12]);
    let insist = Some(crate::exchange::INSIST);
    line.master.set_limits(Limits { insist, reply_timeout: Span::from_millis(250), ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(10, value(1390))]]).is_ok());
    for _ in 0..6 {
        assert!(line.ask(1, OTHER, &[]).is_err());
        assert!(line.ask(1, READ, &[]).is_err());
        assert!(line.ask(1, Request::WriteRegister { address: 410, value: 2 }, &[]).is_err());
    }
    let begun = line.now;
    // From now on the station answers everything.
    let believed = (0..60).find_map(|_| line.answered(1, if line.sent.len().is_multiple_of(2) { OTHER } else { READ }));
    assert!(believed.is_some() && line.now.since(begun) < Span::from_secs(5), "{believed:?} {}", line.now.since(begun));
}

#[test]
fn a_late_answer_from_before_a_write_proves_nothing_of_it() {
    let mut line = Line::new(Framing::Rtu);
    assert!(line.ask(1, READ, &[&[(10, value(1))]]).is_ok());
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    // Its reply comes when the same is asked again.
    assert!(line.ask(1, READ, &[&[(620, value(1))]]).is_err());
    let write = Request::WriteRegister { address: 0x4178, value: 15 };
    assert!(line.ask(1, write.clone(), &[&[(10, rtu::encode(1, &write.encode()))]]).is_ok());
    let since = Some(line.now);
    line.master.set_limits(Limits { retries: 0, since, ..Limits::default() });
    let answers: [&[(u64, Vec<u8>)]; 4] =
        [&[(110, fence_reply())], &[(10, value(2))], &[(10, value(2))], &[(10, value(2))]];
    assert_eq!(taken(line.ask(1, READ, &answers)), Reply::Registers(vec![2]));
    // Without a word of it an older answer will do. (Right behind an answer a loss would be a sign of a second drive.)
    line.now += Span::from_secs(2);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[&[(620, value(2))]]).is_err());
    assert_eq!(taken(line.ask(1, READ, &[&[(200, value(3))]])), Reply::Registers(vec![2]));
}
