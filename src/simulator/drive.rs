//! A station on the bench: its ears, its reply time, its settings, and its script.
//!
//! Choices where the manual is silent:
//! - a new protocol (P.395) or address (P.1376) holds from the end of the reply to the write on, because the echo of
//!   the write must come from the old address; P.10 and P.1375 wait for a reset (CM-485 manual 5.2);
//! - a software reset (P.34 = 123) begins at the same moment and takes 3 s ("a few seconds", CM-485 manual 5.2.1);
//! - a drive hears other drives' telegrams and counts them (RS485), but not itself;
//! - a telegram that is torn, too short or too long, or in another character format counts as bus error 0x0C;
//! - two requests in a row are answered in a row; of more than [`QUEUE`] the rest is forgotten;
//! - the watchdog counts from the last request to this station that had a right check value, from the first one on
//!   after power-on or after P.413 was set.

use super::active::{Active, Effect};
use super::dice::Dice;
use super::disturb::Outgoing;
use super::foreign::Foreign;
use super::judge::TURNAROUND;
use super::setup::{Action, BAUD_RATES, Event, Model, PARITIES, Setup, settings};
use super::slave::{Counters, answer};
use super::wire::{Slot, fits};
use crate::profile::Family;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::pdu::{Reply, Request};
use crate::protocol::modbus::{BROADCAST, FrameError, Framing, ascii, rtu};
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// How long a drive is off the bus after power-on or software reset.
const RESTART: Span = Span::from_secs(3);
/// Most replies that wait to be sent.
const QUEUE: usize = 4;

/// A drive, or another slave, on the bench.
#[derive(Clone, Debug)]
pub struct Drive {
    model: Model,
    body: Body,
    address: u8,
    framing: Option<Framing>,
    line: LineSetting,
    /// Data bits in ASCII mode; 7 by the manual.
    ascii_bits: u8,
    rtu: rtu::Receiver,
    ascii: ascii::Receiver,
    counters: Counters,
    delay: Span,
    jitter: Span,
    dice: Dice,
    strict_silence: bool,
    script: VecDeque<Event>,
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
    Foreign(Foreign),
}

/// A reply that waits for its time.
#[derive(Clone, Debug)]
struct Pending {
    start: Tick,
    frame: Vec<u8>,
    effect: Effect,
    exception: bool,
}

impl Drive {
    pub(super) fn new(setup: Setup, family: Option<&Family>) -> Self {
        let body = match setup.model {
            Model::Foreign => Body::Foreign(Foreign::new(setup.registers)),
            Model::Act | Model::Acu => {
                let acu = setup.model == Model::Acu;
                let mut values = settings(setup.framing, setup.line, setup.address);
                values.extend(&setup.values);
                Body::Active(Box::new(Active::new(acu, family, &setup.modules, setup.contacts, &values)))
            }
        };
        let mut script: Vec<Event> = setup.script;
        script.sort_by_key(|event| event.at);
        let mut drive = Drive {
            model: setup.model,
            body,
            address: setup.address,
            framing: setup.framing,
            line: setup.line,
            ascii_bits: if setup.framing == Some(Framing::Ascii) { setup.line.data_bits } else { 7 },
            rtu: rtu::Receiver::new(setup.line),
            ascii: ascii::Receiver::default(),
            counters: Counters::default(),
            delay: setup.delay,
            jitter: setup.jitter,
            dice: Dice::new(setup.seed),
            strict_silence: setup.strict_silence,
            script: script.into(),
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

    /// Modbus address, 1-247.
    pub fn address(&self) -> u8 {
        self.address
    }

    /// `act`, `acu` or `foreign`.
    pub fn model(&self) -> &str {
        self.model.name()
    }

    /// Speed and character format that it listens with.
    pub fn line(&self) -> LineSetting {
        self.line
    }

    /// How it frames telegrams; `None` while it does not speak Modbus (P.395).
    pub fn framing(&self) -> Option<Framing> {
        self.framing
    }

    /// EEPROM cells written since the bench was built.
    pub fn eeprom_writes(&self) -> u64 {
        match &self.body {
            Body::Active(active) => active.eeprom_writes(),
            Body::Foreign(_) => 0,
        }
    }

    /// Raw value of a parameter in the EEPROM, data set 0-4; `None` if there is no such cell, or if the four data
    /// sets behind 0 differ.
    pub fn eeprom(&self, number: u32, set: u8) -> Option<i64> {
        match &self.body {
            Body::Active(active) => active.eeprom(number, set),
            Body::Foreign(_) => None,
        }
    }

    /// Raw value of a parameter in the RAM, data set 0-4 or 5-9; of a foreign slave, a register.
    pub fn ram(&self, number: u32, set: u8) -> Option<i64> {
        match &self.body {
            Body::Active(active) => active.ram(number, set),
            Body::Foreign(foreign) => foreign.register(number),
        }
    }

    /// Whether a fault stands.
    pub fn in_fault(&self) -> bool {
        matches!(&self.body, Body::Active(active) if active.in_fault())
    }

    /// Takes the mains off and on again: off the bus for 3 s, RAM reloaded from the EEPROM.
    pub fn power_cycle(&mut self, at: Tick) {
        if let Body::Active(active) = &mut self.body {
            active.power_up(at);
        }
        self.counters = Counters::default();
        self.leave_bus(at + RESTART);
        self.adopt();
        self.take_line();
    }

    /// Lets a fault happen: the value of P.260.
    pub fn trip(&mut self, at: Tick, code: u16) {
        if let Body::Active(active) = &mut self.body {
            active.trip(at, code);
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
        self.rtu = rtu::Receiver::new(self.line);
        self.ascii = ascii::Receiver::default();
        self.away = Some(until);
    }

    /// Whether it hears and speaks at all.
    pub(super) fn awake(&self) -> bool {
        !self.dead && self.away.is_none()
    }

    /// Protocol and address, from the RAM copy of their parameters.
    fn adopt(&mut self) {
        let Body::Active(active) = &self.body else { return };
        let framing = match active.value(395) {
            2 => Some(Framing::Rtu),
            3 => Some(Framing::Ascii),
            _ => None,
        };
        self.address = u8::try_from(active.value(1376)).unwrap_or(self.address);
        if framing != self.framing {
            self.framing = framing;
            self.shape_line(self.line.baud, self.line.parity);
        }
    }

    /// Speed and parity, from the RAM copy of their parameters: only at power-on.
    fn take_line(&mut self) {
        let Body::Active(active) = &self.body else { return };
        let baud = BAUD_RATES.iter().find(|row| row.0 == active.value(10)).map_or(self.line.baud, |row| row.1);
        let parity = PARITIES.iter().find(|row| row.0 == active.value(1375)).map_or(self.line.parity, |row| row.1);
        self.adopt();
        self.shape_line(baud, parity);
    }

    fn shape_line(&mut self, baud: u32, parity: Parity) {
        self.line = match self.framing {
            Some(Framing::Ascii) => LineSetting { data_bits: self.ascii_bits, ..LineSetting::ascii(baud, parity) },
            Some(Framing::Rtu) => LineSetting::rtu(baud, parity),
            None => LineSetting { parity, baud, ..self.line },
        };
        self.rtu = rtu::Receiver::new(self.line);
        self.ascii = ascii::Receiver::default();
    }

    /// Takes a byte off the wire that somebody else put there.
    pub(super) fn hear(&mut self, slot: &Slot) {
        let sending = self.sending.is_some_and(|(until, _)| slot.start < until);
        let Some(framing) = self.framing.filter(|_| self.awake() && !sending) else { return };
        if !fits(self.line, slot.line) {
            let new = self.unread.is_none_or(|last| slot.start.since(last) >= self.line.t35());
            if new {
                self.counters.count(Counters::ERRORS);
            }
            self.unread = Some(slot.end);
            return;
        }
        match framing {
            Framing::Rtu => {
                let last = self.last_byte;
                let begins = self.rtu.ends().is_none_or(|ends| ends <= slot.start);
                if let Some(burst) = self.rtu.feed(slot.end, slot.byte) {
                    self.take_burst(last, burst);
                }
                let early = self.own_last.is_some_and(|own| slot.start.since(own) < self.line.t35());
                if begins && self.strict_silence && early {
                    self.deaf = true;
                }
                self.last_byte = slot.end;
            }
            Framing::Ascii => {
                self.last_byte = slot.end;
                if let Some(frame) = self.ascii.feed(slot.end, slot.byte) {
                    self.take_frame(slot.end, slot.end, Framing::Ascii, &frame);
                }
            }
        }
    }

    fn take_burst(&mut self, last: Tick, burst: rtu::Burst) {
        if std::mem::take(&mut self.deaf) {
            return;
        }
        if burst.broken {
            self.counters.count(Counters::ERRORS); // discarded, CM-485 manual 6.7.1.3
            return;
        }
        self.take_frame(last, last + self.line.t35(), Framing::Rtu, &burst.bytes);
    }

    /// Takes a telegram whose last bit was on the wire at `last`, and which is known to be over `now`.
    fn take_frame(&mut self, last: Tick, now: Tick, framing: Framing, frame: &[u8]) {
        let adu = match framing.decode(frame) {
            Ok(adu) => adu,
            Err(error) => {
                self.counters.count(Counters::ERRORS);
                if matches!(error, FrameError::TooLong { .. }) {
                    self.counters.count(Counters::OVERRUNS);
                }
                return;
            }
        };
        self.counters.count(Counters::MESSAGES);
        if adu.station == BROADCAST {
            self.counters.count(Counters::BROADCASTS);
            // Broadcasts are writes only (CM-485 manual 6.1).
            if Request::decode(&adu.pdu).is_ok_and(|request| request.is_write()) {
                let (_, effect) = self.execute(now, &adu.pdu);
                self.follow_up(now, effect);
            }
            return;
        }
        if adu.station != self.address {
            return;
        }
        self.counters.count(Counters::OWN);
        if let Body::Active(active) = &mut self.body {
            active.catch_up(now);
            active.heard(last);
        }
        let (reply, effect) = self.execute(now, &adu.pdu);
        self.prepare(last, framing, &reply, effect);
    }

    fn execute(&mut self, now: Tick, pdu: &[u8]) -> (Reply, Effect) {
        match &mut self.body {
            Body::Active(active) => answer(active, &mut self.counters, now, pdu),
            Body::Foreign(foreign) => (foreign.answer(pdu), Effect::None),
        }
    }

    /// Puts a reply into the queue: not before 10 ms or what the bench file says, and never before t3.5
    /// (CM-485 manual 6.8, 6.7.1.3).
    fn prepare(&mut self, last: Tick, framing: Framing, reply: &Reply, effect: Effect) {
        if self.pending.len() >= QUEUE {
            return;
        }
        let rest = match framing {
            Framing::Rtu => self.line.t35(),
            Framing::Ascii => Span::ZERO,
        };
        let jitter = Span::from_micros(self.dice.below(self.jitter.as_micros().saturating_add(1)));
        let mut start = last + self.delay + jitter;
        let before = self.pending.back().map(|reply| reply.start + self.line.chars(reply.frame.len() as u64));
        if let Some(free) = before.or(self.sending.map(|(until, _)| until)) {
            start = start.max(free + TURNAROUND.longer(rest));
        }
        let frame = framing.encode(self.address, &reply.encode());
        let exception = matches!(reply, Reply::Exception { .. });
        self.pending.push_back(Pending { start: start.max(last + rest), frame, effect, exception });
    }

    /// What holds from now on, after a write was answered.
    fn follow_up(&mut self, now: Tick, effect: Effect) {
        match effect {
            Effect::Reset => self.power_cycle(now),
            Effect::None => self.adopt(),
        }
    }

    /// When something will happen if nobody speaks.
    pub(super) fn next_event(&self) -> Option<Tick> {
        let script = self.script.front().map(|event| event.at);
        let sending = self.sending.map(|(until, _)| until);
        let pending = self.pending.front().filter(|_| self.sending.is_none()).map(|reply| reply.start);
        let body = match &self.body {
            Body::Active(active) => active.next(),
            Body::Foreign(_) => None,
        };
        [script, sending, pending, self.away, self.rtu.ends(), body].into_iter().flatten().min()
    }

    /// Lets everything happen that is due by `now`; returns a reply that starts now, and has to be called again then.
    pub(super) fn run(&mut self, now: Tick) -> Option<Outgoing> {
        while self.script.front().is_some_and(|event| event.at <= now) {
            let Some(event) = self.script.pop_front() else { break };
            self.act(event);
        }
        if self.away.is_some_and(|until| until <= now) {
            self.away = None;
        }
        if let Some((until, effect)) = self.sending.filter(|(until, _)| *until <= now) {
            self.sending = None;
            self.own_last = Some(until);
            self.follow_up(until, effect);
        }
        if let Some(burst) = self.rtu.idle(now) {
            self.take_burst(self.last_byte, burst);
        }
        if let Body::Active(active) = &mut self.body {
            active.catch_up(now);
        }
        if self.sending.is_some() {
            return None;
        }
        self.pending.front().filter(|reply| reply.start <= now)?;
        let reply = self.pending.pop_front()?;
        let framing = self.framing.unwrap_or(Framing::Rtu);
        self.sending = Some((now + self.line.chars(reply.frame.len() as u64), reply.effect));
        self.answered += 1;
        self.exceptions += u64::from(reply.exception);
        Some(Outgoing { station: self.address, framing, line: self.line, frame: reply.frame })
    }

    fn act(&mut self, event: Event) {
        let at = event.at;
        if let Action::Silent(span) = event.action {
            return self.leave_bus(at + span);
        }
        if matches!(event.action, Action::PowerCycle) {
            return self.power_cycle(at);
        }
        if let Action::Mains(on) = event.action
            && self.model == Model::Act
        {
            // Nothing but the mains feeds the electronics of an ACT (CM-485 manual 10.1 names 24 V for the ACU only).
            let back = on && std::mem::replace(&mut self.dead, !on);
            self.dead = !on;
            if back || !on {
                self.power_cycle(at);
            }
        }
        let Body::Active(active) = &mut self.body else { return };
        match event.action {
            Action::Fault(code) => active.trip(at, code),
            Action::Warning(word) => active.warn(word),
            Action::Mains(on) => active.wire(at, |contacts| contacts.mains = on),
            Action::Enable(on) => active.wire(at, |contacts| contacts.enable = on),
            Action::StartRight(on) => active.wire(at, |contacts| contacts.right = on),
            Action::StartLeft(on) => active.wire(at, |contacts| contacts.left = on),
            Action::PowerCycle | Action::Silent(_) => {}
        }
    }
}
