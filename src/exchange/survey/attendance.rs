//! What a survey has seen of one station.

use crate::exchange::Said;
use crate::tick::Tick;

/// What a station did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Attendance {
    /// How often it was asked.
    pub asked: u32,
    /// What it replied; more replies than questions are not the work of one station.
    pub replies: Vec<Said>,
    /// How often garbage came that nobody else can have sent.
    pub garbled: u32,
    /// End of the last question to it.
    pub(super) end: Tick,
    /// It sent something valid.
    pub(super) heard: bool,
}

impl Attendance {
    /// Replies that are more than there were questions.
    pub fn surplus(&self) -> usize {
        self.replies.len().saturating_sub(self.asked as usize)
    }

    /// Whether a reply may still come.
    pub fn owes(&self) -> bool {
        self.replies.len() < self.asked as usize
    }

    /// Whether the replies are not all the same.
    pub fn differ(&self) -> bool {
        self.replies.iter().any(|reply| Some(reply) != self.replies.first())
    }
}
