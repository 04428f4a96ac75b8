//! What `statemachine` and `sollwert` found and did.

use super::{Decimal, ErrorDoc, Fault, State, Value, Word};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// What a verb did that can turn a shaft.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Motion {
    /// Address of the drive.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// The same, but where nobody knows it: one whose states are asked for in the same words.
    #[serde(skip)]
    pub asked_as: String,
    /// What was asked for: `enable`, `quick-stop`, `sollwert` …
    pub action: String,
    /// What is set: `frequency`, `velocity`, `homing` … by the word of `sollwert --mode`; null if nothing is.
    pub mode: Option<String>,
    /// State before.
    pub from: Option<State>,
    /// State at the end.
    pub to: Option<State>,
    /// Transitions that were walked, in order.
    pub steps: Vec<Step>,
    /// Setpoint that was given.
    pub setpoint: Option<Setpoint>,
    /// Settings that were changed for the run, and given back.
    pub changed: Vec<Change>,
    /// The drive's own watchdog in seconds as it is in force now that the program leaves; 0 is off, null could not be read.
    pub watchdog_s: Option<Decimal>,
    /// The stop at the end, if one was needed.
    pub stop: Option<Stop>,
    /// Whether the drive keeps its power now that the program leaves; null if that is not known.
    pub running: Option<bool>,
    /// Whether the shaft stands now that the program leaves: true only if that was seen, false if it was seen turning; null
    /// if nothing tells, as of a drive that shows the frequency of its stator and has no power.
    pub standing: Option<bool>,
    /// The drive had no power at any look, and was not told to take it: its shaft is nobody's concern here.
    #[serde(skip)]
    pub idle: bool,
    /// What is worth knowing besides.
    pub notes: Vec<Text>,
}

impl Motion {
    /// What belongs to "running: no" or "running: yes", so that neither says more of the shaft than is known.
    pub fn shaft(&self) -> Option<&'static str> {
        match (self.running?, self.standing) {
            (true, Some(true)) if self.to.as_ref().is_some_and(|state| state.slug == "quick-stop-active") => {
                Some("powered, held at standstill")
            }
            (false, Some(false)) => Some("the shaft still turns"),
            (false, None) if !self.idle => Some("whether the shaft stands is not told"),
            _ => None,
        }
    }
}

/// A stop of several drives.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Stops {
    /// One entry a drive, in the order that was typed.
    pub drives: Vec<Stopped>,
}

/// What became of the stop of a drive among several.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Stopped {
    /// Its name in the project file, of several lines; on one line it is told by its address.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub called: Option<String>,
    /// Address of the drive.
    pub address: u8,
    /// What the shaft did; null where nothing could be asked.
    pub motion: Option<Motion>,
    /// Why it is not proven that it stands.
    pub error: Option<ErrorDoc>,
}

/// A transition that was walked.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Step {
    /// Number in the manual.
    pub transition: String,
    /// Command; null if the drive goes by itself.
    pub command: Option<String>,
    /// Control word that was written, as `0x000F`.
    pub control: Option<String>,
    /// State that was reached.
    pub state: State,
    /// How long it took.
    pub took_ms: u64,
}

/// A setpoint that was given.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Setpoint {
    /// Parameter that it was written to.
    pub param: u32,
    /// Last value.
    pub value: Decimal,
    /// Lower number of a ratio, whose upper one is the value; missing where it is no ratio.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub denominator: Option<i64>,
    /// What the drive makes of it by its own settings: sources that it adds, limits; null if that is not known.
    pub effective: Option<Decimal>,
    /// Unit.
    pub unit: String,
    /// How often a value was written.
    pub writes: u64,
    /// Whether the drive reports it as reached; null if nobody waited.
    pub reached: Option<bool>,
    /// Actual value at the end.
    pub actual: Option<Decimal>,
}

/// A setting that was changed for a run.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Change {
    /// Parameter number.
    pub param: u32,
    /// Where it was changed, as messages call it: `P.413@0ram`, `MBnode_guard (5644)`.
    pub name: String,
    /// Data set, 0-4; always in RAM. 0 where the family has none.
    pub data_set: u8,
    /// Raw value before.
    pub old: i64,
    /// Raw value during the run.
    pub new: i64,
    /// Whether the old value stands again.
    pub restored: bool,
}

/// The stop at the end of a run.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Stop {
    /// `ramp`, `quick-stop`, `coast`, `keep`.
    pub choice: &'static str,
    /// The stronger way that was taken in the end, because somebody interrupted again or the drive did not obey; null if
    /// none was.
    pub escalated: Option<&'static str>,
    /// Why: `end`, `key` (of its keypad), `dead-man` (nobody held a key any more), `interrupted`, `error`.
    pub because: &'static str,
    /// Whether the drive's state, and its shaft where that is waited for, prove that it was obeyed.
    pub acknowledged: bool,
    /// Whether the shaft was seen to stand; null if nothing told.
    pub standing: Option<bool>,
    /// State that was seen last.
    pub state: Option<State>,
    /// What is to be known of the shaft, or what stops the drive if the line is dead.
    pub note: Option<Text>,
}

/// Result of `statemachine show`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Statemachine {
    /// One entry a drive.
    pub drives: Vec<StateReport>,
}

/// State of one drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct StateReport {
    /// Address.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// State of the status word.
    pub state: Option<State>,
    /// Status word bit by bit.
    pub status: Option<Word>,
    /// Control word as last written, bit by bit, if it can be read.
    pub control: Option<Word>,
    /// How the drive is controlled (P.412), as it works with it: in RAM, in the active data set.
    pub control_mode: Option<Value>,
    /// What is stored and holds after the next power-on, where that differs; null where it is the same.
    pub control_mode_stored: Option<Value>,
    /// Value of the fault parameter; null if it could not be read, 0 if there is no fault.
    pub fault_code: Option<i64>,
    /// Active fault; null if there is none, or if it could not be read.
    pub fault: Option<Fault>,
    /// What keeps the drive from running by the control word, and how one sees it.
    pub missing: Vec<Text>,
    /// The map of the state machine.
    pub states: Vec<StateRow>,
    /// Why it could not be read.
    pub error: Option<ErrorDoc>,
}

/// A state and where it leads.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StateRow {
    /// Stable name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Whether the drive is in it.
    pub present: bool,
    /// Transitions with their number, command and goal.
    pub leads: Vec<Text>,
}

/// Result of `sollwert` without a value.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Sollwert {
    /// One entry a drive.
    pub drives: Vec<SetpointReport>,
}

/// Setpoints and actual values of one drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SetpointReport {
    /// Address.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Setpoints.
    pub setpoints: Vec<Value>,
    /// Actual values.
    pub actual: Vec<Value>,
    /// What decides how the setpoint is formed.
    pub sources: Vec<Value>,
    /// Why it could not be read.
    pub error: Option<ErrorDoc>,
}
