//! A Lexium LXM05 of Schneider Electric, asked over Modbus RTU (LXM05 manual V1.04, chapters 4 to 6).
//!
//! From the ground up: `axis` (the shaft), `params`, `memory` (of faults), `machine` (state machine), `motion` (modes of
//! operation), `servo` (all of them in their time), `modbus` (function codes), `drive` (all of it behind the contract).

mod axis;
mod drive;
mod machine;
mod memory;
mod modbus;
mod motion;
pub(crate) mod params;
pub(crate) mod readings;
mod servo;
pub(crate) mod setup;

pub(crate) use servo::Lexium;
