//! The motor shaft: a frequency that follows its goal on straight ramps, is braked, or coasts.
//!
//! All times are exact, because the frequency is a straight line between two events and is worked out only when
//! somebody asks. What the ramp asks for and what the rotor does differ by the slip of the [`Motor`], which comes and
//! goes with the load at once.

use super::motor::Motor;
use crate::tick::{Span, Tick};

/// Slopes in hundredths of a hertz per second, per direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ramps {
    pub(crate) up_right: i64,
    pub(crate) down_right: i64,
    pub(crate) up_left: i64,
    pub(crate) down_left: i64,
}

impl Ramps {
    /// The same slope in all directions.
    pub(crate) const fn all(slope: i64) -> Self {
        Ramps { up_right: slope, down_right: slope, up_left: slope, down_left: slope }
    }
}

/// How fast an unpowered shaft of the bench slows down: a bench value, 10 Hz/s.
const COASTING: Ramps = Ramps::all(1_000);
/// How fast the DC brake stops it: a bench value, 25 Hz/s.
const BRAKING: Ramps = Ramps::all(2_500);
/// No motor turns faster: keeps the arithmetic far from its limits.
const FASTEST: i64 = 1 << 32;
/// Parts of a hundredth of a hertz; a slope of 0.01 Hz/s is then one part per microsecond.
const FINE: i64 = 1_000_000;

/// What the output stage does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Off,
    /// Turning field.
    Field,
    /// Direct current.
    Brake,
}

/// Frequency of the shaft. Positive turns clockwise.
#[derive(Clone, Debug)]
pub(crate) struct Shaft {
    at: Tick,
    /// Frequency of the ramp with a turning field, else of the rotor.
    speed: i64,
    goal: i64,
    ramps: Ramps,
    stage: Stage,
    motor: Motor,
    /// What hangs at it is stronger than the drive: with a turning field it does not become slower.
    dragged: bool,
}

impl Shaft {
    /// A shaft at standstill.
    pub(crate) fn new(at: Tick) -> Self {
        Shaft { at, speed: 0, goal: 0, ramps: COASTING, stage: Stage::Off, motor: Motor::default(), dragged: false }
    }

    /// Motor data or load have changed.
    pub(crate) fn fit(&mut self, motor: Motor) {
        self.motor = motor;
    }

    /// It is kept from becoming slower, or let go.
    pub(crate) fn drag(&mut self, on: bool) {
        self.dragged = on;
    }

    /// Powers the motor and leads it to `goal` (0.01 Hz). A coasting shaft is caught at its speed.
    pub(crate) fn follow(&mut self, now: Tick, goal: i64, ramps: Ramps) {
        self.advance(now);
        self.goal = goal.clamp(-FASTEST, FASTEST) * FINE;
        self.ramps = ramps;
        self.stage = Stage::Field;
    }

    /// Takes the power off.
    pub(crate) fn coast(&mut self, now: Tick) {
        self.let_go(now, Stage::Off, COASTING);
    }

    /// Feeds direct current.
    pub(crate) fn brake(&mut self, now: Tick) {
        self.let_go(now, Stage::Brake, BRAKING);
    }

    fn let_go(&mut self, now: Tick, stage: Stage, ramps: Ramps) {
        self.advance(now);
        (self.speed, self.goal) = (self.rotor(), 0);
        (self.stage, self.ramps) = (stage, ramps);
    }

    /// Whether the output stage is on.
    pub(crate) fn powered(&self) -> bool {
        self.stage != Stage::Off
    }

    /// Frequency of the rotor, in 0.01 Hz, at the time of the last event.
    pub(crate) fn speed(&self) -> i64 {
        self.rotor() / FINE
    }

    /// Frequency behind the ramp, in 0.01 Hz: 0 without a turning field.
    pub(crate) fn ramp(&self) -> i64 {
        if self.stage == Stage::Field { self.speed / FINE } else { 0 }
    }

    /// Frequency of the stator, in 0.01 Hz.
    pub(crate) fn stator(&self) -> i64 {
        self.motor.stator(self.ramp())
    }

    /// Current, 0.1 A.
    pub(crate) fn current(&self) -> i64 {
        match self.stage {
            Stage::Off => 0,
            Stage::Field => self.motor.current(self.stator()),
            Stage::Brake => self.motor.rated_current(),
        }
    }

    /// Power, 0.1 kW.
    pub(crate) fn power(&self) -> i64 {
        self.motor.power(self.stator())
    }

    fn rotor(&self) -> i64 {
        if self.stage == Stage::Field { self.motor.rotor(self.speed, FINE) } else { self.speed }
    }

    /// Moves on to `now`.
    pub(crate) fn advance(&mut self, now: Tick) {
        let mut left = micros(now.since(self.at));
        self.at = self.at.max(now);
        // At most two straight lines: down to zero, then up in the other direction.
        for _ in 0..2 {
            let (stop, slope) = self.leg(self.speed);
            let time = duration(stop - self.speed, slope);
            if time > left {
                self.speed += (stop - self.speed).signum() * slope * left;
                return;
            }
            self.speed = stop;
            left -= time;
        }
    }

    /// When the ramp will have fallen to `limit` (0.01 Hz) on the way to standstill; never, if it is kept from that.
    pub(crate) fn falls_to(&self, limit: i64) -> Tick {
        if self.is_kept() && self.speed.abs() > limit.clamp(0, FASTEST) * FINE {
            return Tick::from_micros(u64::MAX);
        }
        let (_, slope) = self.leg(self.speed);
        let distance = (self.speed.abs() - limit.clamp(0, FASTEST) * FINE).max(0);
        self.at + Span::from_micros(duration(distance, slope).unsigned_abs())
    }

    /// Whether the turning field is faster than `limit` (0.01 Hz), in either direction.
    pub(crate) fn is_above(&self, limit: i64) -> bool {
        self.stage == Stage::Field && self.speed.abs() > limit.clamp(0, FASTEST) * FINE
    }

    /// When the turning field will be faster than `limit` (0.01 Hz) in either direction, if it goes on as it does.
    pub(crate) fn rises_above(&self, limit: i64) -> Option<Tick> {
        let enough = limit.clamp(0, FASTEST) * FINE + 1;
        if self.stage != Stage::Field || self.goal.abs() < enough {
            return self.is_above(limit).then_some(self.at);
        }
        let (mut speed, mut time) = (self.speed, 0);
        if speed.signum() * self.goal.signum() < 0 && speed.abs() < enough {
            let (stop, slope) = self.leg(speed);
            time += duration(stop - speed, slope);
            speed = stop;
        }
        let (_, slope) = self.leg(speed);
        time += duration((enough - speed.abs()).max(0), slope);
        Some(self.at + Span::from_micros(time.unsigned_abs()))
    }

    /// Whether it cannot become slower.
    fn is_kept(&self) -> bool {
        self.dragged && self.stage == Stage::Field
    }

    /// Where the straight line from `speed` ends, and how steep it is.
    fn leg(&self, speed: i64) -> (i64, i64) {
        let same_way = self.goal.signum() == speed.signum();
        let slowing = speed != 0 && (!same_way || self.goal.abs() < speed.abs());
        let stop = match slowing {
            true if self.is_kept() => speed,
            true if !same_way => 0,
            _ => self.goal,
        };
        let right = if slowing { speed > 0 } else { self.goal > 0 };
        let slope = match (slowing, right) {
            (true, true) => self.ramps.down_right,
            (true, false) => self.ramps.down_left,
            (false, true) => self.ramps.up_right,
            (false, false) => self.ramps.up_left,
        };
        (stop, slope.max(1))
    }
}

/// Microseconds that a change of speed takes, rounded up.
fn duration(change: i64, slope: i64) -> i64 {
    change.abs().saturating_add(slope - 1) / slope
}

fn micros(span: Span) -> i64 {
    i64::try_from(span.as_micros()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAMPS: Ramps = Ramps { up_right: 500, down_right: 1_000, up_left: 250, down_left: 2_000 };

    /// Without load.
    fn shaft() -> Shaft {
        Shaft::new(Tick::ZERO)
    }

    fn after(shaft: &Shaft, millis: u64) -> i64 {
        let mut shaft = shaft.clone();
        shaft.advance(shaft.at + Span::from_millis(millis));
        shaft.speed()
    }

    #[test]
    fn ramps_are_straight_and_reverse_through_zero() {
        let mut shaft = shaft();
        shaft.follow(Tick::ZERO, 1_000, RAMPS);
        assert_eq!((after(&shaft, 500), after(&shaft, 2_000), after(&shaft, 60_000)), (250, 1_000, 1_000));
        shaft.advance(Tick::from_micros(2_000_000));
        shaft.follow(Tick::from_micros(2_000_000), -500, RAMPS);
        assert_eq!((after(&shaft, 500), after(&shaft, 1_000), after(&shaft, 2_000)), (500, 0, -250));
        assert_eq!(after(&shaft, 3_000), -500);
    }

    #[test]
    fn a_coasting_shaft_has_no_stator_frequency() {
        let mut shaft = shaft();
        shaft.follow(Tick::ZERO, 1_000, RAMPS);
        shaft.coast(Tick::from_micros(2_000_000));
        assert_eq!((shaft.speed(), shaft.stator(), shaft.current()), (1_000, 0, 0));
        assert_eq!(shaft.falls_to(500), Tick::from_micros(2_500_000));
        assert_eq!(after(&shaft, 1_000), 0);
    }

    #[test]
    fn under_load_the_rotor_slips_and_a_brake_is_faster_than_nothing() {
        let mut shaft = shaft();
        shaft.fit(Motor::new(5_000, 1_390, 2, 8, 30, false));
        shaft.follow(Tick::ZERO, 1_000, RAMPS);
        shaft.advance(Tick::from_micros(2_000_000));
        assert_eq!((shaft.ramp(), shaft.stator(), shaft.speed()), (1_000, 1_000, 890));
        shaft.brake(Tick::from_micros(2_000_000));
        assert_eq!((shaft.stator(), shaft.speed(), shaft.powered(), shaft.current()), (0, 890, true, 20));
        assert_eq!((after(&shaft, 100), after(&shaft, 356)), (640, 0));
    }

    #[test]
    fn the_moment_of_passing_a_frequency_is_known() {
        let mut shaft = shaft();
        assert_eq!(shaft.rises_above(0), None);
        shaft.follow(Tick::ZERO, -1_000, RAMPS);
        let passes = shaft.rises_above(500).unwrap();
        assert_eq!(passes, Tick::from_micros(2_000_001));
        assert_eq!(shaft.rises_above(1_000), None);
        shaft.advance(Tick::from_micros(2_000_000));
        assert!(!shaft.is_above(500));
        shaft.advance(passes);
        assert!(shaft.is_above(500));
        assert_eq!(shaft.rises_above(500), Some(passes));
        // From 5 Hz anticlockwise through zero to 5 Hz clockwise and on.
        let mut shaft = self::shaft();
        shaft.follow(Tick::ZERO, -500, RAMPS);
        shaft.advance(Tick::from_micros(2_000_000));
        shaft.follow(Tick::from_micros(2_000_000), 1_000, RAMPS);
        assert_eq!(shaft.rises_above(600), Some(Tick::from_micros(3_450_001)));
    }

    #[test]
    fn far_away_times_do_no_harm() {
        let mut shaft = shaft();
        shaft.follow(Tick::ZERO, i64::MAX, Ramps::all(i64::MAX));
        shaft.rises_above(i64::MAX);
        shaft.rises_above(5);
        shaft.advance(Tick::from_micros(u64::MAX));
        shaft.follow(Tick::from_micros(u64::MAX), 0, Ramps::all(0));
        shaft.falls_to(0);
        shaft.rises_above(i64::MIN);
    }
}
