//! The motor shaft in steps of a millisecond: a speed that follows its goal on ramps, and the position that results.
//!
//! All numbers are whole. Speeds count in 0.001 1/min, ramps in 1/min per second, which is 0.001 1/min per step. At
//! [`USR_PER_TURN`] user units a turn a step moves the shaft by 64 / 234375 user units for every unit of speed, so
//! positions count in parts of a user unit.

/// User units of one turn: a choice of the bench.
pub(crate) const USR_PER_TURN: i64 = 16_384;
/// Parts of a user unit.
pub(crate) const PARTS: i64 = 234_375;
/// Parts that one unit of speed makes in a step.
const STEP: i64 = 64;
/// Units of speed in 1/min.
pub(crate) const PER_RPM: i64 = 1_000;

/// How fast an unpowered shaft slows down, 1/min in a second: a choice of the bench.
const COASTING: i64 = 1_000;

/// How steep a change of speed may be, 1/min in a second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ramps {
    pub(crate) up: i64,
    pub(crate) down: i64,
}

/// Speed and position of the shaft, positive clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Axis {
    /// Parts of a user unit from where the shaft stood when the bench was built.
    position: i64,
    /// 0.001 1/min.
    speed: i64,
}

impl Axis {
    pub(crate) fn position(self) -> i64 {
        self.position
    }

    pub(crate) fn speed(self) -> i64 {
        self.speed
    }

    /// One step towards a speed.
    pub(crate) fn accelerate_to(&mut self, goal: i64, ramps: Ramps) {
        self.step(self.towards(goal, ramps));
    }

    /// One step towards a position, at most at speed `top`; tells whether it stands there.
    pub(crate) fn move_to(&mut self, goal: i64, top: i64, ramps: Ramps) -> bool {
        let distance = goal.saturating_sub(self.position).max(-i64::MAX);
        // What a step cannot resolve is taken at once.
        if distance.abs() < STEP && self.speed.abs() <= ramps.down {
            *self = Axis { position: goal, speed: 0 };
            return true;
        }
        let speed = fastest_that_stops(distance.abs() / STEP, ramps.down).min(top.max(0));
        self.step(self.towards(distance.signum() * speed, ramps));
        false
    }

    /// One step without power.
    pub(crate) fn coast(&mut self) {
        self.accelerate_to(0, Ramps { up: COASTING, down: COASTING });
    }

    /// Goes on as `before` the last step, if that has made it slower.
    pub(crate) fn keep_pace(&mut self, before: Axis) {
        if self.speed.abs() < before.speed.abs() {
            *self = before;
            self.step(before.speed);
        }
    }

    fn step(&mut self, speed: i64) {
        self.speed = speed;
        self.position = self.position.saturating_add(speed.saturating_mul(STEP));
    }

    /// The speed after one step towards `goal`. On the way into the other direction the shaft stands for a step.
    fn towards(self, goal: i64, ramps: Ramps) -> i64 {
        let (now, same_way) = (self.speed, self.speed.signum() * goal.signum() >= 0);
        if now != 0 && (!same_way || goal.abs() < now.abs()) {
            let lowest = if same_way { goal.abs() } else { 0 };
            return now.signum() * (now.abs() - ramps.down.max(1)).max(lowest);
        }
        goal.signum() * goal.abs().min(now.abs() + ramps.up.max(1))
    }
}

/// The fastest speed from which the shaft, losing `down` a step, stops within `distance`, both in steps.
fn fastest_that_stops(distance: i64, down: i64) -> i64 {
    // `whole` full steps down from v, and a smaller one: (whole + 1) (whole down / 2 + rest) of way.
    let (down, distance) = (i128::from(down.max(1)), i128::from(distance));
    let whole = ((1 + 8 * (distance / down)).isqrt() - 1) / 2;
    let rest = (distance - whole * (whole + 1) / 2 * down) / (whole + 1);
    i64::try_from(whole * down + rest).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAMPS: Ramps = Ramps { up: 2_000, down: 4_000 };

    #[test]
    fn a_second_of_the_acceleration_ramp_gives_its_speed() {
        let mut axis = Axis::default();
        (0..500).for_each(|_| axis.accelerate_to(5_000 * PER_RPM, RAMPS));
        assert_eq!(axis.speed(), 1_000 * PER_RPM);
        // 1000 1/min after half a second: about 500 / 60 / 2 turns.
        assert_eq!(axis.position() / PARTS, 68_403);
        (0..250).for_each(|_| axis.accelerate_to(-PER_RPM, RAMPS));
        assert_eq!(axis.speed(), 0);
        axis.accelerate_to(-PER_RPM, RAMPS);
        assert_eq!(axis.speed(), -PER_RPM);
    }

    #[test]
    fn a_position_is_met_exactly_and_never_passed() {
        for (target, top) in [(48, 4_000), (-1, 4_000), (1_000_000, 4_000), (-5_000_000, 100), (123_457, 13_200)] {
            let mut axis = Axis::default();
            let mut steps = 0;
            while !axis.move_to(target * PARTS, top * PER_RPM, RAMPS) {
                steps += 1;
                assert!(axis.position().abs() <= (target * PARTS).abs(), "{target}: {axis:?}");
                assert!(axis.speed().abs() <= top * PER_RPM && steps < 300_000, "{target}: {axis:?}");
            }
            assert_eq!((axis.position(), axis.speed()), (target * PARTS, 0), "{target}");
        }
    }

    #[test]
    fn a_target_behind_a_moving_shaft_is_met_by_turning_back() {
        let mut axis = Axis::default();
        (0..1_000).for_each(|_| axis.accelerate_to(2_000 * PER_RPM, RAMPS));
        let mut steps = 0;
        while !axis.move_to(0, 1_000 * PER_RPM, RAMPS) {
            steps += 1;
            assert!(steps < 20_000, "{axis:?}");
        }
        assert_eq!(axis, Axis::default());
    }

    #[test]
    fn far_away_goals_do_no_harm() {
        let mut axis = Axis { position: i64::MAX - 1, speed: i64::MAX / 128 };
        axis.move_to(i64::MIN, i64::MAX, Ramps { up: i64::MAX / 2, down: 1 });
        axis.accelerate_to(i64::MIN / 2, Ramps { up: 0, down: 0 });
    }
}
