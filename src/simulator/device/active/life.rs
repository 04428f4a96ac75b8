//! The time of an ACT or ACU: power, watchdog, what happens to it.

use super::line::values;
use super::machine::Automaton;
use super::setup::{Contacts, Setup};
use super::state::{Active, cells};
use crate::profile::Family;
use crate::simulator::device::contract::{CellFault, NodeSetting};
use crate::tick::{Span, Tick};

/// Watchdog RS232/RS485 (CM-485 manual 6.9).
const WATCHDOG: u16 = 0x2010;
/// Output frequency above the switch-off limit P.417 (CM-485 manual 12.2, EM-RES-03 manual 6.4.1).
const OVERSPEED: u16 = 0x1100;

impl Active {
    /// A drive that stands at `place` on its line, switched on if there is power.
    pub(crate) fn new(setup: &Setup, place: NodeSetting, family: Option<&Family>) -> Self {
        let values = [values(place), setup.values.clone()].concat();
        let (stored, in_ram): (Vec<_>, Vec<_>) = values.into_iter().partition(|(_, set, _)| *set < 5);
        let mut active = Active::equipped(setup, &stored, family);
        for &(number, set, fault) in &setup.faulty {
            active.spoil(number, set, fault);
        }
        match active.acu || active.contacts.mains {
            true => active.power_up(Tick::ZERO, Tick::ZERO),
            false => active.power_down(Tick::ZERO),
        }
        // What somebody has written to RAM since power-on (CM-485 manual 7).
        in_ram.iter().for_each(|(number, set, value)| active.store.write_ram((*number, set - 5), *value));
        active
    }

    /// From now on these cells of the EEPROM take writes so.
    pub(crate) fn spoil(&mut self, number: u32, set: u8, fault: Option<CellFault>) {
        let cells = self.specs.get(&number).map(|spec| cells(spec, set));
        cells.into_iter().flatten().for_each(|set| self.store.spoil((number, set), fault));
    }

    /// Power-on or software reset: RAM from EEPROM, no fault, no warning; not ready before `up`. The watchdog waits for
    /// the first telegram. A shaft that turns coasts on.
    pub(crate) fn power_up(&mut self, now: Tick, up: Tick) {
        self.restart(now, Some(up));
    }

    /// The power is gone until the next power-on.
    pub(crate) fn power_down(&mut self, now: Tick) {
        self.restart(now, None);
    }

    fn restart(&mut self, now: Tick, up: Option<Tick>) {
        self.catch_up(now);
        self.store.power_up();
        self.machine.restart(now, up);
        self.register = 0;
        self.warnings = 0;
        self.heard = None;
        self.backwards = false;
        self.links.forget();
        self.catch_up(now);
    }

    /// A correct exchange with this drive has taken place.
    pub(crate) fn heard(&mut self, at: Tick) {
        self.heard = Some(at);
    }

    /// When something will happen by itself: the watchdog, or the end of a stop.
    pub(crate) fn next(&self) -> Option<Tick> {
        [self.watchdog(), self.overspeed(), self.machine.next()].into_iter().flatten().min()
    }

    /// When the shaft will be faster than P.417; that 0 sets no limit is a choice of this bench.
    fn overspeed(&self) -> Option<Tick> {
        let limit = Some(self.value(417)).filter(|&limit| limit > 0)?;
        self.machine.shaft.rises_above(limit)
    }

    fn watchdog(&self) -> Option<Tick> {
        let seconds = u64::try_from(self.value(413)).ok().filter(|&seconds| seconds > 0)?;
        Some(self.heard? + Span::from_secs(seconds))
    }

    /// Lets the time pass.
    pub(crate) fn catch_up(&mut self, now: Tick) {
        if self.next().is_none_or(|at| at > now) {
            return self.machine.shaft.advance(now);
        }
        let tripped = self.watchdog().is_some_and(|at| at <= now);
        self.machine = self.machine_at(now);
        if tripped {
            self.heard = None;
        }
    }

    /// State machine and shaft as they will be if nobody does anything. The watchdog makes a fault of the silence
    /// (CM-485 manual 6.9), P.417 one of a shaft that is too fast, and a fault switches the output stage off: the shaft coasts.
    fn machine_at(&self, now: Tick) -> Automaton {
        let (mut machine, inputs) = (self.machine.clone(), self.inputs());
        let mut trips = [(self.watchdog(), WATCHDOG), (self.overspeed(), OVERSPEED)];
        trips.sort_unstable();
        for (at, code) in trips.into_iter().filter_map(|(at, code)| Some((at.filter(|&at| at <= now)?, code))) {
            machine.settle(at, &inputs);
            // A ramp that ended before may have taken the speed away.
            if code == WATCHDOG || machine.shaft.is_above(self.value(417)) {
                machine.trip(at, code);
            }
        }
        machine.settle(now, &inputs);
        machine
    }

    pub(crate) fn react(&mut self, now: Tick) {
        let inputs = self.inputs();
        self.machine.react(now, &inputs);
    }

    /// Lets a fault happen.
    pub(crate) fn trip(&mut self, now: Tick, code: u16) {
        self.catch_up(now);
        self.machine.trip(now, code);
    }

    /// Sets the warning word; bit 0 goes with bit 1 or 2 (CM-485 manual 12.1).
    pub(crate) fn warn(&mut self, word: u16) {
        self.warnings = if word & 0x0006 != 0 { word | 1 } else { word };
    }

    /// Changes wires at the terminals.
    pub(crate) fn wire(&mut self, now: Tick, change: impl FnOnce(&mut Contacts)) {
        self.catch_up(now);
        change(&mut self.contacts);
        self.react(now);
    }

    /// Changes the load at the shaft, percent of the rated torque.
    pub(crate) fn burden(&mut self, now: Tick, torque: i64) {
        self.catch_up(now);
        self.torque = torque;
        self.react(now);
    }

    /// What hangs at the shaft keeps it from becoming slower, or lets it go.
    pub(crate) fn drag(&mut self, now: Tick, on: bool) {
        self.catch_up(now);
        let inputs = self.inputs();
        self.machine.drag(on, &inputs);
        self.react(now);
    }

    /// Exchanges two phases of the motor.
    pub(crate) fn rewire(&mut self, now: Tick) {
        self.catch_up(now);
        if let Some(resolver) = &mut self.resolver {
            resolver.swapped = !resolver.swapped;
        }
        self.react(now);
    }

    /// Frequency of the rotor at `now`, 0.01 Hz, positive clockwise.
    pub(crate) fn shaft_speed(&self, now: Tick) -> i64 {
        self.machine_at(now).shaft.speed()
    }
}
