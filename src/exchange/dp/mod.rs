//! PROFIBUS-DP as the only master of a line: no token is passed, slaves answer whoever asks (IEC 61158-4-3).
//!
//! [`Fdl`] puts one question at a time on the line: T_SYN before it, slot time behind it, the same telegram with the same frame
//! count bit again where no answer came. [`Listening`] hears whether somebody else asks on the line, which must be known before
//! the first byte of ours. [`Station`] leads a slave from Slave_Diag to Data_Exchange and lets it go again, and [`Request`] reads or
//! writes a parameter over PKW.

mod cut;
mod fdl;
mod listen;
mod request;
mod station;

pub(super) use cut::Telegrams;
pub use fdl::{Asked, Fdl, Reply, Timing, Unanswered};
pub use listen::{Heard, Listening};
pub use request::{Place, Request, Told};
pub use station::{Cycle, Setup, Station, Trouble};

/// Our address: that of a configuration tool, which class 1 masters of a controller leave free more often than not.
pub const MASTER: u8 = 0;
