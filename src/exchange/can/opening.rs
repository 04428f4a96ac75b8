//! Opening the channel of an adapter, behind listening to the bus.

use super::traffic::Traffic;
use super::words::Words;
use crate::exchange::talk::WINDOW;
use crate::exchange::{Conversation, Step};
use crate::protocol::can::slcan::Word;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// How long an adapter gets to acknowledge; a choice, USB adapters take some milliseconds.
const ANSWER: Span = Span::from_millis(300);
/// An adapter is taken to have said everything when it is silent for so long; at the latest behind the longer time.
const QUIET: Span = Span::from_millis(50);
const QUIET_AT_LAST: Span = Span::from_millis(500);

/// What is done next.
#[derive(Clone, Debug)]
enum Stage {
    /// Tell it this, and wait for what it says to that.
    Tell(Word),
    /// Wait until it is silent: what it says late is nobody's answer.
    Quiet,
    /// Listen to the bus.
    Listen,
}

/// A channel that is open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Opened {
    /// What was heard on the bus before anything was sent.
    pub traffic: Traffic,
    /// What the adapter calls its version, if it says so.
    pub version: Option<String>,
    /// It cannot listen only, so it acknowledged frames on the bus while it listened.
    pub acknowledged: bool,
    /// It has not said a word to anything.
    pub is_mute: bool,
}

/// Why a channel was not opened. Nothing was sent on the bus then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unopened {
    /// What is there says something, but no SLCAN: so many bytes of it.
    NoAdapter(u64),
    /// It refuses the bit rate.
    Rate,
    /// It refuses to open.
    Refused,
    /// It hears errors on the bus and no frame: most likely another bit rate. Its status flags.
    Errors(u8),
}

/// Opens the channel of an adapter.
#[derive(Debug)]
pub struct Opening {
    stages: VecDeque<Stage>,
    only_listens: bool,
    /// What is under way: until when, and at the latest.
    until: Option<(Tick, Tick)>,
    /// What was said to what is told now.
    answer: Option<Word>,
    words: Words,
    opened: Opened,
    end: Option<Result<Opened, Unopened>>,
}

impl Opening {
    /// At a bit rate, by its number in SLCAN.
    pub fn new(rate: u8) -> Self {
        use Stage::{Listen, Quiet, Tell};
        let version = Word::Version(String::new());
        let stages = [
            // Behind a word that somebody left unfinished.
            Tell(Word::Done),
            Tell(Word::Close),
            Quiet,
            Tell(version),
            Tell(Word::Rate(rate)),
            Tell(Word::Listen),
            Listen,
            Tell(Word::Status),
            Tell(Word::Close),
            Quiet,
            Tell(Word::Open),
        ];
        let opened = Opened { traffic: Traffic::default(), version: None, acknowledged: false, is_mute: true };
        let (until, answer, words, end) = (None, None, Words::default(), None);
        Opening { stages: stages.into(), only_listens: false, until, answer, words, opened, end }
    }

    /// The same, for who only listens: the channel stays as it is while the bus is listened to.
    pub fn listening(rate: u8) -> Self {
        let mut opening = Opening::new(rate);
        let listens = |stage: &Stage| matches!(stage, Stage::Tell(Word::Listen));
        let behind = opening.stages.iter().position(listens).map_or(0, |place| place + 1);
        opening.stages.truncate(behind);
        opening.only_listens = true;
        opening
    }

    /// What is under way is over.
    fn goes_on(&mut self) {
        self.until = None;
        let answer = self.answer.take();
        let is_refused = answer == Some(Word::Refused);
        match (self.stages.pop_front(), answer) {
            (Some(Stage::Tell(Word::Version(_))), Some(Word::Version(told))) => self.opened.version = Some(told),
            (Some(Stage::Tell(Word::Rate(_))), _) if is_refused => self.fails(Unopened::Rate),
            (Some(Stage::Tell(Word::Open)), _) if is_refused => self.fails(Unopened::Refused),
            // It knows no such thing: open as it is, it stays so.
            (Some(Stage::Tell(Word::Listen)), _) if is_refused => {
                self.opened.acknowledged = true;
                self.stages = [Stage::Tell(Word::Open), Stage::Listen, Stage::Tell(Word::Status)].into();
                self.stages.truncate(if self.only_listens { 1 } else { 3 });
            }
            (Some(Stage::Tell(Word::Status)), Some(Word::Flags(flags)))
                if self.opened.traffic.frames == 0 && flags & Word::ERRORS != 0 =>
            {
                self.fails(Unopened::Errors(flags));
            }
            _ => {}
        }
        if self.stages.is_empty() && self.end.is_none() {
            self.end = Some(match self.words.garbage() {
                0 => Ok(self.opened.clone()),
                _ if !self.opened.is_mute => Ok(self.opened.clone()),
                garbage => Err(Unopened::NoAdapter(garbage)),
            });
        }
    }

    fn fails(&mut self, why: Unopened) {
        self.stages.clear();
        self.end = Some(Err(why));
    }
}

impl Conversation for Opening {
    type End = Result<Opened, Unopened>;

    fn step(&mut self, now: Tick) -> Step<Self::End> {
        if self.until.is_some_and(|(until, _)| now >= until) || self.answer.is_some() {
            self.goes_on();
        }
        if let Some(end) = &self.end {
            return Step::Done(end.clone());
        }
        if let Some((until, _)) = self.until {
            return Step::Wait(until);
        }
        let (span, longest) = match self.stages.front() {
            Some(Stage::Tell(_)) => (ANSWER, ANSWER),
            Some(Stage::Quiet) => (QUIET, QUIET_AT_LAST),
            Some(Stage::Listen) | None => (WINDOW, WINDOW),
        };
        self.until = Some((now + span, now + longest));
        match self.stages.front() {
            Some(Stage::Tell(word)) => Step::Send(format!("{word}\r").into_bytes()),
            _ => Step::Wait(now + span),
        }
    }

    fn feed(&mut self, at: Tick, bytes: &[u8]) {
        for word in self.words.feed(bytes) {
            match (&word, self.stages.front()) {
                (Word::Frame { frame, .. }, _) => self.opened.traffic.hears(frame),
                // A word to the adapter comes back only from what is no adapter.
                (Word::Done | Word::Refused, _) => self.opened.is_mute = false,
                (Word::Version(told) | Word::Serial(told), _) => self.opened.is_mute &= told.is_empty(),
                (Word::Flags(_), _) => self.opened.is_mute = false,
                _ => {}
            }
            if let Some(Stage::Tell(told)) = self.stages.front()
                && self.answer.is_none()
                && answers(told, &word)
            {
                self.answer = Some(word);
            }
        }
        if matches!(self.stages.front(), Some(Stage::Quiet))
            && let Some((until, longest)) = &mut self.until
        {
            *until = (at + QUIET).min(*longest);
        }
    }
}

/// Whether a word can be what an adapter says to another.
fn answers(told: &Word, said: &Word) -> bool {
    match (told, said) {
        (_, Word::Refused) | (Word::Version(_), Word::Version(_)) | (Word::Status, Word::Flags(_)) => true,
        // These are answered by themselves, and by nothing less.
        (Word::Version(_) | Word::Status, _) => false,
        (_, said) => *said == Word::Done,
    }
}
