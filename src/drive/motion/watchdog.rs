//! What the drive's own watchdog does once nobody talks to it any more, in words.

use super::look::{watchdog_seconds, working_raw};
use super::{Motor, may_turn};
use crate::outcome::Decimal;
use crate::profile::value::format_decimal;
use crate::profile::{Family, Param};
use crate::text::{Text, both};

impl Motor<'_, '_> {
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
