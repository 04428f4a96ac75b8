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
        "over the CAN bus itself the master is not moved: that concerns everybody on it",
        "über den CAN-Bus selbst wird der Master nicht umgestellt: das betrifft alle daran"
    );
    Failure::new(Class::Forbidden, "forbidden.own_line", text).hint(both!(
        "write it over the serial plug of the drive",
        "über den seriellen Anschluss des Umrichters schreiben"
    ))
}

/// What is wished for is no setting of this line.
pub(super) fn other_line(is_on_bus: bool) -> Failure {
    let (message, hint) = match is_on_bus {
        true => (
            both!(
                "a CAN bus has no parity, and its protocols are sdo and sdo1",
                "ein CAN-Bus hat keine Parität, und seine Protokolle sind sdo und sdo1"
            ),
            both!(
                "over the serial plug of the drive its line there is set",
                "die Leitung am seriellen Anschluss wird über diesen eingestellt"
            ),
        ),
        false => (
            both!("sdo and sdo1 are protocols of a CAN bus", "sdo und sdo1 sind Protokolle eines CAN-Busses"),
            both!(
                "from here `antrieb write 923=1` switches SDO2 on, and 923=0 off",
                "von hier schaltet `antrieb write 923=1` SDO2 ein und 923=0 aus"
            ),
        ),
    };
    Failure::new(Class::Data, "data.other_line", message).hint(hint)
}

/// Another rate would leave others behind.
pub(super) fn not_alone(others: &str) -> Failure {
    let message = both!(
        "others are on this bus ({others}): a drive at another bit rate destroys what they say, and they what it says; nothing was written",
        "am Bus sind noch andere ({others}): ein Umrichter mit anderer Bitrate zerstört, was sie sagen, und sie, was er sagt; es wurde \
         nichts geschrieben"
    );
    Failure::new(Class::Forbidden, "forbidden.others_on_bus", message).hint(both!(
        "change the rate with the drive alone behind the adapter, or over its serial plug, and switch all drives on again together",
        "die Bitrate ändern, solange der Umrichter allein am Adapter ist, oder über seinen seriellen Anschluss; danach alle gemeinsam neu \
         einschalten"
    ))
}

/// The bit rate of an interface is set by its kernel.
pub(super) fn fixed_rate(port: &str) -> Failure {
    let name = port.trim_start_matches("can:");
    let message = both!(
        "the bit rate of {port} is set by the kernel: this program cannot follow the drive to another one; nothing was written",
        "die Bitrate von {port} stellt der Kernel ein: dieses Programm kann dem Umrichter nicht folgen; es wurde nichts geschrieben"
    );
    Failure::new(Class::Forbidden, "forbidden.fixed_line", message).hint(both!(
        "over its serial plug `antrieb write 903=CODE`; then as root `ip link set {name} down` and `ip link set {name} up type can bitrate …`",
        "über seinen seriellen Anschluss `antrieb write 903=CODE`; danach als root `ip link set {name} down` und `ip link set {name} up type \
         can bitrate …`"
    ))
}

/// Without the channel for tools the drive could not be reached.
pub(super) fn no_other_channel() -> Failure {
    let message = both!(
        "nobody answers over SDO1, so that without SDO2 the drive would be out of reach; nothing was written",
        "über SDO1 antwortet niemand, ohne SDO2 wäre der Umrichter also nicht mehr erreichbar; es wurde nichts geschrieben"
    );
    Failure::new(Class::Forbidden, "forbidden.own_line", message).hint(both!(
        "SDO1 has other identifiers (P.921, P.922), or belongs to a master; over the serial plug P.923 can be written",
        "SDO1 hat andere Identifier (P.921, P.922) oder gehört einem Master; über den seriellen Anschluss lässt sich P.923 schreiben"
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
    let hint = match perhaps.iter().any(|place| place.line.is_can()) {
        true => both!(
            "check the wiring and both terminations; `antrieb scan` asks every node at one bit rate (-b 50000, 100000, 125000, 250000, \
             500000 or 1000000, P.903); a stopped node answers over its serial plug alone",
            "Verdrahtung und beide Abschlüsse prüfen; `antrieb scan` fragt alle Knoten mit einer Bitrate (-b 50000, 100000, 125000, \
             250000, 500000 oder 1000000, P.903); ein gestoppter Knoten antwortet nur über seinen seriellen Anschluss"
        ),
        false => both!(
            "check the cable; `antrieb scan --protocol auto --baud auto --parity auto` finds the drive wherever it is",
            "Kabel prüfen; `antrieb scan --protocol auto --baud auto --parity auto` findet den Antrieb, wo er auch ist"
        ),
    };
    Failure { message, class, code: "silence.lost".to_owned(), ..cause }.hint(hint)
}
