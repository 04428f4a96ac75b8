//! The state of an SJ2-PB by its status word, or as its Basic block tells it. The words are those of PROFIdrive, and of the manual
//! (3.2.3); which of its own numbers (P.702) is which, no source tells.

use super::mode::Seen;
use crate::outcome::State;
use crate::text::{Text, both};

/// Bits that are looked at, what they are, stable name.
const ROWS: [(u16, u16, &str); 5] = [
    (0x0008, 0x0008, "fault"),
    (0x0007, 0x0007, "operation-enabled"),
    (0x0003, 0x0003, "switched-on"),
    (0x0001, 0x0001, "ready-to-switch-on"),
    (0x0000, 0x0000, "switch-on-disabled"),
];

/// The state that is told (SJ2-PB manual 4.1.2.2, 3.2.3).
pub fn of(seen: Seen) -> State {
    let Seen { zsw, state, .. } = seen;
    if let Some(state) = state {
        return basic(if seen.is_faulted() { TRIPPED } else { state });
    }
    let slug = ROWS.iter().find(|(mask, bits, _)| zsw & mask == *bits).map_or("unknown", |row| row.2);
    State { slug: slug.to_owned(), name: name(slug) }
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
        _ => both!("Not ready to switch on", "Nicht einschaltbereit"),
    }
}
