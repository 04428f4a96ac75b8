//! What a run leaves behind, before it is judged and reported.

use super::Plan;
use crate::drive::motion::{Situation, Unseen};
use crate::failure::Failure;
use crate::text::Text;

/// What a run leaves in its motor.
pub(super) struct Done {
    pub(super) steps: Vec<crate::outcome::Step>,
    pub(super) changed: Vec<crate::outcome::Change>,
    pub(super) setpoint: Option<crate::outcome::Setpoint>,
    pub(super) notes: Vec<Text>,
    pub(super) mode: Option<String>,
    /// Whether the shaft stands.
    pub(super) standing: Option<bool>,
    /// The drive had no power at any look.
    pub(super) idle: bool,
    /// What was seen last of a shaft that was about to stand as its power went.
    pub(super) crept: Option<Text>,
    /// Why nothing shows whether a drive stands that was to be stopped.
    pub(super) unseen: Option<Unseen>,
    /// Another stop was given than was asked for: which, and why.
    pub(super) instead: Option<Text>,
    /// One question was answered in two ways.
    pub(super) differs: bool,
    /// More than one answer came to one question.
    pub(super) twins: Option<Failure>,
}

impl Done {
    /// Whether what was told at the end may be that of another one with its address.
    pub(super) fn is_doubled(&self, plan: &Plan<'_>) -> bool {
        self.twins.is_some() || (self.differs && plan.aim.is_some())
    }
}

/// What the drive said before and afterwards.
pub(super) struct Seen {
    pub(super) before: Option<Situation>,
    /// The first look at a drive to which what takes motion away had gone out already.
    pub(super) first: Option<Situation>,
    pub(super) after: Option<Situation>,
}

impl Seen {
    /// Whether it runs at the end, if that is known.
    pub(super) fn runs(&self) -> Option<bool> {
        self.after.as_ref().map(has_power)
    }
}

pub(super) fn has_power(situation: &Situation) -> bool {
    crate::drive::motion::has_power(&situation.state) == Some(true)
}
