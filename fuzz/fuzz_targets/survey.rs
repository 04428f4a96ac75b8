//! A whole line asked at once, with the line in the fuzzer's hand: it ends.
#![no_main]

use antrieb::exchange::survey::Patience;
use antrieb::exchange::{News, Question, Survey};
use antrieb::protocol::modbus::{Framing, pdu::Request};
use antrieb::protocol::{Protocol, line::Parity};
use antrieb::tick::{Span, Tick};
use antrieb_fuzz::{Line, carry};
use libfuzzer_sys::fuzz_target;

const STATIONS: u8 = 4;

fuzz_target!(|said: (bool, Vec<u8>)| {
    let (quick, said) = said;
    let protocol = Protocol::Modbus(Framing::Rtu);
    let line = protocol.line(19_200, Parity::Even);
    let question = Question::from(Request::ReadRegisters { start: 411, count: 1 });
    let full = Span::from_millis(500);
    let patience = if quick { Patience::quick(protocol, line, &question, full) } else { Patience::by_the_book(full) };
    let asked = (1..=STATIONS).map(|station| (station, question.clone()));
    let mut survey = Survey::new(protocol, line, asked, patience, Tick::ZERO);
    let mut line_of = Line::new(said);
    let mut now = Tick::ZERO;
    // A line may be held for a second before each question of 17 rounds, and no longer.
    let longest = (full + Span::from_millis(1_300) + line.chars(64)).times(u64::from(STATIONS) * 17 + 17);
    for told in 0.. {
        assert!(told < 1_000, "it tells news for ever");
        if carry(&mut survey, &mut line_of, &mut now, longest) == News::Over {
            return;
        }
        survey.take_records();
    }
});
