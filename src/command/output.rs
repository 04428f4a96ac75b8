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
    let free = files::may_be_written(path).and_then(|()| match files::found(path) {
        Some(_) if !force => Err(FileError::Exists),
        _ => Ok(()),
    });
    free.map_err(|error| unwritten(path, &error))
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
