//! Conversations without I/O: what to send, how the reply ends, when to give up, how to retry.
//!
//! A conversation is fed bytes and times and says what to do next ([`Step`]); `drive::pump` carries it out on a link.
//! This room knows no drive and reads no clock.

pub mod modbus;

use crate::tick::Tick;

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

/// What a telegram was to the conversation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// We asked.
    Request,
    /// We asked something whose answer cannot be taken for a missing one, to part old replies from new ones.
    Fence,
    /// The answer to what we asked.
    Reply,
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
    /// Of these, exceptions.
    pub exceptions: u64,
    /// Requests that nobody answered in time.
    pub silences: u64,
    /// Requests answered by garbage only.
    pub garbled: u64,
    /// Valid telegrams that were not the answer.
    pub strays: u64,
    /// Repeats.
    pub repeats: u64,
    /// Fences sent.
    pub fences: u64,
}
