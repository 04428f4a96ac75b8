//! The ends of virtual links in a drive (EM-RES-03 manual 5.11.5): which parameter fills which bytes of a TxPDO, which source brings
//! which bytes of an RxPDO, and which parameters set the rest.

use crate::protocol::can::PdoNumber;
use crate::protocol::can::pdo::{Kind, Place};

/// P.900, the node.
pub(super) const NODE: u32 = 900;
/// P.903, the rate.
pub(super) const RATE: u32 = 903;
/// P.904, of the master.
pub(super) const BOOT_UP_DELAY: u32 = 904;
/// P.918.
pub(super) const SYNC_IDENTIFIER: u32 = 918;
/// P.919, of the master.
pub(super) const SYNC_TIME: u32 = 919;
/// P.921.
pub(super) const RX_SDO1: u32 = 921;
/// P.922.
pub(super) const TX_SDO1: u32 = 922;
/// P.923.
pub(super) const SDO2: u32 = 923;
/// P.939.
pub(super) const SYNC_TIMEOUT: u32 = 939;
/// P.989, of the master.
pub(super) const EMERGENCY_REACTION: u32 = 989;

/// P.924, 926, 928.
pub(super) fn rx_identifier(pdo: PdoNumber) -> u32 {
    924 + 2 * u32::from(pdo.index())
}

/// P.925, 927, 929.
pub(super) fn tx_identifier(pdo: PdoNumber) -> u32 {
    925 + 2 * u32::from(pdo.index())
}

/// P.930, 932, 934.
pub(super) fn tx_function(pdo: PdoNumber) -> u32 {
    930 + 2 * u32::from(pdo.index())
}

/// P.931, 933, 935.
pub(super) fn tx_time(pdo: PdoNumber) -> u32 {
    931 + 2 * u32::from(pdo.index())
}

/// P.936 to 938.
pub(super) fn rx_function(pdo: PdoNumber) -> u32 {
    936 + u32::from(pdo.index())
}

/// P.941, 942 and, really so, 945 (manual 5.11.3).
pub(super) fn rx_timeout(pdo: PdoNumber) -> u32 {
    match pdo {
        PdoNumber::One => 941,
        PdoNumber::Two => 942,
        PdoNumber::Three => 945,
    }
}

/// The parameter that fills a place of a TxPDO with a source (manual 5.11.5.1). The words of the third begin at 972, not at 970.
pub(super) fn input(pdo: PdoNumber, place: Place) -> u32 {
    let base = 946 + 10 * u32::from(pdo.index());
    let shift = u32::from(pdo == PdoNumber::Three) * 2;
    let of_kind = match place.kind() {
        Kind::Boolean => 0,
        Kind::Word => 4 + shift,
        Kind::Long => 8 + shift,
    };
    base + of_kind + u32::from(place.index())
}

/// The source that brings a place of an RxPDO (manual 5.11.5.2).
pub(super) fn source(pdo: PdoNumber, place: Place) -> u16 {
    let of_kind = match place.kind() {
        Kind::Boolean => 0,
        Kind::Word => 4,
        Kind::Long => 8,
    };
    700 + 10 * pdo.index() + of_kind + place.index()
}

/// The source that leaves a place unused (manual 5.11.5.1): FALSE, or 0.
pub(super) fn unused(kind: Kind) -> u16 {
    match kind {
        Kind::Boolean => 7,
        Kind::Word | Kind::Long => 9,
    }
}

/// What a source brings, as far as the manual lists it (5.11.5.1, 5.8.3); its lists are examples.
pub(super) fn listed(source: u16) -> Option<Kind> {
    match source {
        6 | 7 | 70 | 71 | 72 | 161 | 163 | 164 | 730 => Some(Kind::Boolean),
        63 | 64 | 52 | 133 | 137 | 138 | 740 | 741 => Some(Kind::Word),
        0 | 1 | 5 | 62 | 50 => Some(Kind::Long),
        700..=729 => Some(match source % 10 {
            0..=3 => Kind::Boolean,
            4..=7 => Kind::Word,
            _ => Kind::Long,
        }),
        _ => None,
    }
}
