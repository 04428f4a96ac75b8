//! Who may be two, who is beside us, and answers that must be said again.

use super::*;
use crate::exchange::INSIST;

fn once() -> Line {
    let mut line = Line::new(Framing::Rtu);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    line
}

fn counted(sub: u16, data: u16) -> Vec<u8> {
    frame(1, &Reply::Diagnostics { sub, data })
}

const MORE: Span = Span::from_micros(1);

#[test]
fn two_drives_matter_to_what_is_read_and_may_be_asked_again() {
    let line = once();
    let write = Request::WriteRegister { address: 410, value: 2 };
    let told = |request: &Request, limits| line.master.is_told_apart(&request.clone().into(), limits);
    let (plain, insist) = (Limits::default(), Limits { insist: Some(INSIST), ..Limits::default() });
    let cleared = Limits { witness: false, ..plain };
    assert_eq!([plain, insist, cleared].map(|limits| told(&READ, limits)), [true, false, false]);
    assert_eq!([plain, insist, cleared].map(|limits| told(&write, limits)), [false; 3]);
}

#[test]
fn who_asked_something_is_gone_after_five_seconds() {
    let five = Tick::ZERO + Span::from_secs(5);
    for (at, alone) in [(five, false), (five + MORE, true), (five + Span::from_secs(5), true)] {
        let mut line = once();
        line.master.others = [Some(Tick::ZERO); 2];
        assert_eq!(line.master.is_shared(at), !alone, "{at:?}");
        line.master.suspect(1, at);
        assert_eq!(line.master.twins.is_suspect(1), alone, "{at:?}");
    }
    // A question counts once, whatever comes behind it.
    let mut line = once();
    line.master.feed(line.now, &rtu::encode(9, &OTHER.encode()));
    line.master.feed(line.now, &[0x55]);
    assert!(line.master.others[0].is_some() && !line.master.is_shared(line.now));
}

#[test]
fn two_questions_that_are_lost_right_behind_an_answer_are_a_sign_of_a_second_drive() {
    for (behind, suspect) in [(Span::from_millis(20) - MORE, true), (Span::from_millis(20), false)] {
        let mut line = once();
        for _ in 0..2 {
            assert!(!line.master.twins.is_suspect(1));
            taken(line.ask(1, READ, &[&[(10, value(7))]]));
            line.now += behind;
            assert!(line.ask(1, READ, &[]).is_err());
            line.now += Span::from_secs(8);
        }
        assert_eq!(line.master.twins.is_suspect(1), suspect, "{behind}");
    }
}

/// Everything is answered twice in one piece, with this between.
fn doubled(line: &mut Line, number: u16, between: &[u8]) -> Outcome {
    line.master.ask(1, Request::ReadRegisters { start: number, count: 1 }, line.now);
    loop {
        match line.master.step(line.now) {
            Step::Done(outcome) => return outcome,
            Step::Wait(until) => line.now = until,
            Step::Send(bytes) => {
                line.now += line.master.line.chars(bytes.len() as u64) + Span::from_millis(20);
                let reply = match Request::decode(&rtu::decode(&bytes).unwrap().pdu).unwrap() {
                    Request::Diagnostics { sub, .. } => counted(sub, line.sent.len() as u16),
                    _ => value(100 + number),
                };
                line.sent.push(bytes);
                line.master.feed(line.now, &[&reply[..], between, &reply].concat());
            }
        }
    }
}

#[test]
fn what_answers_everything_twice_is_told() {
    for (between, garbage) in [(&[][..], false), (&[0x55][..], true)] {
        let mut line = once();
        assert!(!line.master.answers_twice(1));
        for number in 1..=3 {
            assert_eq!(taken(doubled(&mut line, number, between)), Reply::Registers(vec![100 + number]));
        }
        assert!(line.master.answers_twice(1) && !line.master.differs(1) && !line.master.answers_twice(2));
        let verdicts = line.verdicts();
        let strays = verdicts.iter().filter(|verdict| matches!(verdict, Verdict::Stray { .. })).count();
        assert_eq!(line.master.tally().strays, strays as u64, "{verdicts:?}");
        let noted = verdicts.iter().filter(|verdict| **verdict == Verdict::Garbage).count();
        assert_eq!(noted, if garbage { strays } else { 0 }, "one before each second answer: {verdicts:?}");
    }
}

#[test]
fn a_second_answer_that_was_listened_for_is_looked_into() {
    let listen = Span::from_millis(60);
    let counter = Request::Diagnostics { sub: 0x0B, data: 0 };
    let mut line = once();
    line.master.set_limits(Limits { retries: 0, listen, ..Limits::default() });
    // In the same words: how many answer is found out by a fence.
    let replies: [&[(u64, Vec<u8>)]; 3] =
        [&[(10, counted(0x0B, 7)), (25, counted(0x0B, 7))], &[(10, counted(0x0E, 9))], &[(10, counted(0x0B, 8))]];
    assert!(line.ask(1, counter.clone(), &replies).is_ok());
    assert_eq!(line.master.tally().fences, 1);
    // Noise is no answer of anybody, and ends nothing.
    let mut line = once();
    line.master.set_limits(Limits { retries: 0, listen, ..Limits::default() });
    let outcome = line.ask(1, counter.clone(), &[&[(10, counted(0x0B, 7)), (20, vec![0x55]), (45, counted(0x0B, 4))]]);
    assert!(matches!(outcome, Err(ExchangeError::TwoAnswers { station: 1 })), "{outcome:?}");
    // And what it leaves behind is noted.
    let mut line = once();
    line.master.set_limits(Limits { retries: 0, listen, ..Limits::default() });
    assert!(line.ask(1, counter.clone(), &[&[(10, counted(0x0B, 7)), (30, vec![0x55])]]).is_ok());
    line.now += Span::from_secs(1);
    assert!(line.ask(1, counter, &[&[(10, counted(0x0B, 8))]]).is_ok());
    assert!(line.verdicts().contains(&Verdict::Garbage));
}

#[test]
fn two_counts_of_one_fence_are_two_drives_unless_it_was_asked_twice() {
    let mut line = once();
    line.master.twins.suspects(1);
    let replies: [&[(u64, Vec<u8>)]; 2] = [&[(10, counted(0x0B, 5)), (25, counted(0x0B, 6))], &[(10, value(7))]];
    assert_eq!(line.ask(1, READ, &replies), Err(ExchangeError::TwoAnswers { station: 1 }));
    let mut line = Line::new(Framing::Rtu);
    line.master.has_counters(1, [0x0E]);
    line.master.twins.suspects(1);
    let replies: [&[(u64, Vec<u8>)]; 3] = [&[], &[(10, counted(0x0E, 5)), (25, counted(0x0E, 6))], &[(10, value(7))]];
    let outcome = line.ask(1, READ, &replies);
    assert!(!matches!(outcome, Err(ExchangeError::TwoAnswers { .. })) && !line.master.differs(1), "{outcome:?}");
}

#[test]
fn who_answered_just_now_is_suspected_with_whom_garbage_met() {
    for (more, suspect) in [(Span::ZERO, false), (MORE, true)] {
        let mut line = once();
        taken(line.ask(2, READ, &[&[(10, frame(2, &Reply::Registers(vec![7])))]]));
        line.now += Span::from_millis(600) - Span::from_millis(36) - line.master.line.chars(8) - more;
        let met = vec![0, 0, 0, 0x12, 0x66, 0x42, 0x10, 0x40];
        _ = line.ask(1, OTHER, &[&[(15, met), (36, value(8))], &[(10, fence_reply())], &[(10, value(8))]]);
        assert_eq!((line.master.twins.is_suspect(1), line.master.twins.is_suspect(2)), (true, suspect), "{more}");
    }
}

#[test]
fn from_before_a_time_only_a_read_without_a_number_can_be() {
    let mut line = once();
    let write = Request::WriteRegister { address: 410, value: 2 };
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    assert!(line.ask(1, write.clone(), &[]).is_err());
    line.master.set_limits(Limits { retries: 0, since: Some(line.now), ..Limits::default() });
    assert!(line.ask(1, write.clone(), &[&[(10, rtu::encode(1, &write.encode()))]]).is_ok());
    assert_eq!(line.sent.len(), 3);
    let mut line = Line::new(Framing::Tcp);
    line.master.set_limits(Limits { retries: 0, ..Limits::default() });
    assert!(line.ask(1, READ, &[]).is_err());
    line.master.set_limits(Limits { retries: 0, since: Some(line.now), ..Limits::default() });
    let said = |number, reply: Reply| [(10, mbap::encode(number, 1, &reply.encode()))];
    let fence = said(2, Reply::Diagnostics { sub: 0x0B, data: 5 });
    let value = said(3, Reply::Registers(vec![7]));
    assert_eq!(taken(line.ask(1, READ, &[&fence, &value])), Reply::Registers(vec![7]));
    assert_eq!(line.sent.len(), 3);
}

#[test]
fn a_little_noise_before_what_is_said_again_vouches_for_a_station() {
    let mut line = once();
    taken(line.ask(1, READ, &[&[(10, value(7))]]));
    for start in [1, 2] {
        assert!(!line.master.twins.has_vouched(1));
        let noisy = [&[0x00][..], &value(7)].concat();
        let fence = counted(0x0B, start);
        let replies: [&[(u64, Vec<u8>)]; 3] = [&[(10, noisy)], &[(10, fence)], &[(10, value(7))]];
        let asked = Request::ReadRegisters { start, count: 1 };
        assert_eq!(taken(line.ask(1, asked, &replies)), Reply::Registers(vec![7]));
    }
    assert!(line.master.twins.has_vouched(1));
}

#[test]
fn the_first_and_the_last_three_harmless_questions_are_known_each_once() {
    let mut line = Line::vabus();
    let address = Address::drive(1).unwrap();
    for number in [30, 249, 250, 411, 412, 411] {
        let header = Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        let reply = vabus::Reply::Value { address, header, data: Data::word(number) };
        assert!(line.ask(1, vabus::Request::Enquiry { address, header }, &[&[(10, reply.encode())]]).is_ok());
    }
    let numbers = line.master.known[&1].iter().map(|known| match known {
        Question::Vabus(vabus::Request::Enquiry { header, .. }) => header.number.get(),
        other => panic!("{other:?}"),
    });
    assert_eq!(numbers.collect::<Vec<_>>(), [411, 412, 250, 30]);
}

/// A line on which the answer to this was overtaken, and that is known to mix telegrams up, or not.
fn overtaken(question: &Request, mixes: bool) -> Line {
    let mut line = once();
    let debts = &mut line.master.debts;
    if mixes {
        debts.owes(9, READ.into(), line.now, line.now);
        debts.settle(9, line.now, line.now);
        assert!(debts.arrives(9, &Said::Modbus(Reply::Registers(vec![1])), line.now));
    }
    debts.owes(1, question.clone().into(), line.now, line.now);
    debts.settle(1, line.now, line.now);
    assert_eq!(line.master.debts.mixes(), mixes);
    line
}

#[test]
fn where_telegrams_are_mixed_up_an_older_answer_to_the_same_must_be_said_again() {
    for (mixes, since, telegrams) in [(true, Some(0), 2), (false, Some(0), 1), (true, None, 1)] {
        let mut line = overtaken(&READ, mixes);
        let since = since.map(Tick::from_micros);
        line.master.set_limits(Limits { retries: 0, since, ..Limits::default() });
        let answer: &[(u64, Vec<u8>)] = &[(10, value(7))];
        assert_eq!(taken(line.ask(1, READ, &[answer, answer, answer])), Reply::Registers(vec![7]));
        assert_eq!(line.sent.len(), telegrams, "{mixes} {since:?}");
    }
    // What was missed later than that is not from before it.
    let mut line = overtaken(&READ, true);
    line.master.debts.owes(1, READ.into(), Tick::from_micros(5), Tick::from_micros(5));
    line.master.debts.settle(1, Tick::from_micros(5), Tick::from_micros(5));
    line.master.set_limits(Limits { retries: 0, since: Some(Tick::ZERO), ..Limits::default() });
    let answer: &[(u64, Vec<u8>)] = &[(10, value(7))];
    assert_eq!(taken(line.ask(1, READ, &[answer, answer, answer])), Reply::Registers(vec![7]));
    assert_eq!(line.sent.len(), 2, "one of the two may be it");
}

#[test]
fn a_refusal_that_may_be_an_overtaken_one_must_be_said_again() {
    let mut line = overtaken(&READ, false);
    let refused: &[(u64, Vec<u8>)] =
        &[(10, frame(1, &Reply::Exception { function: 3, code: Exception::DeviceFailure }))];
    assert!(line.ask(1, OTHER, &[refused, refused]).is_ok());
    assert_eq!(line.sent.len(), 2);
}

#[test]
fn answers_that_never_agree_are_waited_out_where_telegrams_are_mixed_up_and_not_under_a_stop() {
    let answers: Vec<[(u64, Vec<u8>); 1]> = (1..9).map(|number| [(10, value(number))]).collect();
    let answers: Vec<&[(u64, Vec<u8>)]> = answers.iter().map(|answer| &answer[..]).collect();
    let mut line = overtaken(&READ, true);
    assert_eq!(taken(line.ask(1, OTHER, &answers)), Reply::Registers(vec![4]), "when nothing old can come any more");
    assert!(line.now > Tick::from_micros(7_000_000) && line.sent.len() == 4);
    let mut line = overtaken(&READ, true);
    line.master.set_limits(Limits { retries: 0, insist: Some(INSIST), ..Limits::default() });
    assert!(matches!(line.ask(1, OTHER, &answers), Err(ExchangeError::Unproven { .. })));
    assert!(line.now < Tick::from_micros(1_000_000) && line.sent.len() == 3);
    // On a line that keeps the order, but brings more than was asked for, nobody waits for what never comes.
    let mut line = overtaken(&READ, false);
    line.master.heard.sees_surplus(1);
    assert!(line.ask(1, OTHER, &answers).is_err());
    assert!(line.now < Tick::from_micros(1_000_000) && line.sent.len() == 3, "{:?}", line.now);
    // Under a stop the last of them will do there.
    let mut line = overtaken(&READ, false);
    line.master.heard.sees_surplus(1);
    line.master.set_limits(Limits { retries: 0, insist: Some(INSIST), ..Limits::default() });
    assert_eq!(taken(line.ask(1, OTHER, &answers)), Reply::Registers(vec![3]));
}

#[test]
fn noise_before_a_second_answer_is_noted_where_it_is_found() {
    let mut line = once();
    line.master.twins.suspects(1);
    let second = [&[0x55][..], &counted(0x0B, 5)].concat();
    let replies: [&[(u64, Vec<u8>)]; 2] = [&[(10, counted(0x0B, 5)), (25, second)], &[(10, value(7))]];
    assert_eq!(taken(line.ask(1, READ, &replies)), Reply::Registers(vec![7]));
    assert!(line.verdicts().contains(&Verdict::Garbage));
}

#[test]
fn a_fence_that_was_asked_twice_proves_nothing_by_its_counts() {
    // The first is answered late, behind the second one, so that nothing is owed any more.
    let late = [counted(0x0E, 0), vec![0x55], counted(0x0E, 6)].concat();
    let value: &[(u64, Vec<u8>)] = &[(10, value(7))];
    // An older count is no second answer; a later one is, but nobody knows to which of the two.
    for (second, likely) in [(5, false), (7, true)] {
        let mut line = Line::new(Framing::Rtu);
        line.master.has_counters(1, [0x0E]);
        line.master.twins.suspects(1);
        let outcome = line.ask(1, READ, &[&[], &[(10, late.clone()), (30, counted(0x0E, second))], value]);
        assert_eq!(taken(outcome), Reply::Registers(vec![7]), "{:?}", line.verdicts());
        assert_eq!((line.master.twins.are_likely(1), line.master.differs(1)), (likely, false), "{second}");
    }
}

#[test]
fn a_count_that_an_older_question_may_have_is_no_second_drives() {
    let value: &[(u64, Vec<u8>)] = &[(10, value(7))];
    for (lost, two) in [(true, false), (false, true)] {
        let mut line = Line::new(Framing::Rtu);
        line.master.has_counters(1, COUNTERS);
        line.master.twins.suspects(1);
        let first: &[(u64, Vec<u8>)] = &[(10, counted(0x0B, 7))];
        let other: &[(u64, Vec<u8>)] = &[(10, counted(0x0E, 4))];
        let replies: &[&[(u64, Vec<u8>)]] = if lost { &[&[], other, value] } else { &[first, value] };
        taken(line.ask(1, READ, replies));
        // The same counter: what was lost comes first.
        let outcome = line.ask(1, OTHER, &[&[(10, counted(0x0B, 8)), (25, counted(0x0B, 9))], value]);
        assert_eq!(matches!(outcome, Err(ExchangeError::TwoAnswers { .. })), two, "{lost}: {outcome:?}");
        assert_eq!(line.master.differs(1), two);
    }
}
