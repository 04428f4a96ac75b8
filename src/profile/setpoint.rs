//! Setpoints as technicians say them (`25Hz`, `-12,5 Hz`, `30%`, `1450rpm`, `2/3`), and setpoints that change with time.

use super::family::Family;
use super::motion::{Convert, Mode};
use super::param::Param;
use super::value::{self, ValueError, parse_decimal};

/// A setpoint as it was said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Said {
    /// Raw value of the mode's setpoint; with `by_speed` a speed in 0.01 1/min.
    pub raw: i64,
    /// It is a speed that pole pairs make a frequency.
    pub by_speed: bool,
    /// Raw value of the mode's denominator.
    pub denominator: Option<i64>,
}

/// Decimals of a speed that is converted.
pub const SPEED_DECIMALS: u8 = 2;
/// Unit of a speed.
pub const SPEED_UNIT: &str = "1/min";

/// The kind of setpoint that a text means by its unit: the first that fits. `None` without a unit, because hertz and
/// percent are easily mixed up.
pub fn mode_of<'f>(family: &'f Family, text: &str) -> Option<&'f Mode> {
    family.modes.iter().find(|mode| {
        let unit = family.param(mode.setpoint).and_then(|param| param.unit.as_deref());
        let ratio = mode.denominator.is_some() && ratio(text).is_some();
        value::carries_unit(text, unit) || is_speed(mode, text) || ratio
    })
}

/// Reads a setpoint of a mode: a number with or without the unit of the mode, a speed (`1450rpm`) where that is converted, or a ratio (`2/3`)
/// where the mode takes one. Fails as [`value::parse`] does, and for a ratio over 0.
pub fn parse(family: &Family, mode: &Mode, text: &str) -> Result<Said, ValueError> {
    let said = |raw| Said { raw, by_speed: false, denominator: None };
    let raw = |id: u32, text: &str| {
        let param: Param = family.param_or_unknown(id);
        value::parse(text, &param, &family.choices(&param))
    };
    if let (Some(denominator), Some((above, below))) = (mode.denominator, ratio(text)) {
        let below = match raw(denominator, below)? {
            0 => return Err(ValueError::Denominator { text: text.to_owned() }),
            below => below,
        };
        return Ok(Said { denominator: Some(below), ..said(raw(mode.setpoint, above)?) });
    }
    if is_speed(mode, text) {
        let (number, _) = value::split_unit(text);
        return Ok(Said { by_speed: true, ..said(value::typed(number, SPEED_DECIMALS, 0)?) });
    }
    raw(mode.setpoint, text).map(said)
}

fn is_speed(mode: &Mode, text: &str) -> bool {
    mode.convert == Some(Convert::PolePairs) && value::carries_unit(text, Some(SPEED_UNIT))
}

/// The two numbers of a ratio.
fn ratio(text: &str) -> Option<(&str, &str)> {
    let (above, below) = text.split_once('/')?;
    let (above, below) = (above.trim(), below.trim());
    let is_number = |text: &str| parse_decimal(text, 0).is_ok();
    (is_number(above) && is_number(below)).then_some((above, below))
}

/// The frequency (0.01 Hz) that turns a motor with so many pole pairs at a speed (0.01 1/min), without slip; rounded
/// to the nearest hundredth. `None` if no number here can hold it.
pub fn frequency_of_speed(speed: i64, pole_pairs: i64) -> Option<i64> {
    let product = i128::from(speed) * i128::from(pole_pairs);
    i64::try_from((product + 30 * product.signum()) / 60).ok()
}

/// A setpoint that changes with time: points of time in microseconds, and raw values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    points: Vec<(u64, i64)>,
    /// Straight lines between the points; otherwise steps at them.
    straight: bool,
}

impl Schedule {
    /// So many places of a way are told one by one.
    const TOLD: usize = 6;

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

    /// The same with every value converted; `None` if one of them cannot be.
    pub fn map(&self, convert: impl Fn(i64) -> Option<i64>) -> Option<Self> {
        let points = self.points.iter().map(|&(us, raw)| Some((us, convert(raw)?))).collect::<Option<_>>()?;
        Some(Schedule { points, straight: self.straight })
    }

    /// When the last value is reached.
    pub fn end_us(&self) -> u64 {
        self.points.last().map_or(0, |point| point.0)
    }

    /// Largest magnitude of any value.
    pub fn peak(&self) -> i64 {
        self.points.iter().map(|point| point.1.saturating_abs()).max().unwrap_or(0)
    }

    /// Every value that it passes or jumps to.
    pub fn values(&self) -> impl Iterator<Item = i64> + '_ {
        self.points.iter().map(|point| point.1)
    }

    /// The way that it takes, from where it begins to where it ends by all places where it turns; of a long one the ends, and
    /// between them the least and the greatest.
    pub fn turns(&self) -> Vec<i64> {
        let mut way: Vec<i64> = Vec::new();
        for raw in self.values() {
            match way.as_slice() {
                [.., last] if *last == raw => {}
                [.., before, last] if (*last > *before) == (raw > *last) => {
                    way.pop();
                    way.push(raw);
                }
                _ => way.push(raw),
            }
        }
        let (Some(&first), Some(&last)) = (way.first(), way.last()) else { return way };
        if way.len() <= Self::TOLD {
            return way;
        }
        let least = way.iter().copied().min().unwrap_or(first);
        let greatest = way.iter().copied().max().unwrap_or(last);
        let mut told = vec![first, least, greatest, last];
        told.dedup();
        told
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
        let (span, gone) = (i128::from(next.0 - before.0), i128::from(us.saturating_sub(before.0)));
        let (whole, span) = (i128::from(next.1) - i128::from(before.1), span.max(1));
        let rise = whole.checked_mul(gone).map_or_else(|| whole / span * gone, |product| product / span);
        // Between two numbers of its type it is one of them too.
        i64::try_from(i128::from(before.1) + rise).unwrap_or(last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;
    use proptest::prelude::*;

    /// Mode, raw value, whether by speed, and denominator of what a drive's user says.
    fn said(drive: &str, text: &str) -> Option<(String, i64, bool, Option<i64>)> {
        let family = Registry::open(&[]).unwrap().family(drive).unwrap();
        let mode = mode_of(&family, text)?;
        let said = parse(&family, mode, text).ok()?;
        Some((mode.slug.clone(), said.raw, said.by_speed, said.denominator))
    }

    #[test]
    fn setpoints_as_technicians_say_them() {
        for (drive, text, mode, raw, by_speed) in [
            ("acu", "25Hz", "frequency", 2_500, false),
            ("acu", "-12,5 Hz", "frequency", -1_250, false),
            ("acu", "30%", "percent", 3_000, false),
            ("acu", "1450rpm", "frequency", 145_000, true),
            ("act", "1450 U/min", "frequency", 145_000, true),
            ("acu", "0 hz", "frequency", 0, false),
            ("lxm05", "1000rpm", "velocity", 1_000, false),
            ("lxm05", "48 usr", "position", 48, false),
            ("lxm05", "10A", "current", 1_000, false),
            ("lxm05", "500 mA", "current", 50, false),
        ] {
            assert_eq!(said(drive, text), Some((mode.to_owned(), raw, by_speed, None)), "{drive} {text}");
        }
        assert_eq!(said("lxm05", "2/3"), Some(("gear".to_owned(), 2, false, Some(3))));
        for text in ["25", "", "Hz", "25 A", "25.001Hz", "2/3"] {
            assert_eq!(said("acu", text), None, "{text}");
        }
    }

    #[test]
    fn a_mode_that_is_named_needs_no_unit() {
        let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
        let raw = |mode: &str, text: &str| parse(&family, family.mode(mode).unwrap(), text).map(|said| said.raw).ok();
        assert_eq!([raw("homing", "17"), raw("speed", "1000"), raw("position", "0x30")], [17, 1_000, 48].map(Some));
        assert_eq!([raw("jog", "positive, fast"), raw("homing", "limn")], [5, 17].map(Some));
        assert_eq!(raw("speed", "10 Hz"), None);
    }

    /// Where a setpoint stays for a while it has not turned.
    #[test]
    fn a_way_is_told_by_the_places_where_it_turns() {
        let turns = |values: &[i64]| {
            let points = (0..).zip(values.iter().copied()).collect();
            Schedule::steps(points).unwrap().turns()
        };
        assert_eq!((turns(&[2, 2]), turns(&[1, 2, 2, 3]), turns(&[1, 2, 2, 1])), (vec![2], vec![1, 3], vec![1, 2, 1]));
        assert_eq!((turns(&[3, 2, 2, 1]), turns(&[0, 5, -5, 0])), (vec![3, 1], vec![0, 5, -5, 0]));
    }

    #[test]
    fn speed_becomes_frequency_by_pole_pairs() {
        assert_eq!(frequency_of_speed(150_000, 2), Some(5_000));
        assert_eq!(frequency_of_speed(145_000, 2), Some(4_833));
        assert_eq!(frequency_of_speed(-145_000, 2), Some(-4_833));
        assert_eq!(frequency_of_speed(i64::MAX, 120), None);
    }

    #[test]
    fn a_frequency_is_rounded_to_the_nearest_on_both_sides_of_0() {
        for (speed, pairs, frequency) in [(89, 1, 1), (90, 1, 2), (29, 1, 0), (30, 1, 1), (100, 3, 5), (0, 3, 0)] {
            assert_eq!(frequency_of_speed(speed, pairs), Some(frequency), "{speed}");
            assert_eq!(frequency_of_speed(-speed, pairs), Some(-frequency), "{}", -speed);
        }
    }

    #[test]
    fn only_two_numbers_are_a_ratio() {
        let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
        for text in ["2/x", "x/3", "2/", "/3", "a/b"] {
            assert!(mode_of(&family, text).is_none(), "{text}");
        }
        assert_eq!(said("lxm05", " 2 / 3 "), Some(("gear".to_owned(), 2, false, Some(3))));
    }

    #[test]
    fn a_schedule_tells_its_end_its_values_and_the_largest_of_them() {
        let steps = Schedule::steps(vec![(0, 500), (2_000_000, -1_000), (3_000_000, 20)]).unwrap();
        assert_eq!((steps.end_us(), steps.peak()), (3_000_000, 1_000));
        assert_eq!(steps.values().collect::<Vec<_>>(), [500, -1_000, 20]);
        let doubled = steps.map(|raw| raw.checked_mul(2)).unwrap();
        assert_eq!((doubled.values().collect::<Vec<_>>(), doubled.at(1)), (vec![1_000, -2_000, 40], 1_000));
        assert_eq!(steps.map(|raw| (raw > 0).then_some(raw)), None, "one value that cannot be converted is enough");
        let ramp = Schedule::ramp(100, 300, 1_000).map(|raw| Some(raw + 1)).unwrap();
        assert_eq!((ramp.at(0), ramp.at(500), ramp.at(1_000)), (101, 201, 301), "what was straight stays so");
        let falling = Schedule::ramp(300, 100, 1_000);
        assert_eq!([0, 250, 750, 999].map(|us| falling.at(us)), [300, 250, 150, 101]);
        let late = Schedule { points: vec![(1_000, 100), (3_000, 300)], straight: true };
        assert_eq!([0, 1_000, 2_000, 3_000].map(|us| late.at(us)), [100, 100, 200, 300]);
        assert_eq!(Schedule::steps(vec![(1, 1), (2, 2), (2, 3)]), Err(3));
        assert!(Schedule::steps(vec![(1, 1), (2, 2)]).is_ok());
    }

    #[test]
    fn the_lower_number_of_a_ratio_is_never_0() {
        let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
        let gear = family.mode("gear").unwrap();
        assert!(matches!(parse(&family, gear, "2/0"), Err(ValueError::Denominator { .. })));
        assert!(matches!(parse(&family, gear, "2/-0"), Err(ValueError::Denominator { .. })));
    }

    proptest! {
        /// Whatever is typed as a setpoint of whatever drive: understood or refused, never a panic; led from the one to
        /// the other it never leaves the span between them.
        #[test]
        fn nothing_that_is_typed_panics_or_wraps(
            text in "[-+−]?[0-9a-fx./,]{0,24} ?(Hz|rpm|%|A|mA|usr|kHz|U/min)?", any in ".{0,16}", us: u64, end: u64,
            from: i64, to: i64, pairs: i64,
        ) {
            let registry = Registry::open(&[]).unwrap();
            for drive in ["act", "acu", "lxm05"] {
                let family = registry.family(drive).unwrap();
                for text in [&text, &any] {
                    let _either = mode_of(&family, text);
                    for mode in &family.modes {
                        let _either = parse(&family, mode, text).map(|said| frequency_of_speed(said.raw, pairs));
                    }
                }
            }
            let ramp = Schedule::ramp(from, to, end);
            let (value, _) = (ramp.at(us), ramp.peak());
            prop_assert!((from.min(to)..=from.max(to)).contains(&value));
            let _either = ramp.map(|raw| frequency_of_speed(raw, pairs));
        }
    }

    #[test]
    fn ramps_are_straight_and_profiles_step() {
        let ramp = Schedule::ramp(0, 1_000, 10_000_000);
        assert_eq!([0, 5_000_000, 10_000_000, 20_000_000].map(|us| ramp.at(us)), [0, 500, 1_000, 1_000]);
        let long = Schedule::ramp(6_825_505_067_119_499_983, -7_662_278_336_939_238_498, u64::MAX);
        assert!(long.at(u64::MAX / 2) < 0, "numbers at the end of their type do not wrap");
        let longest = Schedule::ramp(i64::MIN, i64::MAX, u64::MAX);
        assert_eq!(longest.at(u64::MAX - 1), i64::MAX - 1, "where no product holds it either");
        let steps = Schedule::steps(vec![(0, 500), (2_000_000, 1_000)]).unwrap();
        assert_eq!([0, 1_999_999, 2_000_000].map(|us| steps.at(us)), [500, 500, 1_000]);
        assert_eq!(Schedule::steps(vec![(5, 1), (5, 2)]), Err(2));
        assert_eq!(Schedule::steps(Vec::new()), Err(0));
    }
}
