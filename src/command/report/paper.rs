//! What stands at the head of a report, out of the project file.

use crate::args::{Letterhead, Settings, letterhead};
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::{Logo, Report};
use crate::text::{Text, both};
use std::path::Path;

/// Longest logo in bytes: it stands in the page as text.
const LOGO: u64 = 1 << 20;

/// An empty report with its head.
pub(super) fn head(settings: &Settings) -> Result<Report, Failure> {
    let Letterhead { customer, plant, logo } = letterhead(settings)?;
    let logo = logo.map(|path| read(&path)).transpose()?;
    Ok(Report { customer, plant, logo, ..Report::default() })
}

fn read(path: &Path) -> Result<Logo, Failure> {
    let wrong = |why: Text| {
        let shown = path.display();
        Failure::new(Class::Data, "data.logo", both!("{shown}: {why}", "{shown}: {why}", why))
    };
    let bytes = files::read_bytes(path, LOGO).map_err(|error: FileError| wrong(error.text()))?;
    let kind = kind(&bytes).ok_or_else(|| {
        wrong(both!("expected a picture in PNG, JPEG or SVG", "erwartet wird ein Bild in PNG, JPEG oder SVG"))
    })?;
    Ok(Logo { kind, bytes })
}

/// What a picture is, by how it begins (PNG: RFC 2083 3.1; JPEG: ITU T.81 B.1.1.3).
fn kind(bytes: &[u8]) -> Option<&'static str> {
    let text = || std::str::from_utf8(bytes).ok().map(|text| text.trim_start_matches('\u{FEFF}').trim_start());
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Some("image/png"),
        [0xFF, 0xD8, 0xFF, ..] => Some("image/jpeg"),
        _ if text().is_some_and(|text| text.starts_with('<') && text.contains("<svg")) => Some("image/svg+xml"),
        _ => None,
    }
}
