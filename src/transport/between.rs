//! What stands between the telegrams of a conversation and the bytes of an adapter that has words of its own.

use std::fmt::Debug;

/// Turns telegrams into what an adapter is told, and what it says into telegrams.
pub trait Between: Debug {
    /// What the adapter is to be told so that a telegram goes out.
    fn put(&mut self, telegram: &[u8]) -> Vec<u8>;

    /// The telegrams that came, whole, one behind the other.
    fn take(&mut self, said: &[u8]) -> Vec<u8>;

    /// What ails the adapter, as it says itself.
    fn ailing(&mut self) -> Option<Ailing>;

    /// What it is told at the end.
    fn farewell(&self) -> &'static [u8];
}

/// What ails an adapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ailing {
    /// It refuses to send.
    Unsent,
    /// Nobody acknowledges what it sends; its status flags.
    Unacknowledged(u8),
}
