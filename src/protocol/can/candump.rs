//! Recordings as candump of can-utils writes them: its log, `(1436509052.249713) can0 585#427401026E050000`, and what it shows on
//! a screen, `can0  585   [8]  42 74 01 02 6E 05 00 00`. Both are read, the log is written.

use super::frame::{Body, Frame, FrameError, Identifier, Payload, number, payload};
use std::fmt;

/// A line of a recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Microseconds: of the clock of the day, or since the recording began.
    pub at_us: Option<u64>,
    /// The interface that it came from.
    pub interface: Option<String>,
    /// What came.
    pub what: What,
}

/// What came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// A frame of the bus.
    Frame(Frame),
    /// What the controller of the interface reports; it was never on the bus (linux/can/error.h).
    Trouble {
        /// What kind of trouble, bit by bit.
        class: u32,
        /// What the controller says besides.
        data: Payload,
    },
}

/// Marks a report of the controller among identifiers (CAN_ERR_FLAG of linux/can.h).
const TROUBLE: u32 = 0x2000_0000;

/// Whether a line may be one of candump's.
pub fn is_line(line: &str) -> bool {
    let mut words = line.split_whitespace();
    let first = words.next().unwrap_or_default();
    first.starts_with('(') || words.clone().any(|word| word.contains('#')) || words.nth(1).is_some_and(is_length)
}

fn is_length(word: &str) -> bool {
    word.starts_with('[') && word.ends_with(']')
}

impl Entry {
    /// Reads a line of a log, or of what candump shows.
    pub fn read(line: &str) -> Result<Self, FrameError> {
        let form = || FrameError::Form(line.trim().to_owned());
        let mut words: Vec<&str> = line.split_whitespace().collect();
        let at_us = match words.first() {
            Some(first) if first.starts_with('(') => {
                let time = first.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).and_then(microseconds);
                words.remove(0);
                Some(time.ok_or_else(form)?)
            }
            _ => None,
        };
        match words.as_slice() {
            // What follows is the direction, of newer versions.
            [interface, told, ..] if told.contains('#') => {
                Ok(Entry { at_us, interface: Some((*interface).to_owned()), what: what(told)? })
            }
            [interface, identifier, len, rest @ ..] if is_length(len) => {
                let told = shown(identifier, len, rest)?;
                Ok(Entry { at_us, interface: Some((*interface).to_owned()), what: what(&told)? })
            }
            [told] => Ok(Entry { at_us, interface: None, what: what(told)? }),
            _ => Err(form()),
        }
    }
}

/// What candump shows, in the form of its log.
fn shown(identifier: &str, len: &str, rest: &[&str]) -> Result<String, FrameError> {
    let wrong = || FrameError::Length(len.to_owned());
    let len: usize = len.trim_matches(['[', ']']).parse().map_err(|_| wrong())?;
    let is_fd = len > Payload::MOST;
    if rest.first() == Some(&"remote") {
        return Ok(format!("{identifier}#R{len}"));
    }
    let is_byte = |word: &&&str| word.len() == 2 && word.bytes().all(|letter| letter.is_ascii_hexdigit());
    let bytes: Vec<&str> = rest.iter().take_while(is_byte).take(len).copied().collect();
    match (bytes.len() == len, is_fd) {
        (_, true) => Err(FrameError::Fd),
        (true, _) => Ok(format!("{identifier}#{}", bytes.concat())),
        _ => Err(wrong()),
    }
}

/// A frame as the log has it: `585#427401026E050000`, `705#R1`. Points between the bytes are taken.
pub fn what(told: &str) -> Result<What, FrameError> {
    let (identifier, body) = told.split_once('#').ok_or_else(|| FrameError::Form(told.to_owned()))?;
    let wrong = || FrameError::Identifier(identifier.to_owned());
    let raw = number(identifier).ok_or_else(wrong)?;
    if body.starts_with('#') {
        return Err(FrameError::Fd);
    }
    if identifier.len() == 8 && raw & TROUBLE != 0 {
        return Ok(What::Trouble { class: raw & !TROUBLE, data: payload(body)? });
    }
    let identifier = match identifier.len() {
        3 => Identifier::standard(raw),
        8 => Identifier::extended(raw),
        _ => None,
    };
    let identifier = identifier.ok_or_else(wrong)?;
    let body = match body.strip_prefix(['R', 'r']) {
        Some("") => Body::Remote(0),
        Some(len) => Body::Remote(length(len)?),
        None => Body::Data(payload(&body.replace('.', ""))?),
    };
    Ok(What::Frame(Frame { identifier, body }))
}

/// A length from 0 to 8.
fn length(digits: &str) -> Result<u8, FrameError> {
    let wrong = || FrameError::Length(digits.to_owned());
    digits.parse().ok().filter(|len| usize::from(*len) <= Payload::MOST).ok_or_else(wrong)
}

/// Seconds with up to six decimals.
fn microseconds(text: &str) -> Option<u64> {
    let (seconds, decimals) = text.split_once('.').unwrap_or((text, ""));
    let is_number = |digits: &str| digits.bytes().all(|digit| digit.is_ascii_digit());
    if !is_number(seconds) || !is_number(decimals) || decimals.len() > 6 {
        return None;
    }
    let decimals: u64 = format!("{decimals:0<6}").parse().ok()?;
    seconds.parse::<u64>().ok()?.checked_mul(1_000_000)?.checked_add(decimals)
}

/// Microseconds of a second.
const SECOND: u64 = 1_000_000;

/// As candump logs it, without an end of line.
impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = self.at_us.unwrap_or_default();
        let interface = self.interface.as_deref().unwrap_or("can0");
        write!(f, "({:010}.{:06}) {interface} ", at / SECOND, at % SECOND)?;
        let (identifier, bytes) = match &self.what {
            What::Frame(frame) => (frame.identifier.to_string(), frame.bytes()),
            What::Trouble { class, data } => (format!("{:08X}", class | TROUBLE), data.bytes()),
        };
        write!(f, "{identifier}#")?;
        match &self.what {
            What::Frame(Frame { body: Body::Remote(0), .. }) => write!(f, "R"),
            What::Frame(Frame { body: Body::Remote(len), .. }) => write!(f, "R{len}"),
            _ => bytes.iter().try_for_each(|byte| write!(f, "{byte:02X}")),
        }
    }
}
