//! What a master drive makes of the emergencies of its slaves (EM-RES-03 manual 5.8.3).
//!
//! Choice where the manual is silent: where its own acknowledgement ends the warning and P.989 lets it have no fault, the warning stands
//! until the next fault of its own was acknowledged.

use super::readings::{Reading, Readings};
use crate::protocol::can::LAST_DRIVE;
use crate::protocol::can::emergency::Emergency;
use crate::simulator::device::contract::{Action, Device, Fault};
use crate::tick::Tick;
use std::collections::BTreeSet;

/// The slaves of a master drive.
#[derive(Clone, Debug, Default)]
pub(super) struct Slaves {
    in_fault: BTreeSet<u8>,
    /// The master itself was, when it was looked at last.
    own_fault: bool,
}

/// P.989: 0 is a fault, 1 a warning.
const REACTION: u32 = 989;
/// F21nn: node nn is in fault.
const SLAVE: u16 = 0x2100;

impl Slaves {
    /// An emergency of a node.
    pub(super) fn hear(&mut self, now: Tick, node: u8, told: Emergency, device: &mut dyn Device, readings: Readings) {
        if node == 0 || (node > LAST_DRIVE && !readings.has(Reading::OthersTrip)) {
            return;
        }
        let stands = told != Emergency::CLEARED;
        match stands {
            true => self.in_fault.insert(node),
            false => self.in_fault.remove(&node),
        };
        if stands || readings.has(Reading::ZeroTripsMaster) {
            trip(now, node, device);
        }
        let ends = self.in_fault.is_empty() && !readings.has(Reading::EndsWithMaster);
        if let Some(bus) = device.system_bus().filter(|_| stands || ends) {
            bus.emergency(now, stands);
        }
    }

    /// Looks whether its own fault was acknowledged.
    pub(super) fn look(&mut self, now: Tick, device: &mut dyn Device, readings: Readings) {
        let stood = std::mem::replace(&mut self.own_fault, device.in_fault());
        if !stood || self.own_fault {
            return;
        }
        if let Some(bus) = device.system_bus().filter(|_| readings.has(Reading::EndsWithMaster)) {
            bus.emergency(now, false);
        }
        if let Some(node) = self.in_fault.first().copied().filter(|_| readings.has(Reading::TripsAgain)) {
            trip(now, node, device);
        }
    }
}

fn trip(now: Tick, node: u8, device: &mut dyn Device) {
    if device.ram(REACTION, 0) == Some(0) {
        device.act(now, Action::Fault(Fault { number: SLAVE | u16::from(node), ..Fault::default() }));
    }
}
