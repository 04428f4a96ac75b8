//! Modbus in a conversation: a reply names its station and its function code, in TCP its question as well, and a refusal the
//! function code. Fences are counters (code 8).

mod cut;

use super::{Asks, Cut, Found, Old, Question, STRAGGLE, Said, Says, Speech};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::{COUNTERS, Exception, MOST_READ, Reply, Request};
use crate::protocol::modbus::{Adu, Framing, ascii, mbap, rtu};
use crate::tick::Span;
use std::ops::Range;

/// Modbus in one of its framings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::exchange) struct Modbus {
    framing: Framing,
    /// Number of the last telegram, where telegrams are numbered.
    transaction: u16,
}

/// Bytes of the longest reply that is looked for among others.
const LONGEST_WITHIN: usize = 40;

/// Counters that have counted the very question that asks for them, so that their reply never looks like its echo:
/// telegrams on the bus, telegrams to this station (CM-485 manual 6.4.5; LXM05 manual, table 5.2, has the first).
const BUSY_COUNTERS: [u16; 2] = [0x0B, 0x0E];

/// Counters that every family has, for stations of which nobody knows more. Sub-functions 14 and 15 are reserved on an
/// LXM05 (its table 5.2): being asked for them would overwrite its last synchronous error.
const COMMON_COUNTERS: [u16; 6] = [0x0B, 0x0C, 0x0D, 0x10, 0x11, 0x12];

impl From<Request> for Question {
    fn from(request: Request) -> Self {
        Question::Modbus(request)
    }
}

impl Asks for Request {
    fn telegram(&self, station: u8) -> Vec<u8> {
        Framing::Rtu.encode(station, &self.encode())
    }

    fn is_write(&self) -> bool {
        Request::is_write(self)
    }

    fn is_answered_by(&self, said: &Said) -> bool {
        matches!(said, Said::Modbus(reply) if Request::is_answered_by(self, reply))
    }

    fn resembles_its_reply(&self) -> bool {
        Reply::decode(&self.encode()).is_ok_and(|reply| Request::is_answered_by(self, &reply))
    }

    fn function(&self) -> u8 {
        Request::function(self)
    }

    /// Code 8 parts replies here.
    fn is_harmless(&self) -> bool {
        false
    }
}

impl Says for Reply {
    fn is_refusal(&self) -> bool {
        matches!(self, Reply::Exception { .. })
    }

    /// Exceptions 10 and 11 (MODBUS Application Protocol V1.1b3, 7).
    fn is_unreached(&self) -> bool {
        let unreached = [Exception::GatewayPath, Exception::GatewayTarget];
        matches!(self, Reply::Exception { code, .. } if unreached.contains(code))
    }
}

impl Modbus {
    pub(super) fn new(framing: Framing) -> Self {
        Modbus { framing, transaction: 0 }
    }

    /// A frame with the number of the last question; others are late.
    fn tcp_frame(self, rest: &[u8]) -> Option<(Adu, usize)> {
        let length = mbap::length(rest)?;
        let (transaction, adu) = mbap::decode(rest.get(..length)?).ok()?;
        (transaction == self.transaction).then_some((adu, length))
    }
}

impl Speech for Modbus {
    fn protocol(&self) -> Protocol {
        self.framing.into()
    }

    fn encode(&mut self, station: u8, question: &Question) -> Vec<u8> {
        match (question, self.framing) {
            (Question::Modbus(request), Framing::Tcp) => {
                self.transaction = self.transaction.wrapping_add(1);
                mbap::encode(self.transaction, station, &request.encode())
            }
            (Question::Modbus(request), framing) => framing.encode(station, &request.encode()),
            (other, _) => other.asks().telegram(station),
        }
    }

    fn find(&self, came: &[u8], station: u8, question: &Question) -> Option<Found> {
        let Question::Modbus(request) = question else { return None };
        (0..came.len()).find_map(|start| {
            let rest = came.get(start..)?;
            let (adu, length) = match self.framing {
                Framing::Rtu => rtu_frame(rest, station, request),
                Framing::Ascii => ascii_frame(rest),
                Framing::Tcp => self.tcp_frame(rest),
            }?;
            let reply = Reply::decode(&adu.pdu).ok()?;
            let fits = adu.station == station && request.is_answered_by(&reply);
            fits.then_some(Found { start, end: start + length, said: Said::Modbus(reply) })
        })
    }

    fn sender(&self, bytes: &[u8]) -> Option<(u8, Option<Said>)> {
        let adu = self.framing.decode(bytes).ok()?;
        Some((adu.station, Reply::decode(&adu.pdu).ok().map(Said::Modbus)))
    }

    fn reply_within(&self, bytes: &[u8]) -> Option<Range<usize>> {
        let whole = |range: &Range<usize>| {
            let piece = bytes.get(range.clone()).unwrap_or_default();
            has_form_of_reply(self.framing, piece)
                && self.framing.decode(piece).is_ok_and(|adu| Reply::decode(&adu.pdu).is_ok())
        };
        let ends = |start: usize| start + self.shortest_reply()..=bytes.len().min(start + LONGEST_WITHIN);
        (0..bytes.len()).find_map(|start| ends(start).map(|end| start..end).find(whole))
    }

    fn question(&self, bytes: &[u8]) -> Option<(u8, Question)> {
        let adu = self.framing.decode(bytes).ok()?;
        if may_end_in_noise(self.framing, bytes) {
            return None;
        }
        let request = Request::decode(&adu.pdu).ok()?;
        // Question and reply of these have one form, or nobody knows which.
        let only_asks = !matches!(
            request,
            Request::Other { .. } | Request::Diagnostics { .. } | Request::ReadIdentification { .. }
        );
        only_asks.then(|| (adu.station, request.into()))
    }

    fn has_form_of_question(&self, bytes: &[u8]) -> bool {
        has_form_of_question(self.framing, bytes)
    }

    fn cutter(&self, line: LineSetting) -> (Box<dyn Cut>, Span) {
        match self.framing {
            Framing::Ascii => (Box::new(cut::Ascii::default()), ascii::MAX_PAUSE),
            Framing::Rtu | Framing::Tcp => (Box::new(cut::Rtu::default()), STRAGGLE.longer(line.t35())),
        }
    }

    fn is_numbered(&self) -> bool {
        self.framing == Framing::Tcp
    }

    /// In RTU the silence by which a station knows that the question is over (MODBUS over Serial Line V1.02, 2.5.1.1).
    fn least_turnaround(&self, line: LineSetting) -> Span {
        self.silence(line)
    }

    fn silence(&self, line: LineSetting) -> Span {
        if self.framing == Framing::Rtu { line.t35() } else { Span::ZERO }
    }

    /// Behind a gateway nobody knows.
    fn duration(&self, line: LineSetting, bytes: usize) -> Span {
        if self.is_numbered() { Span::ZERO } else { line.chars(bytes as u64) }
    }

    /// A gateway keeps its own.
    fn gap(&self, line: LineSetting, pause: Span) -> Span {
        if self.is_numbered() { Span::ZERO } else { pause.longer(self.silence(line)) }
    }

    fn straggle(&self, came: &[u8]) -> Span {
        let dawdles = self.framing == Framing::Ascii && !came.ends_with(ascii::END);
        if dawdles { ascii::MAX_PAUSE } else { STRAGGLE }
    }

    fn shortest_reply(&self) -> usize {
        match self.framing {
            Framing::Rtu => 5,
            Framing::Ascii => 11,
            Framing::Tcp => mbap::OVERHEAD + 2,
        }
    }

    fn answers_alike(&self, missing: &Question, question: &Question) -> bool {
        use Request::{
            Diagnostics, ExchangeRegisters, ReadInputs, ReadRegisters, WriteLong, WriteRegister, WriteRegisters,
        };
        let (Question::Modbus(missing), Question::Modbus(question)) = (missing, question) else { return true };
        match (missing, question) {
            (ReadRegisters { count: a, .. }, ReadRegisters { count: b, .. })
            | (ReadInputs { count: a, .. }, ReadInputs { count: b, .. })
            | (ExchangeRegisters { count: a, .. }, ExchangeRegisters { count: b, .. }) => a == b,
            (Diagnostics { sub: a, .. }, Diagnostics { sub: b, .. }) => a == b,
            // These are echoed, so only the same question has the same answer.
            (WriteRegister { .. }, WriteRegister { .. }) | (WriteLong { .. }, WriteLong { .. }) => false,
            (WriteRegisters { start: a, values: x }, WriteRegisters { start: b, values: y }) => {
                (a, x.len()) == (b, y.len())
            }
            _ => missing.function() == question.function(),
        }
    }

    /// A refusal names the function code.
    fn refusals_alike(&self, missing: &Question, question: &Question) -> bool {
        let (Question::Modbus(missing), Question::Modbus(question)) = (missing, question) else { return true };
        missing.function() == question.function()
    }

    /// A counter, at best one that counts the question itself.
    fn fence(&self, old: &Old<'_>) -> Option<Question> {
        let counters = old.counters.unwrap_or(&COMMON_COUNTERS);
        let subs = BUSY_COUNTERS.into_iter().chain(COUNTERS.rev());
        let had = subs.filter(|sub| counters.contains(sub));
        let mut had = had.map(|sub| Question::Modbus(Request::Diagnostics { sub, data: 0 }));
        // One that was asked in vain parts as well as before, as long as nothing was asked since.
        let last = || old.missing.last().filter(|last| is_counter(last) && *last != old.question).cloned();
        had.find(|fence| old.is_fresh(fence)).or_else(last)
    }

    /// A counter that does not count the question itself.
    fn may_stand_still(&self, fence: &Question) -> bool {
        matches!(fence, Question::Modbus(Request::Diagnostics { sub, .. }) if !BUSY_COUNTERS.contains(sub))
    }

    /// A counter that stands at 0 answers in the bytes of its question.
    fn is_echo(&self, fence: &Question, said: &Said) -> bool {
        let (Question::Modbus(fence), Said::Modbus(reply)) = (fence, said) else { return false };
        matches!(fence, Request::Diagnostics { .. }) && fence.encode() == reply.encode()
    }

    /// A counter was lower then.
    fn is_older(&self, said: &Said, first: &Said) -> bool {
        use Reply::Diagnostics;
        match (said, first) {
            (Said::Modbus(Diagnostics { data, .. }), Said::Modbus(Diagnostics { data: first, .. })) => data < first,
            _ => false,
        }
    }
}

/// Whether it looks like a reply that we know, before its check value is computed.
pub(super) fn has_form_of_reply(framing: Framing, bytes: &[u8]) -> bool {
    match framing {
        Framing::Rtu => {
            let pdu = bytes.get(1..bytes.len().saturating_sub(2)).unwrap_or_default();
            Reply::decode(pdu).is_ok_and(|reply| !matches!(reply, Reply::Other { .. }))
        }
        Framing::Ascii => is_line(bytes),
        Framing::Tcp => false,
    }
}

/// Whether it looks like a question that we know, before its check value is computed.
fn has_form_of_question(framing: Framing, bytes: &[u8]) -> bool {
    match framing {
        Framing::Rtu => {
            let pdu = bytes.get(1..bytes.len().saturating_sub(2)).unwrap_or_default();
            // The reply to a read of two registers may begin as a read of many, with a right check value: more than any station takes.
            Request::decode(pdu).is_ok_and(|request| match request {
                Request::Other { .. } => false,
                Request::ReadRegisters { count, .. } => count <= MOST_READ,
                _ => true,
            })
        }
        Framing::Ascii => is_line(bytes),
        Framing::Tcp => true,
    }
}

/// Whether it begins and ends as a telegram in ASCII.
fn is_line(bytes: &[u8]) -> bool {
    bytes.first() == Some(&ascii::START) && bytes.ends_with(ascii::END)
}

/// Whether a whole telegram may be a shorter one and a zero of noise: the remainder of a CRC and itself is 0, so in RTU the check
/// value of one that ends in 0 is right without it as well, and the reply to a read in one byte more has the form of a read.
fn may_end_in_noise(framing: Framing, telegram: &[u8]) -> bool {
    framing == Framing::Rtu && telegram.last() == Some(&0)
}

fn is_counter(question: &Question) -> bool {
    matches!(question, Question::Modbus(Request::Diagnostics { .. }))
}

fn rtu_frame(rest: &[u8], station: u8, request: &Request) -> Option<(Adu, usize)> {
    let (&first, pdu) = rest.split_first()?;
    if first != station {
        return None;
    }
    let length = request.reply_end().length(pdu)? + rtu::OVERHEAD;
    rtu::decode(rest.get(..length)?).ok().map(|adu| (adu, length))
}

fn ascii_frame(rest: &[u8]) -> Option<(Adu, usize)> {
    // Some drivers leave the parity bit of 7-bit characters in place.
    let mask = |byte: &u8| byte & 0x7F;
    if rest.first().map(mask) != Some(ascii::START) {
        return None;
    }
    let masked: Vec<u8> = rest.iter().take(ascii::MAX_FRAME).map(mask).collect();
    let end = masked.windows(2).position(|pair| pair == ascii::END)? + ascii::END.len();
    ascii::decode(masked.get(..end)?).ok().map(|adu| (adu, end))
}
