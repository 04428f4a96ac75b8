//! The program as a process, on ports, terminals and connections of this machine: what only real time shows. A machine
//! may lose any amount of time, so nothing here is measured: a test waits for what has to come, and one runs at a time.
#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]
#![expect(clippy::disallowed_methods, reason = "processes and terminals have a time of their own")]

mod adapters;
mod completing;
mod gathering;
mod keypad;
mod program;
mod reconnect;
mod saving;
mod signals;
