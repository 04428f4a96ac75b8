//! Setpoints as technicians say them (`25Hz`, `-12,5 Hz`, `30%`, `1450rpm`), and setpoints that change with time.

use super::value::{ValueError, parse_decimal};

/// What a setpoint is a setpoint of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Frequency, raw in 0.01 Hz.
    Frequency,
    /// Percentage, raw in 0.01 %.
    Percent,
    /// Speed of the motor shaft in 1/min, raw in 0.01 1/min; pole pairs make it a frequency.
    Speed,
}

impl Quantity {
    /// Unit as it is shown.
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::Frequency => "Hz",
            Quantity::Percent => "%",
            Quantity::Speed => "1/min",
        }
    }
}

/// Decimals of every setpoint (P.484 and P.524: CM-485 manual 9).
pub const DECIMALS: u8 = 2;

/// Reads a setpoint; a number without a unit is no setpoint, because hertz and percent are easily mixed up.
pub fn parse(text: &str) -> Result<(Quantity, i64), ValueError> {
    let text = text.trim();
    let units = [
        ("hz", Quantity::Frequency),
        ("%", Quantity::Percent),
        ("rpm", Quantity::Speed),
        ("1/min", Quantity::Speed),
        ("min-1", Quantity::Speed),
        ("u/min", Quantity::Speed),
    ];
    let lower = text.to_lowercase();
    for (unit, quantity) in units {
        if let Some(number) = lower.strip_suffix(unit) {
            return parse_decimal(number.trim(), DECIMALS).map(|raw| (quantity, raw));
        }
    }
    let choices = ["25Hz", "-12,5 Hz", "30%", "1450rpm"].map(str::to_owned).to_vec();
    Err(ValueError::NotANumber { text: text.to_owned(), choices })
}

/// The frequency (0.01 Hz) that turns a motor with so many pole pairs at a speed (0.01 1/min), without slip; rounded
/// to the nearest hundredth.
pub fn frequency_of_speed(speed: i64, pole_pairs: i64) -> i64 {
    let product = speed * pole_pairs;
    (product + 30 * product.signum()) / 60
}

/// A setpoint that changes with time: points of time in microseconds, and raw values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    points: Vec<(u64, i64)>,
    /// Straight lines between the points; otherwise steps at them.
    straight: bool,
}

impl Schedule {
    /// A ramp from one value to another.
    pub fn ramp(from: i64, to: i64, duration_us: u64) -> Self {
        Schedule { points: vec![(0, from), (duration_us, to)], straight: true }
    }

    /// Steps at given times. The times must rise; the error names the point, counted from 1.
    pub fn steps(points: Vec<(u64, i64)>) -> Result<Self, usize> {
        let falling = points.windows(2).position(|pair| matches!(pair, [a, b] if b.0 <= a.0));
        match falling {
            _ if points.is_empty() => Err(0),
            Some(index) => Err(index + 2),
            None => Ok(Schedule { points, straight: false }),
        }
    }

    /// The same with every value converted.
    #[must_use]
    pub fn map(&self, convert: impl Fn(i64) -> i64) -> Self {
        let points = self.points.iter().map(|&(us, raw)| (us, convert(raw))).collect();
        Schedule { points, straight: self.straight }
    }

    /// When the last value is reached.
    pub fn end_us(&self) -> u64 {
        self.points.last().map_or(0, |point| point.0)
    }

    /// Largest magnitude of any value.
    pub fn peak(&self) -> i64 {
        self.points.iter().map(|point| point.1.abs()).max().unwrap_or(0)
    }

    /// Every value that it passes or jumps to.
    pub fn values(&self) -> impl Iterator<Item = i64> + '_ {
        self.points.iter().map(|point| point.1)
    }

    /// The value at a time; before the first point the first value, after the last the last.
    pub fn at(&self, us: u64) -> i64 {
        let after = self.points.iter().position(|point| point.0 > us);
        let last = self.points.last().map_or(0, |point| point.1);
        let Some(after) = after else { return last };
        let Some(next) = self.points.get(after) else { return last };
        let Some(before) = after.checked_sub(1).and_then(|index| self.points.get(index)) else { return next.1 };
        if !self.straight {
            return before.1;
        }
        let (span, gone) = ((next.0 - before.0) as i128, (us - before.0) as i128);
        let rise = i128::from(next.1 - before.1) * gone / span;
        before.1 + rise as i64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn setpoints_as_technicians_say_them() {
        for (text, quantity, raw) in [
            ("25Hz", Quantity::Frequency, 2_500),
            ("-12,5 Hz", Quantity::Frequency, -1_250),
            ("30%", Quantity::Percent, 3_000),
            ("1450rpm", Quantity::Speed, 145_000),
            ("0 hz", Quantity::Frequency, 0),
        ] {
            assert_eq!(parse(text), Ok((quantity, raw)), "{text}");
        }
        for text in ["25", "", "Hz", "25 A", "25.001Hz"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn speed_becomes_frequency_by_pole_pairs() {
        assert_eq!(frequency_of_speed(150_000, 2), 5_000);
        assert_eq!(frequency_of_speed(145_000, 2), 4_833);
        assert_eq!(frequency_of_speed(-145_000, 2), -4_833);
    }

    #[test]
    fn ramps_are_straight_and_profiles_step() {
        let ramp = Schedule::ramp(0, 1_000, 10_000_000);
        assert_eq!([0, 5_000_000, 10_000_000, 20_000_000].map(|us| ramp.at(us)), [0, 500, 1_000, 1_000]);
        let steps = Schedule::steps(vec![(0, 500), (2_000_000, 1_000)]).unwrap();
        assert_eq!([0, 1_999_999, 2_000_000].map(|us| steps.at(us)), [500, 500, 1_000]);
        assert_eq!(Schedule::steps(vec![(5, 1), (5, 2)]), Err(2));
        assert_eq!(Schedule::steps(Vec::new()), Err(0));
    }
}
