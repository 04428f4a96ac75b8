//! Which settings are tried, and in which order: the likely ones first.

use super::Tuning;
use crate::protocol::Protocol;
use crate::protocol::line::Parity;
use crate::protocol::modbus::Framing;

/// What nobody knows about a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unknown {
    /// Its speed.
    pub baud: bool,
    /// Its parity.
    pub parity: bool,
    /// What is spoken.
    pub protocol: bool,
}

impl Unknown {
    /// Whether anything is unknown.
    pub fn any(self) -> bool {
        self.baud || self.parity || self.protocol
    }
}

/// What drives leave the factory with; the first of a row of the same rank.
const FACTORY: [(Protocol, u32, Parity, &str); 2] = [
    (
        Protocol::Modbus(Framing::Rtu),
        19_200,
        Parity::Even,
        "LXM05: LXM05 manual 4.1; an ACTIVE that was switched to Modbus",
    ),
    (Protocol::Vabus, 19_200, Parity::Even, "ACTIVE: P.395 = 0, P.10 = 4, CM-485 manual 5"),
];

/// Speeds, most likely first: those that both families have before those that one has, and of these the ones that reach as far as
/// a line usually does (CM-485 manual 5.3.1: up to 2400 m at 2400 baud, 300 m at 115200).
const BAUDS: [(u32, &str); 7] = [
    (19_200, "factory setting: P.10 = 4, CM-485 manual 5; MBbaud, LXM05 manual 4.1"),
    (9_600, "both families, and as far as 19200; what most other Modbus devices are set to"),
    (115_200, "ACTIVE, P.10 = 6: chosen where speed matters"),
    (57_600, "ACTIVE, P.10 = 5: the next best"),
    (38_400, "LXM05 alone (MBbaud, LXM05 manual 4.1)"),
    (4_800, "ACTIVE, P.10 = 2: reaches no farther than 2400"),
    (2_400, "ACTIVE, P.10 = 1: 2400 m"),
];

/// Parities, most likely first (P.1375: CM-485 manual 5.3.1; MBformat: LXM05 manual 4.1, whose 8N1 understands and is understood at
/// 8N2).
const PARITIES: [(Parity, &str); 3] = [
    (Parity::Even, "factory setting of both families, and the default of the norm (V1.02, 2.5.1)"),
    (Parity::None, "common elsewhere; the norm wants it supported"),
    (Parity::Odd, "hardly ever chosen"),
];

/// Protocols, most likely first (P.395: CM-485 manual 5).
const PROTOCOLS: [(Protocol, &str); 3] = [
    (Protocol::Modbus(Framing::Rtu), "what a drive on a Modbus line speaks; LXM05 alone that"),
    (Protocol::Vabus, "P.395 = 0"),
    (Protocol::Modbus(Framing::Ascii), "P.395 = 3, chosen on purpose"),
];

/// The settings to try, for what is unknown of `known`: those of the factory, then the others; one that differs from the usual in
/// one thing is likelier than one that differs in two.
pub(in crate::drive) fn tunings(known: Tuning, unknown: Unknown) -> Vec<Tuning> {
    if !unknown.any() {
        return vec![known];
    }
    let protocols = ranked(&PROTOCOLS, unknown.protocol, known.protocol);
    let parities = ranked(&PARITIES, unknown.parity, known.line.parity);
    let bauds = ranked(&BAUDS, unknown.baud, known.line.baud);
    let mut tries = Vec::new();
    for &(protocol, third) in &protocols {
        for &(parity, second) in &parities {
            // VABus has no other parity (sources A1).
            if protocol == Protocol::Vabus && unknown.parity && parity != Parity::Even {
                continue;
            }
            for &(baud, first) in &bauds {
                let tuning = Tuning { protocol, line: protocol.line(baud, parity) };
                let is_factory = FACTORY.iter().any(|&(protocol, baud, parity, _)| {
                    tuning == Tuning { protocol, line: protocol.line(baud, parity) }
                });
                tries.push((!is_factory, first + second + third, tuning));
            }
        }
    }
    tries.sort_by_key(|tried| (tried.0, tried.1));
    tries.into_iter().map(|tried| tried.2).collect()
}

/// The rows of a table with their ranks; only what is known, if it is known.
fn ranked<T: Copy>(table: &[(T, &str)], unknown: bool, known: T) -> Vec<(T, usize)> {
    if !unknown {
        return vec![(known, 0)];
    }
    table.iter().enumerate().map(|(rank, row)| (row.0, rank)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::LineSetting;

    const USUAL: Tuning =
        Tuning { protocol: Protocol::Modbus(Framing::Rtu), line: LineSetting::rtu(19_200, Parity::Even) };

    #[test]
    fn the_factory_setting_comes_first_and_nothing_twice() {
        let all = tunings(USUAL, Unknown { baud: true, parity: true, protocol: true });
        assert_eq!(all.first(), Some(&USUAL));
        let first: Vec<String> = all.iter().take(4).map(ToString::to_string).collect();
        assert_eq!(first, ["19200 8E1 rtu", "19200 7E1 vabus", "9600 8E1 rtu", "19200 8N2 rtu"]);
        assert_eq!(all.len(), 7 * 3 * 2 + 7);
        for (index, tuning) in all.iter().enumerate() {
            assert!(!all[..index].contains(tuning), "{tuning}");
        }
    }

    #[test]
    fn what_is_known_is_not_tried() {
        let known = Tuning { line: LineSetting { stop_bits: 2, ..USUAL.line }, ..USUAL };
        assert_eq!(tunings(known, Unknown::default()), [known], "also an unusual format");
        let shown: Vec<String> =
            tunings(USUAL, Unknown { parity: true, ..Unknown::default() }).iter().map(ToString::to_string).collect();
        assert_eq!(shown, ["19200 8E1 rtu", "19200 8N2 rtu", "19200 8O1 rtu"]);
    }
}
