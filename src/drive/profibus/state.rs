//! The state of an SJ2-PB by its status word. The words are those of PROFIdrive; which of its own numbers (P.702) is which, no source
//! tells.

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

/// The state that a status word tells (SJ2-PB manual 4.1.2.2).
pub fn of(zsw: u16) -> State {
    let slug = ROWS.iter().find(|(mask, bits, _)| zsw & mask == *bits).map_or("unknown", |row| row.2);
    State { slug: slug.to_owned(), name: name(slug) }
}

fn name(slug: &str) -> Text {
    match slug {
        "fault" => both!("Fault", "Störung"),
        "operation-enabled" => both!("Operation enabled", "Betrieb freigegeben"),
        "switched-on" => both!("Ready to operate", "Betriebsbereit"),
        "ready-to-switch-on" => both!("Ready to switch on", "Einschaltbereit"),
        _ => both!("Not ready to switch on", "Nicht einschaltbereit"),
    }
}
