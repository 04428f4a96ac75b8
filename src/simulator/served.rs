//! What carries bytes to drives and back in time that somebody else tells: the bench, the PROFIBUS line, and the CAN bus.

use super::bench::Bench;
use super::can::bus::Can;
use super::dp::bench::Profibus;
use super::line::disturb::Parting;
use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};

/// A line with drives on it, for whoever carries its bytes.
pub trait Served {
    /// Lets its judge allow for this much where bytes may be read late.
    fn allow(&mut self, slack: Span);

    /// The master puts `bytes` on the wire, back to back from `at` on.
    fn master_sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]);

    /// The master's port is set so from now on.
    fn listens(&mut self, _line: LineSetting) {}

    /// The next moment at which something may change if the master stays silent.
    fn next_event(&self) -> Option<Tick>;

    /// Runs until `to`, inclusive; returns every byte that came to the master since the last call, with its time.
    fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)>;

    /// Whether the connection to the master was ended since this was asked last, and how.
    fn hangs_up(&mut self) -> Option<Parting> {
        None
    }

    /// Until when the port of the master takes no bytes.
    fn stuck_until(&self) -> Tick {
        Tick::ZERO
    }

    /// The setting at which a telegram is meant, for a line that carries none.
    fn line_of(&self, bytes: &[u8]) -> Option<LineSetting>;

    /// What a client of a pseudo terminal means who has set this; not every one lets its parity be seen.
    fn meant(&self, set: LineSetting) -> LineSetting {
        set
    }
}

impl Served for Bench {
    fn allow(&mut self, slack: Span) {
        Bench::allow(self, slack);
    }

    fn master_sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) {
        Bench::master_sends(self, at, line, bytes);
    }

    fn listens(&mut self, line: LineSetting) {
        Bench::listens(self, line);
    }

    fn next_event(&self) -> Option<Tick> {
        Bench::next_event(self)
    }

    fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        Bench::advance(self, to)
    }

    fn hangs_up(&mut self) -> Option<Parting> {
        Bench::hangs_up(self)
    }

    fn stuck_until(&self) -> Tick {
        Bench::stuck_until(self)
    }

    fn line_of(&self, bytes: &[u8]) -> Option<LineSetting> {
        Bench::line_of(self, bytes)
    }
}

impl Served for Profibus {
    fn allow(&mut self, slack: Span) {
        Profibus::allow(self, slack);
    }

    fn master_sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) {
        Profibus::master_sends(self, at, line, bytes);
    }

    fn next_event(&self) -> Option<Tick> {
        Profibus::next_event(self)
    }

    fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        Profibus::advance(self, to)
    }

    fn line_of(&self, _bytes: &[u8]) -> Option<LineSetting> {
        Some(self.line())
    }

    fn stuck_until(&self) -> Tick {
        Profibus::stuck_until(self)
    }

    fn meant(&self, set: LineSetting) -> LineSetting {
        LineSetting { baud: set.baud, ..self.line() }
    }
}

impl Served for Can {
    /// A bus has no pauses that anybody could break.
    fn allow(&mut self, _slack: Span) {}

    fn master_sends(&mut self, at: Tick, _line: LineSetting, bytes: &[u8]) {
        Can::master_sends(self, at, bytes);
    }

    fn next_event(&self) -> Option<Tick> {
        Can::next_event(self)
    }

    fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        Can::advance(self, to)
    }

    fn line_of(&self, _bytes: &[u8]) -> Option<LineSetting> {
        Some(self.line())
    }
}
