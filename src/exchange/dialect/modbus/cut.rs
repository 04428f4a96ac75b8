//! Telegrams of Modbus among bytes that nobody asked for.
//!
//! A listener may miss the silences that part RTU telegrams, because adapters deliver bytes in chunks. So an RTU telegram
//! is taken when it is one of a known function code with a right CRC; what such a cut leaves is settled by a longer silence.

use super::super::Cut;
use super::{has_form_of_question, has_form_of_reply};
use crate::protocol::modbus::pdu::EXCEPTION_BIT;
use crate::protocol::modbus::{Framing, ascii, rtu};

/// Telegrams of RTU among bytes whose silences nobody knows.
#[derive(Debug, Default)]
pub(super) struct Rtu {
    open: Vec<u8>,
    noise: Vec<u8>,
}

impl Cut for Rtu {
    fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        self.open.extend(bytes);
        self.cut(false)
    }

    fn silence(&mut self) -> Vec<Vec<u8>> {
        self.cut(true)
    }
}

impl Rtu {
    /// `is_over`: a silence came, nothing that is open will be completed.
    fn cut(&mut self, is_over: bool) -> Vec<Vec<u8>> {
        let mut pieces = Vec::new();
        while !self.open.is_empty() {
            if let Some(len) = self.telegram(is_over) {
                pieces.extend(some(std::mem::take(&mut self.noise)));
                pieces.push(self.open.drain(..len).collect());
            } else if is_over || self.open.len() >= rtu::MAX_FRAME {
                self.noise.push(self.open.remove(0));
                if self.noise.len() >= rtu::MAX_FRAME {
                    pieces.push(std::mem::take(&mut self.noise));
                }
            } else {
                break;
            }
        }
        if is_over {
            pieces.extend(some(std::mem::take(&mut self.noise)));
        }
        pieces
    }

    /// Length of the telegram that the open bytes begin with. One with an unknown function code is believed only where
    /// a telegram must begin, and when nothing more comes: inside noise some CRC is right by chance.
    fn telegram(&self, is_over: bool) -> Option<usize> {
        let frames = || (rtu::MIN_FRAME..=self.open.len().min(rtu::MAX_FRAME)).filter_map(|len| self.open.get(..len));
        let known = frames().find(|frame| is_known(frame) && rtu::decode(frame).is_ok());
        let any = || frames().find(|frame| is_over && self.noise.is_empty() && rtu::decode(frame).is_ok());
        known.or_else(any).map(<[u8]>::len)
    }
}

/// Telegrams of ASCII: the one that has begun.
#[derive(Debug, Default)]
pub(super) struct Ascii(Vec<u8>);

impl Cut for Ascii {
    fn feed(&mut self, bytes: &[u8]) -> Vec<Vec<u8>> {
        bytes.iter().flat_map(|byte| cut_ascii(&mut self.0, byte & 0x7F)).collect()
    }

    fn silence(&mut self) -> Vec<Vec<u8>> {
        some(std::mem::take(&mut self.0)).into_iter().collect()
    }
}

/// What a character ends: the telegram before a colon that was never finished, and the one that a line feed finishes.
fn cut_ascii(open: &mut Vec<u8>, byte: u8) -> Vec<Vec<u8>> {
    let torn = if byte == ascii::START { some(std::mem::take(open)) } else { None };
    open.push(byte);
    let is_over = byte == b'\n' || open.len() > ascii::MAX_FRAME;
    let whole = is_over.then(|| std::mem::take(open));
    torn.into_iter().chain(whole).collect()
}

fn some(bytes: Vec<u8>) -> Option<Vec<u8>> {
    (!bytes.is_empty()).then_some(bytes)
}

/// Whether this looks like a request or a reply of a function code that we know.
fn is_known(frame: &[u8]) -> bool {
    let is_exception = frame.get(1).is_some_and(|function| function & EXCEPTION_BIT != 0);
    has_form_of_reply(Framing::Rtu, frame) || !is_exception && has_form_of_question(Framing::Rtu, frame)
}
