//! One request over the PKW channel of a slave that exchanges data (SJ2-PB manual 4.1.1).
//!
//! The old answer may still stand for a cycle or longer, so no request is acknowledged before the channel is seen empty: AK 0 out,
//! AK 0 in, then the request, then the first answer that names it.

use crate::protocol::dp::pkw::{Answer, Pkw, Task};
use crate::tick::{Span, Tick};

/// How long the channel may take for each half: an SJ2-PB asks its inverter meanwhile (how long is in no source).
const PATIENCE: Span = Span::from_secs(3);

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

/// A request on its way.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    asked: Pkw,
    is_clear: bool,
    since: Tick,
}

impl Request {
    /// Reads a parameter.
    pub fn read(pnu: u16, now: Tick) -> Self {
        Request { asked: Pkw { ak: 1, pnu, ..Pkw::default() }, is_clear: false, since: now }
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
        let answer = Answer::of(said.ak);
        let is_named = self.is_clear && said.pnu == self.asked.pnu;
        let told = match (Task::of(self.asked.ak), answer) {
            (Task::Read, Answer::Word) => Some(Told::Value(said.pwe)),
            (Task::Read, Answer::Double) => Some(Told::Value(said.pwe)),
            (_, Answer::Refused) => Some(Told::Refused(said.pwe)),
            (_, Answer::NoRight) => Some(Told::NoRight),
            _ => None,
        };
        let late = (now.since(self.since) > PATIENCE).then_some(Told::Silence);
        told.filter(|_| is_named).or(late)
    }
}
