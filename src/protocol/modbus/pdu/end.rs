//! Where a reply ends.

use super::{ENCAPSULATED, EXCEPTION_BIT, IDENTIFICATION, identification};

/// How the normal reply to a request ends, so that nobody has to wait for silence to know that it is complete.
///
/// Lengths count the PDU: function code and data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReplyEnd {
    /// The reply has this many bytes.
    Fixed(usize),
    /// The byte at this offset counts the bytes that follow it.
    CountAt(usize),
    /// Nothing counts the bytes: the objects of an identification have to be walked (code 43, type 14).
    Objects,
    /// Only silence (RTU) or the terminator (ASCII) tells.
    Silence,
    /// There is no reply: the request is a broadcast, or asks for silence.
    Never,
}

impl ReplyEnd {
    /// Length of the whole reply PDU whose first bytes are `start`; `None` while it cannot be told yet or ever.
    pub fn length(self, start: &[u8]) -> Option<usize> {
        let first = *start.first()?;
        if first == ENCAPSULATED | EXCEPTION_BIT {
            // With or without the type before the code; no exception has the number of the type.
            return start.get(1).map(|&second| if second == IDENTIFICATION { 3 } else { 2 });
        }
        if first & EXCEPTION_BIT != 0 {
            return Some(2);
        }
        match self {
            ReplyEnd::Fixed(length) => Some(length),
            ReplyEnd::CountAt(offset) => start.get(offset).map(|&count| offset + 1 + usize::from(count)),
            ReplyEnd::Objects => identification::length(start),
            ReplyEnd::Silence | ReplyEnd::Never => None,
        }
    }
}
