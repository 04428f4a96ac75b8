//! A CAN bus through an adapter that speaks SLCAN: how its channel is opened ([`Opening`]), and what goes through it afterwards
//! ([`Channel`]), or only listened to ([`Ear`]).
//!
//! Nothing is sent on the bus before it was listened to, with the channel opened to listen only: an adapter at another bit rate than
//! the bus would spoil the frames of the others by its error frames. No adapter is trusted to acknowledge anything (docs/can.md: some acknowledge nothing, the answer to a close on a closed channel is BEL and may come late).

mod channel;
mod ear;
mod opening;
mod traffic;
mod words;

pub use channel::Channel;
pub use ear::{Ear, Overheard};
pub use opening::{Opened, Opening, Unopened};
pub use traffic::{Sign, Traffic};

#[cfg(test)]
mod tests;
