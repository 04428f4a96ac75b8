//! The motor shaft: a frequency that follows its goal on straight ramps, or coasts.
//!
//! This is a training aid and no motor model: no slip, no load, no current limit. All times are exact, because the
//! frequency is a straight line between two events and is worked out only when somebody asks.

use crate::tick::{Span, Tick};

/// Slopes in hundredths of a hertz per second, per direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ramps {
    pub(super) up_right: i64,
    pub(super) down_right: i64,
    pub(super) up_left: i64,
    pub(super) down_left: i64,
}

impl Ramps {
    /// The same slope in all directions.
    pub(super) const fn all(slope: i64) -> Self {
        Ramps { up_right: slope, down_right: slope, up_left: slope, down_left: slope }
    }
}

/// How fast an unpowered shaft of the bench slows down: a bench value, 10 Hz/s.
const COASTING: Ramps = Ramps::all(1_000);
/// No motor turns faster: keeps the arithmetic far from its limits.
const FASTEST: i64 = 1 << 32;
/// Parts of a hundredth of a hertz; a slope of 0.01 Hz/s is then one part per microsecond.
const FINE: i64 = 1_000_000;

/// Frequency of the shaft. Positive turns clockwise.
#[derive(Clone, Debug)]
pub(super) struct Shaft {
    at: Tick,
    speed: i64,
    goal: i64,
    ramps: Ramps,
    powered: bool,
}

impl Shaft {
    /// A shaft at standstill.
    pub(super) fn new(at: Tick) -> Self {
        Shaft { at, speed: 0, goal: 0, ramps: COASTING, powered: false }
    }

    /// Powers the motor and leads it to `goal` (0.01 Hz). A coasting shaft is caught at its speed.
    pub(super) fn follow(&mut self, now: Tick, goal: i64, ramps: Ramps) {
        self.advance(now);
        self.goal = goal.clamp(-FASTEST, FASTEST) * FINE;
        self.ramps = ramps;
        self.powered = true;
    }

    /// Takes the power off.
    pub(super) fn coast(&mut self, now: Tick) {
        self.advance(now);
        self.goal = 0;
        self.ramps = COASTING;
        self.powered = false;
    }

    /// Whether the output stage is on.
    pub(super) fn powered(&self) -> bool {
        self.powered
    }

    /// Frequency of the rotor, in 0.01 Hz, at the time of the last event.
    pub(super) fn speed(&self) -> i64 {
        self.speed / FINE
    }

    /// Frequency of the stator, in 0.01 Hz: 0 without power.
    pub(super) fn output(&self) -> i64 {
        if self.powered { self.speed() } else { 0 }
    }

    /// Moves on to `now`.
    pub(super) fn advance(&mut self, now: Tick) {
        let mut left = micros(now.since(self.at));
        self.at = self.at.max(now);
        // At most two straight lines: down to zero, then up in the other direction.
        for _ in 0..2 {
            let (stop, slope) = self.leg();
            let distance = (stop - self.speed).abs();
            let time = distance.saturating_add(slope - 1) / slope;
            if time > left {
                self.speed += (stop - self.speed).signum() * slope * left;
                return;
            }
            self.speed = stop;
            left -= time;
        }
    }

    /// When the speed will have fallen to `limit` (0.01 Hz) on the way to standstill.
    pub(super) fn falls_to(&self, limit: i64) -> Tick {
        let (_, slope) = self.leg();
        let distance = (self.speed.abs() - limit.clamp(0, FASTEST) * FINE).max(0);
        let time = distance.saturating_add(slope - 1) / slope;
        self.at + Span::from_micros(time.unsigned_abs())
    }

    /// Where the present straight line ends, and how steep it is.
    fn leg(&self) -> (i64, i64) {
        let same_way = self.goal.signum() == self.speed.signum();
        let slowing = self.speed != 0 && (!same_way || self.goal.abs() < self.speed.abs());
        let stop = if slowing && !same_way { 0 } else { self.goal };
        let right = if slowing { self.speed > 0 } else { self.goal > 0 };
        let slope = match (slowing, right) {
            (true, true) => self.ramps.down_right,
            (true, false) => self.ramps.down_left,
            (false, true) => self.ramps.up_right,
            (false, false) => self.ramps.up_left,
        };
        (stop, slope.max(1))
    }
}

fn micros(span: Span) -> i64 {
    i64::try_from(span.as_micros()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAMPS: Ramps = Ramps { up_right: 500, down_right: 1_000, up_left: 250, down_left: 2_000 };

    fn after(shaft: &Shaft, millis: u64) -> i64 {
        let mut shaft = shaft.clone();
        shaft.advance(shaft.at + Span::from_millis(millis));
        shaft.speed()
    }

    #[test]
    fn ramps_are_straight_and_reverse_through_zero() {
        let mut shaft = Shaft::new(Tick::ZERO);
        shaft.follow(Tick::ZERO, 1_000, RAMPS);
        assert_eq!((after(&shaft, 500), after(&shaft, 2_000), after(&shaft, 60_000)), (250, 1_000, 1_000));
        shaft.advance(Tick::from_micros(2_000_000));
        shaft.follow(Tick::from_micros(2_000_000), -500, RAMPS);
        assert_eq!((after(&shaft, 500), after(&shaft, 1_000), after(&shaft, 2_000)), (500, 0, -250));
        assert_eq!(after(&shaft, 3_000), -500);
    }

    #[test]
    fn a_coasting_shaft_has_no_stator_frequency() {
        let mut shaft = Shaft::new(Tick::ZERO);
        shaft.follow(Tick::ZERO, 1_000, RAMPS);
        shaft.coast(Tick::from_micros(2_000_000));
        assert_eq!((shaft.speed(), shaft.output()), (1_000, 0));
        assert_eq!(shaft.falls_to(500), Tick::from_micros(2_500_000));
        assert_eq!(after(&shaft, 1_000), 0);
    }

    #[test]
    fn far_away_times_do_no_harm() {
        let mut shaft = Shaft::new(Tick::ZERO);
        shaft.follow(Tick::ZERO, i64::MAX, Ramps::all(i64::MAX));
        shaft.advance(Tick::from_micros(u64::MAX));
        shaft.follow(Tick::from_micros(u64::MAX), 0, Ramps::all(0));
        shaft.falls_to(0);
    }
}
