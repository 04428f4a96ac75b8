//! What the protocols differ in, as a conversation sees it: telegrams, silences, and which replies could be confused.
//!
//! A file for each protocol, which says what it is by `Speech`, and what may be asked and answered by `Asks` and
//! `Says`; the enums here only pick. RTU, ASCII and TCP are framings of `modbus`.

mod modbus;
mod pkw;
mod sdo;
mod vabus;

use crate::protocol::Protocol;
use crate::protocol::can::sdo as objects;
use crate::protocol::dp::pkw::Pkw;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu;
use crate::protocol::vabus as telegrams;
use crate::tick::Span;
use modbus::Modbus;
use pkw::Block;
use sdo::Sdo;
use std::fmt::Debug;
use std::ops::{Deref, DerefMut, Range};
use vabus::Vabus;

/// Something to ask, in the words of its protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Question {
    /// A Modbus request.
    Modbus(pdu::Request),
    /// A VABus telegram.
    Vabus(telegrams::Request),
    /// A frame of SDO.
    Sdo(objects::Request),
    /// A PKW block to a slave.
    Pkw(Pkw),
}

/// What a station answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Said {
    /// A Modbus reply; an exception is one too.
    Modbus(pdu::Reply),
    /// A VABus reply; a NAK is one too.
    Vabus(telegrams::Reply),
    /// A frame of SDO; an abort is one too.
    Sdo(objects::Reply),
    /// A PKW block from a slave; a refusal is one too.
    Pkw(Pkw),
}

/// A protocol as it is spoken on one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dialect {
    Modbus(Modbus),
    Vabus(Vabus),
    Sdo(Sdo),
    Pkw(Block),
}

impl Dialect {
    pub(super) fn new(protocol: Protocol) -> Self {
        match protocol {
            Protocol::Modbus(framing) => Dialect::Modbus(Modbus::new(framing)),
            Protocol::Vabus => Dialect::Vabus(Vabus),
            Protocol::Sdo(channel) => Dialect::Sdo(Sdo(channel)),
            Protocol::Pkw => Dialect::Pkw(Block),
        }
    }
}

impl Deref for Dialect {
    type Target = dyn Speech;

    fn deref(&self) -> &Self::Target {
        match self {
            Dialect::Modbus(modbus) => modbus,
            Dialect::Vabus(vabus) => vabus,
            Dialect::Sdo(sdo) => sdo,
            Dialect::Pkw(block) => block,
        }
    }
}

impl DerefMut for Dialect {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Dialect::Modbus(modbus) => modbus,
            Dialect::Vabus(vabus) => vabus,
            Dialect::Sdo(sdo) => sdo,
            Dialect::Pkw(block) => block,
        }
    }
}

impl Question {
    fn asks(&self) -> &dyn Asks {
        match self {
            Question::Modbus(request) => request,
            Question::Vabus(request) => request,
            Question::Sdo(request) => request,
            Question::Pkw(block) => block,
        }
    }

    /// Whether everybody may be asked this: nobody answers, so it must be a write.
    pub fn is_write(&self) -> bool {
        self.asks().is_write()
    }

    /// Whether it asks for a value: everybody answers that, if only by a refusal.
    pub fn asks_for_a_value(&self) -> bool {
        use pdu::Request::{ReadLong, ReadRegisters};
        matches!(self, Question::Modbus(ReadRegisters { .. } | ReadLong { .. }))
    }

    /// Whether `said` can be the answer.
    pub fn is_answered_by(&self, said: &Said) -> bool {
        self.asks().is_answered_by(said)
    }

    /// The telegram that puts this question to a station, for showing it.
    pub fn telegram(&self, protocol: Protocol, station: u8) -> Vec<u8> {
        Dialect::new(protocol).encode(station, self)
    }

    /// Whether its own echo would pass for its answer.
    pub(super) fn resembles_its_reply(&self) -> bool {
        self.asks().resembles_its_reply()
    }

    /// What kind of question it is, as far as that decides how soon it is answered.
    pub(super) fn function(&self) -> u8 {
        self.asks().function()
    }

    /// Whether asking it once more, for nothing but its answer, changes nothing in the drive.
    pub(super) fn is_harmless(&self) -> bool {
        self.asks().is_harmless()
    }
}

impl Said {
    fn says(&self) -> &dyn Says {
        match self {
            Said::Modbus(reply) => reply,
            Said::Vabus(reply) => reply,
            Said::Sdo(reply) => reply,
            Said::Pkw(block) => block,
        }
    }

    /// Whether a gateway says that it got no answer from the station.
    pub fn is_unreached(&self) -> bool {
        self.says().is_unreached()
    }

    /// Whether the station said no.
    pub fn is_refusal(&self) -> bool {
        self.says().is_refusal()
    }
}

/// A question of one protocol.
trait Asks {
    /// As it goes over a line, where nothing else is to be known of that.
    fn telegram(&self, station: u8) -> Vec<u8>;

    fn is_write(&self) -> bool;

    fn is_answered_by(&self, said: &Said) -> bool;

    fn resembles_its_reply(&self) -> bool {
        false
    }

    fn function(&self) -> u8;

    fn is_harmless(&self) -> bool;
}

/// An answer of one protocol.
trait Says {
    fn is_refusal(&self) -> bool;

    fn is_unreached(&self) -> bool {
        false
    }
}

/// A reply inside what has come so far.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) said: Said,
}

/// Telegrams among bytes that nobody asked for; every byte comes out once, in order.
pub(super) trait Cut: Debug {
    /// The pieces that are certain now that these bytes came.
    fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>>;

    /// The pieces of everything that is open, as a silence came: nothing of it will be completed.
    fn silence(&mut self) -> Vec<Vec<u8>>;
}

/// Bytes of one telegram may come in pieces with pauses between them: USB adapters hold them for up to 16 ms.
pub(super) const STRAGGLE: Span = Span::from_millis(50);

/// What a protocol says of itself. What is answered here holds where it says nothing else; a question or an answer of another
/// protocol is none of its own.
pub(super) trait Speech {
    fn protocol(&self) -> Protocol;

    /// The telegram that asks; where telegrams are numbered, with the next number.
    fn encode(&mut self, station: u8, question: &Question) -> Vec<u8> {
        question.asks().telegram(station)
    }

    /// Looks for the complete answer to `question`; bytes of noise before it do not cost it.
    fn find(&self, came: &[u8], station: u8, question: &Question) -> Option<Found>;

    /// The station that one whole valid telegram names, and what it says if it is a reply.
    fn sender(&self, bytes: &[u8]) -> Option<(u8, Option<Said>)>;

    /// The first whole reply among bytes that are none as a whole: where telegrams met, or came in one piece.
    fn reply_within(&self, _: &[u8]) -> Option<Range<usize>> {
        None
    }

    /// How many bytes an answer has that is too short for one, where what carries telegrams tells that.
    fn shortness(&self, _: &[u8]) -> Option<u8> {
        None
    }

    /// The station that is asked, and what, if this is a telegram that can only come from a master. A reply to an order looks
    /// like the order, and a survey orders nothing.
    fn question(&self, bytes: &[u8]) -> Option<(u8, Question)>;

    /// Whether it looks like a question, before its check value is computed.
    fn has_form_of_question(&self, _: &[u8]) -> bool {
        true
    }

    /// Cuts what is only listened to, with the silence that leaves nothing open.
    fn cutter(&self, line: LineSetting) -> (Box<dyn Cut>, Span);

    /// Whether telegrams carry numbers, so that no reply is taken for another.
    fn is_numbered(&self) -> bool {
        false
    }

    /// Whether a value says what it answers; a refusal does not.
    fn names_its_question(&self) -> bool {
        false
    }

    /// The least time from the end of a question to the start of its reply.
    fn least_turnaround(&self, line: LineSetting) -> Span;

    /// Silence that must go before a telegram.
    fn silence(&self, _: LineSetting) -> Span {
        Span::ZERO
    }

    /// How long bytes take on the wire.
    fn duration(&self, line: LineSetting, bytes: usize) -> Span {
        line.chars(bytes as u64)
    }

    /// Whether what is sent waits behind what was sent before, so that nobody has to wait for the end of that.
    fn queues(&self) -> bool {
        false
    }

    /// Pause after a reply.
    fn gap(&self, line: LineSetting, pause: Span) -> Span {
        pause.longer(self.silence(line))
    }

    /// Silence after which a telegram that has begun is over.
    fn straggle(&self, _: &[u8]) -> Span {
        STRAGGLE
    }

    /// The longest that any telegram of it may straggle.
    fn longest_straggle(&self) -> Span {
        self.straggle(&[]).longer(STRAGGLE)
    }

    /// Bytes of the shortest reply; fewer are noise, behind which the reply may still come.
    fn shortest_reply(&self) -> usize;

    /// What ends an exchange on the line.
    fn farewell(&self) -> &'static [u8] {
        &[]
    }

    /// What came behind the echo of what was sent; before it the echo of the end of the last exchange may stand, which an
    /// adapter brings late.
    fn behind_echo<'c>(&self, came: &'c [u8], sent: &[u8]) -> &'c [u8] {
        let ended = came.strip_prefix(self.farewell()).filter(|rest| rest.starts_with(sent));
        ended.unwrap_or(came).strip_prefix(sent).unwrap_or(came)
    }

    /// Whether the late answer to `missing`, if it is no refusal, could be taken for the answer to `question`. Many answers
    /// name what they answer.
    fn confuses(&self, missing: &Question, question: &Question) -> bool {
        missing != question && !self.is_numbered() && self.answers_alike(missing, question)
    }

    /// The same of two questions that differ.
    fn answers_alike(&self, missing: &Question, question: &Question) -> bool;

    /// Whether the late refusal of `missing` could be taken for one of `question`.
    fn refuses_alike(&self, missing: &Question, question: &Question) -> bool {
        missing != question && !self.is_numbered() && self.refusals_alike(missing, question)
    }

    /// The same of two questions that differ: in most protocols a refusal names nothing.
    fn refusals_alike(&self, _: &Question, _: &Question) -> bool {
        true
    }

    /// A question whose answer can be taken for none that is missing, nor for that to the question itself.
    fn fence(&self, old: &Old<'_>) -> Option<Question> {
        old.known.iter().find(|known| old.is_fresh(known)).cloned()
    }

    /// Whether the answer to this fence may be its echo.
    fn may_stand_still(&self, _: &Question) -> bool {
        false
    }

    /// Whether this answer to a fence proves that nothing older can come. What may be its echo does not, where the line may
    /// echo, and a refusal only if none of the missing replies could be one.
    fn settles(&self, fence: &Question, said: &Said, missing: &[Question], may_echo: bool) -> bool {
        let may_be_old = said.is_refusal() && missing.iter().any(|missing| self.refuses_alike(missing, fence));
        !(may_be_old || may_echo && self.is_echo(fence, said))
    }

    /// Whether the answer to a fence is made of the bytes of its echo.
    fn is_echo(&self, _: &Question, _: &Said) -> bool {
        false
    }

    /// Whether this answer to a fence was given before that one.
    fn is_older(&self, _: &Said, _: &Said) -> bool {
        false
    }
}

/// What a fence must keep away, and what it can be made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Old<'a> {
    /// Questions whose answers are missing.
    pub(super) missing: &'a [Question],
    /// The question that they are to be kept away from.
    pub(super) question: &'a Question,
    /// Harmless ones that the station has answered before.
    pub(super) known: &'a [Question],
    /// Counters that it has (sub-functions of code 8); `None` if nobody knows its family.
    pub(super) counters: Option<&'a [u16]>,
}

impl Old<'_> {
    /// Whether nothing of it is this.
    fn is_fresh(&self, fence: &Question) -> bool {
        !self.missing.contains(fence) && fence != self.question
    }
}

#[cfg(test)]
mod tests;
