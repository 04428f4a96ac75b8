//! What `report` found: drives and their line, as they are handed over.

use super::{Diagnosis, Difference, ErrorDoc, Identity, LeftOut, LineCheck, Plot, ProcedureRecord, Value};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `report`.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Report {
    /// Files that were written.
    pub files: Vec<String>,
    /// For whom it is; null if the project file does not say.
    pub customer: Option<String>,
    /// What it is about; null if the project file does not say.
    pub plant: Option<String>,
    /// When it was made, UTC (RFC 3339); null on the bench.
    pub time: Option<String>,
    /// Whether only what differs from the factory settings is listed.
    pub changed_only: bool,
    /// The line; null if it was not measured to the end.
    pub line: Option<LineCheck>,
    /// One entry a drive.
    pub drives: Vec<ReportedDrive>,
    /// Guided work that was done, as its records tell it.
    pub procedures: Vec<ProcedureRecord>,
    /// The records that it shows.
    pub records: Vec<Plot>,
    /// Their pictures, in SVG.
    #[serde(skip)]
    pub pictures: Vec<String>,
    /// What stands at the head of the page.
    #[serde(skip)]
    pub logo: Option<Logo>,
}

/// A picture that goes into the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Logo {
    /// `image/png`, `image/jpeg`, `image/svg+xml`.
    pub kind: &'static str,
    /// The file.
    pub bytes: Vec<u8>,
}

/// A drive as it is handed over.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ReportedDrive {
    /// Address.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Family, or `unknown`.
    pub drive: String,
    /// Its name in the project file; null if it has none.
    pub called: Option<String>,
    /// Who it is; null if it did not tell.
    pub identity: Option<Identity>,
    /// What ails it; null if it did not tell.
    pub diagnosis: Option<Diagnosis>,
    /// Signature over family and all settings, as `dataset save` writes it; null if not all of them were read.
    pub signature: Option<String>,
    /// The settings, as they are stored; data set 0 stands for all four, or is the only one.
    pub values: Vec<Value>,
    /// Parameters that are not among them.
    pub not_held: Vec<LeftOut>,
    /// How many of them have a known factory setting.
    pub compared: usize,
    /// Where they differ from it: `a` is the factory setting, `b` the drive.
    pub differences: Vec<Difference>,
    /// What the drive works with where that is not what it has stored.
    pub in_force: Vec<Text>,
    /// Why the drive did not tell all.
    pub error: Option<ErrorDoc>,
}

/// A form in which a report is handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// One page of HTML with everything in it.
    Html,
    /// Markdown.
    Markdown,
}
