//! One document.

use super::Print;
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, &page.envelope(page.outcome.data.as_ref()))?;
    writeln!(out)
}
