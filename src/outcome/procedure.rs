//! What `procedure` did: guided work, step by step.

use super::{Change, ErrorDoc, Motion, TelegramDoc};
use crate::text::Text;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Result of `procedure`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Procedure {
    /// Whether nothing was sent.
    pub dry_run: bool,
    /// Which one.
    pub procedure: String,
    /// What it is for.
    pub title: Text,
    /// Address of the drive.
    pub address: u8,
    /// Family; before the drive has told it, the one that is taken.
    pub drive: String,
    /// The record, from which it can be continued and which `report --procedure` shows; null if nothing was done.
    pub record: Option<String>,
    /// Whether every step is done.
    pub complete: bool,
    /// What was given for it.
    pub given: Vec<GivenValue>,
    /// Every step, in order.
    pub steps: Vec<ProcedureStep>,
    /// Of a dry run: on what it depends.
    pub notes: Vec<Text>,
}

/// A value that a procedure was given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GivenValue {
    /// Its name.
    pub key: String,
    /// As it was typed.
    pub value: String,
}

/// A step of a procedure.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ProcedureStep {
    /// Its name.
    pub step: String,
    /// In a few words.
    pub title: Text,
    /// What is to be done, or is done.
    pub does: Text,
    /// What the manual warns of.
    pub warning: Option<Text>,
    /// Where the manual says so.
    pub source: String,
    /// Whether it can turn the shaft.
    pub turns: bool,
    /// What became of it.
    pub result: StepFate,
    /// Whether that was in an earlier run.
    pub earlier: bool,
    /// When, UTC (RFC 3339); null on the bench and where nothing became of it.
    pub time: Option<String>,
    /// What was found, or proven.
    pub found: Vec<Text>,
    /// What the shaft did in this run, run by run.
    pub motions: Vec<Motion>,
    /// Of a dry run: what would be sent.
    pub telegrams: Vec<TelegramDoc>,
    /// Why it is not done.
    pub error: Option<ErrorDoc>,
}

/// What became of a step of a procedure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum StepFate {
    /// Its turn has not come.
    Open,
    /// It was begun, and nothing tells how it ended.
    Begun,
    /// It is done and proven, or somebody said so.
    Done,
    /// It was tried and is not done.
    Failed,
}

impl StepFate {
    /// How it is written.
    pub fn slug(self) -> &'static str {
        match self {
            StepFate::Open => "open",
            StepFate::Begun => "begun",
            StepFate::Done => "done",
            StepFate::Failed => "failed",
        }
    }
}

/// Result of `procedure list`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Procedures {
    /// One entry a procedure.
    pub procedures: Vec<ProcedureTold>,
}

/// A procedure that can be done.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ProcedureTold {
    /// How it is typed.
    pub procedure: String,
    /// What it is for.
    pub title: Text,
    /// Families for which a manual describes it.
    pub drives: String,
    /// How many steps it has.
    pub steps: usize,
    /// What must be given.
    pub values: String,
    /// What may be given.
    pub optional: String,
}

/// A procedure as it is kept in its record, and shown in a report.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProcedureRecord {
    /// Version of the file.
    pub antrieb_procedure: u32,
    /// Which one.
    pub procedure: String,
    /// What it is for.
    pub title: Text,
    /// Address of the drive.
    pub address: u8,
    /// Family, by which its steps are taken.
    pub drive: String,
    /// Whether the drive itself has said so; if not, the family is taken for granted.
    #[serde(default)]
    pub asked: bool,
    /// How many steps it has.
    pub of: usize,
    /// What was given for it.
    pub given: Vec<GivenValue>,
    /// Every step that was begun, in order.
    pub steps: Vec<KeptStep>,
    /// What a run has set in the RAM of the drive for its time and not given back yet; who goes on gives it back.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lent: Vec<Lent>,
}

/// A setting that a run has changed for its time.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lent {
    /// Parameter number.
    pub param: u32,
    /// Where it was changed, as messages call it: `P.413@0ram`.
    pub name: String,
    /// Data set, 0-4; always in RAM.
    pub data_set: u8,
    /// Raw value before.
    pub old: i64,
    /// Raw value that was written first.
    pub new: i64,
}

/// A step in a record.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KeptStep {
    /// Its name.
    pub step: String,
    /// In a few words.
    pub title: Text,
    /// Whether it can turn the shaft.
    pub turns: bool,
    /// What became of it.
    pub result: StepFate,
    /// When, UTC.
    pub time: Option<String>,
    /// What was found, or proven.
    pub found: Vec<Text>,
    /// Why it is not done.
    pub error: Option<Text>,
}

impl Lent {
    fn is_of(&self, change: &Change) -> bool {
        (self.param, self.data_set) == (change.param, change.data_set)
    }
}

impl ProcedureRecord {
    /// The version that is written.
    pub const VERSION: u32 = 1;

    /// The family, if the drive has told it.
    pub fn known_drive(&self) -> &str {
        if self.asked { &self.drive } else { "unknown" }
    }

    /// A step, if it was ever begun.
    pub fn step(&self, slug: &str) -> Option<&KeptStep> {
        self.steps.iter().find(|kept| kept.step == slug)
    }

    /// Notes what a setting was before a run changes it; what it was before an earlier one that was broken off, stays noted.
    pub fn lend(&mut self, change: &Change) {
        let Change { param, data_set, old, new, .. } = *change;
        if !self.lent.iter().any(|lent| lent.is_of(change)) {
            self.lent.push(Lent { param, name: change.name.clone(), data_set, old, new });
        }
    }

    /// Strikes out what a run has given back, if that is what it was at first.
    pub fn take_back(&mut self, changed: &[Change]) {
        let is_back = |lent: &Lent| changed.iter().any(|row| lent.is_of(row) && row.restored && row.old == lent.old);
        self.lent.retain(|lent| !is_back(lent));
    }

    /// Puts a step in its place.
    pub fn keep(&mut self, step: KeptStep) {
        match self.steps.iter_mut().find(|kept| kept.step == step.step) {
            Some(kept) => *kept = step,
            None => self.steps.push(step),
        }
    }
}
