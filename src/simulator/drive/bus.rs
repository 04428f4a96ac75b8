//! The ears and the voice of a station: which telegrams it takes off the wire, and when its replies go out.
//!
//! Choices where the manual is silent:
//! - a drive hears other drives' telegrams and counts them (RS485), but not itself;
//! - a telegram that is torn, too short or too long, or in another character format counts as bus error 0x0C;
//! - two requests in a row are answered in a row; of more than [`QUEUE`] the rest is forgotten;
//! - the watchdog counts from the last request to this station that had a right check value, from the first one on
//!   after power-on or after P.413 was set; a broadcast is no exchange and does not hold it off.

use super::{Body, Drive};
use crate::protocol::modbus::pdu::{ParamAddress, Reply, Request};
use crate::protocol::modbus::{BROADCAST, FrameError, Framing, rtu};
use crate::protocol::vabus;
use crate::simulator::active::Effect;
use crate::simulator::disturb::Outgoing;
use crate::simulator::judge::TURNAROUND;
use crate::simulator::lexium;
use crate::simulator::readings::Reading;
use crate::simulator::setup::Spoken;
use crate::simulator::slave::{Counters, answer};
use crate::simulator::wire::{Slot, fits};
use crate::tick::{Span, Tick};

/// Most replies that wait to be sent.
const QUEUE: usize = 4;

/// A reply that waits for its time.
#[derive(Clone, Debug)]
pub(super) struct Pending {
    start: Tick,
    frame: Vec<u8>,
    effect: Effect,
    exception: bool,
}

impl Drive {
    /// Takes a byte off the wire that somebody else put there.
    pub(in crate::simulator) fn hear(&mut self, slot: &Slot) {
        let sending = self.sending.is_some_and(|(until, _)| slot.start < until);
        if !self.awake() || sending {
            return;
        }
        if !fits(self.line, slot.line) {
            let new = self.unread.is_none_or(|last| slot.start.since(last) >= self.line.t35());
            if new {
                self.counters.count(Counters::ERRORS);
            }
            self.unread = Some(slot.end);
            return;
        }
        match self.spoken {
            Spoken::RTU => {
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
            Spoken::ASCII => {
                self.last_byte = slot.end;
                if let Some(frame) = self.ascii.feed(slot.end, slot.byte) {
                    self.take_frame(slot.end, slot.end, Framing::Ascii, &frame);
                }
            }
            Spoken::Vabus => {
                if let Some(telegram) = self.vabus.feed(slot.end, slot.byte) {
                    self.take_telegram(slot.end, &telegram);
                }
            }
            Spoken::Modbus(_) | Spoken::PBus => {}
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
            let is_write = Request::decode(&adu.pdu).is_ok_and(|request| request.is_write());
            if let Some((_, effect)) = is_write.then(|| self.execute(now, &adu.pdu)).flatten() {
                self.follow_up(now, effect);
            }
            return;
        }
        if adu.station != self.address {
            return;
        }
        self.counters.count(Counters::OWN);
        let is_write = Request::decode(&adu.pdu).is_ok_and(|request| request.is_write());
        match &mut self.body {
            Body::Active(active) => {
                active.catch_up(now);
                active.heard(last);
            }
            Body::Lexium(lexium) => {
                lexium.catch_up(now);
                lexium.heard(last, is_write);
            }
            Body::Foreign(_) => {}
        }
        if let Some((reply, effect)) = self.execute(now, &adu.pdu) {
            let line = written(&adu.pdu).is_some_and(|number| LINE_PARAMS.contains(&number));
            let line = line && !matches!(reply, Reply::Exception { .. });
            if let Some(effect) = self.answers_anew(now, line, effect) {
                self.prepare(last, self.framing().unwrap_or(framing), &reply, effect);
            }
        }
    }

    /// Takes a telegram of a VABus master whose last bit was on the wire `now`.
    fn take_telegram(&mut self, now: Tick, telegram: &[u8]) {
        let Body::Active(active) = &mut self.body else { return };
        let request = vabus::Request::decode(telegram);
        let is_select = matches!(request, Ok(vabus::Request::Select { .. }));
        let Some(own) = vabus::Address::drive(self.address) else { return };
        let answer = match request {
            Ok(request) if request.address() == own => {
                active.catch_up(now);
                active.heard(now);
                self.telegrams += 1;
                self.writes += u64::from(is_select);
                self.vabus.answer(active, now, &request)
            }
            Ok(request) if request.address().is_broadcast() => {
                self.writes += u64::from(is_select);
                let effect = self.vabus.obey(active, now, &request);
                return self.follow_up(now, effect);
            }
            Err(vabus::TelegramError::Check { .. }) => self.vabus.garbled(active, own, telegram),
            _ => None,
        };
        if let Some((reply, effect)) = answer {
            let line = matches!(&reply, vabus::Reply::Ack { .. }) && vabus_line(telegram);
            let Some(effect) = self.answers_anew(now, line, effect) else { return };
            let reply = match (reply, vabus::Address::drive(self.address)) {
                (vabus::Reply::Ack { .. }, Some(address)) => vabus::Reply::Ack { address },
                (reply, _) => reply,
            };
            let refused = matches!(reply, vabus::Reply::Nak { .. });
            self.queue(now, Span::ZERO, reply.encode(), effect, refused);
        }
    }

    /// After a write of what the line hangs on, where its reply goes out with the new setting, or is lost: takes the
    /// setting now. `None` if there is no reply.
    fn answers_anew(&mut self, now: Tick, line: bool, effect: Effect) -> Option<Effect> {
        if line && self.readings.has(Reading::LineReplyLost) {
            self.follow_up(now, effect);
            return None;
        }
        // A reset with the new setting answers nobody: the drive is off the bus.
        if line && self.readings.has(Reading::LineReplyNew) && effect == Effect::None {
            self.adopt();
        }
        Some(effect)
    }

    /// How its telegrams are framed, if it speaks Modbus.
    fn framing(&self) -> Option<Framing> {
        match self.spoken {
            Spoken::Modbus(framing) => Some(framing),
            Spoken::Vabus | Spoken::PBus => None,
        }
    }

    /// Executes a request; `None` if it is not answered.
    fn execute(&mut self, now: Tick, pdu: &[u8]) -> Option<(Reply, Effect)> {
        self.telegrams += 1;
        self.writes += u64::from(Request::decode(pdu).is_ok_and(|request| request.is_write()));
        match &mut self.body {
            Body::Active(active) => Some(answer(active, &mut self.counters, now, pdu)),
            Body::Lexium(lexium) => Some((lexium.answer(&mut self.counters, now, pdu)?, Effect::None)),
            Body::Foreign(foreign) => Some((foreign.answer(pdu), Effect::None)),
        }
    }

    fn prepare(&mut self, last: Tick, framing: Framing, reply: &Reply, effect: Effect) {
        let rest = if framing == Framing::Rtu { self.line.t35() } else { Span::ZERO };
        let pdu = if matches!(self.body, Body::Lexium(_)) { lexium::encode(reply) } else { reply.encode() };
        let frame = framing.encode(self.address, &pdu);
        self.queue(last, rest, frame, effect, matches!(reply, Reply::Exception { .. }));
    }

    /// Puts a reply into the queue: not before 10 ms or what the bench file says, and never before the silence `rest`
    /// (CM-485 manual 6.8, 6.7.1.3).
    fn queue(&mut self, last: Tick, rest: Span, frame: Vec<u8>, effect: Effect, exception: bool) {
        if self.pending.len() >= QUEUE {
            return;
        }
        let jitter = Span::from_micros(self.dice.below(self.jitter.as_micros().saturating_add(1)));
        let mut start = last + self.delay + jitter;
        let before = self.pending.back().map(|reply| reply.start + self.line.chars(reply.frame.len() as u64));
        if let Some(free) = before.or(self.sending.map(|(until, _)| until)) {
            start = start.max(free + TURNAROUND.longer(rest));
        }
        self.pending.push_back(Pending { start: start.max(last + rest), frame, effect, exception });
    }

    /// When something will happen if nobody speaks.
    pub(in crate::simulator) fn next_event(&self) -> Option<Tick> {
        let sending = self.sending.map(|(until, _)| until);
        let pending = self.pending.front().filter(|_| self.sending.is_none()).map(|reply| reply.start);
        let body = match &self.body {
            Body::Active(active) => active.next(),
            Body::Lexium(lexium) => lexium.next(),
            Body::Foreign(_) => None,
        };
        [self.next_scene(), sending, pending, self.away, self.rtu.ends(), body, self.vabus.next()]
            .into_iter()
            .flatten()
            .min()
    }

    /// Lets everything happen that is due by `now`; returns a reply that starts now, and has to be called again then.
    pub(in crate::simulator) fn run(&mut self, now: Tick) -> Option<Outgoing> {
        self.play(now);
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
        match &mut self.body {
            Body::Active(active) => active.catch_up(now),
            Body::Lexium(lexium) => lexium.catch_up(now),
            Body::Foreign(_) => {}
        }
        self.vabus.catch_up(now);
        self.play(now);
        if self.sending.is_some() {
            return None;
        }
        self.pending.front().filter(|reply| reply.start <= now)?;
        let reply = self.pending.pop_front()?;
        self.sending = Some((now + self.line.chars(reply.frame.len() as u64), reply.effect));
        self.answered += 1;
        self.exceptions += u64::from(reply.exception);
        Some(Outgoing { station: self.address, spoken: self.spoken, line: self.line, frame: reply.frame })
    }
}

/// Protocol, both addresses, reset: what a reply can be lost by (CM-485 manual 5.2.1, 6; facts A1).
const LINE_PARAMS: [u16; 4] = [395, 1376, 394, 34];

/// The parameter that a Modbus telegram of the ACTIVE family writes.
fn written(pdu: &[u8]) -> Option<u16> {
    match Request::decode(pdu) {
        Ok(Request::WriteRegister { address, .. } | Request::WriteLong { address, .. }) => {
            Some(ParamAddress::from_word(address).number())
        }
        _ => None,
    }
}

/// Whether a VABus telegram writes what its reply can be lost by.
fn vabus_line(telegram: &[u8]) -> bool {
    vabus::Request::decode(telegram).is_ok_and(|request| LINE_PARAMS.contains(&request.header().number.get()))
}
