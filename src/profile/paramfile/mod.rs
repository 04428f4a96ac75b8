//! Parameter files: a drive's settings as text that people review, and that can be written back (docs/parameter-files.md).
//!
//! This room knows the format and what its lines mean for a family. It knows no drive and no files: texts come in, texts go
//! out. [`ParamFile::parse`] takes a text apart, [`ParamFile::settings`] resolves its lines by the catalogue of its family,
//! [`Settings::lay_over`] lays later files over earlier ones, [`print()`] writes a file.

mod advice;
mod file;
mod parse;
mod print;
mod ranges;
mod resolve;
mod settings;
mod signature;

pub use super::value::value_text;
pub use file::{At, Head, Line, NotHeld, ParamFile, Provenance, SavedDrive, Scope, Undo, VERSION};
pub use parse::{FileFault, schema};
pub use print::{UndoSettings, line, print, print_undo, with_unproven};
pub use ranges::{numbers, ranges};
pub use settings::{Setting, Settings};
pub use signature::Signature;
