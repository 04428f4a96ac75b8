//! An adapter between a serial port and the bus, as the manual of the Lawicel CANUSB has it, and what its imitators do otherwise.

use super::confinement::Errors;
use crate::protocol::can::Frame;
use crate::protocol::can::slcan::{RATES, Word};
use crate::tick::Span;

/// What one adapter does and another does not (docs/can.md, adapters).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Quirks {
    /// It acknowledges what it is told; some say nothing but frames.
    pub(crate) acknowledges: bool,
    /// It can listen only.
    pub(crate) listens: bool,
    /// A refusal comes so much later than anything else.
    pub(crate) bell: Span,
    /// It holds everything back for so long.
    pub(crate) latency: Span,
    /// It refuses this number of a bit rate.
    pub(crate) lacks: Option<u8>,
}

impl Default for Quirks {
    fn default() -> Self {
        let (bell, latency) = (Span::ZERO, Span::from_millis(1));
        Quirks { acknowledges: true, listens: true, bell, latency, lacks: None }
    }
}

/// Whether it takes part in the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Channel {
    Closed,
    Listening,
    Open,
}

/// What comes of a byte.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Out {
    /// It says this, so much later than usual.
    Says(String, Span),
    /// This is to go out on the bus.
    Sends(Frame),
}

/// An adapter.
#[derive(Clone, Debug)]
pub(crate) struct Adapter {
    pub(crate) quirks: Quirks,
    pub(crate) channel: Channel,
    /// Bits per second, once it is set.
    pub(crate) rate: Option<u32>,
    /// Of its controller.
    pub(super) errors: Errors,
    /// Status flags.
    flags: u8,
    word: Vec<u8>,
}

/// Longest word that it takes.
const LONGEST: usize = 64;
/// What it says of itself; no adapter of anybody.
const VERSION: &str = "V0001";
const SERIAL: &str = "NBE7C";

impl Adapter {
    pub(crate) fn new(quirks: Quirks) -> Self {
        Adapter { quirks, channel: Channel::Closed, rate: None, errors: Errors::default(), flags: 0, word: Vec::new() }
    }

    /// It has seen this on the bus.
    pub(crate) fn flags(&mut self, flags: u8) {
        self.flags |= flags;
    }

    /// Takes a byte of its host.
    pub(crate) fn feed(&mut self, byte: u8) -> Vec<Out> {
        if byte != b'\r' {
            if self.word.len() < LONGEST {
                self.word.push(byte);
            }
            return Vec::new();
        }
        let word = std::mem::take(&mut self.word);
        let word = std::str::from_utf8(&word).ok().and_then(|word| Word::read(word).ok());
        match word {
            Some(word) => self.obeys(&word),
            None => self.refuses(),
        }
    }

    /// A frame has come over the bus.
    pub(crate) fn hears(&self, frame: &Frame) -> Option<String> {
        (self.channel != Channel::Closed).then(|| format!("{}\r", Word::Frame { frame: *frame, at_ms: None }))
    }

    fn obeys(&mut self, word: &Word) -> Vec<Out> {
        let is_closed = self.channel == Channel::Closed;
        match word {
            Word::Done => self.says("\r"),
            Word::Rate(number) if is_closed && self.quirks.lacks != Some(*number) => {
                self.rate = RATES.get(usize::from(*number)).map(|rate| u32::from(*rate) * 1_000);
                self.says("\r")
            }
            Word::Open if is_closed && self.rate.is_some() => self.turns(Channel::Open),
            Word::Listen if is_closed && self.rate.is_some() && self.quirks.listens => self.turns(Channel::Listening),
            Word::Close if !is_closed => self.turns(Channel::Closed),
            Word::Version(of) if of.is_empty() => self.says(&format!("{VERSION}\r")),
            Word::Serial(of) if of.is_empty() => self.says(&format!("{SERIAL}\r")),
            Word::Status if !is_closed => {
                let flags = std::mem::take(&mut self.flags);
                self.says(&format!("F{flags:02X}\r"))
            }
            Word::Stamps(false) if is_closed => self.says("\r"),
            Word::Frame { frame, at_ms: None } if self.channel == Channel::Open => {
                let mut out = self.says("z\r");
                out.push(Out::Sends(*frame));
                out
            }
            _ => self.refuses(),
        }
    }

    fn turns(&mut self, channel: Channel) -> Vec<Out> {
        (self.channel, self.flags, self.errors) = (channel, 0, Errors::default());
        self.says("\r")
    }

    fn says(&self, text: &str) -> Vec<Out> {
        let said = Out::Says(text.to_owned(), Span::ZERO);
        Some(said).filter(|_| self.quirks.acknowledges).into_iter().collect()
    }

    fn refuses(&self) -> Vec<Out> {
        let said = Out::Says("\u{7}".to_owned(), self.quirks.bell);
        Some(said).filter(|_| self.quirks.acknowledges).into_iter().collect()
    }
}
