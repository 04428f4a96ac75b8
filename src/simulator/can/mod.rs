//! A CAN bus with drives on it as the EM-RES-03 manual (chapter 5) has them, behind an adapter that speaks SLCAN.
//!
//! `bus` is the wire: who sends, who wins it, who hears; `confinement` how a controller counts its errors; `node` a drive on it, `server`
//! its parameters as objects, `settings` what these make of its PDOs, `process` those PDOs, `slaves` what a master makes of emergencies;
//! `adapter` what the master is connected to, with what adapters do each in its own way; `readings` what the manual leaves open.

pub(crate) mod adapter;
pub(crate) mod bus;
mod confinement;
pub(crate) mod node;
mod process;
pub(crate) mod readings;
mod server;
mod settings;
mod slaves;
#[cfg(test)]
mod tests;
