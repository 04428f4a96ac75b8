//! SLCAN, the text that CAN adapters on serial ports speak (Lawicel CANUSB manual, and what its imitators make of it).
//!
//! Every command ends with CR. An adapter acknowledges with CR (behind a frame `z` or `Z` before it) and refuses with BEL.

use super::frame::{Body, Frame, FrameError, Identifier, Payload, digit, number, payload};
use std::fmt;

/// What is said, either way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Word {
    /// A frame: to be sent, or that has come.
    Frame {
        /// The frame.
        frame: Frame,
        /// Milliseconds of the adapter's clock, which begins anew every minute.
        at_ms: Option<u16>,
    },
    /// Sets the bit rate, by its number.
    Rate(u8),
    /// Sets the bit rate by registers of the controller.
    Registers(String),
    /// Opens the channel.
    Open,
    /// Opens it to listen only: nothing is sent, not even acknowledgements.
    Listen,
    /// Closes it.
    Close,
    /// Asks for the status flags.
    Status,
    /// The status flags.
    Flags(u8),
    /// Asks for the version, or tells it.
    Version(String),
    /// Asks for the serial number, or tells it.
    Serial(String),
    /// Switches the time behind frames on or off.
    Stamps(bool),
    /// Acknowledged: nothing, or `z`, `Z` behind a frame.
    Done,
    /// Refused (BEL).
    Refused,
}

/// Bit rates of `S0` to `S8` in kbit/s. `S7` is 750 kbit/s on some adapters.
pub const RATES: [u16; 9] = [10, 20, 50, 100, 125, 250, 500, 800, 1000];

/// Ends a command.
const END: char = '\r';
/// Refused.
const BELL: char = '\u{7}';

/// Whether a text may be SLCAN: it begins with a word of it, and one of them is a frame.
pub fn is_text(text: &str) -> bool {
    let is_word = |word: &&str| Word::read(word).is_ok();
    cut(text).next().is_some_and(|first| is_word(&first)) && cut(text).any(|word| is_frame(word) && is_word(&word))
}

/// Whether a word begins as a frame does.
pub fn is_frame(word: &str) -> bool {
    word.starts_with(['t', 'T', 'r', 'R'])
}

/// The commands of a text, without their ends. A bell is one of its own.
pub fn cut(text: &str) -> impl Iterator<Item = &str> {
    let ends = |letter: char| letter == END || letter == '\n';
    text.split(ends).flat_map(|line| line.split_inclusive(BELL)).filter(|word| !word.is_empty())
}

impl Word {
    /// Status flags that tell of errors on the bus: error warning, error passive, bus error (Lawicel CANUSB manual, F).
    pub const ERRORS: u8 = 1 << 2 | 1 << 5 | 1 << 7;

    /// Status flags that tell of frames that were lost: queue of received frames full, data overrun (the same).
    pub const OVERRUNS: u8 = 1 | 1 << 3;

    /// The word that sets a bit rate; `None` for one that has no number.
    pub fn rate(bit_rate: u32) -> Option<Self> {
        let place = RATES.iter().position(|rate| u32::from(*rate) * 1_000 == bit_rate)?;
        u8::try_from(place).ok().map(Word::Rate)
    }

    /// Reads a command without its end.
    pub fn read(word: &str) -> Result<Self, FrameError> {
        let wrong = || FrameError::Form(word.to_owned());
        let mut letters = word.chars();
        let Some(letter) = letters.next() else { return Ok(Word::Done) };
        let rest = letters.as_str();
        let bare = |word: Word| if rest.is_empty() { Ok(word) } else { Err(wrong()) };
        match letter {
            't' | 'T' | 'r' | 'R' => framed(letter, rest, word),
            'S' => match rest.as_bytes() {
                [number @ b'0'..=b'8'] => Ok(Word::Rate(number - b'0')),
                _ => Err(wrong()),
            },
            's' if rest.len() == 4 && number(rest).is_some() => Ok(Word::Registers(rest.to_owned())),
            'O' => bare(Word::Open),
            'L' => bare(Word::Listen),
            'C' => bare(Word::Close),
            'F' if rest.is_empty() => Ok(Word::Status),
            'F' if rest.len() == 2 => Ok(Word::Flags(number(rest).ok_or_else(wrong)? as u8)),
            'V' if rest.len() <= 4 => Ok(Word::Version(rest.to_owned())),
            'N' if rest.len() <= 4 => Ok(Word::Serial(rest.to_owned())),
            'Z' if rest == "0" || rest == "1" => Ok(Word::Stamps(rest == "1")),
            'z' | 'Z' => bare(Word::Done),
            BELL => bare(Word::Refused),
            _ => Err(wrong()),
        }
    }
}

/// A frame behind its letter: identifier, length, bytes, and the time if there is one.
fn framed(letter: char, rest: &str, word: &str) -> Result<Word, FrameError> {
    let wrong = || FrameError::Form(word.to_owned());
    let width = if letter.is_ascii_uppercase() { 8 } else { 3 };
    let digits = rest.get(..width).ok_or_else(wrong)?;
    let raw = number(digits).ok_or_else(|| FrameError::Identifier(digits.to_owned()))?;
    let identifier = if width == 3 { Identifier::standard(raw) } else { Identifier::extended(raw) };
    let identifier = identifier.ok_or_else(|| FrameError::Identifier(digits.to_owned()))?;
    let rest = rest.get(width..).ok_or_else(wrong)?;
    let len = rest.bytes().next().and_then(digit).filter(|len| usize::from(*len) <= Payload::MOST);
    let len = len.ok_or_else(|| FrameError::Length(rest.chars().take(1).collect()))?;
    let rest = rest.get(1..).ok_or_else(wrong)?;
    let (body, rest) = match letter.eq_ignore_ascii_case(&'r') {
        true => (Body::Remote(len), rest),
        false => {
            let (bytes, rest) = rest.split_at_checked(2 * usize::from(len)).ok_or_else(wrong)?;
            (Body::Data(payload(bytes)?), rest)
        }
    };
    let at_ms = match rest.len() {
        0 => None,
        4 => Some(number(rest).and_then(|ms| u16::try_from(ms).ok()).ok_or_else(wrong)?),
        _ => return Err(wrong()),
    };
    Ok(Word::Frame { frame: Frame { identifier, body }, at_ms })
}

/// Without its end.
impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Word::Frame { frame, at_ms } => {
                let (letter, len) = match frame.body {
                    Body::Data(payload) => ('t', payload.bytes().len()),
                    Body::Remote(len) => ('r', len.into()),
                };
                let is_extended = matches!(frame.identifier, Identifier::Extended(_));
                let letter = if is_extended { letter.to_ascii_uppercase() } else { letter };
                write!(f, "{letter}{}{len}", frame.identifier)?;
                frame.bytes().iter().try_for_each(|byte| write!(f, "{byte:02X}"))?;
                at_ms.map_or(Ok(()), |ms| write!(f, "{ms:04X}"))
            }
            Word::Rate(number) => write!(f, "S{number}"),
            Word::Registers(digits) => write!(f, "s{digits}"),
            Word::Open => write!(f, "O"),
            Word::Listen => write!(f, "L"),
            Word::Close => write!(f, "C"),
            Word::Status => write!(f, "F"),
            Word::Flags(flags) => write!(f, "F{flags:02X}"),
            Word::Version(told) => write!(f, "V{told}"),
            Word::Serial(told) => write!(f, "N{told}"),
            Word::Stamps(on) => write!(f, "Z{}", u8::from(*on)),
            Word::Done => Ok(()),
            Word::Refused => write!(f, "{BELL}"),
        }
    }
}
