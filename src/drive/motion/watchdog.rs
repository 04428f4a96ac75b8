//! What the drive's own watchdog does once nobody talks to it any more, in words.

use super::look::{watchdog_seconds, working_raw};
use super::{Motor, may_turn};
use crate::outcome::Decimal;
use crate::profile::value::format_decimal;
use crate::profile::{Family, Lang, Param};

impl Motor<'_, '_> {
    /// What is to be known of it where the stop was not proven.
    pub(super) async fn watchdog_note(&mut self) -> String {
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
        let turns = may_turn(self.lang);
        match raw {
            Some(raw) if raw > 0 => watchdog_words(family, Some(watchdog_seconds(family, raw)), self.lang),
            raw => {
                let known = raw.map(|raw| watchdog_seconds(family, raw));
                format!("{}: {turns}", watchdog_words(family, known, self.lang))
            }
        }
    }
}

/// What the drive's watchdog is set to, and what it does then.
pub fn watchdog_words(family: &Family, seconds: Option<Decimal>, lang: Lang) -> String {
    let label = family.role("watchdog").map_or_else(|| "-".to_owned(), Param::label);
    let does = family.motion.watchdog.get(lang);
    match (seconds, lang) {
        (Some(off), Lang::En) if off.raw == 0 => format!("the drive's watchdog ({label}) is off"),
        (Some(off), Lang::De) if off.raw == 0 => format!("der Watchdog ({label}) ist aus"),
        (Some(on), Lang::En) => {
            format!("the drive's watchdog ({label}) is {} s: {does}", format_decimal(on.raw, on.decimals))
        }
        (Some(on), Lang::De) => {
            format!("der Watchdog ({label}) steht auf {} s: {does}", format_decimal(on.raw, on.decimals))
        }
        (None, Lang::En) => "whether the drive's watchdog stops it is not known".to_owned(),
        (None, Lang::De) => "ob der Watchdog abschaltet, ist unbekannt".to_owned(),
    }
}
