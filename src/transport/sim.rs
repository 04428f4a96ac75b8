//! The built-in bench as a link, in virtual time: waiting costs nothing and every run is the same.

use super::Wake;
use crate::protocol::line::LineSetting;
use crate::simulator::Bench;
use crate::tick::Tick;

#[derive(Debug)]
pub(super) struct SimLink {
    bench: Bench,
    line: LineSetting,
    now: Tick,
}

impl SimLink {
    pub(super) fn new(bench: Bench, line: LineSetting) -> Self {
        SimLink { bench, line, now: Tick::ZERO }
    }

    pub(super) fn now(&self) -> Tick {
        self.now
    }

    pub(super) fn bench(&mut self) -> &mut Bench {
        &mut self.bench
    }

    pub(super) fn send(&mut self, bytes: &[u8]) {
        self.bench.master_sends(self.now, self.line, bytes);
    }

    /// Goes from event to event of the bench until a drive has put bytes on the wire or the time is over.
    pub(super) fn wait(&mut self, until: Tick) -> Wake {
        loop {
            let next = self.bench.next_event().map_or(until, |event| event.min(until)).max(self.now);
            let bytes: Vec<u8> = self.bench.advance(next).into_iter().map(|(_, byte)| byte).collect();
            let stuck = next == self.now && next < until && bytes.is_empty();
            self.now = next;
            if !bytes.is_empty() {
                return Wake::Bytes(bytes);
            }
            if stuck {
                // An event that does not go away by advancing must not hang the program.
                self.now = until;
                self.bench.advance(until);
            }
            if self.now >= until {
                return Wake::Silence;
            }
        }
    }
}
