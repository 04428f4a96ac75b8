//! Stations: where a device stands on the line. Ears for each protocol, one voice, and the script of what happens.
//!
//! A station knows a device only by [`super::device::contract`], and no maker. The ears name no other ear.

mod drive;
mod ignored;
mod modbus;
pub(crate) mod script;
pub(crate) mod setup;
mod vabus;
mod voice;

pub use drive::Drive;
