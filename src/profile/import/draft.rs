//! What comes of a list before it is a catalogue.

use crate::profile::param::{Access, Effective, HazardKind, Sets, Type};
use crate::text::{Text, both};

/// What the user said about a list.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// Which heading is which field: `("id", "Nr")`; an empty heading takes none.
    pub columns: Vec<(String, String)>,
    /// What every row says that says nothing itself: `("access", "rw")`; what one row says whatever stands there: `("370.type", "long")`;
    /// what a word of a field means: `("type.int", "long")`.
    pub sets: Vec<(String, String)>,
    /// What parts two cells.
    pub separator: Option<char>,
    /// Its decimal mark is a comma, or a point.
    pub commas: Option<bool>,
    /// The number that stands for register 0: 0, 1, 40001 …
    pub base: Option<u32>,
    /// Input registers are read as holding registers.
    pub input_as_holding: bool,
    /// Keys of a register that change nothing of its value.
    pub ignored: Vec<String>,
    /// The rows are for a family of their own, whose numbers are those of registers.
    pub own: bool,
}

/// A column and what it was taken for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnTaken {
    /// Field of the catalogue.
    pub field: &'static str,
    /// Heading in the list.
    pub heading: String,
    /// Which column, from 1.
    pub column: usize,
    /// The user said so.
    pub said: bool,
}

/// A row that was not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Line in the file, from 1.
    pub line: usize,
    /// Why.
    pub why: Text,
}

/// Why a list is refused, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImportError {
    /// Line in the file, from 1; 0 if it is about the whole of it.
    pub line: usize,
    /// What is wrong.
    pub why: Text,
    /// What to do.
    pub hint: Option<Text>,
}

impl ImportError {
    pub(super) fn at(line: usize, why: Text) -> Self {
        ImportError { line, why, hint: None }
    }

    pub(super) fn hint(self, hint: Text) -> Self {
        ImportError { hint: Some(hint), ..self }
    }
}

/// A family that the list brings.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Own {
    /// Its name and that of its only drive.
    pub id: String,
    /// For people.
    pub title: String,
    /// Of a value in two registers the lower half goes first.
    pub low_half_first: bool,
}

/// A row of a catalogue to be.
#[derive(Clone, Debug)]
pub struct Draft {
    /// Line in the list, from 1.
    pub line: usize,
    /// Number.
    pub id: u32,
    /// Stable name, if the list has one.
    pub slug: Option<String>,
    /// The maker's short name.
    pub short: Option<String>,
    /// English and German name.
    pub name: Text,
    /// Unit.
    pub unit: Option<String>,
    /// Type.
    pub kind: Option<Type>,
    /// Places behind the point.
    pub decimals: Option<u8>,
    /// Lower limit, upper limit, factory setting: numbers with a point.
    pub limits: [Option<String>; 3],
    /// Who may read and write it.
    pub access: Access,
    /// Data sets.
    pub sets: Option<Sets>,
    /// Lives in RAM only.
    pub volatile: bool,
    /// When a written value takes effect.
    pub effective: Effective,
    /// What writing it can do.
    pub hazard: Option<HazardKind>,
    /// Option module.
    pub module: Option<String>,
    /// Name of a table of values, and the table.
    pub enumeration: (Option<String>, Vec<(i64, Text)>),
    /// Name of a table of bits, and the table.
    pub bits: (Option<String>, Vec<(i64, Text)>),
    /// Other bits for other modes: `30=440:control-position`.
    pub bits_when: Vec<(u32, i64, String)>,
    /// Shown in hexadecimal.
    pub hex: bool,
    /// A remark.
    pub note: Option<Text>,
    /// Facts that no second source confirms.
    pub unconfirmed: Vec<String>,
    /// Where the facts come from.
    pub source: Option<String>,
    /// Drives of the family that it is for; empty for all.
    pub drives: Vec<String>,
    /// Name of its group.
    pub group: Option<String>,
}

impl Draft {
    /// A row of which only the number and the name are known. Nothing is written that nobody said may be.
    pub(super) fn new(line: usize, id: u32, name: Text) -> Self {
        Draft {
            line,
            id,
            slug: None,
            short: None,
            name,
            unit: None,
            kind: None,
            decimals: None,
            limits: [None, None, None],
            access: Access::Read,
            sets: None,
            volatile: false,
            effective: Effective::AtOnce,
            hazard: None,
            module: None,
            enumeration: (None, Vec::new()),
            bits: (None, Vec::new()),
            bits_when: Vec::new(),
            hex: false,
            note: None,
            unconfirmed: Vec::new(),
            source: None,
            drives: Vec::new(),
            group: None,
        }
    }
}

/// What was found in a list.
#[derive(Clone, Debug, Default)]
pub struct Imported {
    /// `table` or `mbmap`.
    pub format: &'static str,
    /// How its bytes are text: `UTF-8`, `Windows-1252`, `UTF-16`.
    pub encoding: &'static str,
    /// What parts its cells.
    pub separator: Option<char>,
    /// Line of the headings.
    pub head: usize,
    /// What was taken for what.
    pub columns: Vec<ColumnTaken>,
    /// Headings that were taken for nothing.
    pub unused: Vec<String>,
    /// The rows.
    pub drafts: Vec<Draft>,
    /// Rows that were not taken.
    pub left_out: Vec<LeftOut>,
    /// What a reader should know.
    pub notes: Vec<Text>,
    /// The device, where the list names it.
    pub own: Own,
}

impl Imported {
    /// No number may stand twice.
    pub(super) fn check_twins(&self) -> Result<(), ImportError> {
        let mut seen = std::collections::BTreeMap::new();
        for draft in &self.drafts {
            if let Some(first) = seen.insert((draft.id, draft.drives.clone()), draft.line) {
                let id = draft.id;
                return Err(ImportError::at(
                    draft.line,
                    both!(
                        "parameter {id} stands twice, first in line {first}",
                        "Parameter {id} steht zweimal, zuerst in Zeile {first}"
                    ),
                ));
            }
        }
        Ok(())
    }
}
