//! What `plan`, `apply`, `check` and `init` did with a plant.

use super::{Comparison, ErrorDoc, FoundDrive, Load};
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `plan` and `apply`, and of `dataset load` of several drives.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Plant {
    /// The project file; null if the drives and their files were typed.
    pub project: Option<String>,
    /// Whether nothing was opened.
    pub dry_run: bool,
    /// One entry a drive, port by port.
    pub drives: Vec<PlantDrive>,
}

/// A drive of a plant, and what became of what it shall have.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlantDrive {
    /// Its name in the project file, or its address.
    pub called: String,
    /// Its port.
    pub port: String,
    /// How it stands.
    pub state: PlantState,
    /// Its files and values.
    #[serde(flatten)]
    pub load: Load,
    /// Why it is not as it shall be.
    pub error: Option<ErrorDoc>,
}

/// How a drive of a plant stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlantState {
    /// It has every value already.
    Same,
    /// Something would be written.
    Planned,
    /// It has every value now, proven.
    Done,
    /// Every value is stored, proven, but it does not work with all of them.
    Stored,
    /// Nothing was begun with it; the error says why.
    Skipped,
    /// It was begun, and nothing was changed.
    Untouched,
    /// It is as it was before, proven.
    Back,
    /// Some of it is not as before, or nobody knows; the rows say which.
    Torn,
}

/// Result of `check`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlantCheck {
    /// The project file.
    pub project: String,
    /// One entry a drive, port by port.
    pub drives: Vec<PlantComparison>,
}

/// A drive of a plant beside its files.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlantComparison {
    /// Its name in the project file.
    pub called: String,
    /// Its port.
    pub port: String,
    /// Its address.
    pub address: u8,
    /// The files (a) and the drive (b).
    #[serde(flatten)]
    pub comparison: Comparison,
}

/// Result of `init`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Init {
    /// The project file; null if none was written.
    pub project: Option<String>,
    /// The drives that stand in it, by their names.
    pub drives: Vec<NamedFind>,
    /// What answered and was not recognised.
    pub unknown: Vec<FoundDrive>,
}

/// A drive that got a name.
#[derive(Debug, Serialize, JsonSchema)]
pub struct NamedFind {
    /// Its name in the project file.
    pub called: String,
    /// Who it is.
    #[serde(flatten)]
    pub found: FoundDrive,
}
