//! Drives that answer: the judge of the tests, the newcomer's first drive, the trainer's bench.
//!
//! A [`Bench`] is a bus with drives on it, in time that somebody else tells ([`Tick`](crate::tick::Tick)). It is written
//! from the manuals and never from our own master: it answers as CM-485 manual chapters 5 to 12 say, and it notes every timing or
//! framing sin of the master as a [`Remark`]. It reads no clock, does no I/O, and never panics on any input.
//!
//! Files in, benches out: [`mod@file`] tells what one may say, reads it, and builds a [`Bench`] of it. On the bench stand stations (`station`:
//! ears and voice, a room for each protocol) with a device behind each (`device`: a folder for each maker behind one
//! trait), on a line that can be disturbed (`line`), in front of the judge (`judge`: the rules of each protocol).
//! A [`Profibus`] line is a room of its own (`dp`), with slaves that must be kept alive, and so is a [`Can`] bus behind its adapter
//! (`can`); whoever carries bytes knows all of them only as [`Served`].

mod bench;
mod can;
mod device;
mod dice;
mod dp;
pub mod file;
mod judge;
mod line;
mod served;
mod station;
#[cfg(test)]
mod tests;
mod totals;

pub use bench::Bench;
#[cfg(target_os = "linux")]
pub(crate) use can::adapter::{Adapter, Out as AdapterOut, Quirks as AdapterQuirks};
pub use can::bus::Can;
pub use device::contract::Servo;
pub use dp::bench::Profibus;
pub use judge::{Gaps, Remark, Sin};
pub use line::disturb::Parting;
pub use served::Served;
pub use station::Drive;
pub use totals::{Ignored, Totals};
