//! A station on the bench: where it stands on the line, its power, what it takes off the wire.
//!
//! Choices where the manual is silent:
//! - a software reset (P.34 = 123) begins when the reply to its write is out and takes 3 s ("a few seconds", CM-485
//!   manual 5.2.1);
//! - a drive hears other drives' telegrams and counts them (RS485), but not itself;
//! - a telegram that is torn, too short or too long, or in another character format counts as bus error 0x0C;
//! - the watchdog counts from the last request to this station that had a right check value, from the first one on
//!   after power-on or after P.413 was set; a broadcast is no exchange and does not hold it off.

use super::ignored::{acked, acknowledged};
use super::modbus::{self, Heard};
use super::script::Script;
use super::setup::Setup;
use super::vabus;
use super::voice::{QueuedReply, Voice};
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::{Exception, Reply, Request};
use crate::protocol::modbus::{BROADCAST, FrameError, Framing};
use crate::protocol::vabus as bus;
use crate::simulator::device::contract::{Action, Device, Effect, Fault, Goes, NodeSetting, RESTART, Response, Servo};
use crate::simulator::device::counters::Counters;
use crate::simulator::line::disturb::Outgoing;
use crate::simulator::line::speech::Spoken;
use crate::simulator::line::wire::{Slot, fits};
use crate::tick::{Span, Tick};

/// A drive, or another slave, on the bench.
#[derive(Clone, Debug)]
pub struct Drive {
    device: Box<dyn Device>,
    place: NodeSetting,
    modbus: modbus::Ear,
    vabus: vabus::Ear,
    voice: Voice,
    counters: Counters,
    script: Script,
    /// Writes to it are refused.
    refused: Option<u16>,
    /// Writes to it are acknowledged, and that is all.
    ignored: Option<u16>,
    /// Off the bus until then.
    away: Option<Tick>,
    /// Without power: an ACT without mains.
    dead: bool,
    /// End of its own last reply.
    own_last: Option<Tick>,
    /// Last byte that came in a character format that it cannot read.
    unread: Option<Tick>,
}

impl Drive {
    pub(crate) fn new(setup: Setup, device: Box<dyn Device>) -> Self {
        let mut drive = Drive {
            place: setup.place,
            modbus: modbus::Ear::new(setup.place.line, setup.strict_silence),
            vabus: vabus::Ear::default(),
            voice: Voice::new(&setup),
            counters: Counters::default(),
            script: Script::new(setup.script),
            refused: None,
            ignored: None,
            away: None,
            dead: device.lives_by_mains() == Some(false),
            own_last: None,
            unread: None,
            device,
        };
        drive.take_place();
        drive
    }

    /// Address in the protocol that it speaks: of Modbus 1-247, of VABus 1-30.
    pub fn address(&self) -> u8 {
        self.place.address
    }

    /// `act`, `acu`, `lxm05` or `foreign`.
    pub fn model(&self) -> &str {
        self.device.model()
    }

    /// Speed and character format that it listens with.
    pub fn line(&self) -> LineSetting {
        self.place.line
    }

    /// What it speaks (P.395): `vabus`, `p-bus`, `rtu` or `ascii`.
    pub fn protocol(&self) -> &'static str {
        self.place.spoken.name()
    }

    pub(crate) fn spoken(&self) -> Spoken {
        self.place.spoken
    }

    /// EEPROM cells written since the bench was built.
    pub fn eeprom_writes(&self) -> u64 {
        self.device.eeprom_writes()
    }

    /// Raw value of a parameter in the EEPROM, data set 0-4; `None` if there is no such cell, or if the four data
    /// sets behind 0 differ.
    pub fn eeprom(&self, number: u32, set: u8) -> Option<i64> {
        self.device.eeprom(number, set)
    }

    /// Raw value of a parameter in the RAM, data set 0-4 or 5-9; of a foreign slave, a register. An LXM05 has no data
    /// sets.
    pub fn ram(&self, number: u32, set: u8) -> Option<i64> {
        self.device.ram(number, set)
    }

    /// Frequency of the shaft at `now`, if nobody does anything until then, in 0.01 Hz: what it really does, positive
    /// clockwise, whatever the drive knows or shows of it.
    pub fn shaft_speed(&self, now: Tick) -> i64 {
        self.device.shaft_speed(now)
    }

    /// What the shaft of an LXM05 does at `now`, if nobody does anything until then; `None` of all others.
    pub fn servo(&self, now: Tick) -> Option<Servo> {
        self.device.servo(now)
    }

    /// Silence that must follow its telegrams: that of the protocol, and what its transmitter needs to switch off.
    pub(crate) fn rest(&self) -> Span {
        let silence = if self.place.spoken == Spoken::RTU { self.place.line.t35() } else { Span::ZERO };
        silence.longer(self.device.switches_off_in())
    }

    /// Whether the output stage feeds the motor: a turning field, also at standstill, or direct current.
    pub fn is_energised(&self) -> bool {
        self.device.is_energised()
    }

    /// Shafts that turn at `now`: its own, and those of the drives behind it on the system bus.
    pub fn turning(&self, now: Tick) -> u64 {
        self.device.turning(now)
    }

    /// Output stages that feed a motor: its own, and those of the drives behind it.
    pub(crate) fn energised(&self) -> u64 {
        self.device.energised()
    }

    /// Whether a fault stands.
    pub fn in_fault(&self) -> bool {
        self.device.in_fault()
    }

    /// Replies that it sent, and exceptions among them.
    pub(crate) fn answered(&self) -> (u64, u64) {
        (self.voice.answered, self.voice.exceptions)
    }

    /// Takes the power off and on again: off the bus for 3 s, RAM reloaded from the EEPROM.
    pub fn power_cycle(&mut self, at: Tick) {
        if self.dead {
            return;
        }
        self.device.power_up(at, at + RESTART);
        self.counters = Counters::default();
        self.leave_bus(at + RESTART);
        self.take_place();
    }

    /// Lets a fault happen: the value of P.260; of an LXM05, the number of an error of class 3.
    pub fn trip(&mut self, at: Tick, code: u16) {
        self.device.act(at, Action::Fault(Fault { number: code, class: 3, qualifier: 0 }));
    }

    /// Sets the warning word P.270.
    pub fn warn(&mut self, word: u16) {
        // A warning stands from the next look on, whenever that is.
        self.device.act(Tick::ZERO, Action::Warning(word));
    }

    fn leave_bus(&mut self, until: Tick) {
        self.voice.hush();
        self.forget_bytes();
        self.away = Some(until);
    }

    /// Whether it hears and speaks at all.
    pub(crate) fn awake(&self) -> bool {
        !self.dead && self.away.is_none()
    }

    /// Takes its place as power-on finds it.
    fn take_place(&mut self) {
        self.place = self.device.setting_at_power_on(self.place);
        self.forget_bytes();
    }

    /// Takes its place as a write has left it.
    fn adopt(&mut self) {
        let before = self.place;
        self.place = self.device.setting_after_write(before);
        if (before.spoken, before.line) != (self.place.spoken, self.place.line) {
            self.forget_bytes();
        }
    }

    /// Nothing of what came in before counts any more.
    fn forget_bytes(&mut self) {
        self.modbus.forget(self.place.line);
        self.vabus.forget();
    }

    /// What holds from now on, after a write was answered.
    fn follow_up(&mut self, now: Tick, effect: Effect) {
        match effect {
            Effect::Reset => self.power_cycle(now),
            Effect::None => self.adopt(),
        }
    }

    /// Lets everything of the script happen that is due.
    fn play(&mut self, now: Tick) {
        while let Some(action) = self.script.due(now, &*self.device) {
            match action {
                Action::Silent(span) => self.leave_bus(now + span),
                Action::PowerCycle => self.power_cycle(now),
                Action::Refuses(place) => self.refused = Some(place),
                Action::Ignores(place) => self.ignored = Some(place),
                action => {
                    self.feed(now, action);
                    self.device.act(now, action);
                }
            }
        }
    }

    /// Mains of an ACT: all the power that it has.
    fn feed(&mut self, now: Tick, action: Action) {
        let Action::Mains(on) = action else { return };
        if self.device.lives_by_mains().is_none() {
            return;
        }
        let was_dead = std::mem::replace(&mut self.dead, !on);
        if on && was_dead {
            self.power_cycle(now);
        }
        if !on && !was_dead {
            self.leave_bus(now);
            self.device.power_down(now);
        }
    }

    /// Takes a byte off the wire that somebody else put there.
    pub(crate) fn hear(&mut self, slot: &Slot) {
        if !self.awake() || self.voice.speaks(slot.start) {
            return;
        }
        let line = self.place.line;
        if !fits(line, slot.line) {
            let new = self.unread.is_none_or(|last| slot.start.since(last) >= line.t35());
            if new {
                self.counters.count(Counters::ERRORS);
            }
            self.unread = Some(slot.end);
            return;
        }
        let heard = match self.place.spoken {
            Spoken::Modbus(Framing::Rtu) => self.modbus.feed_rtu(line, self.own_last, slot),
            Spoken::Modbus(Framing::Ascii) => self.modbus.feed_ascii(slot),
            Spoken::Vabus => {
                if let Some(telegram) = self.vabus.feed(slot.end, slot.byte) {
                    self.take_telegram(slot.end, &telegram);
                }
                None
            }
            // Nobody on this bench understands P-Bus, and Modbus/TCP is not spoken on a line.
            Spoken::Modbus(Framing::Tcp) | Spoken::PBus => None,
        };
        self.take(heard);
    }

    fn take(&mut self, heard: Option<Heard>) {
        match heard {
            None => {}
            Some(Heard::Torn) => self.counters.count(Counters::ERRORS),
            Some(Heard::Frame { last, over, framing, bytes }) => self.take_frame(last, over, framing, &bytes),
        }
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
        let is_write = Request::decode(&adu.pdu).is_ok_and(|request| request.is_write());
        if adu.station == BROADCAST {
            self.counters.count(Counters::BROADCASTS);
            // Broadcasts are writes only (CM-485 manual 6.1).
            if let Some(answer) = is_write.then(|| self.execute(now, &adu.pdu, is_write)).flatten() {
                self.follow_up(now, answer.effect);
            }
            return;
        }
        if adu.station != self.place.address {
            return;
        }
        self.counters.count(Counters::OWN);
        self.device.heard(now, last, is_write);
        let Some(answer) = self.execute(now, &adu.pdu, is_write) else { return };
        let Some(answer) = self.goes(now, answer) else { return };
        let Some(slave) = self.device.modbus() else { return };
        let (framing, line) = (self.place.spoken.framing().unwrap_or(framing), self.place.line);
        let frame = framing.encode(self.place.address, &slave.encode(&answer.reply));
        let exception = matches!(answer.reply, Reply::Exception { .. });
        let rest = if framing == Framing::Rtu { line.t35() } else { Span::ZERO };
        self.voice.queue(line, last, rest, QueuedReply { frame, effect: answer.effect, exception });
    }

    /// Executes a request of Modbus; `None` if it is not answered.
    fn execute(&mut self, now: Tick, pdu: &[u8], is_write: bool) -> Option<Response<Reply>> {
        self.script.count(is_write);
        if let &[function, high, low, ..] = pdu
            && is_write
            && self.refused == Some(u16::from_be_bytes([high, low]))
        {
            return Some(Response::plain(Reply::Exception { function, code: Exception::DeviceFailure }));
        }
        if let Some(reply) = self.ignored.and_then(|place| acknowledged(pdu, place)) {
            return Some(Response::plain(reply));
        }
        self.device.modbus()?.answer(&mut self.counters, now, pdu)
    }

    /// Takes a telegram of a VABus master whose last bit was on the wire `now`.
    fn take_telegram(&mut self, now: Tick, telegram: &[u8]) {
        let Some(own) = bus::Address::drive(self.place.address) else { return };
        let Some(answer) = self.execute_vabus(now, own, telegram) else { return };
        let Some(answer) = self.goes(now, answer) else { return };
        let reply = match (answer.reply, bus::Address::drive(self.place.address)) {
            (bus::Reply::Ack { .. }, Some(address)) => bus::Reply::Ack { address },
            (reply, _) => reply,
        };
        let exception = matches!(reply, bus::Reply::Nak { .. });
        let said = QueuedReply { frame: reply.encode(), effect: answer.effect, exception };
        self.voice.queue(self.place.line, now, Span::ZERO, said);
    }

    fn execute_vabus(&mut self, now: Tick, own: bus::Address, telegram: &[u8]) -> Option<Response<bus::Reply>> {
        self.device.vabus()?;
        let request = match bus::Request::decode(telegram) {
            Ok(request) => request,
            Err(bus::TelegramError::Check { .. }) => return self.device.vabus()?.garbled(own, telegram),
            Err(_) => return None,
        };
        let is_select = matches!(request, bus::Request::Select { .. });
        if request.address() == own {
            self.device.heard(now, now, is_select);
            self.script.count(is_select);
            if self.refused.is_some_and(|place| acked(&request, place).is_some()) {
                return self.device.vabus()?.refuse(own);
            }
            if let Some(reply) = self.ignored.and_then(|place| acked(&request, place)) {
                return Some(Response::plain(reply));
            }
            return self.device.vabus()?.answer(now, &request);
        }
        if request.address().is_broadcast() {
            self.script.count_broadcast(is_select);
            let effect = self.device.vabus()?.obey(now, &request);
            self.follow_up(now, effect);
        }
        None
    }

    /// After a write of what the line hangs on, where its reply goes out with the new setting, or is lost: takes the
    /// setting now. `None` if there is no reply.
    fn goes<R>(&mut self, now: Tick, answer: Response<R>) -> Option<Response<R>> {
        match answer.goes {
            Goes::Nowhere => {
                self.follow_up(now, answer.effect);
                return None;
            }
            // A reset with the new setting answers nobody: the drive is off the bus.
            Goes::Anew if answer.effect == Effect::None => self.adopt(),
            Goes::Anew | Goes::AsItStands => {}
        }
        Some(answer)
    }

    /// When something will happen if nobody speaks.
    pub(crate) fn next_event(&self) -> Option<Tick> {
        let scene = self.script.next(&*self.device);
        [scene, self.voice.next(), self.away, self.modbus.ends(), self.device.next()].into_iter().flatten().min()
    }

    /// Lets everything happen that is due by `now`; returns a reply that starts now, and has to be called again then.
    pub(crate) fn run(&mut self, now: Tick) -> Option<Outgoing> {
        self.play(now);
        if self.away.is_some_and(|until| until <= now) {
            self.away = None;
        }
        if let Some((until, effect)) = self.voice.ended(now) {
            self.own_last = Some(until);
            self.follow_up(until, effect);
        }
        let heard = self.modbus.idle(self.place.line, now);
        self.take(heard);
        self.device.catch_up(now);
        self.play(now);
        let NodeSetting { address: station, spoken, line } = self.place;
        let frame = self.voice.starts(now, line)?;
        Some(Outgoing { station, spoken, line, frame })
    }
}
