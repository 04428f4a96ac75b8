//! What the arrows of the keypad do: steps of the setpoint, within bounds that are agreed before.

use crate::args::KeypadArgs;
use crate::failure::{Class, Failure};
use crate::profile::setpoint::{self, Schedule};
use crate::profile::value::ValueError;
use crate::profile::{Family, Mode};
use crate::text::{Text, both};

/// Steps and bounds, raw like the setpoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Keys {
    pub(super) step: i64,
    pub(super) min: i64,
    pub(super) max: i64,
}

impl Keys {
    /// What was typed, in the words of the mode; `None` where the arrows do nothing. `is_shown`: there is a view that reads keys.
    pub(super) fn of(
        args: &KeypadArgs,
        (mode, family): (&Mode, &Family),
        schedule: &Schedule,
        (by_speed, is_shown): (bool, bool),
    ) -> Result<Option<Self>, Failure> {
        let Some(step) = &args.step else { return Ok(None) };
        if !mode.zero || !mode.starts.is_empty() || mode.codes.is_some() || mode.denominator.is_some() {
            return Err(bad(both!(
                "--step is for a setpoint that the shaft follows, not for '{mode}'",
                "--step gilt für einen Sollwert, dem die Welle folgt, nicht für '{mode}'",
                mode = mode.text()
            )));
        }
        let raw = |flag: &str, text: &str| {
            let said = setpoint::parse(family, mode, text).map_err(|error| wrong(flag, &error))?;
            (said.by_speed == by_speed).then_some(said.raw).ok_or_else(|| {
                bad(both!(
                    "{flag} {text}: expected the unit of the setpoint",
                    "{flag} {text}: erwartet wird die Einheit des Sollwerts"
                ))
            })
        };
        let lowest = schedule.values().min().unwrap_or(0);
        let highest = schedule.values().max().unwrap_or(0);
        let keys = Keys {
            step: raw("--step", step)?,
            min: args.min.as_deref().map_or(Ok(lowest.min(0)), |text| raw("--min", text))?,
            max: args.max.as_deref().map_or(Ok(highest.max(0)), |text| raw("--max", text))?,
        };
        if keys.step <= 0 {
            return Err(bad(both!("--step {step}: expected more than 0", "--step {step}: erwartet wird mehr als 0")));
        }
        if keys.min > lowest || keys.max < highest {
            return Err(bad(both!(
                "the setpoint of the run must lie between --min and --max",
                "der Sollwert des Laufs muss zwischen --min und --max liegen"
            )));
        }
        if !is_shown {
            return Err(bad(both!(
                "the arrows of --step belong to the live view, and none is asked for: nothing would read a key",
                "die Pfeile von --step gehören zur Ansicht, und die ist nicht verlangt: nichts würde eine Taste lesen"
            ))
            .hint(both!("add --view, or --dead-man", "--view oder --dead-man angeben")));
        }
        Ok(Some(keys))
    }

    /// The same with every value converted.
    pub(super) fn map(self, convert: impl Fn(i64) -> Option<i64>) -> Option<Self> {
        let Keys { step, min, max } = self;
        // What rounds to nothing would be a key without effect.
        Some(Keys { step: convert(step)?.max(1), min: convert(min)?, max: convert(max)? })
    }

    /// The setpoint behind steps in their order; and whether one of them would have left the bounds, and was not taken.
    pub(super) fn after(self, from: i64, steps: &[i8]) -> (i64, bool) {
        let mut refused = false;
        let step = |now: i64, step: &i8| {
            let next = self.step.checked_mul(i64::from(*step)).and_then(|by| now.checked_add(by));
            match next.filter(|next| (self.min..=self.max).contains(next)) {
                Some(next) => next,
                None => {
                    refused = true;
                    now
                }
            }
        };
        (steps.iter().fold(from, step), refused)
    }
}

fn bad(message: Text) -> Failure {
    Failure::new(Class::Usage, "usage.keys", message)
}

fn wrong(flag: &str, error: &ValueError) -> Failure {
    bad(both!("{flag}: {why}", "{flag}: {why}", why = error.text()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_stay_within_their_bounds_and_each_is_taken_or_not() {
        let keys = Keys { step: 100, min: -150, max: 300 };
        for (from, steps, expected) in [
            (0, &[1i8, 1][..], (200, false)),
            (250, &[1], (250, true)),
            (250, &[1, -1, 1], (250, true)),
            (-100, &[-1], (-100, true)),
            (0, &[-1], (-100, false)),
            (300, &[-1, 1, 1], (300, true)),
            (0, &[], (0, false)),
        ] {
            assert_eq!(keys.after(from, steps), expected, "{from} {steps:?}");
        }
        let huge = Keys { step: i64::MAX, min: i64::MIN, max: i64::MAX };
        assert_eq!(huge.after(1, &[1]), (1, true), "a sum that no number holds is none");
        assert_eq!(huge.after(-2, &[-1]), (-2, true));
    }

    #[test]
    fn a_step_that_rounds_to_nothing_is_the_least() {
        let keys = Keys { step: 10, min: 0, max: 6_000 };
        let half = |raw: i64| Some(raw / 60);
        assert_eq!(keys.map(half), Some(Keys { step: 1, min: 0, max: 100 }));
        assert_eq!(keys.map(|_| None), None);
    }
}
