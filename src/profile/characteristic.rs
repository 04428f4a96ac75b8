//! The characteristic of the analog input of an EM-RES-03: what setpoint a voltage becomes (EM-RES-03 manual 6.1.2, 6.1.3, 6.1.5).
//!
//! Printed is the line through two points, what each mode makes of the points, and that the setpoint stays zero within a band around its
//! change of sign. What comes beyond the points is not printed: [`Characteristic::is_printed`] tells.

/// The settings, in hundredths of a percent: of 10 V (X and band) and of the largest setpoint (Y).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Points {
    /// P.564 and P.565.
    pub first: (i64, i64),
    /// P.566 and P.567.
    pub second: (i64, i64),
    /// P.560.
    pub band: i64,
}

/// What P.562 makes of the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// 1: as they are.
    Bipolar,
    /// 11: one below zero volt goes into the origin.
    Unipolar,
    /// 21: the points lie between 2 and 10 V, and one below zero goes to 2 V.
    From2V,
    /// 101: as bipolar, without sign.
    Absolute,
}

/// A line, in volt and percent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Characteristic {
    first: (f64, f64),
    second: (f64, f64),
    band: f64,
    mode: Mode,
}

/// Hundredths of a percent that are all of it, and full scale.
const WHOLE: f64 = 10_000.0;
const FULL: f64 = 10.0;
/// Where the input begins in mode 21.
const LIVE_ZERO: f64 = 2.0;

impl Mode {
    /// All of them.
    pub const ALL: [Mode; 4] = [Mode::Bipolar, Mode::Unipolar, Mode::From2V, Mode::Absolute];

    /// The value of P.562.
    pub fn code(self) -> i64 {
        match self {
            Mode::Bipolar => 1,
            Mode::Unipolar => 11,
            Mode::From2V => 21,
            Mode::Absolute => 101,
        }
    }

    /// From which voltage on it takes a signal (EM-RES-03 manual 6.1.2; mode 21 is limited to 20 to 100 % of it).
    pub fn begins(self) -> f64 {
        match self {
            Mode::Bipolar | Mode::Absolute => -FULL,
            Mode::Unipolar => 0.0,
            Mode::From2V => LIVE_ZERO,
        }
    }

    /// Where a point comes to lie.
    fn placed(self, (x, y): (i64, i64)) -> (f64, f64) {
        let (share, y) = (x as f64 / WHOLE, y as f64 / WHOLE * 100.0);
        match self {
            Mode::Unipolar if x < 0 => (0.0, 0.0),
            Mode::From2V if x < 0 => (LIVE_ZERO, 0.0),
            Mode::From2V => (share * (FULL - LIVE_ZERO) + LIVE_ZERO, y),
            _ => (share * FULL, y),
        }
    }
}

impl Characteristic {
    /// `None` where both points have one voltage: no line goes through them.
    pub fn new(points: Points, mode: Mode) -> Option<Self> {
        let (first, second) = (mode.placed(points.first), mode.placed(points.second));
        let scale = if mode == Mode::From2V { FULL - LIVE_ZERO } else { FULL };
        let band = points.band as f64 / WHOLE * scale;
        (first.0 != second.0).then_some(Characteristic { first, second, band, mode })
    }

    /// The setpoint in percent at a voltage.
    pub fn at(&self, volts: f64) -> f64 {
        let is_zero = self.turns_at().is_some_and(|(turns, band)| (volts - turns).abs() < band);
        let value = if is_zero { 0.0 } else { self.line(volts) };
        if self.mode == Mode::Absolute { value.abs() } else { value }
    }

    /// The voltage at which the setpoint changes its sign between the points, and how far around it stays zero.
    pub fn turns_at(&self) -> Option<(f64, f64)> {
        let ((x1, y1), (x2, y2)) = (self.first, self.second);
        (y1 * y2 < 0.0).then(|| (x1 - y1 * (x2 - x1) / (y2 - y1), self.band))
    }

    /// Whether a voltage lies between the points, where the setpoint is printed.
    pub fn is_printed(&self, volts: f64) -> bool {
        let (low, high) = self.ends();
        (low..=high).contains(&volts)
    }

    /// The voltages of the points, the lower one first.
    pub fn ends(&self) -> (f64, f64) {
        (self.first.0.min(self.second.0), self.first.0.max(self.second.0))
    }

    /// Voltages that a drawing needs from one to another: the ends, the points, and the edges of the band from both sides.
    pub fn corners(&self, from: f64, to: f64) -> Vec<f64> {
        /// A step that no drawing shows.
        const BESIDE: f64 = 1e-9;
        let edges = self.turns_at().into_iter().flat_map(|(turns, band)| {
            [turns - band - BESIDE, turns - band + BESIDE, turns, turns + band - BESIDE, turns + band + BESIDE]
        });
        let (low, high) = self.ends();
        let mut all: Vec<f64> = edges.chain([from, low, high, to]).filter(|x| (from..=to).contains(x)).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    fn line(&self, volts: f64) -> f64 {
        let ((x1, y1), (x2, y2)) = (self.first, self.second);
        (y2 - y1) / (x2 - x1) * (volts - x1) + y1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of 6.1.3.1.
    const WIDE: Points = Points { first: (-7_000, -5_000), second: (8_000, 8_500), band: 200 };
    const NARROW: Points = Points { first: (3_000, -5_000), second: (8_000, 8_500), band: 200 };

    fn of(points: Points, mode: Mode) -> Characteristic {
        Characteristic::new(points, mode).unwrap()
    }

    /// To the printed digit: two decimals.
    fn turns(points: Points, mode: Mode) -> Option<(String, String)> {
        of(points, mode).turns_at().map(|(at, band)| (format!("{at:.2}"), format!("{band:.2}")))
    }

    #[test]
    fn the_examples_turn_where_the_manual_prints_it() {
        let told = |at: &str, band: &str| Some((at.to_owned(), band.to_owned()));
        assert_eq!(turns(WIDE, Mode::Bipolar), told("-1.44", "0.20"));
        assert_eq!(turns(WIDE, Mode::Unipolar), None);
        assert_eq!(turns(NARROW, Mode::Unipolar), told("4.85", "0.20"));
        assert_eq!(turns(WIDE, Mode::From2V), None);
        assert_eq!(turns(NARROW, Mode::From2V), told("5.88", "0.16"));
        assert_eq!(turns(WIDE, Mode::Absolute), told("-1.44", "0.20"));
    }

    #[test]
    fn points_go_where_the_modes_put_them() {
        let ends = |points, mode| of(points, mode).ends();
        assert_eq!(ends(WIDE, Mode::Bipolar), (-7.0, 8.0));
        assert_eq!(ends(WIDE, Mode::Unipolar), (0.0, 8.0));
        assert_eq!(ends(WIDE, Mode::From2V), (2.0, 8.4));
        assert_eq!(ends(NARROW, Mode::From2V), (4.4, 8.4));
        assert_eq!((of(WIDE, Mode::Unipolar).at(0.0), of(WIDE, Mode::From2V).at(2.0)), (0.0, 0.0));
        for mode in Mode::ALL {
            assert!((of(WIDE, mode).at(of(WIDE, mode).ends().1) - 85.0).abs() < 1e-9, "{mode:?}");
        }
        assert!((of(WIDE, Mode::Bipolar).at(-7.0) + 50.0).abs() < 1e-9);
        assert!((of(WIDE, Mode::Absolute).at(-7.0) - 50.0).abs() < 1e-9);
    }

    /// Below 2 V mode 21 takes nothing (6.1.2: limited to 20 to 100 %).
    #[test]
    fn a_mode_begins_where_it_takes_a_signal() {
        assert_eq!(Mode::ALL.map(Mode::begins), [-10.0, 0.0, 2.0, -10.0]);
    }

    #[test]
    fn within_the_band_nothing_is_wanted() {
        let line = of(WIDE, Mode::Bipolar);
        assert_eq!((line.at(-1.44), line.at(-1.25)), (0.0, 0.0));
        assert!(line.at(-1.2) > 2.0 && line.at(-1.7) < -2.0);
        assert!(of(WIDE, Mode::Absolute).at(-1.7) > 2.0);
    }

    #[test]
    fn no_line_goes_through_one_voltage() {
        let same = Points { second: (-7_000, 8_500), ..WIDE };
        assert_eq!(Characteristic::new(same, Mode::Bipolar), None);
        // Both below zero lie in the origin then.
        let below = Points { second: (-1_000, 8_500), ..WIDE };
        assert!(Characteristic::new(below, Mode::Bipolar).is_some());
        assert_eq!(Characteristic::new(below, Mode::Unipolar), None);
    }
}
