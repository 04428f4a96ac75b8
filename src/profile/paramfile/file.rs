//! What stands in a parameter file, as it is written: the head and the lines.

use crate::profile::param::Type;
use crate::profile::select::Store;
use crate::text::Lang;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

/// Newest version of the format. Files of every earlier one stay readable.
pub const VERSION: u32 = 2;

/// A parameter file: whose settings it holds, and a line for each.
#[derive(Clone, Debug)]
pub struct ParamFile {
    /// Where it was read, as the user names it.
    pub path: Rc<str>,
    /// All but the values.
    pub head: Head,
    /// Where its family stands.
    pub family_at: At,
    /// The values, in the order in which they stand.
    pub lines: Vec<Line>,
    /// What a transaction was about to do, if it is the file that takes it back.
    pub undo: Option<Undo>,
}

/// What a transaction was about to do. The `[values]` of the file that takes it back are what stood in the drive.
#[derive(Clone, Debug)]
pub struct Undo {
    /// Where the values went.
    pub store: Store,
    /// What was to come, as it is written.
    pub lines: Vec<Line>,
    /// What stood in the RAM alone, over what was stored: it is named, and not brought back.
    pub ram: Vec<Line>,
    /// What perhaps did not come back, and is written whatever the drive tells of it.
    pub unproven: Vec<Line>,
}

/// A line of `[values]`, as it is written.
#[derive(Clone, Debug)]
pub struct Line {
    /// The parameter and its data set: `372@2`, `rated-speed`.
    pub key: String,
    /// Where the key stands.
    pub at: At,
    /// The value: `1450 1/min`.
    pub value: String,
    /// Where the value stands.
    pub value_at: At,
}

/// Where something stands.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct At {
    /// The file, as the user names it.
    pub path: Rc<str>,
    /// Line, from 1; 0 where no line is meant.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
}

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let At { path, line, column } = self;
        if *line == 0 { write!(f, "{path}") } else { write!(f, "{path}:{line}:{column}") }
    }
}

/// All of a parameter file but its values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// Whose settings they are.
    pub drive: SavedDrive,
    /// How they were read; what was written by hand says nothing.
    pub saved: Provenance,
    /// Numbers of parameters that the file does not hold, by the reason, as ranges: `210-213, 217`.
    pub not_held: BTreeMap<NotHeld, String>,
    /// Data types that were found out by asking, of parameters whose type no catalogue tells.
    pub types: BTreeMap<u32, Type>,
    /// The language of its comments; it says nothing of its values.
    pub lang: Lang,
}

/// The drive that the settings are of, or for.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct SavedDrive {
    /// Family: `act`, `acu`, `lxm05`. A file is for drives of this family only.
    pub family: String,
    /// Address that it was read at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub address: Option<u8>,
    /// Node of the system bus behind the drive at that address.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub node: Option<u8>,
    /// What the drive calls itself, if it does: product code, revision.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub product: Option<String>,
    /// What it answered that tells the family.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<String>,
}

/// When and how a file was written by `dataset save`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Provenance {
    /// Time in UTC: `2026-11-22T14:03:07Z`. The built-in bench has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<String>,
    /// Program and version that wrote it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tool: Option<String>,
    /// Port that the drive was reached through.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub port: Option<String>,
    /// Speed and format of the line: `19200 8E1`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<String>,
    /// What was spoken: `rtu`, `ascii`, `vabus`, `mbtcp`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub protocol: Option<String>,
    /// What the file was to hold.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scope: Option<Scope>,
    /// False while the drive was not asked for all of it: `dataset save --resume` goes on.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub complete: bool,
    /// Over family and values; tells whether two files hold the same.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub signature: Option<String>,
}

fn yes() -> bool {
    true
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn is_yes(complete: &bool) -> bool {
    *complete
}

/// What a file was to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Scope {
    /// Every setting that the catalogue knows.
    Settings,
    /// What differs from the factory settings that are known.
    Changed,
    /// Every number that the drive answers, also those that no catalogue knows.
    Discovered,
}

/// Why a file does not hold a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum NotHeld {
    /// The drive itself changes it: actual values, faults, counters.
    ActualValue,
    /// It lives in RAM only: control words, setpoints, commands.
    RamOnly,
    /// It can be written but not read.
    WriteOnly,
    /// A text, or something else that is no number.
    NoNumber,
    /// The drive refused to tell it, as far as it has it at all.
    Refused,
    /// No valid answer came.
    Unanswered,
    /// Not asked yet: the save was interrupted.
    NotAsked,
    /// It has its factory setting.
    FactorySetting,
    /// No source tells its factory setting, so nobody knows whether it was changed.
    NoKnownFactorySetting,
    /// No source tells how wide it is, and the line does not either: what came may be a number below zero.
    NoKnownWidth,
}

impl Scope {
    /// The word for it in a file and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Scope::Settings => "settings",
            Scope::Changed => "changed",
            Scope::Discovered => "discovered",
        }
    }
}

impl NotHeld {
    /// Every reason.
    pub const ALL: &[NotHeld] = &[
        NotHeld::ActualValue,
        NotHeld::RamOnly,
        NotHeld::WriteOnly,
        NotHeld::NoNumber,
        NotHeld::Refused,
        NotHeld::Unanswered,
        NotHeld::NotAsked,
        NotHeld::FactorySetting,
        NotHeld::NoKnownFactorySetting,
        NotHeld::NoKnownWidth,
    ];

    /// Whether it may still be read: the next try asks it.
    pub fn is_open(self) -> bool {
        matches!(self, NotHeld::Unanswered | NotHeld::NotAsked)
    }

    /// The word for it in a file and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            NotHeld::ActualValue => "actual-value",
            NotHeld::RamOnly => "ram-only",
            NotHeld::WriteOnly => "write-only",
            NotHeld::NoNumber => "no-number",
            NotHeld::Refused => "refused",
            NotHeld::Unanswered => "unanswered",
            NotHeld::NotAsked => "not-asked",
            NotHeld::FactorySetting => "factory-setting",
            NotHeld::NoKnownFactorySetting => "no-known-factory-setting",
            NotHeld::NoKnownWidth => "no-known-width",
        }
    }
}
