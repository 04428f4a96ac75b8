//! What `scan`, `identify` and `diag` found.

use super::{Decimal, ErrorDoc, Fault, Register, SlaveDiagnosis, State, Value, Word};
use crate::text::Text;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Result of `scan`.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub struct Scan {
    /// Port that was searched; several are parted by commas.
    pub port: String,
    /// Line setting that was used, or `auto`.
    pub line: String,
    /// Protocol that was used, or `auto`.
    pub protocol: String,
    /// How many addresses were to be asked, at all settings of all ports together.
    pub addresses: usize,
    /// How many were asked.
    pub asked: usize,
    /// Whether every address was asked.
    pub complete: bool,
    /// Settings that were to be tried, of all ports together.
    #[serde(default)]
    pub settings: usize,
    /// Settings at which every address was asked.
    #[serde(default)]
    pub settings_done: usize,
    /// What was left open would take about so many seconds; 0 if nothing was.
    #[serde(default)]
    pub left_s: u64,
    /// What answered.
    pub drives: Vec<FoundDrive>,
    /// What was asked and what was not, at every setting in the order of its likelihood; `scan --resume` goes on from here.
    pub searches: Vec<Search>,
}

/// What was asked at one setting of one port.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Search {
    /// Port.
    pub port: String,
    /// Line setting.
    pub line: String,
    /// Protocol.
    pub protocol: String,
    /// Addresses that have had their time to answer, such as `1-10,17`.
    pub asked: String,
    /// Addresses that have not.
    #[serde(default)]
    pub open: String,
    /// Whether every address has had its time.
    pub complete: bool,
    /// Addresses where only garbage came.
    pub garbled: Vec<u8>,
}

/// How far the search of a line has come whose setting nobody knows: a line of `scan --format ndjson` before it begins
/// (`setting` 0) and after every setting.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SearchNews {
    /// Seconds since the port was opened.
    pub t: Decimal,
    /// Port.
    pub port: String,
    /// Line setting that was asked.
    pub line: String,
    /// Protocol that was asked.
    pub protocol: &'static str,
    /// Which of the settings it is, in the order of their likelihood, from 1.
    pub setting: usize,
    /// How many settings there are.
    pub settings: usize,
    /// Which round: each goes through all settings, the first ones with few likely addresses.
    pub round: usize,
    /// How many rounds there are.
    pub rounds: usize,
    /// Addresses that were asked at this setting now.
    pub asked_here: String,
    /// Addresses of the drives that were found at this setting now.
    pub found_here: Vec<u8>,
    /// Whether garbage came at this setting: somebody is there whom nobody understands.
    pub garbled: bool,
    /// Drives found so far.
    pub found: usize,
    /// Addresses that have had their time, at all settings together.
    pub asked: usize,
    /// Addresses that are to be asked, at all settings together.
    pub addresses: usize,
    /// What is left takes about so many seconds.
    pub left_s: Decimal,
    /// And at most so many, whatever comes over the line; a drive that is found adds the look at it.
    pub at_most_s: Decimal,
    /// The setting is done, and not on the way.
    #[serde(skip)]
    pub is_over: bool,
    /// One of several ports.
    #[serde(skip)]
    pub is_named: bool,
}

impl SearchNews {
    /// Whether it tells more than where a setting is that takes long.
    pub fn is_told(&self) -> bool {
        self.is_over || self.setting == 0
    }
}

/// Something that answered a scan.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
pub struct FoundDrive {
    /// Address.
    pub address: u8,
    /// Family, or `unknown`.
    pub drive: String,
    /// Title of the family, or what answered in its place.
    #[serde(deserialize_with = "Text::as_printed")]
    pub title: Text,
    /// What it calls itself; missing where it does not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub product: Option<String>,
    /// Port that it was found at.
    pub port: String,
    /// Line setting that it was found with.
    pub line: String,
    /// Protocol that it was found with.
    pub protocol: String,
    /// What the device answered that tells the family.
    pub evidence: Vec<Evidence>,
    /// State, if it is a drive that we know.
    pub state: Option<State>,
    /// Active fault, if there is one.
    #[serde(deserialize_with = "Text::as_printed_or_null")]
    pub fault: Option<Text>,
    /// Warnings that are present, by their names, if it is a drive that tells them.
    #[serde(default, deserialize_with = "Text::as_printed_or_null")]
    pub warnings: Option<Text>,
}

/// One thing that tells a family.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Evidence {
    /// What was asked.
    #[serde(deserialize_with = "Text::as_printed")]
    pub asked: Text,
    /// What came.
    #[serde(deserialize_with = "Text::as_printed")]
    pub answered: Text,
    /// What it tells.
    #[serde(deserialize_with = "Text::as_printed")]
    pub tells: Text,
}

/// Result of `identify`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Identify {
    /// One entry a drive.
    pub drives: Vec<Identity>,
}

/// What can be told of one drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Identity {
    /// Address.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Family, or `unknown`.
    pub drive: String,
    /// Title of the family.
    pub title: Text,
    /// Product code as the drive itself tells it; null if it tells none.
    pub product: Option<String>,
    /// What the device answered that tells the family.
    pub evidence: Vec<Evidence>,
    /// Option modules that answered, and those that did not.
    pub modules: Vec<Module>,
    /// Settings that matter for talking to it.
    pub values: Vec<Value>,
    /// Why it could not be identified.
    pub error: Option<ErrorDoc>,
}

/// An option module.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Module {
    /// Name.
    pub name: String,
    /// Whether its parameters answer.
    pub present: bool,
    /// How that was found out.
    pub evidence: Text,
}

/// Result of `diag`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Diag {
    /// One entry a drive.
    pub drives: Vec<Diagnosis>,
}

/// What ails a drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Diagnosis {
    /// Address.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Family.
    pub drive: String,
    /// Whether neither fault nor warning is present.
    pub healthy: bool,
    /// Status word with its state.
    pub status: Option<Word>,
    /// Whether its catalogue says where it tells a fault.
    #[serde(skip)]
    pub tells_faults: bool,
    /// Value of the fault parameter; null if it could not be read or the family has none, 0 if there is no fault.
    pub fault_code: Option<i64>,
    /// Active fault; null if there is none, or if it could not be read.
    pub fault: Option<Fault>,
    /// Warning word.
    pub warnings: Option<Word>,
    /// Digital inputs, bit by bit; null where the family shows none.
    pub inputs: Option<Word>,
    /// What the system bus tells of it; missing where it is not asked over one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bus: Option<BusDiagnosis>,
    /// What keeps the drive from running by the control word, and how one sees it.
    pub missing: Vec<Text>,
    /// Latest entry of the fault memory, where the family has parameters for it.
    pub memory: Vec<Value>,
    /// The drive's watchdog: how long the line may be silent.
    pub watchdog: Option<Value>,
    /// Why the drive refused something last: the error register as it stood before this command asked anything (reading
    /// clears it), or the number of the last synchronous error.
    pub error_register: Option<Register>,
    /// Diagnostic counters.
    pub counters: Vec<Counter>,
    /// Whether the counters were set to zero.
    pub counters_cleared: bool,
    /// Result of the link test.
    pub link: Option<LinkTest>,
    /// What a slave of PROFIBUS tells besides; missing over other lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slave: Option<SlaveDiagnosis>,
    /// Why it could not be diagnosed.
    pub error: Option<ErrorDoc>,
}

/// What the system bus tells of a drive.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BusDiagnosis {
    /// State of the node and of its controller (P.978, P.979).
    pub values: Vec<Value>,
    /// Emergencies that were heard while this was asked, in their order; over the plug of another drive there are none to hear.
    pub emergencies: Vec<Text>,
}

/// A diagnostic counter.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Counter {
    /// Sub-function of code 8.
    pub sub: u16,
    /// Stable name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Count; null if it could not be read.
    pub count: Option<u16>,
    /// What it counts and what a high value means.
    pub help: Text,
}

/// Result of a link test.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LinkTest {
    /// Questions asked.
    pub asked: u64,
    /// Good replies.
    pub replies: u64,
    /// Questions without a reply.
    pub silent: u64,
    /// Questions answered by garbage.
    pub garbled: u64,
    /// Telegrams that belonged to no question.
    pub strays: u64,
    /// Share of questions that failed, in percent.
    pub error_rate_percent: f64,
    /// Shortest time from the end of a request to the last byte of its reply.
    pub fastest_us: Option<u64>,
    /// Half of the replies were faster.
    pub median_us: Option<u64>,
    /// 95 of 100 replies were faster.
    pub p95_us: Option<u64>,
    /// Longest time.
    pub slowest_us: Option<u64>,
    /// How many replies took how long; empty buckets are left out.
    pub histogram: Vec<Bucket>,
}

/// Replies that took from `from_us` on, but less than `to_us`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Bucket {
    /// From this time on.
    pub from_us: u64,
    /// Up to this time; null for everything that took longer.
    pub to_us: Option<u64>,
    /// Replies.
    pub count: u64,
}
