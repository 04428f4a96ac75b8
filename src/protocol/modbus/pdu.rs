//! Protocol data units: function code and data, requests and replies, for master and slave.
//!
//! Codes 3, 6 and 8 follow MODBUS Application Protocol V1.1b3 (6.3, 6.6, 6.8) as narrowed by the CM-485 manual 6.4;
//! codes 100 and 101 are the maker's own (CM-485 manual 6.4.3, 6.4.4). Codes 16, 23 and 43/14 follow V1.1b3 (6.12, 6.17,
//! 6.21) and the LXM05 manual 5.2, with its lengths as corrected in sources G4. Any other code travels as raw data.

mod address;
mod codes;
mod end;
mod exception;
mod fields;
pub mod identification;
mod order;
mod reply;
mod request;
#[cfg(test)]
mod tests;

pub use address::ParamAddress;
pub use codes::*;
pub use end::ReplyEnd;
pub use exception::Exception;
pub use fields::PduError;
pub use identification::Identification;
pub use order::WordOrder;
pub use reply::{Reply, refused_identification};
pub use request::Request;
