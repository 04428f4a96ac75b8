//! Modbus: protocol data units ([`pdu`]) in RTU ([`rtu`]), ASCII ([`ascii`]) or TCP ([`mbap`]) frames.
//!
//! Norms: MODBUS Application Protocol V1.1b3; MODBUS over Serial Line V1.02. Maker: CM-485 manual, chapters 6 and 8.
//! The frame layer carries `(station, PDU)` and knows no function code, so new codes need no change there.

pub mod ascii;
pub mod mbap;
pub mod pdu;
pub mod rtu;

pub use super::Hex;

/// Station address for broadcasts: everybody obeys, nobody answers; writes only (CM-485 manual 6.1).
pub const BROADCAST: u8 = 0;

/// Highest address of a station (CM-485 manual 6.2).
pub const LAST_STATION: u8 = 247;

/// Longest PDU: function code and at most 252 data bytes (CM-485 manual 6.7.1.2).
pub const MAX_PDU: usize = 253;

/// How telegrams are framed on the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Framing {
    /// Binary, CRC-16, telegrams parted by silence.
    Rtu,
    /// Hexadecimal text between `:` and CR LF, with LRC.
    Ascii,
    /// Modbus/TCP, for gateways: numbered transactions, no check value.
    Tcp,
}

impl Framing {
    /// Puts a PDU for or from `station` into a frame.
    pub fn encode(self, station: u8, pdu: &[u8]) -> Vec<u8> {
        match self {
            Framing::Rtu => rtu::encode(station, pdu),
            Framing::Ascii => ascii::encode(station, pdu),
            Framing::Tcp => mbap::encode(0, station, pdu),
        }
    }

    /// Takes exactly one whole frame apart.
    pub fn decode(self, frame: &[u8]) -> Result<Adu, FrameError> {
        match self {
            Framing::Rtu => rtu::decode(frame),
            Framing::Ascii => ascii::decode(frame),
            Framing::Tcp => mbap::decode(frame).map(|(_, adu)| adu),
        }
    }

    /// The word that names this framing: `rtu`, `ascii` or `mbtcp`.
    pub fn name(self) -> &'static str {
        match self {
            Framing::Rtu => "rtu",
            Framing::Ascii => "ascii",
            Framing::Tcp => "mbtcp",
        }
    }
}

/// What a frame carries: the station and the PDU (function code and data).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Adu {
    /// Address of the slave that is asked or that answers; 0 is a broadcast.
    pub station: u8,
    /// Function code and data.
    pub pdu: Vec<u8>,
}

/// Why bytes are not a frame.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// Fewer bytes than the shortest frame has.
    #[error("{len} bytes are too few for a frame")]
    TooShort {
        /// How many bytes came.
        len: usize,
    },
    /// More bytes than a frame may have.
    #[error("{len} bytes are too many for a frame")]
    TooLong {
        /// How many bytes came.
        len: usize,
    },
    /// The check value does not fit the bytes.
    #[error("check value {got:04X}h, expected {expected:04X}h")]
    Check {
        /// What the bytes ask for.
        expected: u16,
        /// What came.
        got: u16,
    },
    /// An ASCII frame does not start with `:` or does not end with CR LF.
    #[error("an ASCII telegram starts with ':' and ends with CR LF")]
    Delimiter,
    /// A character of an ASCII frame is no hexadecimal digit, or one digit is missing.
    #[error("character {byte:02X}h is no hexadecimal digit of an ASCII telegram")]
    Digit {
        /// The offending character.
        byte: u8,
    },
}
