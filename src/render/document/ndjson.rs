//! One object a line: the rows, then the envelope without data as the last.

use super::Print;
use crate::render::finding;
use crate::render::spoken::spoken;
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    let tagged = |kind: &str, fields: serde_json::Map<String, serde_json::Value>| {
        let mut line = serde_json::Map::new();
        line.insert("type".to_owned(), kind.into());
        line.extend(fields);
        line
    };
    for row in page.outcome.data.iter().flat_map(|data| finding::of(data).rows().rows) {
        serde_json::to_writer(&mut *out, &spoken(&tagged(row.kind, row.fields), page.manner.lang)?)?;
        writeln!(out)?;
    }
    if let serde_json::Value::Object(mut fields) = spoken(&page.envelope(None::<()>), page.manner.lang)? {
        fields.remove("data");
        serde_json::to_writer(&mut *out, &tagged("end", fields))?;
        writeln!(out)?;
    }
    Ok(())
}
