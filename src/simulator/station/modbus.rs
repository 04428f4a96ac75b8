//! The ear for Modbus, both framings. A strict station is deaf to an RTU telegram that begins too early behind its own.

use crate::protocol::line::LineSetting;
use crate::protocol::modbus::{Framing, ascii, rtu};
use crate::simulator::line::wire::Slot;
use crate::tick::Tick;

/// Makes frames of what comes in.
#[derive(Clone, Debug)]
pub(crate) struct Ear {
    rtu: rtu::Receiver,
    ascii: ascii::Receiver,
    is_strict: bool,
    last_byte: Tick,
    /// The telegram that comes in now began too early for a strict station.
    deaf: bool,
}

/// What the ear made of the bytes.
#[derive(Clone, Debug)]
pub(crate) enum Heard {
    /// A frame whose last bit was on the wire at `last`, and which is known to be over at `over`.
    Frame { last: Tick, over: Tick, framing: Framing, bytes: Vec<u8> },
    /// A torn one, which is discarded (CM-485 manual 6.7.1.3).
    Torn,
}

impl Ear {
    pub(crate) fn new(line: LineSetting, is_strict: bool) -> Self {
        let (rtu, ascii) = (rtu::Receiver::new(line), ascii::Receiver::default());
        Ear { rtu, ascii, is_strict, last_byte: Tick::ZERO, deaf: false }
    }

    /// Forgets what has come in; listens with `line` from now on.
    pub(crate) fn forget(&mut self, line: LineSetting) {
        self.rtu = rtu::Receiver::new(line);
        self.ascii = ascii::Receiver::default();
    }

    /// When an RTU telegram is over that nothing follows.
    pub(crate) fn ends(&self) -> Option<Tick> {
        self.rtu.ends()
    }

    /// Takes a byte of an RTU telegram; `own` is the end of the station's own last reply.
    pub(crate) fn feed_rtu(&mut self, line: LineSetting, own: Option<Tick>, slot: &Slot) -> Option<Heard> {
        let last = self.last_byte;
        let begins = self.rtu.ends().is_none_or(|ends| ends <= slot.start);
        let burst = self.rtu.feed(slot.end, slot.byte);
        let heard = burst.and_then(|burst| self.burst(line, last, burst));
        let early = own.is_some_and(|own| slot.start.since(own) < line.t35());
        if begins && self.is_strict && early {
            self.deaf = true;
        }
        self.last_byte = slot.end;
        heard
    }

    /// Takes a character of an ASCII telegram.
    pub(crate) fn feed_ascii(&mut self, slot: &Slot) -> Option<Heard> {
        self.last_byte = slot.end;
        let bytes = self.ascii.feed(slot.end, slot.byte)?;
        Some(Heard::Frame { last: slot.end, over: slot.end, framing: Framing::Ascii, bytes })
    }

    /// The RTU telegram that is over because nothing came until `now`.
    pub(crate) fn idle(&mut self, line: LineSetting, now: Tick) -> Option<Heard> {
        let burst = self.rtu.idle(now)?;
        self.burst(line, self.last_byte, burst)
    }

    fn burst(&mut self, line: LineSetting, last: Tick, burst: rtu::Burst) -> Option<Heard> {
        if std::mem::take(&mut self.deaf) {
            return None;
        }
        if burst.broken {
            return Some(Heard::Torn);
        }
        Some(Heard::Frame { last, over: last + line.t35(), framing: Framing::Rtu, bytes: burst.bytes })
    }
}
