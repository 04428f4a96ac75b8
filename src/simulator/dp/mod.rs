//! A PROFIBUS line with Hitachi inverters behind SJ2-PB modules, and its judge: written from the manual (10-01-26), strict, and
//! never to please our master.
//!
//! On the line (`bench`) stand slaves of DP-V0 (`slave`, with an `ear` for the bytes) that drive a module (`module`): the Basic
//! block, or the words of ProfiDrive mode (`words`) with a PKW channel (`channel`, `params`). Behind it is an inverter with a
//! motor. What the manual leaves open can be answered either way (`readings`). Modules of single parameters (3.1) and acyclic
//! services (4.2) are not there.

pub(crate) mod bench;
mod channel;
mod ear;
pub(crate) mod inverter;
mod judge;
mod module;
mod motor;
mod params;
pub(crate) mod readings;
mod slave;
#[cfg(test)]
mod tests;
mod words;
