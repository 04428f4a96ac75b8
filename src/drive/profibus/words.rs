//! The two words of a cycle, in both directions (SJ2-PB manual 4.1.2), and which follow one another.

/// 100 % of a setpoint (4.1.2.3).
pub(super) const FULL: i64 = 0x4000;
/// The setpoint at which the scale is measured: 3 %.
pub(super) const SMALL: u16 = 0x0200;

/// Control word and setpoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Words {
    pub(super) stw: u16,
    /// 4000h is 100 % of A004 (4.1.2.3).
    pub(super) hsw: u16,
}

impl Words {
    /// OFF1, with control kept (SJ2-PB manual 4.1.2.1).
    pub(super) const STOP: Words = Words { stw: 0x047E, hsw: 0 };
    /// Ready, without a start: bits 1 and 2 alone, with control kept.
    pub(super) const PREPARE: Words = Words { stw: 0x0406, hsw: 0 };
    /// Start clockwise (4.1.2.4), and the bit that turns it.
    pub(super) const START: u16 = 0x047F;
    pub(super) const REVERSE: u16 = 1 << 11;
    /// The edge that acknowledges a fault (bit 7), with control kept.
    pub(super) const ACKNOWLEDGE: Words = Words { stw: 0x0486, hsw: 0 };
    /// OFF3 besides: the motor coasts, or by the norm stops quickly.
    pub(super) const COAST: Words = Words { stw: 0x047A, hsw: 0 };
}

/// Status word and actual frequency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seen {
    /// ZSW (4.1.2.2).
    pub zsw: u16,
    /// HIW, 4000h is 100 % of A004 (4.1.2.3).
    pub hiw: i16,
}

/// What the shaft is to do, signed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// 0.01 Hz.
    Hertz(i64),
    /// 0.01 % of A004.
    Percent(i64),
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
pub fn words(course: Course) -> Vec<(u16, u16)> {
    let end = |coasts: bool| if coasts { Words::COAST } else { Words::STOP };
    let words = match course {
        Course::Stop(coasts) => vec![end(coasts)],
        Course::Reset => vec![Words::PREPARE, Words::ACKNOWLEDGE, Words::PREPARE, Words::STOP],
        Course::Run(wanted, coasts) => {
            let (value, hsw) = match wanted {
                Wanted::Hertz(value) => (value, SMALL),
                Wanted::Percent(value) => (value, part(value, 10_000)),
            };
            vec![Words::PREPARE, Words { stw: start(value), hsw }, end(coasts)]
        }
    };
    words.into_iter().map(|words| (words.stw, words.hsw)).collect()
}

/// The start word for a signed setpoint.
pub(super) fn start(value: i64) -> u16 {
    Words::START | if value < 0 { Words::REVERSE } else { 0 }
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
