//! What goes wrong when a drive is moved, in both languages.

use super::Place;
use crate::failure::{Class, Failure};
use crate::outcome;
use crate::profile::Lang;
use std::fmt::Display;

pub(super) fn unknown_settings(lang: Lang) -> Failure {
    let text = lang.pick(
        "how this family's line is set is not known to this tool",
        "wie die Leitung dieser Familie eingestellt wird, weiß dieses Werkzeug nicht",
    );
    Failure::new(Class::Data, "data.line_settings", text)
        .hint(lang.pick("`write` sets single parameters", "`write` setzt einzelne Parameter"))
}

pub(super) fn speaks_one_only(protocol: &dyn Display, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("this drive speaks {protocol} and nothing else"),
        Lang::De => format!("dieser Antrieb spricht {protocol} und sonst nichts"),
    };
    Failure::new(Class::Data, "data.protocol", message)
}

pub(super) fn behind_another(lang: Lang) -> Failure {
    let text = lang.pick(
        "a node is reached through another drive: it has no line here that could be set",
        "ein Knoten wird über einen anderen Antrieb erreicht: er hat hier keine eigene Leitung",
    );
    Failure::new(Class::Usage, "usage.node", text)
}

pub(super) fn out_of_range(what: &str, expected: &str, got: &dyn Display, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("{what}: expected {expected}, got {got}"),
        Lang::De => format!("{what}: erwartet {expected}, erhalten {got}"),
    };
    Failure::new(Class::Data, "data.range", message)
}

pub(super) fn cannot_follow(port: &str, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("{port} carries bytes only: the line cannot follow the drive to other settings"),
        Lang::De => format!("{port} überträgt nur Bytes: die Leitung kann dem Antrieb nicht folgen"),
    };
    Failure::new(Class::Forbidden, "forbidden.fixed_line", message).hint(lang.pick(
        "use the tty itself, or a server that speaks rfc2217://",
        "den Anschluss selbst verwenden oder einen Server, der rfc2217:// spricht",
    ))
}

pub(super) fn occupied(place: Place, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("somebody answers at {place} already; nothing was written"),
        Lang::De => format!("unter {place} antwortet schon jemand; es wurde nichts geschrieben"),
    };
    Failure::new(Class::Forbidden, "forbidden.occupied", message).hint(lang.pick(
        "choose another address; `antrieb scan` shows them",
        "eine andere Adresse wählen; `antrieb scan` zeigt sie",
    ))
}

/// The drive took the telegram, but is not where it should be.
pub(super) fn unmoved(place: Place, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("the drive does not answer at {place}"),
        Lang::De => format!("der Antrieb antwortet nicht unter {place}"),
    };
    Failure::new(Class::Silence, "silence.not_followed", message)
}

/// A failure that leaves the drive at a known place.
pub(super) fn left(cause: Failure, how: &str, place: Place, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("{}; the drive answers at {place} ({how})", cause.message.get(lang)),
        Lang::De => format!("{}; der Antrieb antwortet unter {place} ({how})", cause.message.get(lang)),
    };
    Failure { message: message.into(), ..cause }
}

/// A failure that leaves the drive nobody knows where.
pub(super) fn lost(cause: Failure, perhaps: &[Place], after_restart: Option<&outcome::Place>, lang: Lang) -> Failure {
    let places: Vec<String> = perhaps.iter().map(Place::to_string).collect();
    let places = places.join(lang.pick(", or ", ", oder "));
    let later = after_restart.filter(|later| !perhaps.iter().any(|place| place.to_string() == later.text));
    let later = later.map_or_else(String::new, |later| match lang {
        Lang::En => format!("; after a restart perhaps at {}", later.text),
        Lang::De => format!("; nach einem Neustart vielleicht unter {}", later.text),
    });
    let message = match lang {
        Lang::En => {
            format!("{}; where the drive is now is not known: look at {places}{later}", cause.message.get(lang))
        }
        Lang::De => {
            format!(
                "{}; wo der Antrieb jetzt ist, ist unbekannt: zu suchen unter {places}{later}",
                cause.message.get(lang)
            )
        }
    };
    let class = if cause.class == Class::Port { Class::Port } else { Class::Silence };
    Failure { message: message.into(), class, code: "silence.lost".to_owned(), ..cause }.hint(lang.pick(
        "check the cable; `antrieb scan --protocol auto --baud auto --parity auto` finds the drive wherever it is",
        "Kabel prüfen; `antrieb scan --protocol auto --baud auto --parity auto` findet den Antrieb, wo er auch ist",
    ))
}
