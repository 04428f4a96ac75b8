//! What ails the inverter of a slave: its trip, what is read of that, and what the LEDs say of it (SJ2-PB manual 5.6, 6.1).

use super::mode::Seen;
use crate::drive::decode::dp::trip;
use crate::outcome::{Fault, Field, Value};
use crate::text::{Text, both};

/// What is read of a slave in ProfiDrive mode: who controls (P.600, P.928), what a lost master means (P.703, P.620, A002, A001), the
/// register of the last trip (d081), and the trip data (P.300 to P.305).
pub const LOOKED_AT: [u32; 13] = [600, 928, 703, 620, 89, 88, 215, 300, 301, 302, 303, 304, 305];
/// The first index that is the module's own (5.2); those below are asked from the inverter.
const GATEWAY: u32 = 600;
const TRIP_DATA: std::ops::RangeInclusive<u32> = 300..=305;

/// The trip that stands: with its cause, which the Basic block alone tells (3.2.3); a bit of ZSW names none.
pub fn fault(seen: Seen) -> Option<Fault> {
    if !seen.is_faulted() {
        return None;
    }
    let (code, key, name) = match seen.state {
        Some(_) => {
            let (code, name) = trip(seen.zsw);
            (code, format!("{code:02X}h"), name)
        }
        None => (
            0,
            "ZSW".to_owned(),
            both!("bit 3: a trip; its display tells which", "Bit 3: eine Störung; die Anzeige nennt sie"),
        ),
    };
    Some(Fault { code: code.into(), key, group: None, name, cause: None, remedy: None, node: None })
}

/// What the five LEDs show while data are exchanged, and what they mean (6.1).
pub fn leds(seen: Seen, values: &[Value]) -> Vec<Field> {
    let of_inverter = |value: &&Value| value.param < GATEWAY && !TRIP_DATA.contains(&value.param);
    let hears = values.iter().find(of_inverter).map(|value| value.raw.is_some());
    let state = match (seen.is_faulted(), seen.is_driven()) {
        (true, _) => both!("red: it cannot start, a trip stands", "rot: er kann nicht starten, eine Störung steht an"),
        (false, true) => both!("green: it runs", "grün: er läuft"),
        (false, false) => both!("off: it stands", "aus: er steht"),
    };
    let condition = match seen.is_faulted() {
        true => both!(
            "blinks red: the trip waits for its reset (red without blinking: the reset did not help)",
            "blinkt rot: die Störung wartet auf das Quittieren (rot ohne Blinken: Quittieren half nicht)"
        ),
        false => both!("green: no trip", "grün: keine Störung"),
    };
    let gateway = match hears {
        Some(true) => both!("green: the inverter answers the module", "grün: der Umrichter antwortet dem Modul"),
        Some(false) => both!(
            "off: the inverter does not answer the module (RJ45 cable, switch at OPE?)",
            "aus: der Umrichter antwortet dem Modul nicht (RJ45-Kabel, Schalter auf OPE?)"
        ),
        None => both!(
            "green, if the inverter answers the module; off, if not",
            "grün, wenn der Umrichter dem Modul antwortet; sonst aus"
        ),
    };
    let rows: [(Text, Text); 5] = [
        (
            both!("LED1, supply", "LED1, Versorgung"),
            both!(
                "orange: inverter and module have it (red: the inverter alone, green: the module alone)",
                "orange: Umrichter und Modul haben sie (rot: nur der Umrichter, grün: nur das Modul)"
            ),
        ),
        (both!("LED2, inverter", "LED2, Umrichter"), state),
        (both!("LED3, trip", "LED3, Störung"), condition),
        (
            both!("LED4, PROFIBUS", "LED4, PROFIBUS"),
            both!("off: data are exchanged (red: none)", "aus: Daten werden ausgetauscht (rot: keine)"),
        ),
        (both!("LED5, gateway", "LED5, Gateway"), gateway),
    ];
    rows.into_iter().map(|(name, value)| Field { hex: String::new(), name, value }).collect()
}
