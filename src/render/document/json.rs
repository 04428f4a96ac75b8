//! One document.

use super::Print;
use crate::render::spoken::spoken;
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, &spoken(&page.envelope(page.outcome.data.as_ref()), page.manner.lang)?)?;
    writeln!(out)
}
