//! How a transaction, or its way back, ended.

use super::plan::Plan;
use crate::failure::Failure;
use crate::outcome::{LoadEnd, WriteResult};
use crate::text::Text;

/// What became of a transaction.
#[derive(Debug, Default)]
pub struct Applied {
    /// How it ended.
    pub ended: LoadEnd,
    /// Why it did not end well: first what went wrong, then what could not be put back.
    pub failures: Vec<Failure>,
    /// What the drive changed by itself.
    pub notes: Vec<Text>,
}

/// Nothing was written.
pub(super) fn untouched(plan: &mut Plan, failure: Failure) -> Applied {
    for row in plan.job.rows.iter_mut().filter(|row| row.result == WriteResult::Planned) {
        row.result = WriteResult::Skipped;
    }
    Applied { ended: LoadEnd::Untouched, failures: vec![failure], notes: Vec::new() }
}
