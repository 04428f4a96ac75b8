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
use can::SdoChannel;
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
    /// Parameters over the system bus, which is CAN: frames, and no characters (EM-RES-03 manual 5.10), over one of the two channels of
    /// every drive (5.9.4).
    Sdo(SdoChannel),
    /// Parameters of one slave of PROFIBUS-DP, over the PKW block of its cyclic data, which somebody else exchanges (SJ2-PB manual 4.1).
    Pkw,
}

impl Protocol {
    /// Every protocol of characters, in the order in which they are named to the user.
    pub const ALL: [Protocol; 4] = [
        Protocol::Modbus(Framing::Rtu),
        Protocol::Modbus(Framing::Ascii),
        Protocol::Vabus,
        Protocol::Modbus(Framing::Tcp),
    ];

    /// Those of a CAN bus: over the channel that is meant for a tool, and over that of the master.
    pub const OF_CAN: [Protocol; 2] = [Protocol::Sdo(SdoChannel::Two), Protocol::Sdo(SdoChannel::One)];

    /// Whether it goes over a CAN bus.
    pub fn is_can(self) -> bool {
        matches!(self, Protocol::Sdo(_))
    }

    /// The word that names it on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Protocol::Modbus(framing) => framing.name(),
            Protocol::Vabus => "vabus",
            Protocol::Sdo(SdoChannel::Two) => "sdo",
            Protocol::Sdo(SdoChannel::One) => "sdo1",
            Protocol::Pkw => "dp",
        }
    }

    /// Its usual character format at this speed and parity.
    pub fn line(self, baud: u32, parity: Parity) -> LineSetting {
        match self {
            Protocol::Modbus(Framing::Rtu | Framing::Tcp) => LineSetting::rtu(baud, parity),
            // VABus uses the same seven bits (sources A1).
            Protocol::Modbus(Framing::Ascii) | Protocol::Vabus => LineSetting::ascii(baud, parity),
            Protocol::Sdo(_) => LineSetting::can(baud),
            // PROFIBUS is always 8E1 (IEC 61158-4-3).
            Protocol::Pkw => LineSetting::rtu(baud, Parity::Even),
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
        let all = || Self::ALL.into_iter().chain(Self::OF_CAN);
        let found = all().find(|protocol| protocol.name().eq_ignore_ascii_case(text.trim()));
        found.ok_or_else(|| {
            let names: Vec<_> = all().map(Protocol::name).collect();
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
