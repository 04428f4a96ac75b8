//! Parameter files into drives, as a transaction: what a file wants is picked ([`Choice`]), everything is read and checked
//! ([`plan`]), an undo file is left ([`UndoPlace::leave`]), then each value is written and proven ([`apply`]), and whatever ends that
//! early, what was written goes back. What could not go back is named, and [`undo`] does it later.
//!
//! ```text
//! settings -> Choice::steps -> plan -> UndoPlace::check -> (question, permit) -> UndoPlace::leave -> apply -> done, or put back
//! undo file -> plan_back -> make_ready -> (question, permit) -> undo
//! ```

mod apply;
mod back;
mod choice;
mod ended;
mod meanwhile;
mod plan;
mod progress;
mod proof;
mod running;
mod undo_file;
mod unproven;
mod weigh;

pub use apply::apply;
pub(super) use back::LONGEST_RESTART;
pub use back::{NOT_SHOWN, SET, STORE, make_ready, switch_off, take_back, undo};
pub use choice::{Choice, NO_VALUES};
pub use ended::Applied;
pub use meanwhile::{THEIRS, still_may};
pub use plan::{Plan, plan};
pub use running::RUNNING;
pub use undo_file::{UNDO_FILE, UndoFile, UndoPlace, WayBack, plan_back};
pub use weigh::{CUTS, Coming, Unproven, fits};
