//! Adapters that hear themselves: what we sent comes back in front of the reply.
//!
//! Some replies are identical to their questions (writes, code 8), so on such a line the echo of a question to a drive
//! that is off would pass for its reply. Whether the line echoes is learnt from questions whose echo cannot be a reply.

/// Whether the line gives back what we send.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Echo {
    /// Nothing was asked yet that tells.
    #[default]
    Unknown,
    /// A reply came without an echo before it.
    Absent,
    /// An echo came.
    Present,
}

impl Echo {
    /// What a reply that came behind `before` tells; behind noise an echo may have been spoilt, so that tells nothing.
    pub(super) fn learn(&mut self, sent: &[u8], before: &[u8]) {
        match before {
            [] => *self = Echo::Absent,
            before if before.ends_with(sent) => *self = Echo::Present,
            _ => {}
        }
    }
}
