//! Axes with round numbers.

/// An axis: its ends, and how far apart its ticks are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) step: f64,
}

impl Axis {
    /// An axis that holds all values, and zero, with about so many ticks; its ends are ticks, and no value lies on the upper one.
    pub(super) fn around(values: impl Iterator<Item = f64>, count: f64) -> Self {
        let (low, high) = values.fold((0.0f64, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
        let high = if high > low { high } else { low + 1.0 };
        let step = round((high - low) / count);
        Axis { low: (low / step).floor() * step, high: (high * ROOM / step).ceil() * step, step }
    }

    /// An axis from one end to the other.
    pub(super) fn from_to(low: f64, high: f64, count: f64) -> Self {
        let high = if high > low { high } else { low + 1.0 };
        Axis { low, high, step: round((high - low) / count) }
    }

    /// Where the ticks stand.
    pub(super) fn ticks(self) -> impl Iterator<Item = f64> {
        let first = (self.low / self.step - 1e-9).ceil() as i64;
        let last = (self.high / self.step + 1e-9).floor() as i64;
        (first..=last).map(move |n| n as f64 * self.step)
    }

    /// A tick as a number, with the decimals that the step needs.
    pub(super) fn label(self, tick: f64) -> String {
        let decimals = (-(self.step.log10() + 1e-9).floor()).clamp(0.0, 6.0) as usize;
        let text = format!("{tick:.decimals$}");
        if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) {
            text.trim_start_matches('-').to_owned()
        } else {
            text
        }
    }

    /// Which share of the axis lies below a value.
    pub(super) fn share(self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }
}

/// So much more than its largest value an axis holds, so that a line does not lie on the frame.
const ROOM: f64 = 1.02;

/// The round number above it: 1, 2 or 5 and zeros.
fn round(step: f64) -> f64 {
    let power = 10f64.powf(step.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|digit| digit * power)
        .find(|round| *round >= step * (1.0 - 1e-9))
        .unwrap_or(power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_hold_all_values() {
        let labels = |axis: Axis| axis.ticks().map(|tick| axis.label(tick)).collect::<Vec<_>>().join(" ");
        assert_eq!(labels(Axis::around([3.0, 24.93].into_iter(), 5.0)), "0 5 10 15 20 25 30");
        assert_eq!(labels(Axis::around([-0.2, 0.31].into_iter(), 5.0)), "-0.2 0.0 0.2 0.4");
        assert_eq!(labels(Axis::around([0.0].into_iter(), 5.0)), "0.0 0.2 0.4 0.6 0.8 1.0 1.2");
        assert_eq!(labels(Axis::from_to(7.06, 14.2, 8.0)), "8 9 10 11 12 13 14");
    }
}
