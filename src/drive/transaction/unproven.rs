//! What a drive perhaps did not take back, though it looks so: it stands in the undo file before the first byte of a way back, and goes
//! out of it by a write that was proven, and by nothing else.

use super::plan::{Kept, Plan, is_doubted};
use super::weigh::covers;
use crate::drive::job::Step;
use crate::outcome::{WriteResult, Written};
use crate::profile::DataSets;

/// What of a way back in this order the drive may tell as before without having taken it.
pub(super) fn open(plan: &Plan, order: &[Kept]) -> Vec<Kept> {
    order.iter().filter(|kept| plan.may_come_back_in_ram_alone(kept)).cloned().collect()
}

impl Plan {
    /// Whether this value, of what is stored, may be written: a drive that may tell its RAM as stored would hide from a later look that its
    /// EEPROM did not take it.
    pub(super) fn may_come_back_in_ram_alone(&self, kept: &Kept) -> bool {
        let is_equal = |(step, row): (&Step, &Written)| row.result == WriteResult::Unchanged && kept.is_of(step);
        let stays = self.altering().next().is_none() && self.job.steps.iter().zip(&self.job.rows).any(is_equal);
        !self.tells_apart && kept.set < DataSets::RAM_OFFSET && !stays
    }

    /// Whether a drive that may tell its RAM as stored has taken another value than it tells: it acknowledged one, or did not take
    /// the old one back, now or in an earlier run.
    pub(super) fn may_hide(&self, kept: &Kept) -> bool {
        let is_its = |(step, row): (&Step, &Written)| row.result == WriteResult::Differs && kept.is_of(step);
        let doubts = |(step, row): (&Step, &Written)| {
            step.param.id == kept.param.id && covers(step.set, kept.set) && is_doubted(row)
        };
        let is_shown = self.in_force.iter().any(|ram| ram.param.id == kept.param.id);
        let rows = || self.job.steps.iter().zip(&self.job.rows);
        let is_open = |(id, set): &(u32, u8)| *id == kept.param.id && covers(*set, kept.set);
        let is_noted = || self.unproven.iter().any(is_open);
        !self.tells_apart && (is_shown && rows().any(is_its) || rows().any(doubts) || is_noted())
    }
}
