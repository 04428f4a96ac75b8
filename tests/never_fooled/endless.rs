//! Every conversation ends in time, whatever the line says: an adversary owns it and puts any bytes on it at any time. In
//! virtual time, by dice with a seed.

use super::adversary::{Adversary, MANNERS, Manner};
use super::dice::Dice;
use antrieb::exchange::survey::Patience;
use antrieb::exchange::{Conversation, INSIST, Limits, Master, News, Question, Step, Survey};
use antrieb::protocol::Protocol;
use antrieb::protocol::can::sdo;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::protocol::modbus::pdu::Request;
use antrieb::protocol::vabus::{self, Address, Data, Header, ParamNumber};
use antrieb::tick::{Span, Tick};

/// Steps at one and the same time after which a conversation runs in circles.
const MOST_AT_ONCE: u32 = 200;

/// Carries a conversation on until it has something to tell; the first telegram is noted.
fn pump<C: Conversation>(talk: &mut C, adversary: &mut Adversary, now: &mut Tick, by: Tick) -> (C::End, Option<Tick>) {
    let (mut sent, mut at_once) = (None, 0);
    loop {
        let before = *now;
        match talk.step(*now) {
            Step::Done(end) => return (end, sent),
            Step::Send(bytes) => {
                sent = sent.or(Some(*now));
                adversary.hears(*now, &bytes);
            }
            Step::Wait(until) => match adversary.speaks(*now, until) {
                Some((at, bytes)) => {
                    *now = at;
                    talk.feed(at, &bytes);
                }
                None => *now = until.max(*now),
            },
        }
        at_once = if *now > before { 0 } else { at_once + 1 };
        assert!(at_once < MOST_AT_ONCE, "it runs in circles at {now:?}");
        assert!(*now <= by, "it is {:?} late", now.since(by));
    }
}

/// Every kind of question, reads first.
fn questions(protocol: Protocol) -> Vec<Question> {
    if protocol == Protocol::Vabus {
        let address = Address::drive(1).unwrap();
        let header = |number| Header { number: ParamNumber::new(number).unwrap(), ..Header::default() };
        let enquiry = |number| vabus::Request::Enquiry { address, header: header(number) };
        let select = vabus::Request::Select { address, header: header(410), data: Data::word(7) };
        return vec![enquiry(372).into(), enquiry(11).into(), enquiry(411).into(), select.into()];
    }
    [
        Request::ReadRegisters { start: 0x2174, count: 1 },
        Request::ReadRegisters { start: 0x0101, count: 1 },
        Request::ReadLong { address: 0x01E1 },
        Request::ReadIdentification { category: 1, object: 0 },
        Request::Diagnostics { sub: 0x0B, data: 0 },
        Request::WriteRegister { address: 410, value: 7 },
        Request::WriteRegisters { start: 6914, values: vec![0, 7] },
        Request::WriteLong { address: 480, value: 1_000 },
    ]
    .map(Question::from)
    .into()
}

fn limits(dice: &mut Dice) -> Limits {
    Limits {
        reply_timeout: Span::from_millis(dice.pick(&[20, 100, 500])),
        retries: dice.below(3) as u8,
        insist: dice.one_in(4).then_some(INSIST),
        ..Limits::default()
    }
}

/// Some questions one after the other: what one of them leaves open, the next has to part from its own answer.
fn interrogate(protocol: Protocol, manner: Manner, seed: u64, asked: u64) -> Master {
    let mut dice = Dice::new(seed);
    let line = protocol.line(dice.pick(&[9_600, 19_200, 38_400]), Parity::Even);
    let mut master = Master::new(protocol, line, Limits::default());
    master.set_wired(dice.one_in(2));
    let mut adversary = Adversary::new(protocol, line, manner, Dice::new(seed + 1));
    let (questions, mut now) = (questions(protocol), Tick::ZERO);
    for _ in 0..asked {
        let question = &questions[dice.below(questions.len() as u64) as usize];
        let (limits, station) = (limits(&mut dice), dice.pick(&[1, 1, 1, 9]));
        if dice.one_in(5) {
            master.expect(1, questions[0].clone(), now);
        }
        let began = now;
        master.ask_within(if protocol == Protocol::Vabus { 1 } else { station }, question.clone(), limits, now);
        if dice.one_in(8) {
            // Given up in the middle, as Ctrl-C does; the next question comes on top of it.
            master.step(now);
            continue;
        }
        let by = now + limits.longest(protocol, line);
        let (_, sent) = pump(&mut master, &mut adversary, &mut now, by);
        if question.is_write() && limits.insist.is_some() {
            let within = INSIST + longest_telegram(protocol, line);
            assert!(sent.is_some_and(|at| at.since(began) <= within), "a stop waited: {sent:?} from {began:?}");
        }
        master.take_records();
    }
    master
}

fn longest_telegram(protocol: Protocol, line: LineSetting) -> Span {
    if protocol.name() == "mbtcp" { Span::ZERO } else { line.chars(24) }
}

/// Seeds; more of them with `ANTRIEB_TRIAL=50`.
#[expect(clippy::disallowed_methods, reason = "a variable is how a test is told to take its time")]
fn seeds() -> u64 {
    std::env::var("ANTRIEB_TRIAL").ok().and_then(|text| text.parse().ok()).unwrap_or(4)
}

#[test]
fn every_question_ends_within_its_bound_whatever_the_line_says() {
    let mut count = 0;
    for protocol in Protocol::ALL {
        for manner in MANNERS {
            for seed in 0..seeds() {
                interrogate(protocol, manner, seed, 4);
                count += 4;
            }
        }
    }
    println!("{count} questions to an adversary");
}

/// What a master remembers of a line does not grow with the time that the line babbles.
#[test]
fn what_is_remembered_of_a_babbling_line_is_bounded() {
    for protocol in Protocol::ALL {
        for manner in [Manner::Flood, Manner::Digits, Manner::Master, Manner::Answers, Manner::Mixed] {
            let size = |asked| format!("{:?}", interrogate(protocol, manner, 5, asked)).len();
            let (little, much) = (size(3), size(9));
            assert!(much < 400_000, "{protocol} {manner:?}: {little} then {much} characters");
        }
    }
}

/// A survey of so many stations ends within so many rounds of its longest windows.
#[test]
fn every_survey_ends_whatever_the_line_says() {
    const STATIONS: u8 = 4;
    let mut longest = Span::ZERO;
    for protocol in Protocol::ALL {
        for manner in MANNERS {
            for seed in 0..seeds() {
                let mut dice = Dice::new(seed);
                let line = protocol.line(dice.pick(&[9_600, 19_200, 38_400]), Parity::Even);
                let full = Span::from_millis(dice.pick(&[50, 500]));
                let question = questions(protocol).remove(0);
                let mut patience = match dice.below(3) {
                    0 => Patience::brief(protocol, line, &question, full),
                    1 => Patience::quick(protocol, line, &question, full),
                    _ => Patience::by_the_book(full),
                };
                (patience.yields, patience.twice) = (dice.one_in(2), dice.below(4) as usize);
                let asked = (1..=STATIONS).map(|station| (station, asks(protocol, station)));
                let mut survey = Survey::new(protocol, line, asked, patience, Tick::ZERO);
                let mut adversary = Adversary::new(protocol, line, manner, Dice::new(seed + 77));
                // A line may be held for a second before each of 17 rounds' questions, and no longer.
                let each = full + Span::from_millis(1_300) + line.chars(64);
                let by = Tick::ZERO + each.times(u64::from(STATIONS) * 17 + 17);
                let mut now = Tick::ZERO;
                let mut told = 0;
                while pump(&mut survey, &mut adversary, &mut now, by).0 != News::Over {
                    told += 1;
                    assert!(told < 1_000, "{protocol} {manner:?}: it tells news for ever");
                    survey.take_records();
                }
                longest = longest.max(now.since(Tick::ZERO));
            }
        }
    }
    println!("the longest survey of {STATIONS} stations took {longest}");
}

fn asks(protocol: Protocol, station: u8) -> Question {
    match protocol {
        Protocol::Vabus => {
            let header = Header { number: ParamNumber::new(411).unwrap(), ..Header::default() };
            vabus::Request::Enquiry { address: Address::drive(station).unwrap(), header }.into()
        }
        Protocol::Sdo(_) => sdo::Request::Upload(sdo::Multiplexer { index: 411, sub: 0 }).into(),
        Protocol::Pkw => unreachable!("a block of a slave goes over no line of characters"),
        Protocol::Modbus(_) => Request::ReadRegisters { start: 411, count: 1 }.into(),
    }
}
