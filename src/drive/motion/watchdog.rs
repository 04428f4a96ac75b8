//! The drive's own watchdog: what feeds it, and in words what it does once nobody talks to the drive any more.

use super::Motor;
use super::look::{watchdog_seconds, working_raw};
use crate::drive::target::Target;
use crate::failure::{Class, Failure, may_turn};
use crate::outcome::Decimal;
use crate::profile::value::format_decimal;
use crate::profile::{Family, Param};
use crate::text::{Text, both};
use crate::tick::Span;

impl Motor<'_, '_> {
    /// Writes what was written last once more, which changes nothing, before the drive's watchdog misses us: some are fed
    /// by writes only. An enable is repeated only to a drive that has just said that it is enabled.
    pub(super) async fn feed(&mut self, enabled: bool) -> Result<(), Failure> {
        let (Some(guard), Some((param, raw))) = (self.guard, self.again.clone()) else { return Ok(()) };
        let is_due = self.session.now().since(self.fed).as_micros() >= guard.as_micros() / 3;
        if !is_due || (self.is_control_word(&param) && self.enables(raw) && !enabled) {
            return Ok(());
        }
        self.write_again(&param, raw).await
    }

    /// Writes something once more. Whether the drive has heard it is what the next look tells.
    pub(super) async fn write_again(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        match self.write_once(param, 0, raw).await {
            Err(failure) if matches!(failure.class, Class::Port | Class::Interrupted) => Err(failure),
            _ => Ok(()),
        }
    }

    pub(super) fn is_control_word(&self, param: &Param) -> bool {
        self.target.family.role("control-word").is_some_and(|word| word.id == param.id)
    }

    /// Whether a control word asks for power.
    pub(super) fn enables(&self, word: i64) -> bool {
        let enable = self.target.family.machine.command("enable");
        enable.is_some_and(|row| word & i64::from(row.mask) == i64::from(row.value))
    }

    /// What is to be known of it where the stop was not proven.
    pub(super) async fn watchdog_note(&mut self) -> Text {
        let changed = self.target.family.role("watchdog").map(|param| param.id);
        let set = self.changes.iter().find(|change| Some(change.param) == changed).map(|change| change.new);
        let raw = match set {
            Some(raw) => Some(raw),
            None => {
                let told = working_raw(self.session, self.target, "watchdog").await;
                told.ok().flatten().or(self.target.known_watchdog)
            }
        };
        let family = &self.target.family;
        match raw {
            Some(raw) if raw > 0 => watchdog_words(family, Some(watchdog_seconds(family, raw))),
            raw => {
                let words = watchdog_words(family, raw.map(|raw| watchdog_seconds(family, raw)));
                Text::join([&words, &may_turn()], ": ")
            }
        }
    }
}

/// The drive's watchdog as a time, if it is on.
pub(super) fn guard(target: &Target, watchdog: Option<i64>) -> Option<Span> {
    let watchdog = watchdog.map(|raw| watchdog_seconds(&target.family, raw)).filter(|span| span.raw > 0)?;
    Some(Span::from_millis(watchdog.raw.unsigned_abs() * 1_000 / 10u64.pow(watchdog.decimals.into())))
}

/// What the drive's watchdog is set to, and what it does then.
pub fn watchdog_words(family: &Family, seconds: Option<Decimal>) -> Text {
    let label = family.role("watchdog").map_or_else(|| "-".to_owned(), Param::label);
    match seconds {
        Some(off) if off.raw == 0 => {
            both!("the drive's watchdog ({label}) is off", "der Watchdog ({label}) ist aus")
        }
        Some(on) => both!(
            "the drive's watchdog ({label}) is {seconds} s: {does}",
            "der Watchdog ({label}) steht auf {seconds} s: {does}",
            seconds = format_decimal(on.raw, on.decimals),
            does = family.motion.watchdog
        ),
        None => {
            both!("whether the drive's watchdog stops it is not known", "ob der Watchdog abschaltet, ist unbekannt")
        }
    }
}
