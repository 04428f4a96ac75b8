//! Pure codecs: bytes to telegrams and back, for the master and for the slave side.
//!
//! This room knows wire formats and their norms. It knows no drive, no clock and no I/O, and it never panics on any
//! input: there is no indexing here, only checked access.

pub mod can;
pub mod check;
pub mod dp;
pub mod line;
pub mod modbus;
pub mod vabus;

use crate::text::{Wrong, both};
use line::{LineSetting, Parity};
use modbus::Framing;
use std::fmt;
use std::str::FromStr;

/// What is spoken on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Protocol {
    /// Modbus, framed in one of its ways.
    Modbus(Framing),
    /// The maker's own protocol of the ACTIVE family (P.395 = 0, factory setting).
    Vabus,
}

impl Protocol {
    /// Every protocol, in the order in which they are named to the user.
    pub const ALL: [Protocol; 4] = [
        Protocol::Modbus(Framing::Rtu),
        Protocol::Modbus(Framing::Ascii),
        Protocol::Vabus,
        Protocol::Modbus(Framing::Tcp),
    ];

    /// The word that names it on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Protocol::Modbus(framing) => framing.name(),
            Protocol::Vabus => "vabus",
        }
    }

    /// Its usual character format at this speed and parity.
    pub fn line(self, baud: u32, parity: Parity) -> LineSetting {
        match self {
            Protocol::Modbus(Framing::Rtu | Framing::Tcp) => LineSetting::rtu(baud, parity),
            // VABus uses the same seven bits (sources A1).
            Protocol::Modbus(Framing::Ascii) | Protocol::Vabus => LineSetting::ascii(baud, parity),
        }
    }
}

impl From<Framing> for Protocol {
    fn from(framing: Framing) -> Self {
        Protocol::Modbus(framing)
    }
}

impl fmt::Display for Protocol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Protocol {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let found = Self::ALL.into_iter().find(|protocol| protocol.name().eq_ignore_ascii_case(text.trim()));
        found.ok_or_else(|| {
            let names: Vec<_> = Self::ALL.iter().map(|protocol| protocol.name()).collect();
            let names = names.join(", ");
            Wrong(both!("expected {names}, got '{text}'", "erwartet: {names}; angegeben: '{text}'"))
        })
    }
}

/// Prints a byte string as the manuals do: `01 03 21 74`.
#[derive(Clone, Copy, Debug)]
pub struct Hex<'a>(pub &'a [u8]);

impl fmt::Display for Hex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, byte) in self.0.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            write!(f, "{gap}{byte:02X}")?;
        }
        Ok(())
    }
}
