//! What `params import` and `params export` say.

use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// What `params` finds, what it took from a list, or the list that it writes.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum ListOr<D> {
    /// What was found.
    Found(D),
    /// What was taken from a list.
    Import(Import),
    /// The list.
    Export(Export),
}

/// Result of `params import`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Import {
    /// The list.
    pub file: String,
    /// `table` or `mbmap`.
    pub format: &'static str,
    /// `UTF-8`, `UTF-16`, `Windows-1252`.
    pub encoding: &'static str,
    /// What parts the cells of a table.
    pub separator: Option<String>,
    /// Family that the rows are for.
    pub family: String,
    /// The list brings the family.
    pub own: bool,
    /// Columns, and what they were taken for.
    pub columns: Vec<ImportColumn>,
    /// Headings that were taken for nothing.
    pub unused: Vec<String>,
    /// The rows.
    pub rows: Vec<ImportRow>,
    /// Rows that were not taken.
    pub left_out: Vec<RowLeftOut>,
    /// What a reader should know.
    pub notes: Vec<Text>,
    /// Where the catalogue was written.
    pub output: Option<String>,
    /// The catalogue (TOML), if it was not written to a file.
    pub catalogue: Option<String>,
    /// All of this in lines.
    #[serde(skip)]
    pub told: Vec<Text>,
}

/// A column, and what it was taken for.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ImportColumn {
    /// Field of the catalogue.
    pub field: &'static str,
    /// Heading in the list.
    pub heading: String,
    /// Which column, from 1.
    pub column: usize,
    /// Named by --column; otherwise guessed.
    pub said: bool,
}

/// A row that was taken.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ImportRow {
    /// Line in the list.
    pub line: usize,
    /// Number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Unit.
    pub unit: Option<String>,
    /// Data type, where the list tells it.
    pub data_type: Option<&'static str>,
    /// Places behind the point, where the list tells them.
    pub decimals: Option<u8>,
    /// `r`, `w`, `rw`.
    pub access: &'static str,
}

/// A row that was not taken.
#[derive(Debug, Serialize, JsonSchema)]
pub struct RowLeftOut {
    /// Line in the list.
    pub line: usize,
    /// Why.
    pub why: Text,
}

/// Result of `params export`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Export {
    /// Family.
    pub drive: String,
    /// Fields, in the order of the columns.
    pub columns: Vec<&'static str>,
    /// One entry a parameter: text by field.
    pub params: Vec<BTreeMap<&'static str, String>>,
    /// Where the list was written.
    pub output: Option<String>,
    /// The list, if it was not written to a file.
    #[serde(skip)]
    pub list: Option<String>,
}
