//! A station on the bench: its settings, its power, and its script. Its ears and its voice are in `bus.rs`.
//!
//! Choices where the manual is silent:
//! - a new protocol (P.395) or address (P.1376, P.394 of VABus) holds from the end of the reply to the write on, because
//!   that must come from the old address; P.10 and P.1375 wait for a reset (CM-485 manual 5.2);
//! - VABus is 7E1 (facts A1) whatever P.1375 says, which is called "Modbus parity";
//! - a software reset (P.34 = 123) begins at the same moment and takes 3 s ("a few seconds", CM-485 manual 5.2.1);
//! - nothing but the mains feeds the electronics of an ACT (CM-485 manual 10.1 names 24 V for the ACU only);
//! - a power cycle and a reset leave the shaft to coast.

mod bus;

use super::active::{Active, Effect};
use super::dice::Dice;
use super::foreign::Foreign;
use super::judge::TURNAROUND;
use super::lexium::{Fault, Lexium, Servo};
use super::readings::Readings;
use super::script::{Action, Event, Trigger};
use super::setup::{BAUD_RATES, Model, PARITIES, Setup, Spoken};
use super::slave::Counters;
use super::vabus;
use crate::profile::Family;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{ascii, rtu};
use crate::tick::{Span, Tick};
use bus::Pending;
use std::collections::VecDeque;

/// How long a drive is off the bus after power-on or software reset.
pub(super) const RESTART: Span = Span::from_secs(3);

/// A drive, or another slave, on the bench.
#[derive(Clone, Debug)]
pub struct Drive {
    model: Model,
    body: Body,
    address: u8,
    spoken: Spoken,
    line: LineSetting,
    /// P.1375 as it was at power-on.
    modbus_parity: Parity,
    /// Data bits in ASCII mode; 7 by the manual.
    ascii_bits: u8,
    /// Character format of VABus; 7E1 by the manual.
    vabus_line: LineSetting,
    rtu: rtu::Receiver,
    ascii: ascii::Receiver,
    vabus: vabus::Port,
    counters: Counters,
    delay: Span,
    jitter: Span,
    dice: Dice,
    strict_silence: bool,
    /// What is still to happen.
    script: Vec<Event>,
    /// Telegrams, and writes among them, that have come to it.
    telegrams: u64,
    writes: u64,
    readings: Readings,
    pending: VecDeque<Pending>,
    sending: Option<(Tick, Effect)>,
    /// Off the bus until then.
    away: Option<Tick>,
    /// Without power: an ACT without mains.
    dead: bool,
    last_byte: Tick,
    /// End of its own last reply.
    own_last: Option<Tick>,
    /// The telegram that comes in now began too early for a strict drive.
    deaf: bool,
    /// Last byte that came in a character format that it cannot read.
    unread: Option<Tick>,
    pub(super) answered: u64,
    pub(super) exceptions: u64,
}

#[derive(Clone, Debug)]
enum Body {
    Active(Box<Active>),
    Lexium(Box<Lexium>),
    Foreign(Foreign),
}

impl Drive {
    pub(super) fn new(setup: Setup, family: Option<&Family>) -> Self {
        let body = match setup.model {
            Model::Foreign => Body::Foreign(Foreign::new(setup.registers.clone())),
            Model::Act | Model::Acu => Body::Active(Box::new(Active::new(&setup, family))),
            Model::Lxm05 => Body::Lexium(Box::new(Lexium::new(&setup))),
        };
        let mut drive = Drive {
            model: setup.model,
            body,
            address: setup.address,
            spoken: setup.spoken,
            line: setup.line,
            modbus_parity: setup.line.parity,
            ascii_bits: if setup.spoken == Spoken::ASCII { setup.line.data_bits } else { 7 },
            vabus_line: if setup.spoken == Spoken::Vabus { setup.line } else { LineSetting::vabus(setup.line.baud) },
            rtu: rtu::Receiver::new(setup.line),
            ascii: ascii::Receiver::default(),
            vabus: vabus::Port::new(setup.nodes),
            counters: Counters::default(),
            delay: setup.delay,
            jitter: setup.jitter,
            dice: Dice::new(setup.seed),
            strict_silence: setup.strict_silence,
            script: setup.script,
            telegrams: 0,
            writes: 0,
            readings: setup.readings,
            pending: VecDeque::new(),
            sending: None,
            away: None,
            dead: setup.model == Model::Act && !setup.contacts.mains,
            last_byte: Tick::ZERO,
            own_last: None,
            deaf: false,
            unread: None,
            answered: 0,
            exceptions: 0,
        };
        drive.take_line();
        drive
    }

    /// Address in the protocol that it speaks: of Modbus 1-247, of VABus 1-30.
    pub fn address(&self) -> u8 {
        self.address
    }

    /// `act`, `acu`, `lxm05` or `foreign`.
    pub fn model(&self) -> &str {
        self.model.name()
    }

    /// Speed and character format that it listens with.
    pub fn line(&self) -> LineSetting {
        self.line
    }

    /// What it speaks (P.395): `vabus`, `p-bus`, `rtu` or `ascii`.
    pub fn protocol(&self) -> &'static str {
        self.spoken.name()
    }

    pub(super) fn spoken(&self) -> Spoken {
        self.spoken
    }

    /// EEPROM cells written since the bench was built.
    pub fn eeprom_writes(&self) -> u64 {
        match &self.body {
            Body::Active(active) => active.eeprom_writes(),
            Body::Lexium(lexium) => lexium.eeprom_writes(),
            Body::Foreign(_) => 0,
        }
    }

    /// Raw value of a parameter in the EEPROM, data set 0-4; `None` if there is no such cell, or if the four data
    /// sets behind 0 differ.
    pub fn eeprom(&self, number: u32, set: u8) -> Option<i64> {
        match &self.body {
            Body::Active(active) => active.eeprom(number, set),
            Body::Lexium(lexium) => lexium.kept(number),
            Body::Foreign(_) => None,
        }
    }

    /// Raw value of a parameter in the RAM, data set 0-4 or 5-9; of a foreign slave, a register. An LXM05 has no data
    /// sets.
    pub fn ram(&self, number: u32, set: u8) -> Option<i64> {
        match &self.body {
            Body::Active(active) => active.ram(number, set),
            Body::Lexium(lexium) => lexium.value(number),
            Body::Foreign(foreign) => foreign.register(number),
        }
    }

    /// Frequency of the shaft at `now`, if nobody does anything until then, in 0.01 Hz: what it really does, positive
    /// clockwise, whatever the drive knows or shows of it.
    pub fn shaft_speed(&self, now: Tick) -> i64 {
        match &self.body {
            Body::Active(active) => active.shaft_speed(now),
            Body::Lexium(lexium) => lexium.frequency(now),
            Body::Foreign(_) => 0,
        }
    }

    /// What the shaft of an LXM05 does at `now`, if nobody does anything until then; `None` of all others.
    pub fn servo(&self, now: Tick) -> Option<Servo> {
        match &self.body {
            Body::Lexium(lexium) => Some(lexium.servo(now)),
            Body::Active(_) | Body::Foreign(_) => None,
        }
    }

    /// Silence that must follow its telegrams: that of the protocol, and what its transmitter needs to switch off. The
    /// LXM05 manual tells no such time.
    pub(super) fn rest(&self) -> Span {
        let silence = if self.spoken == Spoken::RTU { self.line.t35() } else { Span::ZERO };
        match &self.body {
            Body::Lexium(_) => silence,
            Body::Active(_) | Body::Foreign(_) => silence.longer(TURNAROUND),
        }
    }

    /// Whether the output stage feeds the motor: a turning field, also at standstill, or direct current.
    pub fn is_energised(&self) -> bool {
        match &self.body {
            Body::Active(active) => active.machine().shaft.powered(),
            Body::Lexium(lexium) => lexium.powered(),
            Body::Foreign(_) => false,
        }
    }

    /// Shafts that turn at `now`: its own, and those of the drives behind it on the system bus.
    pub(super) fn turning(&self, now: Tick) -> u64 {
        let behind = self.vabus.nodes().filter(|node| node.shaft_speed(now) != 0).count() as u64;
        behind + u64::from(self.shaft_speed(now) != 0)
    }

    /// Output stages that feed a motor: its own, and those of the drives behind it.
    pub(super) fn energised(&self) -> u64 {
        let behind = self.vabus.nodes().filter(|node| node.machine().shaft.powered()).count() as u64;
        behind + u64::from(self.is_energised())
    }

    /// Whether a fault stands.
    pub fn in_fault(&self) -> bool {
        match &self.body {
            Body::Active(active) => active.machine().in_fault(),
            Body::Lexium(lexium) => lexium.in_fault(),
            Body::Foreign(_) => false,
        }
    }

    /// Takes the power off and on again: off the bus for 3 s, RAM reloaded from the EEPROM.
    pub fn power_cycle(&mut self, at: Tick) {
        if self.dead {
            return;
        }
        match &mut self.body {
            Body::Active(active) => active.power_up(at, at + RESTART),
            Body::Lexium(lexium) => lexium.power_up(at, at + RESTART),
            Body::Foreign(_) => {}
        }
        self.vabus.unlock();
        self.counters = Counters::default();
        self.leave_bus(at + RESTART);
        self.adopt();
        self.take_line();
    }

    /// Lets a fault happen: the value of P.260; of an LXM05, the number of an error of class 3.
    pub fn trip(&mut self, at: Tick, code: u16) {
        match &mut self.body {
            Body::Active(active) => active.trip(at, code),
            Body::Lexium(lexium) => lexium.fail(at, Fault { number: code, class: 3, qualifier: 0 }),
            Body::Foreign(_) => {}
        }
    }

    /// Sets the warning word P.270.
    pub fn warn(&mut self, word: u16) {
        if let Body::Active(active) = &mut self.body {
            active.warn(word);
        }
    }

    fn leave_bus(&mut self, until: Tick) {
        self.pending.clear();
        self.sending = None;
        self.forget_bytes();
        self.away = Some(until);
    }

    /// Whether it hears and speaks at all.
    pub(super) fn awake(&self) -> bool {
        !self.dead && self.away.is_none()
    }

    /// Protocol and address, from the RAM copy of their parameters.
    fn adopt(&mut self) {
        if let Body::Lexium(lexium) = &mut self.body {
            let (address, line) = lexium.follow(self.address, self.line);
            if line != self.line {
                self.line = line;
                self.forget_bytes();
            }
            self.address = address;
        }
        let Body::Active(active) = &self.body else { return };
        let spoken = Spoken::of(active.value(395));
        let address = if spoken == Spoken::Vabus { 394 } else { 1376 };
        self.address = u8::try_from(active.value(address)).unwrap_or(self.address);
        if spoken != self.spoken {
            self.spoken = spoken;
            self.shape_line(self.line.baud);
        }
    }

    /// Speed and parity, from the RAM copy of their parameters: only at power-on.
    fn take_line(&mut self) {
        if let Body::Lexium(lexium) = &self.body {
            (self.address, self.line) = (lexium.address(), lexium.line());
            return self.forget_bytes();
        }
        let Body::Active(active) = &self.body else { return };
        let baud = BAUD_RATES.iter().find(|row| row.0 == active.value(10)).map_or(self.line.baud, |row| row.1);
        let parity = PARITIES.iter().find(|row| row.0 == active.value(1375)).map(|row| row.1);
        self.modbus_parity = parity.unwrap_or(self.modbus_parity);
        self.adopt();
        self.shape_line(baud);
    }

    fn shape_line(&mut self, baud: u32) {
        let parity = self.modbus_parity;
        self.line = match self.spoken {
            Spoken::ASCII => LineSetting { data_bits: self.ascii_bits, ..LineSetting::ascii(baud, parity) },
            Spoken::Modbus(_) | Spoken::PBus => LineSetting::rtu(baud, parity),
            Spoken::Vabus => LineSetting { baud, ..self.vabus_line },
        };
        self.forget_bytes();
    }

    /// Nothing of what came in before counts any more.
    fn forget_bytes(&mut self) {
        self.rtu = rtu::Receiver::new(self.line);
        self.ascii = ascii::Receiver::default();
        self.vabus.forget();
    }

    /// What holds from now on, after a write was answered.
    fn follow_up(&mut self, now: Tick, effect: Effect) {
        match effect {
            Effect::Reset => self.power_cycle(now),
            Effect::None => self.adopt(),
        }
    }

    /// When the script goes on, as far as that can be told.
    fn next_scene(&self) -> Option<Tick> {
        let scenes = self.script.iter().filter_map(|event| match (event.trigger, &self.body) {
            (Trigger::At(at), _) => Some(at),
            (Trigger::Above(limit), Body::Active(active)) => active.machine().shaft.rises_above(limit),
            (Trigger::Above(_), Body::Lexium(lexium)) => lexium.next_turning(),
            _ => None,
        });
        scenes.min()
    }

    /// Lets everything of the script happen that is due.
    fn play(&mut self, now: Tick) {
        while let Some(place) = self.script.iter().position(|event| self.is_due(event.trigger, now)) {
            let event = self.script.remove(place);
            let back = event.lasts.zip(event.action.opposite());
            self.script.extend(back.map(|(span, action)| Event {
                trigger: Trigger::At(now + span),
                action,
                lasts: None,
            }));
            self.act(now, event.action);
        }
    }

    fn is_due(&self, trigger: Trigger, now: Tick) -> bool {
        match (trigger, &self.body) {
            (Trigger::At(at), _) => at <= now,
            (Trigger::Writes(count), _) => count <= self.writes,
            (Trigger::Telegrams(count), _) => count <= self.telegrams,
            (Trigger::Running, Body::Active(active)) => active.machine().runs(),
            (Trigger::Above(limit), Body::Active(active)) => active.machine().shaft.is_above(limit),
            (Trigger::Running, Body::Lexium(lexium)) => lexium.powered(),
            (Trigger::Above(limit), Body::Lexium(lexium)) => lexium.frequency(now).abs() > limit,
            (Trigger::Running | Trigger::Above(_), Body::Foreign(_)) => false,
        }
    }

    fn act(&mut self, now: Tick, action: Action) {
        match action {
            Action::Silent(span) => return self.leave_bus(now + span),
            Action::PowerCycle => return self.power_cycle(now),
            Action::Mains(on) if self.model == Model::Act => self.feed(now, on),
            _ => {}
        }
        if let (Body::Lexium(lexium), Action::Error(error)) = (&mut self.body, action) {
            lexium.fail(now, error);
        }
        let Body::Active(active) = &mut self.body else { return };
        match action {
            Action::Fault(code) => active.trip(now, code),
            Action::Warning(word) => active.warn(word),
            Action::Torque(torque) => active.burden(now, torque),
            Action::Mains(on) => active.wire(now, |contacts| contacts.mains = on),
            Action::StoA(on) => active.wire(now, |contacts| contacts.sto_a = on),
            Action::StoB(on) => active.wire(now, |contacts| contacts.sto_b = on),
            Action::StartRight(on) => active.wire(now, |contacts| contacts.right = on),
            Action::StartLeft(on) => active.wire(now, |contacts| contacts.left = on),
            Action::Error(_) | Action::PowerCycle | Action::Silent(_) => {}
        }
    }

    /// Mains of an ACT: all the power that it has.
    fn feed(&mut self, now: Tick, on: bool) {
        let was_dead = std::mem::replace(&mut self.dead, !on);
        if on && was_dead {
            self.power_cycle(now);
        }
        if !on && !was_dead {
            self.leave_bus(now);
            if let Body::Active(active) = &mut self.body {
                active.power_down(now);
            }
        }
    }
}
