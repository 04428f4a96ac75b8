//! SDO in a conversation: a question is one frame and so is its answer, which names the parameter and the data set, a refusal too. What
//! comes are whole frames of SDO and nothing else: [`crate::exchange::can`] has cut them out of what an adapter says.

use super::{Asks, Cut, Found, Question, STRAGGLE, Said, Says, Speech};
use crate::protocol::Protocol;
use crate::protocol::can::sdo::{Multiplexer, Reply, Request};
use crate::protocol::can::{Identifier, SdoChannel, Service, Telegram, duration, station, telegram_frame};
use crate::protocol::line::LineSetting;
use crate::tick::Span;
use std::ops::Range;

/// SDO over one of the channels, which has nothing to remember.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::exchange) struct Sdo(pub(super) SdoChannel);

/// The error register is cleared by reading (P.11).
const ERROR_REGISTER: u16 = 11;

impl From<Request> for Question {
    fn from(request: Request) -> Self {
        Question::Sdo(request)
    }
}

/// Whose value a question or an answer is about.
fn of_request(request: &Request) -> Option<Multiplexer> {
    match request {
        Request::Upload(of) | Request::Download(of, _) => Some(*of),
        _ => None,
    }
}

impl Asks for Request {
    fn telegram(&self, station: u8) -> Vec<u8> {
        let telegram = Telegram::request(SdoChannel::Two, station, self.encode());
        telegram.map(|telegram| telegram.encode().to_vec()).unwrap_or_default()
    }

    fn is_write(&self) -> bool {
        matches!(self, Request::Download(..))
    }

    fn is_answered_by(&self, said: &Said) -> bool {
        let Said::Sdo(reply) = said else { return false };
        match (self, reply) {
            (Request::Upload(asked), Reply::Upload(of, _)) => asked == of,
            (Request::Download(asked, _), Reply::Downloaded(of)) => asked == of,
            (asked, Reply::Abort(of, _)) => of_request(asked) == Some(*of),
            _ => false,
        }
    }

    fn function(&self) -> u8 {
        u8::from(Asks::is_write(self))
    }

    fn is_harmless(&self) -> bool {
        matches!(self, Request::Upload(of) if of.index != ERROR_REGISTER)
    }
}

impl Says for Reply {
    fn is_refusal(&self) -> bool {
        matches!(self, Reply::Abort(..))
    }
}

/// The node of an answer that has fewer bytes than the eight of every SDO (EM-RES-03 manual 5.10.1), and how many.
fn short(bytes: &[u8]) -> Option<(u8, u8)> {
    let frame = telegram_frame(bytes).filter(|_| bytes.len() == Telegram::LEN && Telegram::decode(bytes).is_none())?;
    let Identifier::Standard(identifier) = frame.identifier else { return None };
    match Service::of(identifier) {
        Service::SdoReply(_, node) => Some((node, u8::try_from(frame.bytes().len()).ok()?)),
        _ => None,
    }
}

impl Sdo {
    /// The station that a frame of this channel comes from, and what it says.
    fn reply(self, bytes: &[u8]) -> Option<(u8, Reply)> {
        let telegram = Telegram::decode(bytes)?;
        match telegram.service() {
            Service::SdoReply(channel, node) if channel == self.0 => {
                Some((station(node), Reply::decode(telegram.data)))
            }
            _ => None,
        }
    }
}

impl Speech for Sdo {
    fn protocol(&self) -> Protocol {
        Protocol::Sdo(self.0)
    }

    fn encode(&mut self, station: u8, question: &Question) -> Vec<u8> {
        let Question::Sdo(request) = question else { return question.asks().telegram(station) };
        let telegram = Telegram::request(self.0, station, request.encode());
        telegram.map(|telegram| telegram.encode().to_vec()).unwrap_or_default()
    }

    fn find(&self, came: &[u8], asked: u8, question: &Question) -> Option<Found> {
        let Question::Sdo(request) = question else { return None };
        let (frames, _) = came.as_chunks::<{ Telegram::LEN }>();
        (0..).zip(frames).find_map(|(place, frame)| {
            let (station, reply) = self.reply(frame)?;
            let said = Said::Sdo(reply);
            let start = place * Telegram::LEN;
            let fits = station == asked && Asks::is_answered_by(request, &said);
            fits.then_some(Found { start, end: start + Telegram::LEN, said })
        })
    }

    fn sender(&self, bytes: &[u8]) -> Option<(u8, Option<Said>)> {
        let Some(telegram) = Telegram::decode(bytes) else {
            return short(bytes).map(|(node, _)| (station(node), None));
        };
        match telegram.service() {
            Service::SdoReply(_, node) => Some((station(node), Some(Said::Sdo(Reply::decode(telegram.data))))),
            Service::SdoRequest(_, node) => Some((station(node), None)),
            _ => None,
        }
    }

    /// What comes at once is frame behind frame.
    fn reply_within(&self, bytes: &[u8]) -> Option<Range<usize>> {
        (bytes.len() > Telegram::LEN).then_some(0..Telegram::LEN)
    }

    fn shortness(&self, bytes: &[u8]) -> Option<u8> {
        short(bytes).map(|(_, len)| len)
    }

    fn question(&self, bytes: &[u8]) -> Option<(u8, Question)> {
        let telegram = Telegram::decode(bytes)?;
        match telegram.service() {
            Service::SdoRequest(channel, node) if channel == self.0 => {
                Some((station(node), Question::Sdo(Request::decode(telegram.data))))
            }
            _ => None,
        }
    }

    fn cutter(&self, _: LineSetting) -> (Box<dyn Cut>, Span) {
        (Box::new(Frames::<{ Telegram::LEN }>::default()), STRAGGLE)
    }

    fn names_its_question(&self) -> bool {
        true
    }

    fn least_turnaround(&self, _: LineSetting) -> Span {
        Span::ZERO
    }

    fn duration(&self, line: LineSetting, bytes: usize) -> Span {
        let frames = bytes.div_ceil(Telegram::LEN) as u64;
        duration(line.baud, 8).times(frames)
    }

    /// An adapter keeps frames until the bus takes them.
    fn queues(&self) -> bool {
        true
    }

    /// The bus itself parts frames.
    fn gap(&self, _: LineSetting, _: Span) -> Span {
        Span::ZERO
    }

    /// What comes is whole.
    fn straggle(&self, _: &[u8]) -> Span {
        Span::ZERO
    }

    fn longest_straggle(&self) -> Span {
        Span::ZERO
    }

    fn shortest_reply(&self) -> usize {
        Telegram::LEN
    }

    /// An acknowledgement tells no value: what was written before under the same name is answered alike.
    fn answers_alike(&self, missing: &Question, question: &Question) -> bool {
        let (Question::Sdo(missing), Question::Sdo(question)) = (missing, question) else { return true };
        Asks::is_write(missing) == Asks::is_write(question) && of_request(missing) == of_request(question)
    }

    /// A refusal names the parameter, but not whether it was read or written.
    fn refusals_alike(&self, missing: &Question, question: &Question) -> bool {
        let (Question::Sdo(missing), Question::Sdo(question)) = (missing, question) else { return true };
        of_request(missing) == of_request(question)
    }
}

/// Whole frames, one behind the other.
#[derive(Debug, Default)]
pub(super) struct Frames<const LEN: usize>(Vec<u8>);

impl<const LEN: usize> Cut for Frames<LEN> {
    fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        self.0.extend(bytes);
        let (frames, rest) = self.0.as_chunks::<LEN>();
        let (frames, rest) = (frames.iter().map(|frame| frame.to_vec()).collect(), rest.to_vec());
        self.0 = rest;
        frames
    }

    fn silence(&mut self) -> Vec<Vec<u8>> {
        Some(std::mem::take(&mut self.0)).into_iter().filter(|rest| !rest.is_empty()).collect()
    }
}
