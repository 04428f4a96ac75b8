//! What stands behind a station: one folder (or file) per maker, each behind [`contract::Device`].
//!
//! A maker's folder names no other maker's, and no station: how telegrams come and go on the line is not its business.
//! Makers share what is no maker's: the contract, the commands and states of CiA 402, a shaft with its motor, diagnostic
//! counters, and the form in which open questions are read.

pub(crate) mod active;
mod cia402;
pub(crate) mod contract;
pub(crate) mod counters;
pub(crate) mod foreign;
pub(crate) mod lexium;
mod motor;
pub(crate) mod readings;
pub(crate) mod shaft;
