//! PROFIBUS-DP: telegrams of the data link layer (IEC 61158 type 3, EN 50170), the services of DP-V0 that a master of class 1 uses,
//! and what a Hitachi SJ2-PB makes of their bytes (manual 10-01-26).
//!
//! A telegram is framed ([`frame`]) and says in its control byte ([`control`]) who speaks. Which service it belongs to stands in
//! its service access points ([`Service`]). What the services carry: [`Diagnosis`], [`Parameters`], the bytes of a configuration
//! ([`mod@cfg`]), and in Data_Exchange what the configuration says: for an SJ2-PB a PKW block ([`pkw`]) and process data, or the
//! words of its Basic block ([`basic`]). Its modules are described by bytes of their own ([`module`]).

pub mod basic;
pub mod cfg;
pub mod control;
pub mod diagnosis;
pub mod frame;
pub mod gsd;
pub mod module;
pub mod pkw;
pub mod prm;
mod service;

pub use control::Control;
pub use diagnosis::Diagnosis;
pub use frame::{Frame, FrameError, Telegram};
pub use prm::Parameters;
pub use service::Service;

/// Everybody at once; nobody answers (IEC 61158-4-3: global address).
pub const EVERYBODY: u8 = 127;
/// Highest address of a station; 126 is that of a slave whose address is still to be set (fieldbus facts).
pub const LAST_STATION: u8 = 126;
/// The word that names the protocol on the command line and in JSON.
pub const NAME: &str = "dp";
