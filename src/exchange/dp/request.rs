//! One request over the PKW channel of a slave that exchanges data (SJ2-PB manual 4.1.1).
//!
//! The old answer may still stand for a cycle or longer, so no request is acknowledged before the channel is seen empty: AK 0 out,
//! AK 0 in, then the request, then the first answer that names it.

use crate::protocol::dp::pkw::{Answer, Pkw, Task};
use crate::tick::{Span, Tick};

/// How long the channel may take for each half: an SJ2-PB asks its inverter meanwhile (how long is in no source).
const PATIENCE: Span = Span::from_secs(3);
/// Requests (manual 4.1.1): a value, that of an element, a new word, a new word of an element.
const READ: u8 = 1;
const WRITE: u8 = 2;
const READ_ELEMENT: u8 = 6;
const WRITE_ELEMENT: u8 = 7;

/// What came of a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Told {
    /// The value.
    Value(u32),
    /// No; the number stands in one half of this or the other.
    Refused(u32),
    /// No right to do it from here.
    NoRight,
    /// No answer.
    Silence,
}

/// A parameter, or an element of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Its number.
    pub pnu: u16,
    /// The element of an array, from 1.
    pub element: Option<u8>,
}

impl Place {
    /// Where a parameter stands.
    pub fn of(id: u32, element: Option<u8>) -> Self {
        Place { pnu: u16::try_from(id).unwrap_or(u16::MAX), element }
    }
}

/// A request on its way.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    asked: Pkw,
    is_clear: bool,
    since: Tick,
}

impl Request {
    /// Reads a value.
    pub fn read(place: Place, now: Tick) -> Self {
        Request::of(place, [READ, READ_ELEMENT], 0, now)
    }

    /// Writes a value of at most 16 bits; no longer one can be written (5.5).
    pub fn write(place: Place, word: u16, now: Tick) -> Self {
        Request::of(place, [WRITE, WRITE_ELEMENT], word.into(), now)
    }

    fn of(place: Place, [plain, of_array]: [u8; 2], pwe: u32, now: Tick) -> Self {
        let Place { pnu, element } = place;
        // The element stands in the high byte (4.1.2.5).
        let (ak, ind) = element.map_or((plain, 0), |element| (of_array, u16::from(element) << 8));
        Request { asked: Pkw { ak, pnu, ind, pwe, ..Pkw::default() }, is_clear: false, since: now }
    }

    /// The block that asks it.
    pub fn asked(&self) -> Pkw {
        self.asked
    }

    /// Whether it changes something, so that it is not to be said twice.
    pub fn writes(&self) -> bool {
        Task::of(self.asked.ak).writes()
    }

    /// What stands in the outputs.
    pub fn outputs(&self) -> Pkw {
        if self.is_clear { self.asked } else { Pkw::default() }
    }

    /// Takes what stands in the inputs; the end, if it is one.
    pub fn inputs(&mut self, now: Tick, said: Pkw) -> Option<Told> {
        if !self.is_clear && said.ak == 0 {
            (self.is_clear, self.since) = (true, now);
            return None;
        }
        // Whether a refusal names the element, no source tells.
        let is_named = self.is_clear && said.pnu == self.asked.pnu;
        let is_meant = match Task::of(self.asked.ak).has_element() {
            true => Answer::of(said.ak).has_element() && said.sub_index() == self.asked.sub_index(),
            false => true,
        };
        let told = match Answer::of(said.ak) {
            Answer::Word | Answer::Double | Answer::ElementWord | Answer::ElementDouble => {
                is_meant.then_some(Told::Value(said.pwe))
            }
            Answer::Refused => Some(Told::Refused(said.pwe)),
            Answer::NoRight => Some(Told::NoRight),
            _ => None,
        };
        let late = (now.since(self.since) > PATIENCE).then_some(Told::Silence);
        told.filter(|_| is_named).or(late)
    }
}

#[cfg(test)]
mod tests;
