//! What `read`, `write` and `dataset` did.

use super::{Decimal, ErrorDoc, TelegramDoc, Value};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `read`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Read {
    /// One entry a value.
    pub values: Vec<Value>,
}

/// Result of `write` and of everything else that writes.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Write {
    /// Whether nothing was sent.
    pub dry_run: bool,
    /// One entry a value.
    pub values: Vec<Written>,
}

/// A value that was, or would be, written.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Written {
    /// Address of the drive; 0 is a broadcast.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Family.
    pub drive: String,
    /// Parameter number.
    pub param: u32,
    /// Element of an array, from 1; missing where it is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub index: Option<u8>,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Data set, 0-4.
    pub data_set: u8,
    /// `eeprom`, `ram`, or `unknown` where no source tells whether the value outlives power-off.
    pub store: &'static str,
    /// Raw value before; null if it could not be read.
    pub old_raw: Option<i64>,
    /// Value before; null as well where no source tells its decimals.
    pub old: Option<Decimal>,
    /// Raw value asked for.
    pub raw: i64,
    /// Value asked for; null where no source tells its decimals, so that only the raw one is known.
    pub value: Option<Decimal>,
    /// Unit.
    pub unit: Option<String>,
    /// What the new value stands for.
    pub text: Option<Text>,
    /// What became of it.
    pub result: WriteResult,
    /// The telegram that was, or would be, sent.
    pub telegram: Option<String>,
    /// What the telegram says.
    pub meaning: Option<Text>,
    /// When it takes effect, if not at once.
    pub note: Option<Text>,
    /// Why it was not written.
    pub error: Option<ErrorDoc>,
}

/// What became of a write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WriteResult {
    /// Echoed and read back.
    Verified,
    /// Echoed; cannot be read back.
    Written,
    /// Stored, read back, but the drive works with another value (RAM).
    Stored,
    /// The drive has this value already; nothing was sent.
    Unchanged,
    /// A dry run: nothing was sent.
    Planned,
    /// The drive, or we, refused.
    Refused,
    /// The reply is missing and the value could not be read back.
    Unknown,
    /// The drive took the telegram but reads back another value.
    Differs,
    /// Sent to everybody; nobody answers a broadcast.
    Broadcast,
    /// Not tried, because something before it failed.
    Skipped,
    /// It has its old value again, read back, because something behind it failed.
    Restored,
    /// Something behind it failed, and it may not have its old value again.
    Unrestored,
}

/// What a verb that reads would send, under `--dry-run`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Plan {
    /// True: nothing was opened, nothing was sent.
    pub dry_run: bool,
    /// The telegrams in their order; what depends on answers stands as in the usual case.
    pub telegrams: Vec<TelegramDoc>,
    /// What depends on answers, what is left out, what else is asked.
    pub notes: Vec<Text>,
}

/// Result of `dataset`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Dataset {
    /// Address of the drive.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Data set that the drive works with (P.249).
    pub active: Option<i64>,
    /// How it is selected (P.414), as the drive works with it.
    pub selection: Option<Value>,
    /// What is stored, where that is something else.
    pub selection_stored: Option<Value>,
    /// Parameters beside each other.
    pub rows: Vec<DatasetRow>,
    /// Values that were, or would be, written.
    pub written: Vec<Written>,
    /// Whether nothing was sent.
    pub dry_run: bool,
    /// Why not all that was asked for was done with it; of one drive alone the document says it.
    pub error: Option<ErrorDoc>,
}

/// The data sets of several drives.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Datasets {
    /// One entry a drive, in the order that was typed.
    pub drives: Vec<Dataset>,
}

/// A parameter in several data sets.
#[derive(Debug, Serialize, JsonSchema)]
pub struct DatasetRow {
    /// Parameter number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Unit.
    pub unit: Option<String>,
    /// Whether the values are the same.
    pub equal: bool,
    /// One value a data set.
    pub values: Vec<Value>,
}

/// Result of `dataset load` and `dataset undo`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Load {
    /// Address of the drive.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Family.
    pub drive: String,
    /// The parameter files, later ones over earlier ones.
    pub files: Vec<String>,
    /// Whether nothing was sent.
    pub dry_run: bool,
    /// How it ended; null where nothing was begun.
    pub ended: Option<LoadEnd>,
    /// The file that takes it back; null where none was needed.
    pub undo_file: Option<String>,
    /// Cells of the EEPROM that were going to be written at most.
    pub eeprom_writes: u64,
    /// Cells that putting everything back writes at most.
    pub eeprom_writes_back: u64,
    /// Whether something takes effect only after a restart of the drive.
    pub restart: bool,
    /// What the file holds and is not written.
    pub left_out: Vec<NotLoaded>,
    /// One entry a value.
    pub values: Vec<Written>,
    /// For people, behind the values: how much was written, and what takes it back.
    #[serde(skip)]
    pub closing: Option<Text>,
}

/// How a transaction ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LoadEnd {
    /// The drive has every value, proven.
    #[default]
    Done,
    /// Every value is stored, proven, but the drive does not work with all of them; the rows say with which.
    Stored,
    /// Nothing was changed.
    Untouched,
    /// Everything that was written is as it was before, proven.
    Back,
    /// Some of it is not as before, or nobody knows; the rows say which.
    Torn,
}

/// A setting of a file that is not written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct NotLoaded {
    /// Parameter number.
    pub param: u32,
    /// Data set, 0-4.
    pub data_set: u8,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Why.
    pub why: NotLoadedWhy,
}

/// Why a setting of a file is not written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NotLoadedWhy {
    /// A setting of a bus, or what hangs on an index, for which nobody asked: `--only` names it.
    NotAskedFor,
    /// The drive only tells it.
    ReadOnly,
    /// A command or a setpoint, which lives in RAM only.
    Command,
    /// It restarts the drive.
    Restarts,
    /// A text, for which there is no telegram.
    Text,
}
