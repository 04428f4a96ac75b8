//! What a drive keeps of virtual links: what came over the system bus (EM-RES-03 manual 5.11.5), and what the bench file says of
//! sources. Nothing that came outlives power-on, which is a choice of this bench.

use std::collections::BTreeMap;

/// What comes over the system bus, and what the bench file says of sources.
#[derive(Clone, Debug, Default)]
pub(crate) struct Links {
    /// By source, 700 to 729.
    pub(super) received: BTreeMap<u16, i64>,
    pub(super) held: BTreeMap<u16, i64>,
    /// A slave is in fault: source 730, and bit 13 of P.270.
    pub(super) emergency: bool,
}

/// What RxPDOs bring (manual 5.11.5.2).
const OF_PDOS: std::ops::RangeInclusive<u16> = 700..=729;

impl Links {
    pub(super) fn new(held: &BTreeMap<u16, i64>) -> Self {
        Links { held: held.clone(), ..Links::default() }
    }

    /// Power-on.
    pub(super) fn forget(&mut self) {
        self.received.clear();
        self.emergency = false;
    }

    /// What the source of an RxPDO tells; `None` for any other.
    pub(super) fn over_bus(&self, source: u16) -> Option<i64> {
        OF_PDOS.contains(&source).then(|| self.received.get(&source).copied().unwrap_or(0))
    }
}
