//! A synchronous motor that is led by its resolver (EM-RES-03 manual 6.4.1).
//!
//! The drive takes the position of the rotor from the resolver and P.382. By how far that is off, in electrical degrees, the
//! current meets the field of the rotor at a wrong angle: its torque is the cosine of that angle, and the voltage of the turning rotor shows in
//! the flux-forming voltage by the sine. So the manual has it: near the right offset that voltage is about 0, positive where the offset
//! must grow, negative where it must shrink; a change by 360° through the ratio of the pole pairs changes nothing.
//!
//! Choices where the manual is silent:
//! - less than a fifth of the torque moves no shaft (the current limit P.728 is low and there is friction): it stands;
//! - torque the other way round makes the speed controller ask for more and more of it: the shaft races away, by 50 Hz/s, until
//!   F1100 at P.417, which is read in 0.01 Hz; with P.417 = 0 nothing of the drive ends it;
//! - somebody who wired the sine track the wrong way round is told by P.219 only: what the motor then does is not modelled;
//! - with two phases exchanged field and rotor turn against each other: it stands at every offset;
//! - P.235 has no unit in the manual: here it is the sine of a voltage of one for each 0.01 Hz of the rotor.

/// How the rotor follows what the drive does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Follows {
    /// It turns as it is told.
    Setpoint,
    /// It stands.
    Nothing,
    /// It races away, against the setpoint.
    Itself,
}

/// A motor with a resolver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Resolver {
    /// What P.382 must be, 0.1°.
    pub(crate) offset: i64,
    /// Two phases of the motor are exchanged.
    pub(crate) swapped: bool,
    /// SIN+ and SIN- are: clockwise shows as negative, unless P.492 turns it round again.
    pub(crate) inverted: bool,
}

/// Where the drive looks for the rotor: P.382 in 0.1°, P.373, P.381.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Angle {
    pub(crate) offset: i64,
    pub(crate) motor_pairs: i64,
    pub(crate) resolver_pairs: i64,
}

/// Less torque than this share of what there is moves nothing.
const STICKS: f64 = 0.2;
/// How fast a shaft races away, 0.01 Hz/s, and where it ends if nothing else ends it, 0.01 Hz.
pub(crate) const RACES: i64 = 5_000;
pub(crate) const FASTEST: i64 = 50_000;

impl Resolver {
    /// By how much the drive is off, as an electrical angle in radians.
    fn error(self, angle: Angle) -> f64 {
        let ratio = angle.motor_pairs.max(1) as f64 / angle.resolver_pairs.max(1) as f64;
        ((angle.offset - self.offset) as f64 / 10.0 * ratio).to_radians()
    }

    /// What the rotor does.
    pub(crate) fn follows(self, angle: Angle) -> Follows {
        let torque = self.error(angle).cos();
        match torque {
            _ if self.swapped => Follows::Nothing,
            torque if torque > STICKS => Follows::Setpoint,
            torque if torque < -STICKS => Follows::Itself,
            _ => Follows::Nothing,
        }
    }

    /// P.235 at a speed of the rotor (0.01 Hz).
    pub(crate) fn flux_voltage(self, speed: i64, angle: Angle) -> i64 {
        (-self.error(angle).sin() * speed as f64).round() as i64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOTOR: Resolver = Resolver { offset: 375, swapped: false, inverted: false };

    fn three_pairs(offset: i64) -> Angle {
        Angle { offset, motor_pairs: 3, resolver_pairs: 1 }
    }

    #[test]
    fn the_voltage_tells_the_way_to_the_offset_and_is_0_there() {
        let at = |offset: i64| MOTOR.flux_voltage(500, three_pairs(offset));
        assert_eq!(at(375), 0);
        assert!(at(350) > 0 && at(400) < 0 && at(300) > at(350));
        // 360° / (3 / 1), up and down (EM-RES-03 manual 6.4.1).
        assert_eq!([at(350 + 1_200), at(350 - 1_200)], [at(350); 2]);
    }

    #[test]
    fn a_quarter_off_it_stands_and_a_half_off_it_races() {
        let follows = |offset: i64| MOTOR.follows(three_pairs(offset));
        assert_eq!([375, 375 + 200, 375 - 200].map(follows), [Follows::Setpoint; 3]);
        // 90° and 180° through the pole pairs of the motor.
        assert_eq!([375 + 300, 375 - 300].map(follows), [Follows::Nothing; 2]);
        assert_eq!([375 + 600, 375 - 600, 375 + 400].map(follows), [Follows::Itself; 3]);
        assert_eq!(Resolver { swapped: true, ..MOTOR }.follows(three_pairs(375)), Follows::Nothing);
    }
}
