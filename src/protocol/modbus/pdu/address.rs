//! The address word of the ACTIVE family.

use std::fmt;

/// The address word of the ACTIVE family: data set in the upper 4 bits, parameter number in the lower 12
/// (CM-485 manual 6.4.1).
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParamAddress(u16);

impl ParamAddress {
    /// Highest parameter number that the drives know (CM-485 manual 6.4.1).
    pub const LAST_NUMBER: u16 = 1599;
    /// Highest number that the 12 bits can carry.
    pub const MAX_NUMBER: u16 = 0x0FFF;
    /// Highest data set: 0-4 EEPROM, 5-9 RAM (CM-485 manual 7).
    pub const LAST_SET: u8 = 9;

    /// An address from data set (0-15) and parameter number (0-4095); `None` if they do not fit into their bits.
    pub fn new(set: u8, number: u16) -> Option<Self> {
        (set <= 0x0F && number <= Self::MAX_NUMBER).then(|| ParamAddress(u16::from(set) << 12 | number))
    }

    /// The address that a word on the wire stands for.
    pub const fn from_word(word: u16) -> Self {
        ParamAddress(word)
    }

    /// The word on the wire.
    pub const fn word(self) -> u16 {
        self.0
    }

    /// Data set, 0-15.
    pub const fn set(self) -> u8 {
        (self.0 >> 12) as u8
    }

    /// Parameter number, 0-4095.
    pub const fn number(self) -> u16 {
        self.0 & Self::MAX_NUMBER
    }
}

impl fmt::Debug for ParamAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "P.{}@{}", self.number(), self.set())
    }
}
