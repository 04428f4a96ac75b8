//! Use-cases on connected drives: open a line, identify, read, write, scan, diagnose; watch and sniff; settings as files and
//! transactions, over a plant; move a shaft and stop it; move a drive to another line setting. PROFIBUS and CAN beside serial lines.
//!
//! This room turns parameters into questions and answers into [`crate::outcome`] types. It asks nobody for permission
//! (that is `gate`, held by `command`) and prints nothing.

mod access;
mod account;
pub mod bench;
mod bus_order;
mod bus_watch;
mod can;
pub mod decode;
mod demand;
pub mod describe;
mod diag;
mod interrupt;
pub mod job;
mod line_check;
pub mod motion;
mod open_line;
mod opening;
mod panel;
pub mod paramfile;
pub mod plant;
mod probe;
pub mod profibus;
mod pump;
mod reader;
mod recognise;
pub mod relocate;
mod route;
mod scan;
mod session;
mod sniff;
mod stands;
mod tally;
mod target;
mod terms;
pub mod transaction;
mod transfer;
mod trouble;
mod turns;
mod upper;
mod watch;
mod widths;
mod write;

pub use access::{AccessError, Refusal};
pub use bus_order::BusOrder;
pub use bus_watch::{Awaited, BusWatch, watch_bus};
pub use diag::{clear_counters, counters, harmless, last_refusal, link_test};
pub use interrupt::Interrupt;
pub use line_check::check_line;
pub use opening::{Opening, Recording, open_port};
pub use panel::{Button, EndedBy, Keypad, Panel, QUIET, Stays, last_told};
pub use reader::{InForce, Reader};
pub use recognise::{Finding, introduce, is_there, recognise};
pub use route::{Cell, Inquiry, No, Route};
pub use scan::{
    Asked, First, Manner, ScanPlan, ScanResult, Searched, Talker, Tuning, Unknown, Yielded, probe_question, ranges,
    scan,
};
pub use session::Session;
pub use sniff::{Filter, Listening, sniff};
pub use tally::{is_over, summary};
pub use target::Target;
pub use terms::{Recognised, Stated, Terms, cut_by, who};
pub use transfer::Reading;
pub use trouble::advice;
pub use upper::{Price, Upper};
pub use watch::{Calls, Chosen, Compare, Condition, Item, Place, Rounds, Select, Signal, Test, When, Window, watch};
pub use write::{Order, WriteFate};

pub use crate::protocol::modbus::LAST_STATION;
pub use crate::transport::Port;
