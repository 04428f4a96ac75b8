//! The system bus of ACTIVE Cube drives as it is planned (EM-RES-03 manual 5.11 and 5.14): who sends which PDO to whom, what stands
//! in it, whether it is allowed, and what it costs the bus.
//!
//! This room knows plans, parameter numbers and source numbers. It knows no line: a plan becomes settings of drives
//! ([`settings`]), which somebody else writes.

mod carried;
mod check;
mod dcf;
mod ends;
mod load;
mod picture;
mod plan;
mod read;
mod relations;
mod settings;
mod standing;

pub use carried::{Carried, carried};
pub use check::{Level, Remark, check};
pub use dcf::{DcfError, dcf, from_dcf};
pub use load::{Budget, Charge, Load, Rate, Verdict};
pub use picture::picture;
pub use plan::{Drive, EmergencyReaction, Foreign, Numbering, Plan, Rx, Trigger, Tx};
pub use read::{PlanError, read};
pub use relations::{Link, Receiver, Relation, links, relations};
pub use settings::{Setting, settings};
pub use standing::{Channel, End, Function, Standing};

#[cfg(test)]
mod tests;
