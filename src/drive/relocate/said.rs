//! What goes wrong when a drive is moved, in both languages.

use super::Place;
use crate::failure::{Class, Failure};
use crate::outcome;
use crate::text::{Text, both};
use std::fmt::Display;

pub(super) fn unknown_settings() -> Failure {
    let text = both!(
        "how this family's line is set is not known to this tool",
        "wie die Leitung dieser Familie eingestellt wird, weiß dieses Werkzeug nicht"
    );
    Failure::new(Class::Data, "data.line_settings", text)
        .hint(both!("`write` sets single parameters", "`write` setzt einzelne Parameter"))
}

pub(super) fn speaks_one_only(protocol: &dyn Display) -> Failure {
    let message =
        both!("this drive speaks {protocol} and nothing else", "dieser Antrieb spricht {protocol} und sonst nichts");
    Failure::new(Class::Data, "data.protocol", message)
}

pub(super) fn behind_another() -> Failure {
    let text = both!(
        "a node is reached through another drive: it has no line here that could be set",
        "ein Knoten wird über einen anderen Antrieb erreicht: er hat hier keine eigene Leitung"
    );
    Failure::new(Class::Usage, "usage.node", text)
}

pub(super) fn of_the_bus() -> Failure {
    let text = both!(
        "over the CAN bus itself only the node of a slave (P.900) is changed: rate, channels and the master concern everybody on it",
        "über den CAN-Bus selbst wird nur der Knoten eines Slaves (P.900) umgestellt: Bitrate, Kanäle und Master betreffen alle daran"
    );
    Failure::new(Class::Forbidden, "forbidden.own_line", text).hint(both!(
        "write it over the serial plug of the drive",
        "über den seriellen Anschluss des Umrichters schreiben"
    ))
}

/// What is out of range.
pub(super) const ADDRESS: Text = Text::new("address", "Adresse");
pub(super) const BAUD: Text = Text::new("baud", "Baudrate");

pub(super) fn out_of_range(what: &Text, expected: &str, got: &dyn Display) -> Failure {
    let message = both!(
        "{what}: expected {expected}, got {got}",
        "{what}: erwartet {expected}, erhalten {got}",
        what,
        expected,
        got
    );
    Failure::new(Class::Data, "data.range", message)
}

pub(super) fn cannot_follow(port: &str) -> Failure {
    let message = both!(
        "{port} carries bytes only: the line cannot follow the drive to other settings",
        "{port} überträgt nur Bytes: die Leitung kann dem Antrieb nicht folgen"
    );
    Failure::new(Class::Forbidden, "forbidden.fixed_line", message).hint(both!(
        "use the tty itself, or a server that speaks rfc2217://",
        "den Anschluss selbst verwenden oder einen Server, der rfc2217:// spricht"
    ))
}

pub(super) fn occupied(place: Place) -> Failure {
    let message = both!(
        "somebody answers at {place} already; nothing was written",
        "unter {place} antwortet schon jemand; es wurde nichts geschrieben",
        place = place.text()
    );
    Failure::new(Class::Forbidden, "forbidden.occupied", message).hint(both!(
        "choose another address; `antrieb scan` shows them",
        "eine andere Adresse wählen; `antrieb scan` zeigt sie"
    ))
}

/// The drive took the telegram, but is not where it should be.
pub(super) fn unmoved(place: Place) -> Failure {
    let message = both!(
        "the drive does not answer at {place}",
        "der Antrieb antwortet nicht unter {place}",
        place = place.text()
    );
    Failure::new(Class::Silence, "silence.not_followed", message)
}

/// A failure that leaves the drive at a known place.
pub(super) fn left(cause: Failure, how: &Text, place: Place) -> Failure {
    let message = both!(
        "{why}; the drive answers at {place} ({how})",
        "{why}; der Antrieb antwortet unter {place} ({how})",
        why = cause.message,
        place = place.text(),
        how
    );
    Failure { message, ..cause }
}

/// A failure that leaves the drive nobody knows where.
pub(super) fn lost(cause: Failure, perhaps: &[Place], after_restart: Option<&outcome::Place>) -> Failure {
    let places: Vec<Text> = perhaps.iter().map(|place| place.text()).collect();
    let later = after_restart.filter(|later| !places.contains(&later.text));
    let first = places.iter().cloned();
    let places = first.reduce(|all, place| both!("{all}, or {place}", "{all}, oder {place}", all, place));
    let later = later.map_or_else(Text::default, |later| {
        both!("; after a restart perhaps at {text}", "; nach einem Neustart vielleicht unter {text}", text = later.text)
    });
    let message = both!(
        "{why}; where the drive is now is not known: look at {places}{later}",
        "{why}; wo der Antrieb jetzt ist, ist unbekannt: zu suchen unter {places}{later}",
        why = cause.message,
        places = places.unwrap_or_default(),
        later
    );
    let class = if cause.class == Class::Port { Class::Port } else { Class::Silence };
    Failure { message, class, code: "silence.lost".to_owned(), ..cause }.hint(both!(
        "check the cable; `antrieb scan --protocol auto --baud auto --parity auto` finds the drive wherever it is",
        "Kabel prüfen; `antrieb scan --protocol auto --baud auto --parity auto` findet den Antrieb, wo er auch ist"
    ))
}
