//! A result that goes into a file which somebody named.

use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::text::both;
use std::path::Path;

/// Writes it whole or not at all.
///
/// # Errors
/// The file exists and may not be replaced, or cannot be written (`data.output`).
pub(super) fn write(path: &Path, text: &str, force: bool) -> Result<(), Failure> {
    files::write_whole(path, text, force).map_err(|error| unwritten(path, &error))
}

/// Refuses a file that must not be written, before anything is asked.
///
/// # Errors
/// As [`write`].
pub(super) fn check(path: &Path, force: bool) -> Result<(), Failure> {
    files::check(path, force).map_err(|error| unwritten(path, &error))
}

/// The same of a file that is not replaced as a whole, but written anew where it stands.
///
/// # Errors
/// As [`write`].
pub(super) fn check_in_place(path: &Path, force: bool) -> Result<(), Failure> {
    match files::found(path) {
        Some(_) if force => files::may_be_written(path).map_err(|error| unwritten(path, &error)),
        _ => check(path, force),
    }
}

/// Why a file was not written, and what to do about it.
pub(super) fn unwritten(path: &Path, error: &FileError) -> Failure {
    let message = both!("{path}: {why}", "{path}: {why}", path = path.display(), why = error.text());
    let failure = Failure::new(Class::Data, "data.output", message);
    match error {
        FileError::Exists => failure.hint(both!("--force replaces it", "--force ersetzt sie")),
        _ => failure,
    }
}
