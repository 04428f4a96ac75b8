//! What `dataset save`, `check` and `diff` did with files.

use super::{Decimal, ErrorDoc, OrLines, Value};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// What `dataset` finds of data sets, or of files.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrFile<D> {
    /// What was found.
    Found(D),
    /// Files that were written.
    Saves(OrLines<Saves>),
    /// Differences between files, drives and factory settings.
    Comparisons(OrLines<Comparisons>),
}

/// Result of `dataset save`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Saves {
    /// One entry a drive.
    pub saved: Vec<SavedFile>,
}

/// The settings of a drive, and the file that holds them.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SavedFile {
    /// Address of the drive.
    pub address: u8,
    /// Family, or `unknown`.
    pub drive: String,
    /// The file that was written; that of an interrupted save ends with `.part`. Null if none was.
    pub file: Option<String>,
    /// `settings`, `changed` or `discovered`.
    pub scope: &'static str,
    /// Whether everything was asked that was to be.
    pub complete: bool,
    /// Signature over family and values.
    pub signature: Option<String>,
    /// One entry a value that the file holds; data set 0 stands for all four, or is the only one.
    pub values: Vec<Value>,
    /// What the file does not hold.
    pub not_held: Vec<LeftOut>,
    /// Why it is not complete.
    pub error: Option<ErrorDoc>,
}

/// Parameters that a file does not hold.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LeftOut {
    /// `actual-value`, `ram-only`, `write-only`, `no-number`, `refused`, `unanswered`, `not-asked`, `factory-setting`,
    /// `no-known-factory-setting`, `no-known-width`.
    pub reason: &'static str,
    /// The same for people.
    pub text: Text,
    /// How many.
    pub count: usize,
    /// Their numbers: `210-213, 217`.
    pub params: String,
}

/// Result of `dataset check`, and of `dataset diff` where a side is no data set.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Comparisons {
    /// One entry a drive.
    pub comparisons: Vec<Comparison>,
}

/// Two sides, and where they differ.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Comparison {
    /// One side.
    pub a: Side,
    /// The other.
    pub b: Side,
    /// Whether all that was compared is the same; null if it could not be found out.
    pub equal: Option<bool>,
    /// How many values were compared.
    pub compared: usize,
    /// Where the sides differ.
    pub differences: Vec<Difference>,
    /// Why it could not be compared, or not all of it.
    pub error: Option<ErrorDoc>,
    /// The differences as lines of both files.
    #[serde(skip)]
    pub unified: Option<Text>,
}

/// A side of a comparison.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Side {
    /// `file`, `drive`, `factory` or `set`.
    pub kind: &'static str,
    /// What it is called: a path, `drive 3`, `factory`, `drive 3, set 2ram`.
    pub name: Text,
    /// Family, or `unknown`.
    pub drive: String,
    /// Address, if it is a drive.
    pub address: Option<u8>,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Signature over the values that were compared.
    pub signature: Option<String>,
    /// Whether a file was changed since it was saved: its own signature is another one. Null if it has none.
    pub edited: Option<bool>,
}

/// A value that is not the same on both sides.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Difference {
    /// Group of the catalogue.
    pub group: Option<String>,
    /// Parameter number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Data set, 0-4; 0 stands for all four, or is the only one.
    pub data_set: u8,
    /// Unit.
    pub unit: Option<String>,
    /// Raw value of the one side; null if it holds none.
    pub a_raw: Option<i64>,
    /// Its value; null if nobody knows its decimals.
    pub a_value: Option<Decimal>,
    /// What it stands for.
    pub a_text: Option<Text>,
    /// Raw value of the other side; null if it holds none.
    pub b_raw: Option<i64>,
    /// Its value; null if nobody knows its decimals.
    pub b_value: Option<Decimal>,
    /// What it stands for.
    pub b_text: Option<Text>,
    /// Why a drive did not tell it.
    pub error: Option<ErrorDoc>,
}
