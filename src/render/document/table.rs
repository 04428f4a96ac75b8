//! For people.

use super::Print;
use crate::render::{clean, finding};
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    let Some(data) = &page.outcome.data else { return Ok(()) };
    let text = finding::of(data).table(finding::Page {
        lang: page.manner.lang,
        width: page.manner.width,
        full: page.manner.full,
        node: page.manner.node,
    });
    // Nothing slips through, whichever cell it stands in.
    let lines: Vec<String> = text.split('\n').map(clean).collect();
    out.write_all(lines.join("\n").as_bytes())
}
