//! What the protocols differ in, as a conversation sees it: telegrams, silences, and which replies could be confused.

use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::{COUNTERS, Exception, Reply, Request};
use crate::protocol::modbus::{Adu, Framing, ascii, mbap, rtu};
use crate::protocol::vabus::{self, Arrival};
use crate::tick::Span;

/// Something to ask, in the words of its protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Question {
    /// A Modbus request.
    Modbus(Request),
    /// A VABus telegram.
    Vabus(vabus::Request),
}

/// What a station answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Said {
    /// A Modbus reply; an exception is one too.
    Modbus(Reply),
    /// A VABus reply; a NAK is one too.
    Vabus(vabus::Reply),
}

impl From<Request> for Question {
    fn from(request: Request) -> Self {
        Question::Modbus(request)
    }
}

impl From<vabus::Request> for Question {
    fn from(request: vabus::Request) -> Self {
        Question::Vabus(request)
    }
}

impl Question {
    /// Whether everybody may be asked this: nobody answers, so it must be a write.
    pub fn is_write(&self) -> bool {
        match self {
            Question::Modbus(request) => request.is_write(),
            Question::Vabus(request) => matches!(request, vabus::Request::Select { .. }),
        }
    }

    /// Whether `said` can be the answer.
    pub fn is_answered_by(&self, said: &Said) -> bool {
        match (self, said) {
            (Question::Modbus(request), Said::Modbus(reply)) => request.is_answered_by(reply),
            (Question::Vabus(request), Said::Vabus(reply)) => request.is_answered_by(reply),
            _ => false,
        }
    }

    /// The telegram that puts this question to a station, for showing it.
    pub fn telegram(&self, protocol: Protocol, station: u8) -> Vec<u8> {
        Dialect::new(protocol).encode(station, self)
    }

    /// Whether its own echo would pass for its answer.
    pub(super) fn resembles_its_reply(&self) -> bool {
        match self {
            Question::Modbus(request) => {
                Reply::decode(&request.encode()).is_ok_and(|reply| request.is_answered_by(&reply))
            }
            Question::Vabus(_) => false,
        }
    }

    /// What kind of question it is, as far as that decides how soon it is answered.
    pub(super) fn function(&self) -> u8 {
        match self {
            Question::Modbus(request) => request.function(),
            Question::Vabus(vabus::Request::Enquiry { .. }) => 0,
            Question::Vabus(vabus::Request::Select { .. }) => 1,
        }
    }

    /// Whether asking it once more, for nothing but its answer, changes nothing in the drive; the error register of
    /// VABus is cleared by reading.
    pub(super) fn is_harmless(&self) -> bool {
        match self {
            Question::Modbus(_) => false, // code 8 parts replies there
            Question::Vabus(vabus::Request::Enquiry { header, .. }) => {
                header.number != vabus::ParamNumber::ERROR_REGISTER
            }
            Question::Vabus(vabus::Request::Select { .. }) => false,
        }
    }
}

impl Said {
    /// Whether a gateway says that it got no answer from the station (exceptions 10 and 11; MODBUS Application Protocol
    /// V1.1b3, 7).
    pub fn is_unreached(&self) -> bool {
        let unreached = [Exception::GatewayPath, Exception::GatewayTarget];
        matches!(self, Said::Modbus(Reply::Exception { code, .. }) if unreached.contains(code))
    }

    /// Whether the station said no.
    pub fn is_refusal(&self) -> bool {
        matches!(self, Said::Modbus(Reply::Exception { .. }) | Said::Vabus(vabus::Reply::Nak { .. }))
    }
}

/// A protocol as it is spoken on one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dialect {
    protocol: Protocol,
    /// Number of the last telegram, where telegrams are numbered.
    transaction: u16,
}

/// A reply inside what has come so far.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) said: Said,
}

/// Bytes of one telegram may come in pieces with pauses between them: USB adapters hold them for up to 16 ms.
const STRAGGLE: Span = Span::from_millis(50);

/// Bytes of the longest reply that is looked for among others.
const LONGEST_WITHIN: usize = 40;

/// Counters that have counted the very question that asks for them, so that their reply never looks like its echo:
/// telegrams on the bus, telegrams to this station (CM-485 manual 6.4.5; LXM05 manual, table 5.2, has the first).
const BUSY_COUNTERS: [u16; 2] = [0x0B, 0x0E];

/// Counters that every family has, for stations of which nobody knows more. Sub-functions 14 and 15 are reserved on an
/// LXM05 (its table 5.2): being asked for them would overwrite its last synchronous error.
pub(super) const COMMON_COUNTERS: [u16; 6] = [0x0B, 0x0C, 0x0D, 0x10, 0x11, 0x12];

impl Dialect {
    pub(super) fn new(protocol: Protocol) -> Self {
        Dialect { protocol, transaction: 0 }
    }

    pub(super) fn protocol(self) -> Protocol {
        self.protocol
    }

    /// The telegram that asks; where telegrams are numbered, with the next number.
    pub(super) fn encode(&mut self, station: u8, question: &Question) -> Vec<u8> {
        match (question, self.protocol) {
            (Question::Modbus(request), Protocol::Modbus(Framing::Tcp)) => {
                self.transaction = self.transaction.wrapping_add(1);
                mbap::encode(self.transaction, station, &request.encode())
            }
            (Question::Modbus(request), Protocol::Modbus(framing)) => framing.encode(station, &request.encode()),
            (Question::Modbus(request), Protocol::Vabus) => Framing::Rtu.encode(station, &request.encode()),
            (Question::Vabus(request), _) => request.encode(),
        }
    }

    /// Looks for the complete answer to `question`; bytes of noise before it do not cost it.
    pub(super) fn find(self, came: &[u8], station: u8, question: &Question) -> Option<Found> {
        match question {
            Question::Modbus(request) => self.find_modbus(came, station, request),
            Question::Vabus(request) => find_vabus(came, request),
        }
    }

    fn find_modbus(self, came: &[u8], station: u8, request: &Request) -> Option<Found> {
        (0..came.len()).find_map(|start| {
            let rest = came.get(start..)?;
            let (adu, length) = match self.protocol {
                Protocol::Modbus(Framing::Rtu) => rtu_frame(rest, station, request),
                Protocol::Modbus(Framing::Ascii) => ascii_frame(rest),
                Protocol::Modbus(Framing::Tcp) => self.tcp_frame(rest),
                Protocol::Vabus => None,
            }?;
            let reply = Reply::decode(&adu.pdu).ok()?;
            let fits = adu.station == station && request.is_answered_by(&reply);
            fits.then_some(Found { start, end: start + length, said: Said::Modbus(reply) })
        })
    }

    /// A frame with the number of the last question; others are late.
    fn tcp_frame(self, rest: &[u8]) -> Option<(Adu, usize)> {
        let length = mbap::length(rest)?;
        let (transaction, adu) = mbap::decode(rest.get(..length)?).ok()?;
        (transaction == self.transaction).then_some((adu, length))
    }

    /// Whether telegrams carry numbers, so that no reply is taken for another.
    pub(super) fn is_numbered(self) -> bool {
        self.protocol == Protocol::Modbus(Framing::Tcp)
    }

    /// The least time from the end of a question to the start of its reply: in RTU the silence by which a station knows that
    /// the question is over (MODBUS over Serial Line V1.02, 2.5.1.1), over VABus 1 ms (sources A2).
    pub(super) fn least_turnaround(self, line: LineSetting) -> Span {
        match self.protocol {
            Protocol::Modbus(Framing::Rtu) => line.t35(),
            Protocol::Modbus(Framing::Ascii | Framing::Tcp) => Span::ZERO,
            Protocol::Vabus => Span::from_millis(1),
        }
    }

    /// The station that one whole valid telegram names, and what it says if it is a reply.
    pub(super) fn sender(self, bytes: &[u8]) -> Option<(u8, Option<Said>)> {
        match self.protocol {
            Protocol::Modbus(framing) => {
                let adu = framing.decode(bytes).ok()?;
                Some((adu.station, Reply::decode(&adu.pdu).ok().map(Said::Modbus)))
            }
            Protocol::Vabus => match vabus::Reply::decode(bytes) {
                Ok(reply) => Some((reply.address().id(), Some(Said::Vabus(reply)))),
                Err(_) => vabus::Request::decode(bytes).ok().map(|request| (request.address().id(), None)),
            },
        }
    }

    /// The first whole reply among bytes that are none as a whole: where telegrams met, or came in one piece.
    pub(super) fn reply_within(self, bytes: &[u8]) -> Option<std::ops::Range<usize>> {
        let framing = match self.protocol {
            Protocol::Modbus(framing) => framing,
            Protocol::Vabus => return None,
        };
        let whole = |range: &std::ops::Range<usize>| {
            let piece = bytes.get(range.clone()).unwrap_or_default();
            has_form_of_reply(framing, piece) && framing.decode(piece).is_ok_and(|adu| Reply::decode(&adu.pdu).is_ok())
        };
        let ends = |start: usize| start + self.shortest_reply()..=bytes.len().min(start + LONGEST_WITHIN);
        (0..bytes.len()).find_map(|start| ends(start).map(|end| start..end).find(whole))
    }

    /// Silence that must go before a telegram.
    pub(super) fn silence(self, line: LineSetting) -> Span {
        match self.protocol {
            Protocol::Modbus(Framing::Rtu) => line.t35(),
            Protocol::Modbus(Framing::Ascii | Framing::Tcp) | Protocol::Vabus => Span::ZERO,
        }
    }

    /// How long bytes take on the wire; behind a gateway nobody knows.
    pub(super) fn duration(self, line: LineSetting, bytes: usize) -> Span {
        match self.protocol {
            Protocol::Modbus(Framing::Tcp) => Span::ZERO,
            Protocol::Modbus(_) | Protocol::Vabus => line.chars(bytes as u64),
        }
    }

    /// Pause after a reply; a gateway keeps its own.
    pub(super) fn gap(self, line: LineSetting, pause: Span) -> Span {
        match self.protocol {
            Protocol::Modbus(Framing::Tcp) => Span::ZERO,
            Protocol::Modbus(_) | Protocol::Vabus => pause.longer(self.silence(line)),
        }
    }

    /// Silence after which a telegram that has begun is over.
    pub(super) fn straggle(self, came: &[u8]) -> Span {
        let dawdles = self.protocol == Protocol::Modbus(Framing::Ascii) && !came.ends_with(ascii::END);
        if dawdles { ascii::MAX_PAUSE } else { STRAGGLE }
    }

    /// The longest that any telegram of it may straggle.
    pub(super) fn longest_straggle(self) -> Span {
        self.straggle(&[]).longer(STRAGGLE)
    }

    /// Bytes of the shortest reply; fewer are noise, behind which the reply may still come.
    pub(super) fn shortest_reply(self) -> usize {
        match self.protocol {
            Protocol::Modbus(Framing::Rtu) => 5,
            Protocol::Modbus(Framing::Ascii) => 11,
            Protocol::Modbus(Framing::Tcp) => mbap::OVERHEAD + 2,
            Protocol::Vabus => 2,
        }
    }

    /// What ends an exchange on the line; nothing in Modbus.
    pub(super) fn farewell(self) -> &'static [u8] {
        match self.protocol {
            Protocol::Modbus(_) => &[],
            Protocol::Vabus => &[vabus::EOT],
        }
    }

    /// What came behind the echo of what was sent; before it the echo of the end of the last exchange may stand, which an
    /// adapter brings late.
    pub(super) fn behind_echo<'c>(self, came: &'c [u8], sent: &[u8]) -> &'c [u8] {
        let ended = came.strip_prefix(self.farewell()).filter(|rest| rest.starts_with(sent));
        ended.unwrap_or(came).strip_prefix(sent).unwrap_or(came)
    }

    /// Whether the late answer to `missing`, if it is no refusal, could be taken for the answer to `question`. Many answers
    /// name what they answer.
    pub(super) fn confuses(self, missing: &Question, question: &Question) -> bool {
        if missing == question || self.protocol == Protocol::Modbus(Framing::Tcp) {
            return false;
        }
        match (missing, question) {
            (Question::Modbus(missing), Question::Modbus(question)) => confuses_modbus(missing, question),
            (Question::Vabus(missing), Question::Vabus(question)) => confuses_vabus(missing, question),
            _ => true,
        }
    }

    /// Whether the late refusal of `missing` could be taken for one of `question`: refusals name only the function code in
    /// Modbus, and nothing at all in VABus.
    pub(super) fn refuses_alike(self, missing: &Question, question: &Question) -> bool {
        match (missing, question) {
            _ if missing == question || self.protocol == Protocol::Modbus(Framing::Tcp) => false,
            (Question::Modbus(missing), Question::Modbus(question)) => missing.function() == question.function(),
            _ => true,
        }
    }

    /// A question whose answer can be taken for none of the missing ones. Modbus: a counter, at best one that counts the
    /// question itself. VABus: one of the `known`, harmless ones that the station has answered before.
    pub(super) fn fence<'k>(
        self,
        missing: &[Question],
        question: &Question,
        mut known: impl Iterator<Item = &'k Question>,
        counters: &[u16],
    ) -> Option<Question> {
        let fresh = |fence: &Question| !missing.contains(fence) && fence != question;
        match self.protocol {
            Protocol::Modbus(_) => {
                let subs = BUSY_COUNTERS.into_iter().chain(COUNTERS.rev());
                let had = subs.filter(|sub| counters.contains(sub));
                let mut had = had.map(|sub| Question::Modbus(Request::Diagnostics { sub, data: 0 }));
                // One that was asked in vain parts as well as before, as long as nothing was asked since.
                had.find(fresh).or_else(|| missing.last().filter(|last| is_counter(last) && *last != question).cloned())
            }
            Protocol::Vabus => known.find(|known| fresh(known)).cloned(),
        }
    }

    /// Whether the answer to this fence may be its echo: a counter that does not count the question itself.
    pub(super) fn may_stand_still(self, fence: &Question) -> bool {
        matches!(fence, Question::Modbus(Request::Diagnostics { sub, .. }) if !BUSY_COUNTERS.contains(sub))
    }

    /// Whether this answer to a fence proves that nothing older can come. Its echo does not, where the line
    /// may echo (a counter that stands at 0 answers in the same bytes), and a refusal only if none of the missing replies
    /// could be one.
    pub(super) fn settles(self, fence: &Question, said: &Said, missing: &[Question], may_echo: bool) -> bool {
        let may_be_old = said.is_refusal() && missing.iter().any(|missing| self.refuses_alike(missing, fence));
        let is_echo = match (fence, said) {
            (Question::Modbus(fence), Said::Modbus(reply)) => {
                matches!(fence, Request::Diagnostics { .. }) && fence.encode() == reply.encode()
            }
            _ => false,
        };
        !(may_be_old || is_echo && may_echo)
    }
}

/// Whether it looks like a reply that we know, before its check value is computed.
fn has_form_of_reply(framing: Framing, bytes: &[u8]) -> bool {
    match framing {
        Framing::Rtu => {
            let pdu = bytes.get(1..bytes.len().saturating_sub(2)).unwrap_or_default();
            Reply::decode(pdu).is_ok_and(|reply| !matches!(reply, Reply::Other { .. }))
        }
        Framing::Ascii => bytes.first() == Some(&ascii::START) && bytes.ends_with(ascii::END),
        Framing::Tcp => false,
    }
}

fn is_counter(question: &Question) -> bool {
    matches!(question, Question::Modbus(Request::Diagnostics { .. }))
}

fn confuses_modbus(missing: &Request, question: &Request) -> bool {
    use Request::{ExchangeRegisters, ReadRegisters, WriteLong, WriteRegister, WriteRegisters};
    match (missing, question) {
        (ReadRegisters { count: a, .. }, ReadRegisters { count: b, .. })
        | (ExchangeRegisters { count: a, .. }, ExchangeRegisters { count: b, .. }) => a == b,
        (Request::Diagnostics { sub: a, .. }, Request::Diagnostics { sub: b, .. }) => a == b,
        // These are echoed, so only the same question has the same answer.
        (WriteRegister { .. }, WriteRegister { .. }) | (WriteLong { .. }, WriteLong { .. }) => false,
        (WriteRegisters { start: a, values: x }, WriteRegisters { start: b, values: y }) => {
            (a, x.len()) == (b, y.len())
        }
        _ => missing.function() == question.function(),
    }
}

/// A value names its parameter; an ACK names nothing.
fn confuses_vabus(missing: &vabus::Request, question: &vabus::Request) -> bool {
    use vabus::Request::{Enquiry, Select};
    match (missing, question) {
        (Enquiry { header: missing, .. }, Enquiry { header: question, .. }) => {
            let replied = vabus::Header { set: missing.set.as_replied(), ..*missing };
            missing.answers(*question) || replied.answers(*question)
        }
        (Select { .. }, Select { .. }) => true,
        _ => false,
    }
}

fn find_vabus(came: &[u8], request: &vabus::Request) -> Option<Found> {
    let mut start = 0;
    loop {
        match vabus::arrival(request, came.get(start..)?) {
            Arrival::Pending => return None,
            Arrival::Reply { reply, noise, len } => {
                return Some(Found { start: start + noise, end: start + len, said: Said::Vabus(reply) });
            }
            Arrival::Stray { len, .. } | Arrival::Spoilt { len, .. } => start += len,
        }
    }
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

#[cfg(test)]
mod tests;
