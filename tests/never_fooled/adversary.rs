//! An adversary that owns the line: it hears what is asked and puts any bytes on the line at any time.

use super::dice::Dice;
use antrieb::protocol::Protocol;
use antrieb::protocol::line::LineSetting;
use antrieb::protocol::modbus::pdu::identification::Object;
use antrieb::protocol::modbus::pdu::{Exception, Identification, Reply, Request};
use antrieb::protocol::modbus::{Framing, mbap};
use antrieb::protocol::vabus::{self, Data};
use antrieb::tick::{Span, Tick};
use std::collections::VecDeque;

/// What it is at. `Mixed` changes every so often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Manner {
    /// One byte every 20 ms: an adapter with a wrong rate.
    Drip,
    /// Random bytes without an end.
    Flood,
    /// Hexadecimal digits without an end: the inside of a telegram of VABus or ASCII.
    Digits,
    /// Telegrams begun and never ended.
    Beginnings,
    /// Another master, with pauses of 12 and 25 ms.
    Master,
    /// Valid answers of the station that is asked, with random values at random times.
    Answers,
    /// Everything comes back.
    Echo,
    /// Two answers to everything.
    Twins,
    /// Refusals, at random times.
    Refusals,
    /// Nothing.
    Silence,
    Mixed,
}

pub(crate) const MANNERS: [Manner; 11] = [
    Manner::Drip,
    Manner::Flood,
    Manner::Digits,
    Manner::Beginnings,
    Manner::Master,
    Manner::Answers,
    Manner::Echo,
    Manner::Twins,
    Manner::Refusals,
    Manner::Silence,
    Manner::Mixed,
];

/// How often the mixed one changes.
const SPELL: Span = Span::from_millis(300);
/// It thinks up bytes for so long ahead when it hears something.
const AHEAD_MS: u64 = 900;

#[derive(Debug)]
pub(crate) struct Adversary {
    protocol: Protocol,
    line: LineSetting,
    manner: Manner,
    now_at: Manner,
    dice: Dice,
    /// What it puts on the line, in order of time.
    coming: VecDeque<(Tick, Vec<u8>)>,
    heard: Vec<u8>,
    spell: Tick,
    next: Tick,
}

impl Adversary {
    pub(crate) fn new(protocol: Protocol, line: LineSetting, manner: Manner, dice: Dice) -> Self {
        let (spell, next, coming) = (Tick::ZERO, Tick::ZERO, VecDeque::new());
        Adversary { protocol, line, manner, now_at: manner, dice, coming, heard: Vec::new(), spell, next }
    }

    /// It hears this, at `now`.
    pub(crate) fn hears(&mut self, now: Tick, bytes: &[u8]) {
        self.change(now);
        self.heard = bytes.to_vec();
        let end = now + self.line.chars(bytes.len() as u64);
        match self.now_at {
            Manner::Echo => self.put(end, bytes.to_vec()),
            Manner::Twins => {
                for _ in 0..2 {
                    let after = Span::from_micros(5_000 + self.dice.below(60_000));
                    self.answer(end + after);
                }
            }
            Manner::Answers | Manner::Refusals => {
                for _ in 0..self.dice.below(4) {
                    let after = Span::from_micros(self.dice.below(AHEAD_MS * 1_000));
                    self.answer(end + after);
                }
            }
            _ => {}
        }
    }

    /// What comes next until then, if anything does.
    pub(crate) fn speaks(&mut self, now: Tick, until: Tick) -> Option<(Tick, Vec<u8>)> {
        self.change(now);
        let at = self.next.max(now);
        let own = at <= until && self.babbles();
        match self.coming.front() {
            Some((first, _)) if *first <= until && (!own || *first <= at) => {
                self.coming.pop_front().map(|(first, bytes)| (first.max(now), bytes))
            }
            _ if own => {
                let (bytes, pause) = self.babble();
                self.next = at + pause;
                Some((at, bytes))
            }
            _ => None,
        }
    }

    fn change(&mut self, now: Tick) {
        if self.manner == Manner::Mixed && now >= self.spell {
            self.now_at = self.dice.pick(&MANNERS[..10]);
            self.spell = now + SPELL.times(1 + self.dice.below(4));
        }
    }

    fn babbles(&self) -> bool {
        !matches!(self.now_at, Manner::Echo | Manner::Twins | Manner::Silence | Manner::Mixed)
    }

    fn babble(&mut self) -> (Vec<u8>, Span) {
        let millis = Span::from_millis;
        match self.now_at {
            Manner::Drip => (vec![0x55], millis(20)),
            Manner::Digits => {
                let digits = (0..16).map(|_| self.dice.pick(b"0123456789ABCDEF")).collect();
                (digits, self.line.chars(16))
            }
            Manner::Beginnings => {
                let start =
                    self.dice.pick(&[&b":01"[..], b"\x04A0", b"A\x020", &[1, 3, 250], &[0, 1, 0, 0, 255, 255, 1]]);
                (start.to_vec(), Span::from_micros(200 + self.dice.below(30_000)))
            }
            Manner::Master => {
                let (bytes, pause) = (self.strange(), self.dice.pick(&[12, 25]));
                (bytes, millis(pause))
            }
            Manner::Answers | Manner::Refusals => {
                let pause = Span::from_micros(1_000 + self.dice.below(120_000));
                (self.reply().unwrap_or_else(|| vec![0]), pause)
            }
            _ => {
                let count = 1 + self.dice.below(64);
                let pause = self.line.chars(count) + Span::from_micros(self.dice.below(4_000));
                (self.dice.bytes(count), pause)
            }
        }
    }

    fn put(&mut self, at: Tick, bytes: Vec<u8>) {
        let place = self.coming.partition_point(|coming| coming.0 <= at);
        self.coming.insert(place, (at, bytes));
        self.coming.truncate(64);
    }

    fn answer(&mut self, at: Tick) {
        if let Some(bytes) = self.reply() {
            self.put(at, bytes);
        }
    }

    /// A question of somebody else, or an answer to it.
    fn strange(&mut self) -> Vec<u8> {
        let station = self.dice.pick(&[1, 9]);
        match self.protocol {
            Protocol::Vabus => format!("\x04{}0000372\x05", char::from(b'@' + station)).into_bytes(),
            Protocol::Sdo(_) | Protocol::Pkw => Vec::new(),
            Protocol::Modbus(framing) => {
                let read = Request::ReadRegisters { start: 0x2174, count: 1 }.encode();
                let reply = Reply::Registers(vec![self.dice.below(65_536) as u16]).encode();
                let pdu = if self.dice.one_in(2) { read } else { reply };
                match framing {
                    Framing::Tcp => mbap::encode(self.dice.below(9) as u16, station, &pdu),
                    _ => framing.encode(station, &pdu),
                }
            }
        }
    }

    /// A valid answer to what it heard last, with a random value.
    fn reply(&mut self) -> Option<Vec<u8>> {
        let Protocol::Modbus(framing) = self.protocol else { return self.vabus_reply() };
        let (number, adu) = match framing {
            Framing::Tcp => mbap::decode(&self.heard).ok()?,
            _ => (0, framing.decode(&self.heard).ok()?),
        };
        let request = Request::decode(&adu.pdu).ok()?;
        let refused = self.now_at == Manner::Refusals || self.dice.one_in(9);
        let code = self.dice.pick(&[Exception::DeviceFailure, Exception::GatewayTarget]);
        let pdu = match refused {
            true => Reply::Exception { function: request.function(), code }.encode(),
            false => self.modbus_reply(&request)?.encode(),
        };
        Some(match framing {
            Framing::Tcp => mbap::encode(number, adu.station, &pdu),
            _ => framing.encode(adu.station, &pdu),
        })
    }

    fn modbus_reply(&mut self, request: &Request) -> Option<Reply> {
        let any = self.dice.below(65_536) as u16;
        Some(match *request {
            Request::ReadRegisters { count, .. } => Reply::Registers(vec![any; count.into()]),
            Request::ReadLong { .. } => Reply::Long(any.into()),
            Request::WriteRegister { address, value } => Reply::RegisterWritten { address, value },
            Request::WriteLong { address, value } => Reply::LongWritten { address, value },
            Request::WriteRegisters { start, ref values } => {
                Reply::RegistersWritten { start, count: values.len() as u16 }
            }
            Request::Diagnostics { sub, .. } => Reply::Diagnostics { sub, data: self.dice.pick(&[0, any]) },
            // More follows, always.
            Request::ReadIdentification { category, object } => Reply::Identification(Identification {
                category,
                conformity: 1,
                next: Some(object),
                objects: vec![Object { id: object, value: vec![b'x'; 20] }],
            }),
            _ => return None,
        })
    }

    fn vabus_reply(&mut self) -> Option<Vec<u8>> {
        let any = self.dice.below(65_536) as u16;
        let refused = self.now_at == Manner::Refusals || self.dice.one_in(9);
        let reply = match vabus::Request::decode(&self.heard).ok()? {
            request if refused => vabus::Reply::Nak { address: request.address() },
            vabus::Request::Enquiry { address, header } => {
                vabus::Reply::Value { address, header, data: Data::word(any) }
            }
            vabus::Request::Select { address, .. } => vabus::Reply::Ack { address },
        };
        Some(reply.encode())
    }
}
