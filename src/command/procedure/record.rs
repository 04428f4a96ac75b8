//! The record of a procedure: a file that is written whole behind every step, and read again to go on.

use super::given::Given;
use crate::command::output;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::ProcedureRecord;
use crate::profile::procedure::Procedure;
use crate::profile::{Family, stumbled_json};
use crate::text::{Text, both};
use std::path::Path;

/// What an earlier run has left at a path.
///
/// # Errors
/// A file is there that is no record.
pub(super) fn kept(path: &Path) -> Result<Option<ProcedureRecord>, Failure> {
    files::found(path).map(|_| read(path).map_err(|failure| failure.hint(begin_anew()))).transpose()
}

/// The record to go on with: what was kept, or a new one.
///
/// # Errors
/// What was kept is of something else, or the file cannot be written.
pub(super) fn open(
    path: &Path,
    kept: Option<ProcedureRecord>,
    procedure: &Procedure,
    (address, family): (u8, &Family),
    given: &Given,
) -> Result<ProcedureRecord, Failure> {
    output::check(path, true)?;
    let new = ProcedureRecord {
        antrieb_procedure: ProcedureRecord::VERSION,
        procedure: procedure.slug.clone(),
        title: procedure.title.clone(),
        address,
        drive: family.drive.clone(),
        asked: false,
        of: procedure.steps_of(&family.drive).len(),
        given: given.told(),
        steps: Vec::new(),
        lent: Vec::new(),
        left: Vec::new(),
        answered: None,
        stored: Vec::new(),
    };
    let Some(kept) = kept else { return Ok(new) };
    if (&kept.procedure, kept.address, &kept.drive) != (&new.procedure, address, &new.drive) {
        let was = both!(
            "it is the record of {procedure} with drive {address} ({drive})",
            "sie ist die Aufzeichnung von {procedure} mit Antrieb {address} ({drive})",
            procedure = kept.procedure,
            address = kept.address,
            drive = kept.drive
        );
        return Err(wrong(path, &was).hint(begin_anew()));
    }
    if kept.given != new.given {
        let was = both!("it was begun with other values", "sie wurde mit anderen Werten begonnen");
        return Err(wrong(path, &was).hint(begin_anew()));
    }
    Ok(kept)
}

/// The record in a file.
///
/// # Errors
/// It cannot be read, or is none.
pub(in crate::command) fn read(path: &Path) -> Result<ProcedureRecord, Failure> {
    let text = files::read(path, files::TEXT).map_err(|error| wrong(path, &error.text()))?;
    let kept: ProcedureRecord = serde_json::from_str(&text).map_err(|error| {
        let why = stumbled_json(&error);
        wrong(path, &both!("no record of a procedure: {why}", "keine Aufzeichnung einer Prozedur: {why}", why))
    })?;
    if kept.antrieb_procedure != ProcedureRecord::VERSION {
        let version = kept.antrieb_procedure;
        return Err(wrong(path, &both!("version {version} of a record", "Version {version} einer Aufzeichnung")));
    }
    Ok(kept)
}

/// Writes it whole.
///
/// # Errors
/// It cannot be written.
pub(super) fn save(path: &Path, record: &ProcedureRecord) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(record).unwrap_or_default();
    output::write(path, &(text + "\n"), true)
}

pub(super) fn wrong(path: &Path, why: &Text) -> Failure {
    let message = both!("{file}: {why}", "{file}: {why}", file = path.display(), why);
    Failure::new(Class::Data, "data.record", message)
}

pub(super) fn begin_anew() -> Text {
    both!(
        "--record names another file; --force begins anew and replaces this one",
        "--record nennt eine andere Datei; --force beginnt von vorn und ersetzt diese"
    )
}
