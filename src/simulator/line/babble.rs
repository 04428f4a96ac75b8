//! Somebody who speaks on the line unasked, and what a second drive at one address says.

use super::speech::Spoken;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::Framing;
use crate::protocol::modbus::pdu::{Reply, Request};
use crate::protocol::vabus::{self, Address, Data};
use crate::simulator::dice::Dice;
use crate::tick::{Span, Tick};

/// What is said again and again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Pattern {
    /// These bytes.
    Bytes(Vec<u8>),
    /// 1 to 64 bytes by chance.
    Random,
    /// Hexadecimal digits, as inside a telegram of ASCII or VABus.
    Digits,
    /// Questions to a station that is not there, and its answers in turn.
    Master(Spoken),
}

/// What somebody says, and at which setting; `None`: at that of whoever listens.
pub(crate) type Said = (Vec<u8>, Option<LineSetting>);

/// Somebody who speaks whatever the others do.
#[derive(Clone, Debug)]
pub(crate) struct Babbler {
    pattern: Pattern,
    /// From the end of what is said until it is said again.
    pause: Span,
    /// The same from a question to its answer, where that is another time.
    reply_delay: Option<Span>,
    /// At which setting; `None`: at that of whoever listens.
    line: Option<LineSetting>,
    next: Tick,
    until: Option<Tick>,
    /// The question has been asked; the answer is next.
    asked: bool,
}

/// Whom another master asks: the last address of VABus, so that it is one everywhere.
const STRANGER: u8 = Address::LAST;

impl Babbler {
    pub(crate) fn new(pattern: Pattern, from: Tick, pause: Span, lasts: Option<Span>) -> Self {
        let until = lasts.map(|lasts| from + lasts);
        Babbler { pattern, pause, reply_delay: None, line: None, next: from, until, asked: false }
    }

    /// The same at a setting of its own, with another pause between a question and its answer.
    pub(crate) fn at(self, line: Option<LineSetting>, reply_delay: Option<Span>) -> Self {
        Babbler { line, reply_delay, ..self }
    }

    /// When it speaks next; `None` if never again.
    pub(crate) fn next(&self) -> Option<Tick> {
        Some(self.next).filter(|&next| self.until.is_none_or(|until| next < until))
    }

    /// What it says from now on, to who listens at `line`, and at which setting of its own.
    pub(crate) fn speak(&mut self, now: Tick, line: LineSetting, dice: &mut Dice) -> Option<Said> {
        let line = self.line.unwrap_or(line);
        let bytes = match &self.pattern {
            Pattern::Bytes(bytes) => bytes.clone(),
            Pattern::Random => (0..=dice.below(63)).map(|_| dice.below(256) as u8).collect(),
            Pattern::Digits => (0..16).map(|_| b"0123456789ABCDEF"[dice.below(16) as usize]).collect(),
            Pattern::Master(spoken) => self.telegram(*spoken, dice)?,
        };
        self.asked = !self.asked;
        let pause = self.reply_delay.filter(|_| self.asked).unwrap_or(self.pause);
        self.next = now + line.chars(bytes.len() as u64) + pause.longer(Span::from_micros(1));
        Some((bytes, self.line))
    }

    /// The question or the answer of another master: P.372 of a station far away.
    fn telegram(&self, spoken: Spoken, dice: &mut Dice) -> Option<Vec<u8>> {
        let value = dice.below(0x1_0000) as u16;
        let read = Request::ReadRegisters { start: 372, count: 1 };
        let pdu = if self.asked { Reply::Registers(vec![value]).encode() } else { read.encode() };
        let address = Address::drive(STRANGER)?;
        let header = vabus::Header { number: vabus::ParamNumber::new(372)?, ..vabus::Header::default() };
        Some(match (spoken, self.asked) {
            (Spoken::Modbus(framing), _) => framing.encode(STRANGER, &pdu),
            (Spoken::PBus, _) => Framing::Rtu.encode(STRANGER, &pdu),
            (Spoken::Vabus, false) => vabus::Request::Enquiry { address, header }.encode(),
            (Spoken::Vabus, true) => vabus::Reply::Value { address, header, data: Data::word(value) }.encode(),
        })
    }
}

/// The same reply with other values, from the same station; what carries no value stays.
pub(crate) fn other_value(spoken: Spoken, frame: &[u8]) -> Vec<u8> {
    let other = match spoken {
        Spoken::Modbus(framing) => framing.decode(frame).ok().and_then(|adu| {
            let reply = match Reply::decode(&adu.pdu).ok()? {
                Reply::Registers(values) => {
                    Reply::Registers(values.iter().map(|value| value.wrapping_add(1)).collect())
                }
                Reply::Long(value) => Reply::Long(value.wrapping_add(1)),
                Reply::Diagnostics { sub, data } => Reply::Diagnostics { sub, data: data.wrapping_add(1) },
                _ => return None,
            };
            Some(framing.encode(adu.station, &reply.encode()))
        }),
        Spoken::Vabus => match vabus::Reply::decode(frame) {
            Ok(vabus::Reply::Value { address, header, data }) => {
                let word = data.as_word().map(|word| Data::word(word.wrapping_add(1)));
                let data = word.or_else(|| data.as_long().map(|long| Data::long(long.wrapping_add(1))));
                data.map(|data| vabus::Reply::Value { address, header, data }.encode())
            }
            _ => None,
        },
        Spoken::PBus => None,
    };
    other.unwrap_or_else(|| frame.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

    #[test]
    fn it_speaks_until_its_time_is_over() {
        let lasts = Some(Span::from_millis(100));
        let mut babbler = Babbler::new(Pattern::Bytes(vec![0x55]), Tick::ZERO, Span::from_millis(20), lasts);
        let mut said = 0;
        while let Some(next) = babbler.next() {
            assert_eq!(babbler.speak(next, LINE, &mut Dice::new(1)), Some((vec![0x55], None)));
            said += 1;
        }
        assert_eq!(said, 5);
    }

    #[test]
    fn another_master_asks_and_is_answered() {
        let mut other = Babbler::new(Pattern::Master(Spoken::RTU), Tick::ZERO, Span::ZERO, None);
        let mut say = || Framing::Rtu.decode(&other.speak(Tick::ZERO, LINE, &mut Dice::new(1)).unwrap().0).unwrap();
        assert!(Request::decode(&say().pdu).is_ok());
        assert!(matches!(Reply::decode(&say().pdu), Ok(Reply::Registers(_))));
    }

    #[test]
    fn a_twin_says_something_else_in_a_valid_telegram() {
        let frame = Framing::Rtu.encode(1, &[3, 2, 5, 0x6E]);
        let other = other_value(Spoken::RTU, &frame);
        assert_eq!(Framing::Rtu.decode(&other).unwrap().pdu, [3, 2, 5, 0x6F]);
        let refused = Framing::Rtu.encode(1, &[0x83, 4]);
        assert_eq!(other_value(Spoken::RTU, &refused), refused);
    }
}
