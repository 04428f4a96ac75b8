//! What a serial port hears that is set to something else than whoever speaks: it takes the levels of the wire at its own speed, as
//! a UART does: a start bit begins with a low level, every bit is looked at in its middle. A character whose parity or stop bit is
//! wrong comes as 0 where the port has a parity, and not at all where it has none, which is how a Linux driver is set
//! (INPCK, IGNPAR); a low stop bit then is the next start bit.

use super::wire::Slot;
use crate::protocol::line::{LineSetting, Parity};
use crate::tick::Tick;
use std::collections::VecDeque;

const NANOS: u128 = 1_000_000_000;
/// No port is faster; a bit lasts longer than no time at all.
const FASTEST: u32 = 12_000_000;

/// A port that does not fit what is on the wire.
#[derive(Clone, Debug)]
pub(crate) struct Port {
    line: LineSetting,
    /// What was on the wire and is not over for it.
    slots: VecDeque<Slot>,
    /// It looks for a start bit from here on; nanoseconds, as every time below.
    from: u128,
}

impl Port {
    pub(crate) fn new(line: LineSetting, now: Tick) -> Self {
        Port { line, slots: VecDeque::new(), from: nanos(now) }
    }

    /// What it is set to.
    pub(crate) fn line(&self) -> LineSetting {
        self.line
    }

    /// A character of another setting is over; what it makes of the wire until then.
    pub(crate) fn hear(&mut self, slot: &Slot) -> Vec<(Tick, u8)> {
        self.slots.push_back(*slot);
        self.read(nanos(slot.end))
    }

    /// When the character that it is at is over, if nothing more comes.
    pub(crate) fn due(&self) -> Option<Tick> {
        Some(tick(self.end(self.start()?)))
    }

    /// What it makes of the wire until now, on which nobody speaks any more.
    pub(crate) fn rest(&mut self, now: Tick) -> Vec<(Tick, u8)> {
        self.read(nanos(now))
    }

    /// Every character that is over by then.
    fn read(&mut self, until: u128) -> Vec<(Tick, u8)> {
        let mut heard = Vec::new();
        while let Some(start) = self.start() {
            let end = self.end(start);
            if end > until {
                break;
            }
            // A low level that is gone in the middle of the start bit is none.
            let is_start = !self.level(start + self.bits(1));
            self.from = if is_start { end } else { start + self.bits(1) };
            if let Some(byte) = self.character(start).filter(|_| is_start) {
                heard.push((tick(end), byte));
            }
            let from = self.from;
            while self.slots.front().is_some_and(|slot| nanos(slot.end) <= from) {
                self.slots.pop_front();
            }
        }
        heard
    }

    /// Where the next start bit begins.
    fn start(&self) -> Option<u128> {
        let low = |slot: &Slot| {
            let (begin, bit) = (nanos(slot.start), bit(slot.line));
            let lows = (0..u128::from(slot.line.bits_per_char())).filter(|&index| !level(slot, index));
            let spans = lows.map(|index| (begin + index * bit, begin + (index + 1) * bit));
            spans.filter(|span| span.1 > self.from).map(|span| span.0.max(self.from)).min()
        };
        self.slots.iter().filter_map(low).min()
    }

    /// Until the middle of the first stop bit nothing else begins.
    fn end(&self, start: u128) -> u128 {
        let parity = u128::from(self.line.parity != Parity::None);
        start + self.bits(2 * (1 + data_bits(self.line) + parity) + 1)
    }

    /// So many halves of a bit of its own.
    fn bits(&self, halves: u128) -> u128 {
        halves * bit(self.line) / 2
    }

    fn character(&self, start: u128) -> Option<u8> {
        let at = |index: u128| self.level(start + self.bits(2 * index + 1));
        let data = data_bits(self.line);
        let byte = (0..data).filter(|&index| at(1 + index)).fold(0_u8, |byte, index| byte | 1 << index);
        let ones = u128::from(byte.count_ones());
        let (fits, stop) = match self.line.parity {
            Parity::None => (true, at(1 + data)),
            parity => (at(1 + data) == parity_bit(parity, ones), at(2 + data)),
        };
        match (fits && stop, self.line.parity) {
            (true, _) => Some(byte),
            (false, Parity::None) => None,
            (false, _) => Some(0),
        }
    }

    /// The level of the wire at a time; it is high where nobody speaks.
    fn level(&self, at: u128) -> bool {
        let speaks = |slot: &&Slot| (nanos(slot.start)..nanos(slot.end)).contains(&at);
        let slot = self.slots.iter().find(speaks);
        slot.is_none_or(|slot| level(slot, (at - nanos(slot.start)) / bit(slot.line)))
    }
}

/// The level of a bit of a character, its start bit first.
fn level(slot: &Slot, index: u128) -> bool {
    let data = data_bits(slot.line);
    match index {
        0 => false,
        index if index <= data => slot.byte >> (index - 1) & 1 == 1,
        index if index == data + 1 && slot.line.parity != Parity::None => {
            parity_bit(slot.line.parity, u128::from(slot.byte.count_ones()))
        }
        _ => true,
    }
}

fn parity_bit(parity: Parity, ones: u128) -> bool {
    (ones % 2 == 1) == (parity == Parity::Even)
}

fn bit(line: LineSetting) -> u128 {
    NANOS / u128::from(line.baud.clamp(1, FASTEST))
}

fn nanos(at: Tick) -> u128 {
    u128::from(at.as_micros()) * 1_000
}

fn tick(at: u128) -> Tick {
    Tick::from_micros(u64::try_from(at.div_ceil(1_000)).unwrap_or(u64::MAX))
}

/// How many bits of a character carry it: no byte has more than 8.
fn data_bits(line: LineSetting) -> u128 {
    u128::from(line.data_bits.min(8))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulator::line::wire::{Sender, Wire};

    /// What a port at `own` hears of what is sent at `line`.
    fn heard(own: LineSetting, line: LineSetting, bytes: &[u8]) -> Vec<u8> {
        let (mut wire, mut port) = (Wire::default(), Port::new(own, Tick::ZERO));
        let (end, _) = wire.put(Sender::Stranger, line, Tick::from_micros(1_000), bytes);
        let mut heard = Vec::new();
        while let Some(slot) = wire.take(end) {
            heard.extend(port.hear(&slot));
        }
        while let Some(due) = port.due() {
            heard.extend(port.rest(due));
        }
        heard.into_iter().map(|heard| heard.1).collect()
    }

    const SENT: [u8; 8] = [0x01, 0x03, 0x21, 0x74, 0x00, 0x01, 0xCE, 0x2C];

    #[test]
    fn what_fits_is_what_was_sent() {
        for baud in [2_400, 19_200, 115_200] {
            for parity in [Parity::Even, Parity::Odd, Parity::None] {
                let line = LineSetting::rtu(baud, parity);
                assert_eq!(heard(line, line, &SENT), SENT, "{line}");
            }
        }
    }

    #[test]
    fn a_wrong_parity_is_a_zero_and_without_one_a_missing_character() {
        let even = LineSetting::rtu(19_200, Parity::Even);
        assert_eq!(heard(LineSetting::rtu(19_200, Parity::Odd), even, &SENT), [0; 8]);
        // A parity bit of 0 is taken for the start of the next character.
        let none = heard(LineSetting::rtu(19_200, Parity::None), even, &SENT);
        assert!(none.first() == SENT.first() && none.len() < SENT.len(), "{none:02X?}");
    }

    #[test]
    fn it_survives_any_time_and_any_setting() {
        let end_of_time = Tick::from_micros(u64::MAX);
        for baud in [0, 1, 2_400, u32::MAX] {
            for data_bits in [0, 9, u8::MAX] {
                let line = LineSetting { baud, data_bits, parity: Parity::Odd, stop_bits: 1 };
                let mut port = Port::new(line, Tick::ZERO);
                let slot = Slot { line, byte: 0x55, sender: Sender::Noise, start: Tick::ZERO, end: end_of_time };
                assert!(port.hear(&slot).len() < 3 && port.due().is_none_or(|due| due > Tick::ZERO));
                port.rest(end_of_time);
            }
        }
    }

    #[test]
    fn another_speed_makes_other_characters() {
        let at = |own: u32, baud: u32| {
            let of = |baud| LineSetting::rtu(baud, Parity::Even);
            heard(of(own), of(baud), &SENT)
        };
        // Too fast: several for each; too slow: few for all of them.
        assert!(at(115_200, 9_600).len() > 2 * SENT.len(), "{:02X?}", at(115_200, 9_600));
        assert!(at(2_400, 19_200).len() < SENT.len() / 2 + 1, "{:02X?}", at(2_400, 19_200));
        for (own, baud) in [(9_600, 19_200), (19_200, 9_600), (57_600, 115_200)] {
            assert_ne!(at(own, baud), SENT, "{own} {baud}");
        }
    }
}
