//! The buffer between a client, which sends as fast as it likes, and the wire, which does not.

use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// What a client has sent and the wire has not taken yet. It is the buffer of a serial server: what does not fit is lost,
/// and what is left goes with the client.
#[derive(Debug, Default)]
pub(super) struct Backlog {
    queue: VecDeque<(LineSetting, u8)>,
    /// Until then the bytes that were given to the bench are on the wire.
    busy: Tick,
}

/// Bytes that a client may be ahead of the wire: more than any telegram has.
const ROOM: usize = 4_096;
/// The bench is told so early of what follows back to back, so that no lateness of ours tears a telegram.
const AHEAD: Span = Span::from_millis(50);
/// Silence between two clients: longer than any that parts telegrams.
const BETWEEN_CLIENTS: Span = Span::from_millis(20);
/// Bytes that it is told at once.
const PIECE: usize = 64;

impl Backlog {
    pub(super) fn take(&mut self, line: LineSetting, bytes: &[u8]) {
        // Without a speed nothing goes anywhere.
        if line.baud > 0 {
            let room = ROOM.saturating_sub(self.queue.len());
            self.queue.extend(bytes.iter().take(room).map(|&byte| (line, byte)));
        }
    }

    /// The client is gone. What it has on the wire already and what the next one sends are not one telegram.
    pub(super) fn leave(&mut self) {
        self.queue.clear();
        self.busy += BETWEEN_CLIENTS;
    }

    /// The next bytes that go on the wire, and when.
    pub(super) fn next(&mut self, now: Tick) -> Option<(Tick, LineSetting, Vec<u8>)> {
        let &(line, _) = self.queue.front().filter(|_| self.busy <= now + AHEAD)?;
        let count = self.queue.iter().take(PIECE).take_while(|(other, _)| *other == line).count();
        let bytes: Vec<u8> = self.queue.drain(..count).map(|(_, byte)| byte).collect();
        let at = self.busy.max(now);
        self.busy = at + line.chars(bytes.len() as u64);
        Some((at, line, bytes))
    }

    /// When there is room on the wire for more.
    pub(super) fn goes_on(&self) -> Option<Tick> {
        self.queue.front().map(|_| Tick::ZERO + (self.busy.since(Tick::ZERO) - AHEAD))
    }
}
