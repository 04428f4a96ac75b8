//! The ear for VABus. Where the manual is silent: a pause of more than [`VABUS_PAUSE`] inside a telegram drops it.

use crate::protocol::vabus::{ENQ, EOT, ETX, MAX_TELEGRAM};
use crate::simulator::line::speech::VABUS_PAUSE;
use crate::tick::Tick;

/// Makes telegrams of what comes in.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ear {
    /// What has come of a telegram, from EOT on.
    bytes: Vec<u8>,
    last: Tick,
}

impl Ear {
    /// Forgets what has come in.
    pub(crate) fn forget(&mut self) {
        self.bytes.clear();
    }

    /// Takes a character that was complete at `at`; returns the telegram that ends with it, right or wrong.
    ///
    /// EOT begins a telegram wherever it comes, but behind ETX every character is the check character.
    pub(crate) fn feed(&mut self, at: Tick, byte: u8) -> Option<Vec<u8>> {
        if at.since(self.last) > VABUS_PAUSE {
            self.bytes.clear();
        }
        self.last = at;
        let is_check = self.bytes.last() == Some(&ETX);
        if byte == EOT && !is_check {
            self.bytes.clear();
        } else if self.bytes.is_empty() {
            return None;
        }
        self.bytes.push(byte);
        let over = is_check || byte == ENQ || self.bytes.len() >= MAX_TELEGRAM;
        over.then(|| std::mem::take(&mut self.bytes))
    }
}
