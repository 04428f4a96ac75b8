//! What the arrows of the keypad do: steps of the setpoint, within bounds that are agreed before.

use crate::args::KeypadArgs;
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, RunKeys};
use crate::profile::setpoint::Schedule;
use crate::profile::value::format_decimal;
use crate::text::{Text, both};

/// Steps and bounds, raw like the setpoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::command) struct Keys {
    pub(in crate::command) step: i64,
    pub(in crate::command) min: i64,
    pub(in crate::command) max: i64,
}

impl Keys {
    /// What was typed; `None` where the arrows do nothing. `raw` understands the value of an option as a setpoint, and `is_shown` says that
    /// there is a view that reads keys.
    pub(in crate::command) fn of(
        args: &KeypadArgs,
        raw: impl Fn(&str, &str) -> Result<i64, Failure>,
        schedule: &Schedule,
        is_shown: bool,
    ) -> Result<Option<Self>, Failure> {
        let Some(step) = &args.step else { return Ok(None) };
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
    pub(in crate::command) fn map(self, convert: impl Fn(i64) -> Option<i64>) -> Option<Self> {
        let Keys { step, min, max } = self;
        // What rounds to nothing would be a key without effect.
        Some(Keys { step: convert(step)?.max(1), min: convert(min)?, max: convert(max)? })
    }

    /// What the arrows do, as it is shown.
    pub(in crate::command) fn shown(self, decimals: u8, unit: &str) -> RunKeys {
        let value = |raw: i64| Decimal { raw, decimals };
        RunKeys { step: value(self.step), min: value(self.min), max: value(self.max), unit: unit.to_owned() }
    }

    /// What is agreed to that the arrows may do.
    pub(in crate::command) fn told(self, shown: impl Fn(i64) -> Text) -> Text {
        let [step, min, max] = [self.step, self.min, self.max].map(shown);
        both!(
            "the arrows change the setpoint by {step}, from {min} to {max}",
            "die Pfeile ändern den Sollwert um {step}, von {min} bis {max}",
            step,
            min,
            max
        )
    }

    /// What a key is told that would have left the bounds.
    pub(in crate::command) fn refused(self, decimals: u8, unit: &str) -> Text {
        let [min, max] = [self.min, self.max].map(|raw| format_decimal(raw, decimals));
        both!("agreed are {min} to {max} {unit}, no further", "vereinbart sind {min} bis {max} {unit}, weiter nicht")
    }

    /// The setpoint behind steps in their order; and whether one of them would have left the bounds, and was not taken.
    pub(in crate::command) fn after(self, from: i64, steps: &[i8]) -> (i64, bool) {
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

/// Options of the keypad that make no sense.
pub(in crate::command) fn bad(message: Text) -> Failure {
    Failure::new(Class::Usage, "usage.keys", message)
}

/// An option whose unit is not that of the setpoint.
pub(in crate::command) fn other_unit(flag: &str, text: &str) -> Failure {
    bad(both!(
        "{flag} {text}: expected the unit of the setpoint",
        "{flag} {text}: erwartet wird die Einheit des Sollwerts"
    ))
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
