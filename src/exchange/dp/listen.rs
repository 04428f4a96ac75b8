//! Whether somebody else asks on a line, before anything is sent.

use crate::exchange::talk::WINDOW;
use crate::exchange::{Conversation, Step};
use crate::protocol::dp::frame::cut;
use crate::protocol::dp::{Control, Telegram};
use crate::tick::Tick;

/// So many bytes that are no telegram are no noise any more: somebody speaks at another speed.
const NOISE: usize = 12;
/// Bytes that are kept.
const MOST_BYTES: usize = 4_096;

/// Who was heard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heard {
    /// Nobody.
    Nobody,
    /// A master, by its address.
    Master(u8),
    /// Somebody whom nobody understands at this speed.
    Somebody,
}

/// Listens on a line.
#[derive(Debug)]
pub struct Listening {
    until: Tick,
    bytes: Vec<u8>,
}

impl Listening {
    /// Listens from `now` on.
    pub fn new(now: Tick) -> Self {
        Listening { until: now + WINDOW, bytes: Vec::new() }
    }

    fn master(&self) -> Option<u8> {
        cut(&self.bytes).into_iter().find_map(|piece| match Telegram::decode(piece).ok()? {
            Telegram::Token { from, .. } => Some(from),
            Telegram::Frame(frame) => match frame.control {
                Control::Request { .. } => Some(frame.from),
                Control::Reply { .. } => Some(frame.to),
            },
            Telegram::Ack => None,
        })
    }
}

impl Conversation for Listening {
    type End = Heard;

    fn step(&mut self, now: Tick) -> Step<Heard> {
        if let Some(master) = self.master() {
            return Step::Done(Heard::Master(master));
        }
        match now >= self.until {
            false => Step::Wait(self.until),
            true if self.bytes.len() >= NOISE => Step::Done(Heard::Somebody),
            true => Step::Done(Heard::Nobody),
        }
    }

    fn feed(&mut self, _at: Tick, bytes: &[u8]) {
        self.bytes.extend(bytes);
        self.bytes.truncate(MOST_BYTES);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_bytes_that_are_no_telegram_are_noise_and_twelve_are_somebody() {
        for (bytes, expected) in [(0, Heard::Nobody), (NOISE - 1, Heard::Nobody), (NOISE, Heard::Somebody)] {
            let mut listening = Listening::new(Tick::ZERO);
            let end = Tick::ZERO + WINDOW;
            assert_eq!(listening.step(Tick::ZERO), Step::Wait(end));
            listening.feed(Tick::ZERO, &vec![0x55; bytes]);
            assert_eq!(listening.step(end), Step::Done(expected), "{bytes}");
        }
    }
}
