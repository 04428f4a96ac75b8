//! `antrieb`: the commissioning tool for industrial drives on serial lines.
//!
//! A library of pure protocol and drive knowledge, and a thin command-line program on it. The rooms, from the floor up:
//!
//! | room | what it knows |
//! |---|---|
//! | [`tick`], [`failure`], [`files`], [`outcome`], [`gate`] | values that every room may name |
//! | [`protocol`] | bytes to telegrams and back |
//! | [`profile`] | what a drive is: catalogues and pure decoding |
//! | [`exchange`] | conversations without I/O |
//! | [`simulator`] | drives that answer, on a bus that judges timing |
//! | [`transport`] | what carries bytes, and the clock |
//! | [`drive`] | use-cases on connected drives |
//! | [`args`], [`command`], [`render`], [`cli`] | the program: settings, verbs, output, dispatch |
//!
//! Who may name whom is law, and `tests/house` holds it. ARCHITECTURE.md is the floor plan.

pub mod args;
pub mod cli;
pub mod command;
pub mod drive;
pub mod exchange;
pub mod failure;
pub mod files;
pub mod gate;
pub mod outcome;
pub mod profile;
pub mod protocol;
pub mod render;
pub mod simulator;
pub mod tick;
pub mod transport;

pub use cli::run;
