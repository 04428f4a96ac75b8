//! Conversations without I/O: what to send, how the reply ends, when to give up, how to retry.
//!
//! A conversation is fed bytes and times and says what to do next ([`Step`]); `drive::pump` carries it out on a link.
//! [`Master`] asks one station, [`Survey`] looks for all of them; [`dialect`] is what the protocols differ in. [`dp`] is the
//! master of a PROFIBUS line, [`can`] the way through an adapter to a CAN bus. This room
//! knows no drive and reads no clock.

mod alike;
pub mod can;
mod cut;
mod debt;
pub mod dialect;
pub mod dp;
mod ear;
mod echo;
mod foreign;
mod heard;
mod job;
mod ledger;
mod limits;
pub mod master;
pub mod survey;
pub mod talk;
mod twins;

pub use cut::Cutter;
pub use dialect::{Question, Said};
pub use limits::{INSIST, Limits};
pub use master::Master;
pub use survey::{News, Survey};
pub use talk::{Talk, Talker};

use crate::tick::{Span, Tick};

/// What a conversation wants next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step<T> {
    /// Put these bytes on the line, then ask again.
    Send(Vec<u8>),
    /// Wait for bytes until this moment, feed them if any came, then ask again.
    Wait(Tick),
    /// The conversation is over.
    Done(T),
}

/// Something that is said over a line, step by step.
pub trait Conversation {
    /// How it ends.
    type End;

    /// What to do now. Call again after every step.
    fn step(&mut self, now: Tick) -> Step<Self::End>;

    /// Takes bytes that came in at `at`.
    fn feed(&mut self, at: Tick, bytes: &[u8]);
}

/// A telegram, or a piece of one, as it went over the line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// When it was sent, or when its last byte came.
    pub at: Tick,
    /// What it was.
    pub verdict: Verdict,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// Bytes that are kept of what is no telegram yet: more than any telegram has (Modbus ASCII: 513, MODBUS over Serial Line
/// V1.02, 2.5.2.1).
const MOST_BYTES: usize = 1_024;
/// Telegrams that are kept until somebody takes them.
const MOST_RECORDS: usize = 4_096;

/// What a telegram was to the conversation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// We asked.
    Request,
    /// We asked something whose answer cannot be taken for a missing one, to part old replies from new ones.
    Fence,
    /// We ended an exchange, where the protocol wants that.
    Farewell,
    /// The answer to what we asked.
    Reply,
    /// What we sent, as the adapter heard it.
    Echo,
    /// What we sent, as the adapter heard it or as the station answered: nobody knows yet which.
    Copy,
    /// A valid telegram, but not the answer to what we asked: late, doubled, or from somebody else.
    Stray {
        /// The station that it names.
        station: u8,
    },
    /// Bytes that are no valid telegram.
    Garbage,
}

/// Counts of what happened on the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Telegrams sent, repeats included.
    pub sent: u64,
    /// Answers taken.
    pub replies: u64,
    /// From the end of each request until its answer was taken, in all.
    pub waited: Span,
    /// Of the answers, exceptions.
    pub exceptions: u64,
    /// Requests that nobody answered in time.
    pub silences: u64,
    /// Requests answered by garbage only.
    pub garbled: u64,
    /// Valid telegrams that were not the answer.
    pub strays: u64,
    /// Telegrams of ours that came back from the adapter.
    pub echoes: u64,
    /// Repeats.
    pub repeats: u64,
    /// Fences sent.
    pub fences: u64,
}

/// Pauses between a reply and the question that waited for it to go out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pauses {
    /// What must be kept at least.
    pub required: Span,
    /// How many were measured.
    pub count: u64,
    /// The shortest.
    pub shortest: Span,
    /// The longest.
    pub longest: Span,
}

impl Pauses {
    fn note(&mut self, pause: Span) {
        self.shortest = if self.count == 0 { pause } else { self.shortest.min(pause) };
        self.longest = self.longest.max(pause);
        self.count += 1;
    }
}

/// How a question ended well.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The station answered; a refusal is an answer too.
    Reply {
        /// What it said.
        said: Said,
        /// From the end of the request to the last byte of the reply.
        after: Span,
    },
    /// A broadcast was sent; nobody answers.
    Broadcast,
}

/// How a question ended badly.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExchangeError {
    /// No byte came.
    #[error("no reply within {timeout}, asked {asked} times")]
    Silence {
        /// How long each try waited.
        timeout: Span,
        /// How often it was asked.
        asked: u8,
    },
    /// Bytes came, but no valid reply.
    #[error("no valid reply, asked {asked} times; {} bytes of garbage came", .bytes.len())]
    Garbled {
        /// How often it was asked.
        asked: u8,
        /// What came at last.
        bytes: Vec<u8>,
    },
    /// A valid telegram came that is not the answer: from somebody else, or to something else.
    #[error("a telegram of station {station} came that does not answer the question")]
    Stray {
        /// The station that answered.
        station: u8,
    },
    /// The station answered with fewer bytes than an answer has.
    #[error("an answer of {bytes} bytes, asked {asked} times")]
    Short {
        /// How often it was asked.
        asked: u8,
        /// Its bytes.
        bytes: u8,
    },
    /// The station announced over SDO that the value follows in pieces.
    #[error("a value in pieces, asked {asked} times")]
    Pieces {
        /// How often it was asked.
        asked: u8,
    },
    /// A gateway says that the station did not answer it.
    #[error("the gateway got no answer from the station")]
    Unreached,
    /// Somebody speaks all the time.
    #[error("the line is never silent, asked {asked} times")]
    NeverSilent {
        /// How often it was asked; 0 if there was no pause to ask in.
        asked: u8,
    },
    /// Answers came, but each of them may be the answer to something older.
    #[error("no answer that is certainly none to an older question, asked {asked} times")]
    Unproven {
        /// How often it was asked.
        asked: u8,
    },
    /// The time that was left for it is over, and nothing came in it.
    #[error("no answer in the time that was left, asked {asked} times")]
    NoTime {
        /// How often it was asked; 0 if no time was left at all.
        asked: u8,
    },
    /// A station answered one question in two ways, or everything twice so that nothing is sure.
    #[error("station {station} gives two answers to one question")]
    TwoAnswers {
        /// The station.
        station: u8,
    },
    /// A broadcast that asks for a reply.
    #[error("a broadcast can only write")]
    BroadcastRead,
}

impl ExchangeError {
    /// Whether an answer is missing, so that the same asked again may bring one.
    pub fn is_missing(&self) -> bool {
        !matches!(self, ExchangeError::TwoAnswers { .. } | ExchangeError::BroadcastRead)
    }

    /// The same where it had been asked so often before.
    #[must_use]
    pub fn behind(mut self, before: u8) -> Self {
        if let ExchangeError::Silence { asked, .. }
        | ExchangeError::Garbled { asked, .. }
        | ExchangeError::Short { asked, .. }
        | ExchangeError::Pieces { asked }
        | ExchangeError::NeverSilent { asked }
        | ExchangeError::Unproven { asked }
        | ExchangeError::NoTime { asked } = &mut self
        {
            *asked = asked.saturating_add(before);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pauses_are_counted_with_the_shortest_and_the_longest_of_them() {
        let mut pauses = Pauses::default();
        let seen: Vec<_> = [7, 3, 9]
            .map(|ms| {
                pauses.note(Span::from_millis(ms));
                (pauses.count, pauses.shortest.as_millis(), pauses.longest.as_millis())
            })
            .to_vec();
        assert_eq!(seen, [(1, 7, 7), (2, 3, 7), (3, 3, 9)]);
    }
}
