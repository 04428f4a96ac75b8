//! A result that goes into a file which somebody named.

use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::Warning;
use crate::text::both;
use std::io;
use std::path::{Path, PathBuf};

/// What went wrong with a file that a stream keeps, on its way through what writes: it is the file's, not the output's.
#[derive(Debug, thiserror::Error)]
#[error("{}: {error}", path.display())]
struct OfFile {
    path: PathBuf,
    error: FileError,
}

/// The error with the name of the file in it.
pub(super) fn of_file(path: &Path, error: impl Into<FileError>) -> io::Error {
    io::Error::other(OfFile { path: path.to_owned(), error: error.into() })
}

/// The failure to show where it was not the output that could not be written, but a file beside it.
pub fn file_failure(error: &io::Error) -> Option<Failure> {
    let OfFile { path, error } = error.get_ref()?.downcast_ref()?;
    Some(Failure { hint: None, ..unwritten(path, error) })
}

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

/// That a parameter file is TOML, whatever its name promises.
pub(super) fn misnamed(path: &Path) -> Option<Warning> {
    let form = path.extension()?.to_str()?.to_ascii_lowercase();
    ["csv", "json", "ndjson"].contains(&form.as_str()).then(|| Warning {
        code: "file.is_toml".to_owned(),
        message: both!(
            "{path} is a parameter file (TOML) all the same; `--format {form} > FILE` keeps what goes to stdout",
            "{path} ist trotzdem eine Parameterdatei (TOML); `--format {form} > DATEI` behält, was auf stdout steht",
            path = path.display()
        ),
    })
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
