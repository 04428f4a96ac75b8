//! The motor and the load at its shaft: slip, current and power.
//!
//! A training aid and no motor model. It is made from the motor data of the drive (P.372, 373, 375, 376) and a load
//! that the bench file tells: a constant torque that brakes in both directions, in percent of the rated one. In the V/f
//! configurations (P.30 = 1xx) the drive sets the frequency of the stator and the rotor slips behind; in all others it
//! leads the rotor, and the stator runs ahead by the compensated slip (EM-RES-03 manual 6.1.4; CM-485 manual 10.2.3:
//! the actual value follows the control method).

/// Motor data and load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Motor {
    /// P.375, 0.01 Hz.
    rated_frequency: i64,
    /// 0.01 Hz.
    rated_slip: i64,
    /// P.376, 0.1 kW.
    rated_power: i64,
    /// Percent of the rated torque.
    torque: i64,
    leads_rotor: bool,
}

/// Torque at which the current limit steps in, percent: a bench value.
const LIMIT: i64 = 150;
/// Rated current of a bench motor, 0.1 A for each kilowatt.
const CURRENT_PER_KW: i64 = 25;

impl Default for Motor {
    /// Nothing is known yet.
    fn default() -> Self {
        Motor::new(0, 0, 0, 0, 0, false)
    }
}

impl Motor {
    /// From P.375, P.372, P.373, P.376, the load in percent, and whether the rotor is led.
    pub(crate) fn new(frequency: i64, speed: i64, pole_pairs: i64, power: i64, torque: i64, leads_rotor: bool) -> Self {
        let rated_frequency = frequency.max(1);
        let turning = speed.max(0).saturating_mul(pole_pairs.max(1)).saturating_mul(100) / 60;
        // Motor data that contradict each other give no slip, or that of a very bad motor.
        let rated_slip = rated_frequency.saturating_sub(turning).clamp(0, rated_frequency / 5);
        let (rated_power, torque) = (power.clamp(0, 0xFFFF), torque.clamp(0, 1_000));
        Motor { rated_frequency, rated_slip, rated_power, torque, leads_rotor }
    }

    /// Whether the current limit takes the speed away.
    pub(crate) fn overloaded(&self) -> bool {
        self.torque > LIMIT
    }

    /// Frequency of the rotor when the ramp stands at `ramp`; both in one unit, 0.01 Hz / `fine`.
    pub(crate) fn rotor(&self, ramp: i64, fine: i64) -> i64 {
        let slip = if self.leads_rotor { 0 } else { self.slip().saturating_mul(fine) };
        ramp.signum() * ramp.abs().saturating_sub(slip).max(0)
    }

    /// Frequency of the stator when the ramp stands at `ramp`, 0.01 Hz.
    pub(crate) fn stator(&self, ramp: i64) -> i64 {
        let slip = if self.leads_rotor { self.slip() } else { 0 };
        ramp + ramp.signum() * slip
    }

    /// Current at a frequency of the stator, 0.1 A: half the rated one magnetises, the load needs the rest.
    pub(crate) fn current(&self, stator: i64) -> i64 {
        let rated = self.rated_current();
        let torque = if stator == 0 && !self.overloaded() { 0 } else { self.drawn() };
        let (magnetising, active) = (rated * 50 / 100, rated * 87 * torque / 10_000);
        (magnetising * magnetising + active * active).isqrt()
    }

    /// Rated current, 0.1 A.
    pub(crate) fn rated_current(&self) -> i64 {
        self.rated_power * CURRENT_PER_KW / 10
    }

    /// Power at a frequency of the stator, 0.1 kW.
    pub(crate) fn power(&self, stator: i64) -> i64 {
        let whole = self.rated_frequency.saturating_mul(100);
        let power = i128::from(self.rated_power) * i128::from(self.drawn()) * i128::from(stator.unsigned_abs());
        i64::try_from((power + i128::from(whole / 2)) / i128::from(whole)).unwrap_or(i64::MAX)
    }

    fn slip(&self) -> i64 {
        self.rated_slip * self.drawn() / 100
    }

    fn drawn(&self) -> i64 {
        self.torque.min(LIMIT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slip_goes_behind_or_ahead_by_the_control_method() {
        // 50.00 Hz, 1390 1/min, 2 pole pairs: 3.67 Hz at rated torque.
        let scalar = Motor::new(5_000, 1_390, 2, 15, 100, false);
        let led = Motor::new(5_000, 1_390, 2, 15, 100, true);
        assert_eq!((scalar.stator(5_000), scalar.rotor(5_000, 1), scalar.rotor(-300, 1)), (5_000, 4_633, 0));
        assert_eq!((led.stator(-5_000), led.rotor(-5_000, 1), led.stator(0)), (-5_367, -5_000, 0));
    }

    #[test]
    fn current_and_power_grow_with_the_load_up_to_the_limit() {
        let motor = |torque| Motor::new(5_000, 1_390, 2, 15, torque, false);
        let currents = [0, 30, 100, 150, 400].map(|torque| motor(torque).current(5_000));
        assert_eq!(currents, [18, 20, 36, 51, 51]);
        assert_eq!([30, 100].map(|torque| motor(torque).power(5_000)), [5, 15]);
        assert!(motor(151).overloaded() && !motor(150).overloaded());
    }

    #[test]
    fn nonsense_does_no_harm() {
        let motor = Motor::new(i64::MIN, i64::MAX, i64::MAX, i64::MAX, i64::MAX, true);
        assert_eq!((motor.rotor(500, 1), motor.stator(500)), (500, 500));
        assert!(motor.power(1 << 40) > 0 && motor.current(1) > 0);
    }
}
