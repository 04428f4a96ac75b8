//! PKW in a conversation with a slave that somebody else keeps going: a block each way, and the answer names the parameter and the element.
//! What a cycle told is matched there ([`crate::exchange::dp::Request`]), so whatever comes is whole and was meant.

use super::sdo::Frames;
use super::{Asks, Cut, Found, Question, STRAGGLE, Said, Says, Speech};
use crate::protocol::Protocol;
use crate::protocol::dp::pkw::{Answer, LENGTH, Pkw, Task};
use crate::protocol::line::LineSetting;
use crate::tick::Span;

/// The block of one slave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::exchange) struct Block;

/// The station, and its block.
const TELEGRAM: usize = LENGTH + 1;

impl From<Pkw> for Question {
    fn from(block: Pkw) -> Self {
        Question::Pkw(block)
    }
}

/// A block of a station.
fn read(bytes: &[u8]) -> Option<(u8, Pkw)> {
    let (station, block) = bytes.split_first()?;
    Some((*station, Pkw::decode(block.try_into().ok()?)))
}

fn of(block: &Pkw) -> (u16, u8) {
    (block.pnu, block.sub_index())
}

impl Asks for Pkw {
    fn telegram(&self, station: u8) -> Vec<u8> {
        [&[station], &self.encode()[..]].concat()
    }

    fn is_write(&self) -> bool {
        Task::of(self.ak).writes()
    }

    fn is_answered_by(&self, said: &Said) -> bool {
        matches!(said, Said::Pkw(block) if of(block) == of(self))
    }

    fn function(&self) -> u8 {
        self.ak
    }

    fn is_harmless(&self) -> bool {
        !Asks::is_write(self)
    }
}

impl Says for Pkw {
    fn is_refusal(&self) -> bool {
        matches!(Answer::of(self.ak), Answer::Refused | Answer::NoRight)
    }
}

impl Speech for Block {
    fn protocol(&self) -> Protocol {
        Protocol::Pkw
    }

    fn find(&self, came: &[u8], asked: u8, question: &Question) -> Option<Found> {
        let Question::Pkw(request) = question else { return None };
        let (telegrams, _) = came.as_chunks::<TELEGRAM>();
        (0..).zip(telegrams).find_map(|(place, telegram)| {
            let (station, block) = read(telegram)?;
            let (said, start) = (Said::Pkw(block), place * TELEGRAM);
            let fits = station == asked && Asks::is_answered_by(request, &said);
            fits.then_some(Found { start, end: start + TELEGRAM, said })
        })
    }

    fn sender(&self, bytes: &[u8]) -> Option<(u8, Option<Said>)> {
        let (station, block) = read(bytes)?;
        Some((station, Some(Said::Pkw(block))))
    }

    fn question(&self, _: &[u8]) -> Option<(u8, Question)> {
        None
    }

    fn cutter(&self, _: LineSetting) -> (Box<dyn Cut>, Span) {
        (Box::new(Frames::<TELEGRAM>::default()), STRAGGLE)
    }

    fn names_its_question(&self) -> bool {
        true
    }

    fn least_turnaround(&self, _: LineSetting) -> Span {
        Span::ZERO
    }

    /// What goes over the line are the cycles of whoever keeps the slave going.
    fn duration(&self, _: LineSetting, _: usize) -> Span {
        Span::ZERO
    }

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
        TELEGRAM
    }

    fn answers_alike(&self, missing: &Question, question: &Question) -> bool {
        let (Question::Pkw(missing), Question::Pkw(question)) = (missing, question) else { return true };
        of(missing) == of(question)
    }

    fn refusals_alike(&self, missing: &Question, question: &Question) -> bool {
        self.answers_alike(missing, question)
    }
}
