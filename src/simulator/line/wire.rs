//! The pair of wires: every byte with the time that it takes, and what becomes of two that are on it at once.

use crate::protocol::line::LineSetting;
use crate::tick::Tick;
use std::collections::VecDeque;

/// Who puts a byte on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sender {
    Master,
    /// Somebody who is no drive of the bench.
    Stranger,
    /// What comes as it is, whatever the setting of who hears it.
    Noise,
    /// A drive, by its place on the bench.
    Drive(usize),
}

/// A byte on the wire, from its start bit to its last stop bit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slot {
    pub(crate) start: Tick,
    pub(crate) end: Tick,
    pub(crate) byte: u8,
    pub(crate) sender: Sender,
    pub(crate) line: LineSetting,
}

/// The bytes that are on the wire or will be, in the order of their ends.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wire {
    slots: VecDeque<Slot>,
}

impl Wire {
    /// Puts `bytes` on the wire, back to back from `at`; tells the end of the last one and whether somebody else was
    /// speaking.
    pub(crate) fn put(&mut self, sender: Sender, line: LineSetting, at: Tick, bytes: &[u8]) -> (Tick, bool) {
        let mut collided = false;
        let mut start = at;
        for (count, byte) in (1..).zip(bytes.iter().map(|&byte| byte & characters(line))) {
            let end = at + line.chars(count);
            collided |= !self.add(Slot { start, end, byte, sender, line });
            start = end;
        }
        (start, collided)
    }

    /// Adds a byte, or spoils those that it meets.
    fn add(&mut self, slot: Slot) -> bool {
        let mut free = true;
        for other in self.slots.iter_mut().filter(|other| other.start < slot.end && slot.start < other.end) {
            // Low wins on the wire, and two stations are never in step to the bit: also equal bytes get spoiled.
            other.byte &= slot.byte.rotate_left(1);
            free = false;
        }
        if free {
            let place = self.slots.partition_point(|other| other.end <= slot.end);
            self.slots.insert(place, slot);
        }
        free
    }

    /// Whether somebody speaks before then.
    pub(crate) fn speaks_before(&self, at: Tick) -> bool {
        self.slots.iter().any(|slot| slot.start < at)
    }

    /// When the next byte will be complete.
    pub(crate) fn next(&self) -> Option<Tick> {
        self.slots.front().map(|slot| slot.end)
    }

    /// The next byte that is complete by `now`.
    pub(crate) fn take(&mut self, now: Tick) -> Option<Slot> {
        (self.next()? <= now).then(|| self.slots.pop_front()).flatten()
    }
}

/// The bits of a byte that a character carries: 7 or 8.
pub(crate) fn characters(line: LineSetting) -> u8 {
    if line.data_bits == 7 { 0x7F } else { 0xFF }
}

/// Whether a station with setting `own` can read what is sent with `other`; stop bits do not matter.
pub(crate) fn fits(own: LineSetting, other: LineSetting) -> bool {
    (own.baud, own.parity, own.data_bits) == (other.baud, other.parity, other.data_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;

    #[test]
    fn two_at_once_spoil_each_other() {
        let line = LineSetting::rtu(19_200, Parity::Even);
        let mut wire = Wire::default();
        assert!(!wire.put(Sender::Drive(0), line, Tick::ZERO, &[1, 3, 2]).1);
        let (end, collided) = wire.put(Sender::Drive(1), line, Tick::ZERO, &[1, 3, 2, 9]);
        assert!(collided);
        assert_eq!(end, Tick::ZERO + line.chars(4));
        let bytes: Vec<u8> = std::iter::from_fn(|| wire.take(end)).map(|slot| slot.byte).collect();
        assert_eq!(bytes, [0, 2, 0, 9]);
    }
}
