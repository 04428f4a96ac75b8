//! What a station makes of the bytes on the wire: a telegram begins behind T_SYN of silence and has no gap (IEC 61158-4-3).

use crate::protocol::dp::frame::length;
use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};

/// Idle bits before every question (IEC 61158-4-3: T_SYN).
const SYN_BITS: u64 = 33;
/// Idle bits inside a telegram that a receiver still bears. The norm has none; receivers sample, so they bear a few.
const GAP_BITS: u64 = 3;

/// T_SYN on a line.
pub(crate) fn syn(line: LineSetting) -> Span {
    bits(line, SYN_BITS)
}

/// The longest idle inside a telegram.
pub(crate) fn gap(line: LineSetting) -> Span {
    bits(line, GAP_BITS)
}

/// So many bit times, rounded up.
pub(crate) fn bits(line: LineSetting, count: u64) -> Span {
    Span::from_micros((count * 1_000_000).div_ceil(u64::from(line.baud.max(1))))
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Ear {
    bytes: Vec<u8>,
    /// End of the last byte of anybody.
    last: Option<Tick>,
    /// What comes is no telegram until T_SYN has been silent.
    is_deaf: bool,
}

impl Ear {
    /// Takes a byte from its start to its end; the telegram that ends with it.
    pub(crate) fn feed(&mut self, line: LineSetting, start: Tick, end: Tick, byte: u8) -> Option<Vec<u8>> {
        let idle = self.last.map(|last| start.since(last));
        self.last = Some(end);
        if idle.is_none_or(|idle| idle >= syn(line)) {
            self.is_deaf = false;
            self.bytes.clear();
        } else if self.bytes.is_empty() || idle.is_some_and(|idle| idle > gap(line)) {
            self.is_deaf = true;
        }
        if self.is_deaf {
            return None;
        }
        self.bytes.push(byte);
        match length(&self.bytes) {
            Ok(Some(length)) if self.bytes.len() >= length => Some(std::mem::take(&mut self.bytes)),
            Ok(_) => None,
            Err(_) => {
                self.is_deaf = true;
                None
            }
        }
    }
}
