//! What a shaft is to do, and which words of a cycle follow one another for it.

use super::mode::{Mode, Words};
use crate::text::Text;
use crate::tick::Span;

/// 100 % of a setpoint (4.1.2.3).
pub(super) const FULL: i64 = 0x4000;
/// The setpoint at which the scale is measured: 3 %.
pub(super) const SMALL: u16 = 0x0200;

/// What the shaft is to do, signed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// 0.01 Hz.
    Hertz(i64),
    /// 0.01 % of A004.
    Percent(i64),
}

impl Wanted {
    /// The number of it.
    pub fn value(self) -> i64 {
        match self {
            Wanted::Hertz(value) | Wanted::Percent(value) => value,
        }
    }

    /// Another number of the same unit.
    #[must_use]
    pub fn at(self, value: i64) -> Self {
        match self {
            Wanted::Hertz(_) => Wanted::Hertz(value),
            Wanted::Percent(_) => Wanted::Percent(value),
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Wanted::Hertz(_) => "Hz",
            Wanted::Percent(_) => "%",
        }
    }
}

/// Who leads a setpoint: where it is now, of the unit of the run, and what somebody is told. On its way so long after its beginning, or behind
/// it.
pub(super) type Next<'l> = dyn FnMut(Option<Span>) -> (i64, Option<Text>) + 'l;

/// Where a setpoint goes.
pub struct Lead<'l> {
    /// At the start.
    pub first: Wanted,
    /// The furthest that it may ever be, on the side on which it always is; of the unit of the run.
    pub furthest: i64,
    /// So long it is on its way.
    pub takes: Span,
    /// Who leads it.
    pub next: &'l mut Next<'l>,
}

impl std::fmt::Debug for Lead<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lead").field("first", &self.first).field("furthest", &self.furthest).finish_non_exhaustive()
    }
}

/// What words are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// A run, and whether it ends by OFF3.
    Run(Wanted, bool),
    /// A stop, and whether it is OFF3.
    Stop(bool),
    /// A fault is acknowledged.
    Reset,
}

/// Words one behind the other, with what is known of their setpoints before anything was measured.
pub fn words(course: Course, mode: Mode) -> Vec<(u16, u16)> {
    let end = |coasts: bool| mode.coast().filter(|_| coasts).unwrap_or(mode.stop());
    let words = match course {
        Course::Stop(coasts) => vec![end(coasts)],
        Course::Reset => vec![mode.prepare(), mode.acknowledge(), mode.prepare(), mode.stop()],
        Course::Run(wanted, coasts) => {
            let (value, hsw) = match wanted {
                Wanted::Hertz(value) if mode.is_basic() => (value, hundredths(value)),
                Wanted::Hertz(value) => (value, SMALL),
                Wanted::Percent(value) => (value, part(value, 10_000)),
            };
            vec![mode.prepare(), Words { stw: mode.start(value), hsw }, end(coasts)]
        }
    };
    let mut words: Vec<_> = words.into_iter().map(|words| (words.stw, words.hsw)).collect();
    words.dedup();
    words
}

/// A setpoint of the Basic block: 0.01 Hz (3.2.2).
pub(super) fn hundredths(value: i64) -> u16 {
    u16::try_from(value.abs()).unwrap_or_default()
}

/// A setpoint of 4000h at most, for a part of a maximum, rounded to 0.
pub(super) fn part(value: i64, maximum: i64) -> u16 {
    let part = value.abs().saturating_mul(FULL).checked_div(maximum).unwrap_or_default();
    u16::try_from(part.min(FULL)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setpoint_is_rounded_to_zero_and_never_above_100_percent() {
        for (value, maximum, expected) in
            [(2_500, 5_000, 0x2000), (-2_500, 5_000, 0x2000), (5_000, 5_000, 0x4000), (9_000, 5_000, 0x4000)]
        {
            assert_eq!(part(value, maximum), expected, "{value} of {maximum}");
        }
        assert_eq!((part(1, 40_000), part(0, 5_000), part(100, 0)), (0, 0, 0));
    }
}
