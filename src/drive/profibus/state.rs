//! The state of an SJ2-PB by its status word, or as its Basic block tells it. The words are those of PROFIdrive, and of the manual
//! (3.2.3); which of its own numbers (P.702) is which, no source tells.

use super::mode::Seen;
use crate::outcome::State;
use crate::text::{Text, both};

/// Bits that are looked at, what they are, stable name.
const ROWS: [(u16, u16, &str); 6] = [
    (0x0008, 0x0008, "fault"),
    (0x0007, 0x0007, "operation-enabled"),
    (0x0003, 0x0003, "switched-on"),
    (0x0001, 0x0001, "ready-to-switch-on"),
    (0x0040, 0x0040, "switch-on-disabled"),
    (0x0000, 0x0000, "not-ready"),
];

/// The state that is told (SJ2-PB manual 4.1.2.2, 3.2.3). A status word of 0 tells none: it stays 0 as long as no master has the control
/// (4.1.2.4).
pub fn of(seen: Seen) -> Option<State> {
    let Seen { zsw, state, .. } = seen;
    if let Some(state) = state {
        return Some(basic(if seen.is_faulted() { TRIPPED } else { state }));
    }
    let slug = ROWS.iter().find(|(mask, bits, _)| zsw & mask == *bits).filter(|_| zsw != 0)?.2;
    Some(State { slug: slug.to_owned(), name: name(slug) })
}

/// The same in a step, which has one.
pub(super) fn or_untold(seen: Seen) -> State {
    of(seen).unwrap_or_else(|| State { slug: "unknown".to_owned(), name: both!("not told", "nicht genannt") })
}

/// Operating states of the Basic block (3.2.3).
fn basic(state: u16) -> State {
    let (slug, name) = match state {
        0 => ("stop", both!("Stop", "Stop")),
        1 => ("run", both!("Run", "Betrieb")),
        2 => ("jog", both!("Jogging", "Tippbetrieb")),
        3 => ("coasting", both!("Coasting", "Freier Auslauf")),
        4 => ("dc-brake", both!("DC braking", "DC-Bremse")),
        TRIPPED => ("fault", name("fault")),
        other => ("unknown", both!("{other}, in no source", "{other}, in keiner Quelle")),
    };
    State { slug: slug.to_owned(), name }
}

const TRIPPED: u16 = 10;

fn name(slug: &str) -> Text {
    match slug {
        "fault" => both!("Fault", "Störung"),
        "operation-enabled" => both!("Operation enabled", "Betrieb freigegeben"),
        "switched-on" => both!("Ready to operate", "Betriebsbereit"),
        "ready-to-switch-on" => both!("Ready to switch on", "Einschaltbereit"),
        "switch-on-disabled" => both!("Switch-on inhibited", "Einschaltsperre"),
        _ => both!("Not ready to switch on", "Nicht einschaltbereit"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nobody_is_given_a_state_that_he_did_not_tell() {
        let told = |zsw, state| of(Seen { zsw, hiw: 0, state }).map(|state| state.slug);
        for (zsw, slug) in [
            (0x0231, Some("ready-to-switch-on")),
            (0x0233, Some("switched-on")),
            (0x0737, Some("operation-enabled")),
            (0x0238, Some("fault")),
            (0x0240, Some("switch-on-disabled")),
            (0x0200, Some("not-ready")),
            (0x0000, None),
        ] {
            assert_eq!(told(zsw, None).as_deref(), slug, "{zsw:04X}");
        }
        assert_eq!(told(0, Some(0)).as_deref(), Some("stop"), "the Basic block has a word of its own for it");
    }
}
