//! Watching a shaft from look to look: does it stand, does it still change?

use crate::profile::Movement;
use crate::tick::Tick;

/// What the last looks at a shaft tell.
#[derive(Debug)]
pub(super) struct Watch {
    movement: Movement,
    last: Option<(Tick, i64)>,
    /// Speed of the shaft; of a position the change in a second.
    pace: Option<i64>,
    /// The pace that counts as unchanged.
    steady: Option<i64>,
}

impl Watch {
    pub(super) fn new(movement: Movement) -> Self {
        Watch { movement, last: None, pace: None, steady: None }
    }

    /// Takes a look; says whether the shaft has become faster or slower.
    pub(super) fn see(&mut self, now: Tick, raw: Option<i64>) -> bool {
        let Some(raw) = raw else { return false };
        self.pace = match (self.movement, self.last) {
            (Movement::Speed, _) => Some(raw),
            (Movement::Position, None) => None,
            (Movement::Position, Some((then, before))) if (raw - before).abs() <= JITTER || now <= then => Some(0),
            (Movement::Position, Some((then, before))) => {
                let span = i128::from(now.since(then).as_micros());
                i64::try_from(i128::from(raw - before) * 1_000_000 / span).ok()
            }
        };
        self.last = Some((now, raw));
        let Some(pace) = self.pace else { return true };
        let tolerance = match self.movement {
            Movement::Speed => 0,
            Movement::Position => pace.abs() / 8,
        };
        let changed = self.steady.is_none_or(|steady| (pace - steady).abs() > tolerance);
        if changed {
            self.steady = Some(pace);
        }
        changed
    }

    /// Whether the shaft stands; one look at a position does not tell.
    pub(super) fn stands(&self) -> bool {
        self.pace == Some(0)
    }
}

/// A servo that holds its position may still toggle by an increment.
const JITTER: i64 = 1;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tick::Span;

    fn looks(movement: Movement, values: &[i64]) -> (Vec<bool>, bool) {
        let mut watch = Watch::new(movement);
        let at = |index: usize| Tick::ZERO + Span::from_millis(50 * index as u64);
        let seen = values.iter().enumerate().map(|(index, &value)| watch.see(at(index), Some(value))).collect();
        (seen, watch.stands())
    }

    #[test]
    fn a_speed_tells_by_itself() {
        assert_eq!(looks(Movement::Speed, &[500, 400, 400]), (vec![true, true, false], false));
        assert!(looks(Movement::Speed, &[0]).1);
    }

    #[test]
    fn a_position_tells_by_its_change() {
        // Steady for two looks, slowing down, standing with the jitter of a servo.
        let (changed, stands) = looks(Movement::Position, &[0, 100, 200, 260, 261, 260]);
        assert_eq!((changed, stands), (vec![true, true, false, true, true, false], true));
        assert!(!looks(Movement::Position, &[7]).1, "one look is not enough");
    }
}
