//! A drive as an end of virtual links: what its sources tell, and what takes from the system bus (EM-RES-03 manual 5.11.5).
//!
//! Choices where the manual is silent:
//! - frequencies are 0.01 Hz and percentages 0.01 % as sources and where they arrive: "internal notation" has no printed scale;
//! - a source that is not worked out here tells what the bench file says, else 0;
//! - P.68, 69, 99 and 137 take from the sources of RxPDOs and from 730; any other source stands for what the drive does from the
//!   factory, and no other parameter takes anything.

use super::setup::Contacts;
use super::state::Active;
use crate::simulator::device::contract::OnSystemBus;
use crate::tick::Tick;

/// SysbusEmergency: a slave is in fault, or the master itself (manual 5.8.3).
const EMERGENCY: u16 = 730;
const NODE_ID: u32 = 900;
const MASTER: i64 = 0;

impl Active {
    /// What a parameter takes from the system bus, if it is linked to it.
    pub(super) fn over_bus(&self, param: u32) -> Option<i64> {
        u16::try_from(self.value(param)).ok().and_then(|source| self.bus_source(source))
    }

    fn bus_source(&self, source: u16) -> Option<i64> {
        let own_fault = self.value(NODE_ID) == MASTER && self.machine.in_fault();
        match source {
            EMERGENCY => Some(i64::from(self.links.emergency || own_fault)),
            _ => self.links.over_bus(source),
        }
    }
}

impl OnSystemBus for Active {
    fn source(&self, number: u16) -> i64 {
        if let Some(value) = self.bus_source(number).or_else(|| self.links.held.get(&number).copied()) {
            return value;
        }
        let Contacts { sto_a, right, left, .. } = self.contacts;
        // Manual 5.11.5.1.
        match number {
            0 => self.machine.shaft.ramp(),
            1 => self.value(480),
            5 => self.value(484),
            6 => 1,
            62 => self.value(228),
            70 => sto_a.into(),
            71 => right.into(),
            72 => left.into(),
            137 => self.actual(229).unwrap_or(0),
            161 => self.machine.runs().into(),
            163 => i64::from(self.status() >> 10 & 1),
            740 => self.control_word(),
            741 => self.status().into(),
            _ => 0,
        }
    }

    fn receive(&mut self, now: Tick, values: &[(u16, i64)]) {
        self.catch_up(now);
        self.links.received.extend(values.iter().copied());
        self.machine.fresh |= values.iter().any(|value| self.value(99) == i64::from(value.0));
        self.react(now);
    }

    fn emergency(&mut self, now: Tick, stands: bool) {
        self.catch_up(now);
        self.links.emergency = stands;
        self.react(now);
    }
}
