//! An LXM05 as a station has it: what it understands, and what can happen to it.

use super::modbus::encode;
use super::params;
use super::servo::Lexium;
use crate::protocol::modbus::pdu::Reply;
use crate::simulator::device::contract::{Action, AskedByModbus, Device, NodeSetting, Response, Servo};
use crate::simulator::device::counters::Counters;
use crate::tick::{Span, Tick};

impl Device for Lexium {
    fn model(&self) -> &'static str {
        "lxm05"
    }

    fn catch_up(&mut self, now: Tick) {
        Lexium::catch_up(self, now);
    }

    fn next(&self) -> Option<Tick> {
        Lexium::next(self)
    }

    fn power_up(&mut self, now: Tick, up: Tick) {
        Lexium::power_up(self, now, up);
    }

    fn act(&mut self, now: Tick, action: Action) {
        self.catch_up(now);
        match action {
            Action::Fault(fault) => self.fail(now, fault),
            Action::Set(address, _, value) => self.set_by_hand(now, address, value),
            Action::Dragged(on) => self.motion.drag(on),
            _ => {}
        }
    }

    fn setting_at_power_on(&mut self, before: NodeSetting) -> NodeSetting {
        NodeSetting { address: self.address(), line: self.line(), ..before }
    }

    fn setting_after_write(&mut self, before: NodeSetting) -> NodeSetting {
        let (address, line) = self.follow(before.address, before.line);
        NodeSetting { address, line, ..before }
    }

    /// The manual tells no such time.
    fn switches_off_in(&self) -> Span {
        Span::ZERO
    }

    fn heard(&mut self, now: Tick, last: Tick, is_write: bool) {
        self.catch_up(now);
        Lexium::heard(self, last, is_write);
    }

    fn modbus(&mut self) -> Option<&mut dyn AskedByModbus> {
        Some(self)
    }

    /// It has no data sets.
    fn eeprom(&self, address: u32, _set: u8) -> Option<i64> {
        self.kept(address)
    }

    fn ram(&self, address: u32, _set: u8) -> Option<i64> {
        let row = params::at(u16::try_from(address).ok()?)?;
        Some(self.read(row.address).into())
    }

    fn eeprom_writes(&self) -> u64 {
        Lexium::eeprom_writes(self)
    }

    fn in_fault(&self) -> bool {
        Lexium::in_fault(self)
    }

    fn is_energised(&self) -> bool {
        self.powered()
    }

    fn runs(&self) -> bool {
        self.powered()
    }

    fn shaft_speed(&self, now: Tick) -> i64 {
        self.frequency(now)
    }

    fn is_above(&self, now: Tick, limit: i64) -> bool {
        self.frequency(now).abs() > limit
    }

    fn rises_above(&self, _limit: i64) -> Option<Tick> {
        self.next_turning()
    }

    fn servo(&self, now: Tick) -> Option<Servo> {
        Some(Lexium::servo(self, now))
    }
}

impl AskedByModbus for Lexium {
    fn answer(&mut self, counters: &mut Counters, now: Tick, pdu: &[u8]) -> Option<Response<Reply>> {
        Lexium::answer(self, counters, now, pdu).map(Response::plain)
    }

    fn encode(&self, reply: &Reply) -> Vec<u8> {
        encode(reply)
    }
}
