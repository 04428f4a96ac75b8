//! What `profibus` says.

use super::{Decimal, ErrorDoc, Field, Value};
use crate::text::{Text, both};
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `profibus module`: a module of an SJ2-PB in Basic mode.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BasicModule {
    /// What was given.
    pub input: String,
    /// Series that the module expects: `l200`, `sj200`, `x200`.
    pub drive: String,
    /// Its parameter, if it carries one that the catalogue knows.
    pub param: Option<u32>,
    /// Its bytes in Set_Prm, behind what the GSD puts in front.
    pub parameters: String,
    /// Its byte in Chk_Cfg; null where the manual leaves it open.
    pub cfg: Option<String>,
    /// In words.
    pub meaning: Text,
    /// Field by field.
    pub fields: Vec<Field>,
    /// What the manual leaves open.
    pub notes: Vec<Text>,
}

/// Result of `profibus live`: the stations that answered.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LiveList {
    /// Port.
    pub port: String,
    /// Line setting.
    pub line: String,
    /// Addresses that were to be asked.
    pub addresses: usize,
    /// Addresses that were asked.
    pub asked: usize,
    /// Who answered.
    pub stations: Vec<LiveStation>,
}

/// A station of a PROFIBUS line. What stands in Slave_Diag and Get_Cfg is told by slaves alone.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct LiveStation {
    /// Address, 0 to 125.
    pub address: u8,
    /// `slave`, `master-not-ready`, `master-ready`, `master-in-ring`; empty if nothing valid came.
    pub kind: &'static str,
    /// The same in words.
    pub is: Text,
    /// Ident number, hexadecimal.
    pub ident: Option<String>,
    /// `wait-prm`, `wait-cfg`, `data-exchange`.
    pub state: Option<&'static str>,
    /// Master that parameterised it; null if none did.
    pub master: Option<u8>,
    /// Bits of Slave_Diag that are set, by the names of the norm.
    pub flags: Vec<String>,
    /// Bytes of its configuration.
    pub configuration: Option<String>,
    /// `basic`, `ppo1` to `ppo5`, where it is one of an SJ2-PB.
    pub layout: Option<&'static str>,
    /// From the end of the question (FDL status) to its answer, microseconds, with what the adapter adds; null if it had to be
    /// asked again.
    pub answered_us: Option<u64>,
    /// How often it had to be asked again.
    pub repeats: u64,
    /// How it answers, where it was asked many times (`--questions`).
    pub answers: Option<Answers>,
    /// Slave_Diag, field by field.
    pub diagnosis: Vec<Field>,
    /// Get_Cfg, identifier by identifier.
    pub identifiers: Vec<Field>,
    /// Why it is not all told.
    pub error: Option<ErrorDoc>,
}

impl LiveStation {
    /// Its state as what a slave does in it (IEC 61158-6-3), where one was told.
    pub fn does(&self) -> Option<Text> {
        Some(match self.state? {
            "wait-prm" => both!("waits for Set_Prm", "wartet auf Set_Prm"),
            "wait-cfg" => both!("waits for Chk_Cfg", "wartet auf Chk_Cfg"),
            _ => both!("exchanges data", "tauscht Daten aus"),
        })
    }
}

/// A station that came, went, or is otherwise than before: a line of `profibus live --follow`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StationNews {
    /// Seconds since the first question.
    pub t: Decimal,
    /// What became of it.
    pub change: StationChange,
    /// The station; of one that went what was told last.
    pub station: LiveStation,
}

/// What became of a station.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StationChange {
    /// It answers.
    Came,
    /// It tells something else.
    Changed,
    /// It does not answer any more.
    Went,
}

/// How a station answers the same question (FDL status) many times over.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Answers {
    /// How often it was asked, repeats not counted.
    pub asked: u64,
    /// Of these, answered at once, behind one repeat, behind two, and so on.
    pub repeats: Vec<u64>,
    /// Not answered at all.
    pub silences: u64,
    /// Answered by garbage only.
    pub garbled: u64,
    /// From the end of a question that was answered at once to the end of its answer, microseconds: the shortest.
    pub least_us: Option<u64>,
    /// The median.
    pub median_us: Option<u64>,
    /// The longest.
    pub most_us: Option<u64>,
}

/// What a slave of PROFIBUS tells besides.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct SlaveDiagnosis {
    /// Slave_Diag, field by field.
    pub diagnosis: Vec<Field>,
    /// Who controls, what a lost master means, and the trip data, as they stand there; none in Basic mode.
    pub values: Vec<Value>,
    /// What each LED shows now, and what that means.
    pub leds: Vec<Field>,
}
