//! What a run leaves behind, before it is judged and reported.

use crate::drive::motion::{Situation, Unseen};
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
    /// Why nothing shows whether a drive stands that was to be stopped.
    pub(super) unseen: Option<Unseen>,
    /// Another stop was given than was asked for: which, and why.
    pub(super) instead: Option<Text>,
}

/// What the drive said before and afterwards.
pub(super) struct Seen {
    pub(super) before: Option<Situation>,
    /// The first look at a drive to which what takes motion away had gone out already.
    pub(super) first: Option<Situation>,
    pub(super) after: Option<Situation>,
}
