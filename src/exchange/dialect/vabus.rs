//! VABus in a conversation: a value names its parameter, an ACK and a NAK name nothing, and every exchange is ended on the
//! line. Fences are questions that the drive has answered before.

use super::{Asks, Cut, Found, Question, STRAGGLE, Said, Says, Speech};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::vabus::{Arrival, EOT, Header, Heard, ParamNumber, Receiver, Reply, Request, arrival};
use crate::tick::Span;

/// VABus, which has nothing to remember.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::exchange) struct Vabus;

impl From<Request> for Question {
    fn from(request: Request) -> Self {
        Question::Vabus(request)
    }
}

impl Asks for Request {
    fn telegram(&self, _: u8) -> Vec<u8> {
        self.encode()
    }

    fn is_write(&self) -> bool {
        matches!(self, Request::Select { .. })
    }

    fn is_answered_by(&self, said: &Said) -> bool {
        matches!(said, Said::Vabus(reply) if Request::is_answered_by(self, reply))
    }

    fn function(&self) -> u8 {
        u8::from(Asks::is_write(self))
    }

    /// The error register is cleared by reading.
    fn is_harmless(&self) -> bool {
        matches!(self, Request::Enquiry { header, .. } if header.number != ParamNumber::ERROR_REGISTER)
    }
}

impl Says for Reply {
    fn is_refusal(&self) -> bool {
        matches!(self, Reply::Nak { .. })
    }
}

impl Speech for Vabus {
    fn protocol(&self) -> Protocol {
        Protocol::Vabus
    }

    fn find(&self, came: &[u8], _: u8, question: &Question) -> Option<Found> {
        let Question::Vabus(request) = question else { return None };
        let mut start = 0;
        loop {
            match arrival(request, came.get(start..)?) {
                Arrival::Pending => return None,
                Arrival::Reply { reply, noise, len } => {
                    return Some(Found { start: start + noise, end: start + len, said: Said::Vabus(reply) });
                }
                Arrival::Stray { len, .. } | Arrival::Spoilt { len, .. } => start += len,
            }
        }
    }

    fn sender(&self, bytes: &[u8]) -> Option<(u8, Option<Said>)> {
        match Reply::decode(bytes) {
            Ok(reply) => Some((reply.address().id(), Some(Said::Vabus(reply)))),
            Err(_) => Request::decode(bytes).ok().map(|request| (request.address().id(), None)),
        }
    }

    fn question(&self, bytes: &[u8]) -> Option<(u8, Question)> {
        Request::decode(bytes).ok().map(|asked| (asked.address().id(), asked.into()))
    }

    fn cutter(&self, line: LineSetting) -> (Box<dyn Cut>, Span) {
        (Box::new(Receiver::default()), STRAGGLE.longer(line.t35()))
    }

    fn names_its_question(&self) -> bool {
        true
    }

    /// 1 ms (sources A2).
    fn least_turnaround(&self, _: LineSetting) -> Span {
        Span::from_millis(1)
    }

    fn shortest_reply(&self) -> usize {
        2
    }

    fn farewell(&self) -> &'static [u8] {
        &[EOT]
    }

    /// A value names its parameter; an ACK names nothing.
    fn answers_alike(&self, missing: &Question, question: &Question) -> bool {
        use Request::{Enquiry, Select};
        let (Question::Vabus(missing), Question::Vabus(question)) = (missing, question) else { return true };
        match (missing, question) {
            (Enquiry { header: missing, .. }, Enquiry { header: question, .. }) => {
                let replied = Header { set: missing.set.as_replied(), ..*missing };
                missing.answers(*question) || replied.answers(*question)
            }
            (Select { .. }, Select { .. }) => true,
            _ => false,
        }
    }
}

impl Cut for Receiver {
    fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        Receiver::feed(self, bytes).into_iter().map(bytes_of).collect()
    }

    fn silence(&mut self) -> Vec<Vec<u8>> {
        Receiver::silence(self).into_iter().map(bytes_of).collect()
    }
}

fn bytes_of(heard: Heard) -> Vec<u8> {
    match heard {
        Heard::Telegram(_, bytes) | Heard::Noise(bytes, _) => bytes,
    }
}
