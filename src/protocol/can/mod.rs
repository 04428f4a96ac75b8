//! CAN as the system bus of ACTIVE Cube drives speaks it (EM-RES-03 manual, chapter 5), and CANopen beside it (CiA 301 4.02).
//!
//! * [`Frame`]: what stands on the bus;
//! * [`Service`]: what an identifier means by the predefined connection set;
//! * [`nmt`], [`emergency`], [`sdo`], [`pdo`]: what the data of a service say, to bytes and back;
//! * [`Telegram`]: a frame of SDO as a conversation has it;
//! * [`slcan`], [`candump`]: frames as text, of adapters and of recordings.

pub mod candump;
pub mod emergency;
mod frame;
mod identifier;
pub mod nmt;
pub mod pdo;
pub mod sdo;
pub mod slcan;
mod telegram;

pub use frame::{Body, Frame, FrameError, Identifier, Payload};
pub use identifier::{EMERGENCIES, FOR_PDOS, LAST_DRIVE, LAST_NODE, PdoNumber, SdoChannel, Service};
pub use telegram::{MASTER_STATION, Telegram, duration, station, telegram_frame};

#[cfg(test)]
mod tests;
