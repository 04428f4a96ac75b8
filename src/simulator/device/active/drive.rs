//! An ACT or ACU as a station has it: what it understands, and what can happen to it.
//!
//! Choices where the manual is silent:
//! - nothing but the mains feeds the electronics of an ACT (CM-485 manual 10.1 names 24 V for the ACU only);
//! - a power cycle and a reset leave the shaft to coast.

use super::line::{self, LineParams};
use super::modbus;
use super::setup::Setup;
use super::state::Active;
use super::vabus::{Node, Slave};
use crate::profile::Family;
use crate::protocol::modbus::pdu::Reply as ModbusReply;
use crate::protocol::vabus::{Address, Reply as VabusReply, Request};
use crate::simulator::device::contract::{
    Action, AskedByModbus, AskedBySdo, AskedByVabus, Device, Effect, Goes, NodeSetting, OnSystemBus, Response,
};
use crate::simulator::device::counters::Counters;
use crate::tick::Tick;

/// An ACT or ACU.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    pub(super) active: Active,
    vabus: Slave,
    port: LineParams,
}

impl Drive {
    /// A drive that stands at `place` on its line, with others behind it on the system bus.
    pub(crate) fn new(setup: &Setup, place: NodeSetting, nodes: Vec<Node>, family: Option<&Family>) -> Self {
        Drive { active: Active::new(setup, place, family), vabus: Slave::new(nodes), port: LineParams::new(place) }
    }
}

impl Device for Drive {
    fn model(&self) -> &'static str {
        if self.active.acu { "acu" } else { "act" }
    }

    fn catch_up(&mut self, now: Tick) {
        self.active.catch_up(now);
        self.vabus.catch_up(now);
    }

    fn next(&self) -> Option<Tick> {
        [self.active.next(), self.vabus.next()].into_iter().flatten().min()
    }

    fn power_up(&mut self, now: Tick, up: Tick) {
        self.active.power_up(now, up);
        self.vabus.unlock();
    }

    fn power_down(&mut self, now: Tick) {
        self.active.power_down(now);
    }

    fn lives_by_mains(&self) -> Option<bool> {
        (!self.active.acu).then_some(self.active.contacts.mains)
    }

    fn act(&mut self, now: Tick, action: Action) {
        let active = &mut self.active;
        match action {
            Action::Fault(fault) => active.trip(now, fault.number),
            Action::Warning(word) => active.warn(word),
            Action::Torque(torque) => active.burden(now, torque),
            Action::ExchangePhases => active.rewire(now),
            Action::Hand(speed) => active.hand = speed,
            Action::Analog(volts) => active.analog.applied = volts,
            Action::Dragged(on) => active.drag(now, on),
            Action::Mains(on) => active.wire(now, |contacts| contacts.mains = on),
            Action::StoA(on) => active.wire(now, |contacts| contacts.sto_a = on),
            Action::StoB(on) => active.wire(now, |contacts| contacts.sto_b = on),
            Action::StartRight(on) => active.wire(now, |contacts| contacts.right = on),
            Action::StartLeft(on) => active.wire(now, |contacts| contacts.left = on),
            Action::Set(number, set, value) => active.set_by_hand(now, number, set, value),
            Action::Eeprom(number, set, fault) => active.spoil(number, set, fault),
            Action::PowerCycle | Action::Silent(_) | Action::BusOff(_) | Action::Refuses(_) | Action::Ignores(_) => {}
        }
    }

    fn setting_at_power_on(&mut self, before: NodeSetting) -> NodeSetting {
        self.port.at_power_on(&self.active, before)
    }

    fn setting_after_write(&mut self, before: NodeSetting) -> NodeSetting {
        self.port.after_write(&self.active, before)
    }

    fn heard(&mut self, now: Tick, last: Tick, _is_write: bool) {
        self.active.catch_up(now);
        self.active.heard(last);
    }

    fn modbus(&mut self) -> Option<&mut dyn AskedByModbus> {
        Some(self)
    }

    fn vabus(&mut self) -> Option<&mut dyn AskedByVabus> {
        Some(self)
    }

    fn sdo(&mut self) -> Option<&mut dyn AskedBySdo> {
        Some(self)
    }

    fn system_bus(&mut self) -> Option<&mut dyn OnSystemBus> {
        Some(&mut self.active)
    }

    fn eeprom(&self, number: u32, set: u8) -> Option<i64> {
        self.active.eeprom(number, set)
    }

    fn ram(&self, number: u32, set: u8) -> Option<i64> {
        self.active.ram(number, set)
    }

    fn eeprom_writes(&self) -> u64 {
        self.active.eeprom_writes()
    }

    fn in_fault(&self) -> bool {
        self.active.machine.in_fault()
    }

    fn is_energised(&self) -> bool {
        self.active.machine.shaft.powered()
    }

    fn runs(&self) -> bool {
        self.active.machine.runs()
    }

    fn shaft_speed(&self, now: Tick) -> i64 {
        self.active.shaft_speed(now)
    }

    fn is_above(&self, _now: Tick, limit: i64) -> bool {
        self.active.machine.shaft.is_above(limit)
    }

    fn rises_above(&self, limit: i64) -> Option<Tick> {
        self.active.machine.shaft.rises_above(limit)
    }

    fn turning(&self, now: Tick) -> u64 {
        let behind = self.vabus.nodes().filter(|node| node.shaft_speed(now) != 0).count() as u64;
        behind + u64::from(self.shaft_speed(now) != 0)
    }

    fn energised(&self) -> u64 {
        let behind = self.vabus.nodes().filter(|node| node.machine.shaft.powered()).count() as u64;
        behind + u64::from(self.is_energised())
    }
}

impl AskedByModbus for Drive {
    fn answer(&mut self, counters: &mut Counters, now: Tick, pdu: &[u8]) -> Option<Response<ModbusReply>> {
        let (reply, effect) = modbus::answer(&mut self.active, counters, now, pdu);
        let refused = matches!(reply, ModbusReply::Exception { .. });
        let goes = line::goes(&self.active, modbus::written(pdu).filter(|_| !refused));
        Some(Response { reply, effect, goes })
    }
}

impl AskedByVabus for Drive {
    fn answer(&mut self, now: Tick, request: &Request) -> Option<Response<VabusReply>> {
        let (reply, effect) = self.vabus.answer(&mut self.active, now, request)?;
        let taken = matches!(reply, VabusReply::Ack { .. });
        let goes = line::goes(&self.active, Some(request.header().number.get()).filter(|_| taken));
        Some(Response { reply, effect, goes })
    }

    fn obey(&mut self, now: Tick, request: &Request) -> Effect {
        self.vabus.obey(&mut self.active, now, request)
    }

    fn garbled(&mut self, own: Address, telegram: &[u8]) -> Option<Response<VabusReply>> {
        let (reply, effect) = self.vabus.garbled(&mut self.active, own, telegram)?;
        Some(Response { reply, effect, goes: Goes::AsItStands })
    }

    fn refuse(&mut self, own: Address) -> Option<Response<VabusReply>> {
        self.vabus.refused(&mut self.active, own).map(Response::plain)
    }
}
