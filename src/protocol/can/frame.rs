//! A frame of classic CAN (ISO 11898-1): identifier, and up to eight bytes or a request for them.

use super::super::Hex;
use std::fmt;

/// The identifier of a frame. The smaller one wins the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Identifier {
    /// 11 bits; the only kind that the system bus knows.
    Standard(u16),
    /// 29 bits; somebody else's.
    Extended(u32),
}

impl Identifier {
    /// Largest identifier of 11 bits.
    pub const MAX_STANDARD: u16 = 0x7FF;
    /// Largest identifier of 29 bits.
    pub const MAX_EXTENDED: u32 = 0x1FFF_FFFF;

    /// An identifier of 11 bits.
    pub fn standard(number: u32) -> Option<Self> {
        u16::try_from(number).ok().filter(|number| *number <= Self::MAX_STANDARD).map(Identifier::Standard)
    }

    /// An identifier of 29 bits.
    pub fn extended(number: u32) -> Option<Self> {
        (number <= Self::MAX_EXTENDED).then_some(Identifier::Extended(number))
    }

    /// Its number.
    pub fn number(self) -> u32 {
        match self {
            Identifier::Standard(number) => number.into(),
            Identifier::Extended(number) => number,
        }
    }
}

/// As candump prints it: three hex digits, or eight.
impl fmt::Display for Identifier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Identifier::Standard(number) => write!(f, "{number:03X}"),
            Identifier::Extended(number) => write!(f, "{number:08X}"),
        }
    }
}

/// Up to eight bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Payload {
    len: u8,
    /// Zero behind `len`.
    bytes: [u8; Self::MOST],
}

impl Payload {
    /// Bytes of the longest frame.
    pub const MOST: usize = 8;

    /// `None` for more than eight bytes.
    pub fn new(bytes: &[u8]) -> Option<Self> {
        let mut payload = Payload { len: u8::try_from(bytes.len()).ok()?, bytes: [0; Self::MOST] };
        payload.bytes.get_mut(..bytes.len())?.copy_from_slice(bytes);
        Some(payload)
    }

    /// The bytes.
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get(..self.len.into()).unwrap_or_default()
    }

    /// All eight bytes, if there are so many.
    pub fn eight(&self) -> Option<[u8; Self::MOST]> {
        (usize::from(self.len) == Self::MOST).then_some(self.bytes)
    }
}

impl From<[u8; Self::MOST]> for Payload {
    fn from(bytes: [u8; Self::MOST]) -> Self {
        Payload { len: Self::MOST as u8, bytes }
    }
}

/// What a frame carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Body {
    /// Bytes.
    Data(Payload),
    /// A request for so many bytes (RTR).
    Remote(u8),
}

/// A frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Frame {
    /// Whose it is, and how urgent.
    pub identifier: Identifier,
    /// What it carries.
    pub body: Body,
}

impl Frame {
    /// A frame of 11 bits with these bytes. `None` where the number or the bytes are too many.
    pub fn data(identifier: u16, bytes: &[u8]) -> Option<Self> {
        let identifier = Identifier::standard(identifier.into())?;
        Some(Frame { identifier, body: Body::Data(Payload::new(bytes)?) })
    }

    /// Its bytes; a request has none.
    pub fn bytes(&self) -> &[u8] {
        match &self.body {
            Body::Data(payload) => payload.bytes(),
            Body::Remote(_) => &[],
        }
    }
}

/// As people read it and `decode can` takes it: `585#42 74 01 02 6E 05 00 00`, `705#R1`.
impl fmt::Display for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.body {
            Body::Data(payload) => write!(f, "{}#{}", self.identifier, Hex(payload.bytes())),
            Body::Remote(0) => write!(f, "{}#R", self.identifier),
            Body::Remote(len) => write!(f, "{}#R{len}", self.identifier),
        }
    }
}

/// Why a text is no frame.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// No identifier of three or eight hex digits.
    #[error("'{0}' is no identifier (three hex digits up to 7FF, or eight up to 1FFFFFFF)")]
    Identifier(String),
    /// No bytes, or more than eight of them.
    #[error("'{0}' is not up to eight hex bytes")]
    Bytes(String),
    /// A length above 8, or one that the bytes do not have.
    #[error("'{0}' is no length from 0 to 8")]
    Length(String),
    /// CAN FD, which the system bus does not speak.
    #[error("a frame of CAN FD")]
    Fd,
    /// Nothing of what a frame looks like.
    #[error("'{0}' is no CAN frame")]
    Form(String),
}

/// Hex digits as bytes, up to eight.
pub(super) fn payload(digits: &str) -> Result<Payload, FrameError> {
    let wrong = || FrameError::Bytes(digits.to_owned());
    let mut bytes = Vec::new();
    for pair in digits.as_bytes().chunks(2) {
        bytes.push(byte(pair).ok_or_else(wrong)?);
    }
    Payload::new(&bytes).ok_or_else(wrong)
}

/// Two hex digits.
fn byte(pair: &[u8]) -> Option<u8> {
    match pair {
        [high, low] => Some((digit(*high)? << 4) | digit(*low)?),
        _ => None,
    }
}

/// A hex digit.
pub(super) fn digit(letter: u8) -> Option<u8> {
    char::from(letter).to_digit(16).map(|digit| digit as u8)
}

/// A number of nothing but hex digits; `from_str_radix` alone would take a sign.
pub(super) fn number(digits: &str) -> Option<u32> {
    let is_hex = !digits.is_empty() && digits.bytes().all(|letter| letter.is_ascii_hexdigit());
    is_hex.then(|| u32::from_str_radix(digits, 16).ok()).flatten()
}
