//! What a drive is: data and pure decoding.
//!
//! Parameters, enums, bits, states, faults and texts of every family come from catalogue files (TOML) in one format,
//! shipped (`data/`) or brought by the user. This room knows no bytes on a line, no clock and no I/O but the texts
//! that it is handed.

mod broken;
mod catalogue;
pub mod characteristic;
mod cited;
mod family;
mod files;
mod float;
pub mod import;
mod link;
mod machine;
mod motion;
mod names;
mod param;
pub mod paramfile;
pub mod procedure;
mod role;
mod row;
mod select;
pub mod setpoint;
mod time;
pub mod value;

pub use crate::text::{Lang, Text};
pub use broken::{Broken, in_both, stumbled, stumbled_json};
pub use catalogue::{CatalogueFile, DriveTitle, Registry};
pub use cited::{cited, origin};
pub use family::{Family, LookupError, WordBit};
pub use files::{Alters, FileRules, Goes};
pub use link::{Cause, Holds, INPUTS, LineTable, Link, Route, input_register};
pub use machine::{Command, Facts, Need, NoPlan, StateMachine, Takes, Transition};
pub use motion::{
    Adds, Blind, Choice, Control, Convert, Floor, Interlock, Mode, MotionRules, Movement, Part, Preset, Rest, Setting,
    Show, Source, Start, Stator, StopRow,
};
pub use names::{fold, is_nearly, nearest, place};
pub use param::{Access, BitsWhen, Effective, HazardKind, Param, Sets, Type};
pub use role::Role;
pub use row::{BitRow, CounterRow, DriveState, ErrorRow, FaultCodes, FaultRow};
pub use select::{DataSets, SelectError, Selection, Selector, Store};
pub use value::format_value;
