//! What `systembus monitor` heard, and what `systembus nmt` did.

use super::{Decimal, ErrorDoc};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `systembus monitor`. Times are seconds since the port was opened.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BusMonitor {
    /// Port.
    pub port: String,
    /// Bit rate in bit/s.
    pub bit_rate: u32,
    /// Why it ended: `duration`, `interrupted`, `quiet` (virtual time), `lost`.
    pub because: &'static str,
    /// Seconds for which it listened.
    pub t: Decimal,
    /// Frames that were heard.
    pub frames: u64,
    /// Frames that came faster than they could be told.
    pub lost: u64,
    /// Share of the bus in percent, every frame counted with all the bits that stuffing can add.
    pub load_percent: Decimal,
    /// What was heard, by identifier, and PDOs of the plan that were not.
    pub heard: Vec<HeardOnBus>,
    /// Emergencies, in order.
    pub emergencies: Vec<HeardEmergency>,
}

/// What came under an identifier.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct HeardOnBus {
    /// The identifier: 11 bits, 0 to 2047, or 29.
    pub identifier: u32,
    /// By the plan who sends it, else by the predefined connection set what it is for.
    pub name: Text,
    /// Frames.
    pub frames: u64,
    /// Mean time between two of them in milliseconds; null for fewer than two.
    pub every_ms: Option<Decimal>,
    /// The longest time between two of them in milliseconds.
    pub longest_ms: Option<Decimal>,
    /// Milliseconds from one to the next by the plan; null where it says none.
    pub planned_ms: Option<u32>,
    /// The plan has it sent, and it did not come for longer than anybody waits for it.
    pub missing: bool,
    /// The bytes that came last.
    pub hex: Option<String>,
    /// What they carry, where the plan says it.
    pub places: Vec<HeardPlace>,
}

/// What stands at a place of a PDO.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct HeardPlace {
    /// Place: `boolean1`, `word3`, `long2`.
    pub place: String,
    /// First byte, from 0 on.
    pub first_byte: u8,
    /// Last byte.
    pub last_byte: u8,
    /// The source that fills it.
    pub source: Option<u16>,
    /// Its name.
    pub source_name: Option<Text>,
    /// Who takes it.
    pub takers: Vec<HeardTaker>,
    /// The number that stands there, without sign and scale: none is printed.
    pub raw: u32,
}

/// Who takes what stands at a place.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct HeardTaker {
    /// The drive.
    pub drive: String,
    /// Its parameter.
    pub param: u32,
    /// What that is called.
    pub param_name: Option<Text>,
}

/// An emergency of a node.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct HeardEmergency {
    /// The node.
    pub node: u8,
    /// The fault key.
    pub fault: u16,
    /// What it says.
    pub meaning: Text,
    /// Seconds at which it came.
    pub t: Decimal,
    /// Seconds at which it was told that the fault was acknowledged; null if it was not.
    pub cleared: Option<Decimal>,
}

/// Result of `systembus nmt`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BusOrders {
    /// `start`, `stop`, `preop`, `reset`.
    pub command: &'static str,
    /// The node that was told; null for all of them.
    pub node: Option<u8>,
    /// What the nodes did that are known.
    pub nodes: Vec<BusOrdered>,
}

/// What a node did that was told something.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BusOrdered {
    /// The node.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Its state before (P.978); null if it did not answer.
    pub before: Option<i64>,
    /// In words.
    pub before_text: Option<Text>,
    /// Its state behind it.
    pub after: Option<i64>,
    /// In words.
    pub after_text: Option<Text>,
    /// What proves that it obeyed: `state` (P.978), `silence` (a stopped node answers nothing), `boot_up`; null for nothing.
    pub proof: Option<&'static str>,
    /// Why nothing does.
    pub error: Option<ErrorDoc>,
}
