//! The serial line: speed, character format, and how long characters take on it.

use crate::text::{Wrong, both};
use crate::tick::Span;
use std::fmt;
use std::str::FromStr;

/// Parity bit of a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Parity {
    /// Even number of ones (factory setting of the CM modules).
    Even,
    /// Odd number of ones.
    Odd,
    /// No parity bit.
    None,
}

/// Speed and character format of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LineSetting {
    /// Bits per second.
    pub baud: u32,
    /// Data bits per character: 7 or 8; 0 where there are none ([`LineSetting::can`]).
    pub data_bits: u8,
    /// Parity bit.
    pub parity: Parity,
    /// Stop bits per character: 1 or 2.
    pub stop_bits: u8,
}

impl LineSetting {
    /// Format of Modbus RTU: 8 data bits and always 11 bits a character, so 2 stop bits when there is no parity
    /// (CM-485 manual 6.7.1.1).
    pub const fn rtu(baud: u32, parity: Parity) -> Self {
        LineSetting { baud, data_bits: 8, parity, stop_bits: stop_bits_for(parity) }
    }

    /// Format of Modbus ASCII: 7 data bits and always 10 bits a character (CM-485 manual 6.7.2.1).
    pub const fn ascii(baud: u32, parity: Parity) -> Self {
        LineSetting { baud, data_bits: 7, parity, stop_bits: stop_bits_for(parity) }
    }

    /// Usual format of VABus: 7 data bits, even parity, 1 stop bit (S1 p25).
    pub const fn vabus(baud: u32) -> Self {
        Self::ascii(baud, Parity::Even)
    }

    /// A CAN bus of this bit rate: no characters, so no data bits; its frames take [`crate::protocol::can::duration`].
    pub const fn can(bit_rate: u32) -> Self {
        LineSetting { baud: bit_rate, data_bits: 0, parity: Parity::None, stop_bits: 0 }
    }

    /// Whether it is a CAN bus.
    pub const fn is_can(self) -> bool {
        self.data_bits == 0
    }

    /// Bits that one character takes on the wire, start bit included.
    pub const fn bits_per_char(self) -> u64 {
        let parity = match self.parity {
            Parity::None => 0,
            Parity::Even | Parity::Odd => 1,
        };
        1 + self.data_bits as u64 + parity + self.stop_bits as u64
    }

    /// Time of `count` characters back to back, rounded up to a microsecond.
    pub const fn chars(self, count: u64) -> Span {
        Span::from_micros((count * self.bits_per_char() * 1_000_000).div_ceil(self.baud as u64))
    }

    /// Time of `halves` half characters, rounded up: 3 gives t1.5, 7 gives t3.5.
    const fn half_chars(self, halves: u64) -> Span {
        Span::from_micros((halves * self.bits_per_char() * 500_000).div_ceil(self.baud as u64))
    }

    /// Longest silence inside an RTU telegram: 1.5 characters, fixed 750 us above 19200 baud
    /// (Modbus over serial line V1.02, 2.5.1.1).
    pub const fn t15(self) -> Span {
        if self.baud > 19_200 { Span::from_micros(750) } else { self.half_chars(3) }
    }

    /// Shortest silence between RTU telegrams: 3.5 characters, fixed 1750 us above 19200 baud
    /// (Modbus over serial line V1.02, 2.5.1.1).
    pub const fn t35(self) -> Span {
        if self.baud > 19_200 { Span::from_micros(1_750) } else { self.half_chars(7) }
    }
}

const fn stop_bits_for(parity: Parity) -> u8 {
    match parity {
        Parity::None => 2,
        Parity::Even | Parity::Odd => 1,
    }
}

/// Prints as technicians write it: `19200 8E1`, `CAN 500 kbit/s`.
impl fmt::Display for LineSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parity = match self.parity {
            Parity::Even => 'E',
            Parity::Odd => 'O',
            Parity::None => 'N',
        };
        if self.is_can() {
            return write!(f, "CAN {} kbit/s", self.baud / 1_000);
        }
        write!(f, "{} {}{parity}{}", self.baud, self.data_bits, self.stop_bits)
    }
}

impl Parity {
    /// Every parity with the word that names it on the command line and in files.
    pub const NAMES: [(Parity, &'static str); 3] =
        [(Parity::Even, "even"), (Parity::Odd, "odd"), (Parity::None, "none")];

    /// The word that names this parity: `even`, `odd`, `none`.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(parity, _)| *parity == self).map_or("none", |(_, name)| name)
    }
}

/// Reads `even`, `odd` or `none`.
impl FromStr for Parity {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let found = Self::NAMES.iter().find(|(_, name)| name.eq_ignore_ascii_case(text.trim()));
        found.map(|(parity, _)| *parity).ok_or_else(|| {
            Wrong(both!(
                "expected even, odd or none, got '{text}'",
                "erwartet: even, odd oder none; angegeben: '{text}'"
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_a_19200_8e1_line() {
        let line = LineSetting::rtu(19_200, Parity::Even);
        assert_eq!(line.bits_per_char(), 11);
        assert_eq!(line.chars(8).as_micros(), 4_584);
        assert_eq!(line.t15().as_micros(), 860);
        assert_eq!(line.t35().as_micros(), 2_006);
    }

    #[test]
    fn silences_are_fixed_above_19200() {
        let line = LineSetting::rtu(115_200, Parity::None);
        assert_eq!(line.bits_per_char(), 11);
        assert_eq!((line.t15().as_micros(), line.t35().as_micros()), (750, 1_750));
    }

    #[test]
    fn settings_print_as_technicians_write_them() {
        assert_eq!(LineSetting::rtu(19_200, Parity::None).to_string(), "19200 8N2");
        assert_eq!(LineSetting::ascii(9_600, Parity::Even).to_string(), "9600 7E1");
        assert_eq!(LineSetting::can(500_000).to_string(), "CAN 500 kbit/s");
    }
}
