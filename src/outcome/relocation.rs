//! What `protocol set` and `line set` did.

use super::ErrorDoc;
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// A drive that was, or was to be, moved to other line settings.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Relocation {
    /// Address before.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Where the drive answered before.
    pub from: Place,
    /// Where it was to answer.
    pub to: Place,
    /// What was done for it, in order.
    pub steps: Vec<RelocationStep>,
    /// What became of it.
    pub result: RelocationResult,
    /// Where the drive answers now, proven; null if that is not known.
    pub now: Option<Place>,
    /// Where it may be if `now` is null, the likeliest first.
    pub perhaps: Vec<Place>,
    /// Where it will be after its next restart, if that is not where it is.
    pub after_restart: Option<Place>,
    /// The command line that goes back.
    pub way_back: Option<String>,
}

/// How a drive is reached.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Place {
    /// `rtu`, `ascii`, `vabus`.
    pub protocol: &'static str,
    /// Bits per second.
    pub baud: u32,
    /// `even`, `odd`, `none`.
    pub parity: &'static str,
    /// 7 or 8.
    pub data_bits: u8,
    /// 1 or 2.
    pub stop_bits: u8,
    /// Address in that protocol.
    pub address: u8,
    /// The same for people: `rtu 19200 8E1, address 1`.
    pub text: Text,
}

/// A write on the way.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RelocationStep {
    /// Parameter number.
    pub param: u32,
    /// Name in the chosen language.
    pub name: Text,
    /// Raw value before; null where there is none, as for a restart.
    pub old_raw: Option<i64>,
    /// Raw value that was, or is to be, written.
    pub raw: i64,
    /// What the value stands for.
    pub text: Option<Text>,
    /// When the drive is somewhere else by it.
    pub moves: Moves,
    /// What became of it.
    pub result: StepResult,
    /// Why it failed.
    pub error: Option<ErrorDoc>,
}

/// When a write moves the drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Moves {
    /// With the next restart.
    AfterRestart,
    /// At once, after its reply.
    AtOnce,
    /// At once or when the drive is switched on the next time: no source says which.
    Unsaid,
    /// It is the restart.
    Restart,
}

/// What became of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StepResult {
    /// Not begun.
    Planned,
    /// Done, and proven: read back, or the drive answers where it should.
    Proven,
    /// Undone again, and proven.
    Undone,
    /// The drive refused, or did not do it.
    Failed,
    /// Whether it was done is not known.
    Unknown,
}

/// What became of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RelocationResult {
    /// The drive answers where it should.
    Moved,
    /// It was there already; nothing was sent.
    Unchanged,
    /// It is stored, and holds when the drive is switched on the next time; until then it answers where it did.
    Stored,
    /// It did not work, and the drive was left as it was before.
    Restored,
    /// It did not work; the drive answers, but not all of it is as it was before.
    Halfway,
    /// The drive answers nowhere.
    Lost,
}
