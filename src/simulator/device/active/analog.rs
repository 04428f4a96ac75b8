//! The analog input of an EM-RES-03: it measures a little beside the truth until it is adjusted (EM-RES-03 manual 6.1.7).
//!
//! Choices where the manual is silent:
//! - P.253 shows hundredths of a volt;
//! - a write of P.568 adjusts at once, by what lies at the input then, right or wrong; what was adjusted outlives the power;
//! - P.568 goes on showing what was written.

/// The input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Analog {
    /// What lies at the terminal, 0.001 V.
    pub(crate) applied: i64,
    /// What it measures at 0 V, 0.001 V.
    offset: i64,
    /// How much it measures of each volt, thousandths.
    gain: i64,
    /// What counts as 0 V, and what as 10 V more, 0.001 V.
    zero: i64,
    span: i64,
}

/// Between the two voltages of the adjustment, 0.001 V.
const SPAN: i64 = 10_000;

impl Default for Analog {
    /// Nothing lies at it, and it measures the truth.
    fn default() -> Self {
        Analog::new(0, 0, 1_000)
    }
}

impl Analog {
    /// With its errors, not adjusted.
    pub(crate) fn new(applied: i64, offset: i64, gain: i64) -> Self {
        Analog { applied, offset, gain, zero: 0, span: SPAN }
    }

    /// P.253, 0.01 V.
    pub(crate) fn shown(self) -> i64 {
        let fine = (self.measured() - self.zero) * SPAN / self.span.max(1);
        (fine + 5 * fine.signum()) / 10
    }

    /// P.568 was written: 1 at 0 V, 2 at 10 V.
    pub(crate) fn adjust(&mut self, mode: i64) {
        match mode {
            1 => self.zero = self.measured(),
            2 if self.measured() > self.zero => self.span = self.measured() - self.zero,
            _ => {}
        }
    }

    fn measured(self) -> i64 {
        self.applied * self.gain / 1_000 + self.offset
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_adjustments_take_the_errors_away() {
        let mut input = Analog::new(0, 300, 950);
        let at = |input: Analog, applied| Analog { applied, ..input }.shown();
        assert_eq!([0, 5_000, 10_000].map(|volts| at(input, volts)), [30, 505, 980]);
        input.adjust(1);
        assert_eq!([0, 5_000, 10_000].map(|volts| at(input, volts)), [0, 475, 950]);
        input.applied = 10_000;
        input.adjust(2);
        assert_eq!([0, 5_000, 10_000, -10_000].map(|volts| at(input, volts)), [0, 500, 1_000, -1_000]);
        // With the wrong voltage it adjusts wrongly, or where that is none not at all.
        let mut wrong = Analog { applied: 5_000, ..input };
        wrong.adjust(2);
        assert_eq!(at(wrong, 5_000), 1_000);
        let mut none = Analog { applied: 0, ..input };
        none.adjust(2);
        assert_eq!(at(none, 10_000), 1_000);
    }
}
