//! What `procedure` did: guided work, step by step.

use super::{Change, ErrorDoc, Motion, TelegramDoc};
use crate::text::{Text, both};
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
    /// Of a dry run: on what it depends. Else: what stands otherwise in the drive than before, and stays so.
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
    /// What a run that was broken off had changed and somebody else has changed since: it is left alone.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left: Vec<Left>,
    /// Who answered; null before it was asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub answered: Option<Answered>,
    /// What its steps have written to stay: the drive with which it goes on has it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stored: Vec<Stored>,
}

/// What a drive tells of itself that does not change.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Answered {
    /// Product code, if it tells one.
    pub product: Option<String>,
    /// Its option modules.
    pub modules: Vec<String>,
}

/// A value that was written to stay.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stored {
    /// Parameter number.
    pub param: u32,
    /// Data set, 0-4.
    pub data_set: u8,
    /// Raw value.
    pub raw: i64,
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
    /// The same as it is typed: `12.5`.
    pub stood: String,
    /// Raw value that was written last, or was about to be.
    pub new: i64,
    /// Raw value that a run had written before it: this stands where it was broken off between the record and the telegram.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub was: Option<i64>,
    /// Whether it stays, because contacts that are closed could start the drive under the value before.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub stays: bool,
}

/// A setting that is otherwise than before, and not as a run has set it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Left {
    /// Parameter number.
    pub param: u32,
    /// Where it is, as messages call it: `P.413@0ram`.
    pub name: String,
    /// Data set, 0-4; always in RAM.
    pub data_set: u8,
    /// Raw value before the run.
    pub old: i64,
    /// The same as it is typed: `12.5`.
    pub stood: String,
    /// Raw value that was found.
    pub now: i64,
    /// The same as it is typed.
    pub stands: String,
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

    /// Whether a run has left this value, and nobody else.
    pub fn is_left(&self, raw: i64) -> bool {
        raw == self.new || Some(raw) == self.was
    }
}

impl Lent {
    fn stays_so(&self) -> Text {
        let Lent { name, stood, new, .. } = self;
        let back = way_back(name, stood);
        both!(
            "{name} stays {new} (was {stood}): contacts that are closed could start the drive under {stood}; {back} sets it back, when \
             nothing can start",
            "{name} bleibt {new} (war {stood}): geschlossene Kontakte könnten den Antrieb unter {stood} starten; {back} stellt es zurück, \
             wenn nichts anlaufen kann"
        )
    }
}

impl Left {
    fn told(&self) -> Text {
        let Left { name, stands, stood, .. } = self;
        let back = way_back(name, stood);
        both!(
            "{name} was left alone at {stands}: a run that was broken off had changed it, and somebody else since; before that it was \
             {stood} ({back})",
            "{name} blieb bei {stands}: ein abgebrochener Lauf hatte es geändert, und seitdem jemand anderes; davor war es {stood} ({back})"
        )
    }
}

/// The command that sets what stood before.
fn way_back(name: &str, stood: &str) -> String {
    format!("`antrieb write {}={stood}`", name.trim_start_matches("P."))
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

    /// Notes what a run is about to set, and what the setting was, which is `stood` as it is typed; what it was before an earlier run that
    /// was broken off, stays noted.
    pub fn lend(&mut self, change: &Change, stood: String) {
        let Change { param, data_set, old, new, .. } = *change;
        match self.lent.iter_mut().find(|lent| lent.is_of(change)) {
            Some(lent) if lent.new == new => {}
            Some(lent) => (lent.was, lent.new) = (Some(lent.new), new),
            None => {
                let name = change.name.clone();
                self.lent.push(Lent { param, name, data_set, old, stood, new, was: None, stays: false });
            }
        }
    }

    /// Strikes out what a run has given back, if that is what it was at first.
    pub fn take_back(&mut self, changed: &[Change]) {
        let given = || changed.iter().filter(|row| row.restored);
        self.lent.retain(|lent| !given().any(|row| lent.is_of(row) && row.old == lent.old));
        for row in given() {
            for lent in self.lent.iter_mut().filter(|lent| lent.is_of(row)) {
                (lent.was, lent.new) = (None, row.old);
            }
        }
    }

    /// Notes values that were written to stay.
    pub fn store(&mut self, stored: impl Iterator<Item = Stored>) {
        for one in stored {
            self.stored.retain(|other| (other.param, other.data_set) != (one.param, one.data_set));
            self.stored.push(one);
        }
    }

    /// What stands otherwise in the drive than before the procedure, and stays so.
    pub fn stays(&self) -> Vec<Text> {
        let lent = self.lent.iter().filter(|lent| lent.stays).map(Lent::stays_so);
        lent.chain(self.left.iter().map(Left::told)).collect()
    }

    /// Puts a step in its place.
    pub fn keep(&mut self, step: KeptStep) {
        match self.steps.iter_mut().find(|kept| kept.step == step.step) {
            Some(kept) => *kept = step,
            None => self.steps.push(step),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A search sets one thing again and again: what stands behind a kill is the last value, or the one before it, and no other proves
    /// that it was the run.
    #[test]
    fn what_is_set_again_is_known_by_its_last_two_values() {
        let text = r#"{ "antrieb_procedure": 1, "procedure": "x", "title": { "en": "", "de": "" }, "address": 1, "drive": "acu",
            "of": 1, "given": [], "steps": [] }"#;
        let mut record: ProcedureRecord = serde_json::from_str(text).unwrap();
        let change = |old: i64, new: i64, restored: bool| Change {
            param: 382,
            name: "P.382@1ram".to_owned(),
            data_set: 1,
            old,
            new,
            restored,
        };
        let left = |record: &ProcedureRecord| (0..9).filter(|raw| record.lent[0].is_left(*raw)).collect::<Vec<_>>();
        let lend = |record: &mut ProcedureRecord, new: i64| record.lend(&change(0, new, false), "0.0".to_owned());
        lend(&mut record, 3);
        assert_eq!(left(&record), [3]);
        lend(&mut record, 5);
        lend(&mut record, 5);
        assert_eq!(left(&record), [3, 5]);
        lend(&mut record, 7);
        assert_eq!((left(&record), record.lent[0].old), (vec![5, 7], 0));
        // A later run found what an earlier one had left, and has given back that.
        record.take_back(&[change(7, 8, true)]);
        assert_eq!((left(&record), record.lent[0].old), (vec![7], 0));
        record.take_back(&[change(0, 8, false)]);
        assert_eq!(record.lent.len(), 1);
        record.take_back(&[change(0, 8, true)]);
        assert_eq!(record.lent, []);
    }
}
