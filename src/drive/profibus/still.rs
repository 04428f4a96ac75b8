//! Whether the shaft stands, by what is told of the frequency alone: the bits of the status word say what was commanded.
//!
//! HIW is the frequency that the inverter puts out, not that of the shaft. Where the output goes dark at once (a trip, coasting) it is 0
//! while the shaft turns on. So a shaft is known to stand only where the frequency was seen on its way down to 0.

use super::mode::Seen;
use crate::tick::{Span, Tick};

/// So many cycles in a row with a frequency of 0, over this time, and the output is off.
const ZEROS: u32 = 3;
const QUIET: Span = Span::from_millis(100);
/// A frequency that stays for so long is on no ramp.
const STEADY: Span = Span::from_millis(500);
/// So long at most the rest of a ramp rolls on that is told as coasting.
const ROLLS: Span = Span::from_secs(3);

/// What the frequency has told.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Still {
    /// The last frequency that was not 0, and since when it was that.
    last: Option<(Tick, i32)>,
    /// When it was seen last.
    sight: Tick,
    /// How far it fell before that, and in which time.
    fall: Option<(i32, Span)>,
    zeros: u32,
    since: Tick,
    proven: bool,
    /// It turned without power once.
    free: bool,
    /// The rest of a ramp that came down is told as coasting.
    rolls: bool,
    /// What a frequency may be where a ramp ends.
    slow: i32,
    /// It was told to coast.
    pub(super) coasts: bool,
}

impl Still {
    /// Of a slave that tells frequencies of which this one is slow.
    pub(super) fn new(slow: i32) -> Self {
        Still { slow, ..Still::default() }
    }

    /// Takes what came in one cycle.
    pub(super) fn sees(&mut self, now: Tick, seen: Seen) {
        let frequency = seen.hiw.abs();
        if frequency != 0 {
            self.free |= seen.is_free();
            self.turns(now, frequency);
            return;
        }
        if self.zeros == 0 {
            self.since = now;
            self.proven = self.last.is_some_and(|(at, last)| last <= self.slow || self.comes_down(last, now.since(at)));
        }
        self.zeros = self.zeros.saturating_add(1);
        // The inverter says so itself, and says when it is over; a trip says nothing of the kind.
        self.rolls = self.proven && seen.is_free() && !seen.is_faulted();
        self.free |= seen.is_free() && !self.rolls;
    }

    fn turns(&mut self, now: Tick, frequency: i32) {
        (self.zeros, self.proven, self.rolls) = (0, false, false);
        let sight = std::mem::replace(&mut self.sight, now);
        match self.last {
            Some((at, last)) if last == frequency => {
                self.fall = self.fall.filter(|_| now.since(at) <= STEADY);
                return;
            }
            Some((at, last)) if last > frequency => {
                // Of a frequency that was held the ramp began behind its latest sight, of one on the way behind its first.
                let began = if sight.since(at) > STEADY { sight } else { at };
                self.fall = Some((last - frequency, now.since(began)));
            }
            _ => self.fall = None,
        }
        self.last = Some((now, frequency));
    }

    /// Whether the ramp that was seen reaches the end in this time.
    fn comes_down(&self, last: i32, elapsed: Span) -> bool {
        let Some((fall, took)) = self.fall.filter(|(_, took)| *took <= STEADY && elapsed <= STEADY) else {
            return false;
        };
        let micros = |span: Span| i64::try_from(span.as_micros()).unwrap_or(i64::MAX);
        i64::from(fall).saturating_mul(micros(elapsed)) >= i64::from(last - self.slow).saturating_mul(micros(took))
    }

    /// Whether the output is off, and nothing more is to be waited for.
    pub(super) fn is_dark(&self, now: Tick) -> bool {
        let quiet = if self.rolls { ROLLS } else { QUIET };
        self.zeros >= ZEROS && now.since(self.since) >= quiet
    }

    /// What is known of the shaft: it stands, it is driven, or nothing tells.
    pub(super) fn standing(&self) -> Option<bool> {
        match self.zeros {
            0 => self.last.map(|_| false),
            _ => (self.proven && !self.rolls && !self.free && !self.coasts).then_some(true),
        }
    }

    /// Whether the frequency was ever seen.
    pub(super) fn has_turned(&self) -> bool {
        self.last.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frequencies every 25 ms, the last of them for a while; with a fault from this one on.
    fn told(frequencies: &[i32], fault: usize) -> Still {
        let mut still = Still::new(crate::drive::profibus::mode::Mode::PPO1.slow());
        for (place, hiw) in frequencies.iter().enumerate() {
            let zsw = if place >= fault { 1 << 3 } else { 0 };
            still.sees(Tick::ZERO + Span::from_millis(25 * place as u64), Seen { zsw, hiw: *hiw, state: None });
        }
        still
    }

    #[test]
    fn only_a_frequency_that_came_down_proves_a_standing_shaft() {
        let never = usize::MAX;
        for (frequencies, fault, standing) in [
            (&[0, 0, 0][..], never, None),
            (&[900, 600, 300, 0, 0], never, Some(true)),
            (&[-900, -600, -300, 0, 0], never, Some(true)),
            (&[9000, 6000, 3000, 0], never, Some(true)),
            // Off at once: a trip, or coasting.
            (&[8192, 8192, 0, 0], never, None),
            (&[8192, 8000, 0, 0], never, None),
            (&[900, 600, 300, 0, 0], 3, None),
            (&[8192, 8192], never, Some(false)),
            (&[300, 0, 0, 300], never, Some(false)),
        ] {
            assert_eq!(told(frequencies, fault).standing(), standing, "{frequencies:?}");
        }
    }

    #[test]
    fn a_ramp_that_was_seen_long_ago_proves_nothing() {
        let mut frequencies = vec![9_000, 7_000];
        frequencies.extend([5_000; 40]);
        frequencies.push(0);
        assert_eq!(told(&frequencies, usize::MAX).standing(), None);
    }

    /// Where answers are garbled a ramp from a frequency that was held shows few others: the time of its fall is not that of the run.
    #[test]
    fn a_ramp_begins_behind_the_latest_sight_of_what_was_held() {
        let seen = |behind: &[(u64, i32)]| {
            let mut still = Still::new(60);
            let held = (0..25).map(|nth| (nth * 200, 2_000));
            for (at, hiw) in held.chain(behind.iter().map(|(at, hiw)| (4_800 + at, *hiw))) {
                still.sees(
                    Tick::ZERO + Span::from_millis(at),
                    Seen { zsw: 0x0050, hiw, state: Some(u16::from(hiw != 0)) },
                );
            }
            still.standing()
        };
        for (behind, standing) in [
            (&[(200, 1_000), (400, 0), (425, 0), (450, 0)][..], Some(true)),
            (&[(200, 1_400), (400, 800), (620, 150), (800, 0)], Some(true)),
            // Let go on its way, or at speed.
            (&[(200, 1_800), (400, 0)], None),
            (&[(200, 0)], None),
            // What is held lower down is on no ramp any more.
            (&[(200, 900), (300, 500), (700, 500), (1_100, 500), (1_125, 0)], None),
        ] {
            assert_eq!(seen(behind), standing, "{behind:?}");
        }
    }

    /// Of the Basic block: frequencies, 0.01 Hz, and states, every 25 ms.
    fn told_basic(rows: &[(i32, u16)]) -> Still {
        let mut still = Still::new(60);
        for (place, (hiw, state)) in rows.iter().enumerate() {
            let at = Tick::ZERO + Span::from_millis(25 * place as u64);
            still.sees(at, Seen { zsw: 0x0050, hiw: *hiw, state: Some(*state) });
        }
        still
    }

    /// 3.2.3: 1 is running, 3 coasting, 0 stop.
    #[test]
    fn the_rest_of_a_ramp_that_is_told_as_coasting_ends_with_the_stop() {
        let ramp = [(1_115, 1), (874, 1), (702, 1), (508, 1), (259, 1), (87, 1)];
        let at = |rows: usize| Tick::ZERO + Span::from_millis(25 * (rows as u64 - 1));
        for (behind, standing, is_dark) in [
            (&[(0, 3), (0, 3), (0, 0), (0, 0), (0, 0), (0, 0)][..], Some(true), true),
            // It rolls on.
            (&[(0, 3), (0, 3), (0, 3), (0, 3), (0, 3), (0, 3)], None, false),
            // A trip is no end of a ramp.
            (&[(0, 10), (0, 0), (0, 0), (0, 0), (0, 0)], None, true),
        ] {
            let rows = [&ramp[..], behind].concat();
            let still = told_basic(&rows);
            assert_eq!((still.standing(), still.is_dark(at(rows.len()))), (standing, is_dark), "{behind:?}");
        }
        // Let go at speed: the stop that comes afterwards proves nothing.
        let free = [(2_000, 1), (1_990, 1), (0, 3), (0, 3), (0, 0), (0, 0), (0, 0), (0, 0)];
        assert_eq!(told_basic(&free).standing(), None);
        let still = told_basic(&[&ramp[..], &[(0, 3)].repeat(200)[..]].concat());
        assert!(still.is_dark(at(206)) && still.standing().is_none(), "it is not waited for without an end");
    }

    #[test]
    fn a_single_zero_is_no_end() {
        let still = told(&[300, 0], usize::MAX);
        assert!(!still.is_dark(Tick::ZERO + Span::from_secs(1)));
        let still = told(&[300, 0, 0, 0], usize::MAX);
        assert!(
            !still.is_dark(Tick::ZERO + Span::from_millis(75)) && still.is_dark(Tick::ZERO + Span::from_millis(125))
        );
    }
}
